# Install the files of a list, or remove them:
#
#     DESTDIR=dir PREFIX=dir VERSION=x.y.z install.sh put|remove <list
#
# A line of the list names a file below PREFIX and the file that is to be
# there, or "->" and what it is a link to.  In .pc and .cmake files @prefix@ and
# @version@ are filled in.  A relative PREFIX counts from here.
set -eu

case $PREFIX in /*) ;; *) PREFIX=$(pwd)/$PREFIX ;; esac
top=$DESTDIR$PREFIX

# What sed would take for more than letters is quoted.
fill_in() {
    prefix=$(printf '%s\n' "$PREFIX" | sed 's/[&\|]/\\&/g')
    sed "s|@prefix@|$prefix|; s|@version@|$VERSION|" "$1"
}

put() { # file, source, target
    mkdir -p "$(dirname "$top/$1")"
    rm -f "$top/$1"
    case $1,$2 in
    *,'->') ln -s "$3" "$top/$1" && return ;;
    *.pc,* | *.cmake,*) fill_in "$2" >"$top/$1" ;;
    *) cp "$2" "$top/$1" ;;
    esac
    case $1 in
    bin/*) chmod 755 "$top/$1" ;;
    *) chmod 644 "$top/$1" ;;
    esac
}

# The folders that are called tanglefree are removed, too, and those in them,
# once they are empty.
remove() {
    rm -f "$top/$1"
    folder=$(dirname "$1")
    while case $folder in */tanglefree | */tanglefree/*) true ;; *) false ;; esac
    do
        rmdir "$top/$folder" 2>/dev/null || break
        folder=$(dirname "$folder")
    done
}

while read -r file source target; do
    $1 "$file" "$source" "${target-}"
done

case $1 in
put)
    # So that programs find the shared library; not for a package, and not
    # without the rights.
    [ "$DESTDIR" ] || ldconfig 2>/dev/null || true
    echo "installed to $top" ;;
remove)
    echo "removed from $top" ;;
esac

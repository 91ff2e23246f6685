# Install the packages that a target needs and that are missing:
#
#     CC=gcc install-packages.sh TARGET
#
# tests/packages lists them.  Prints which are missing, and why they are needed,
# before it installs anything; where it may not install, prints the command to type.
set -eu

target=$1
table=$(dirname "$0")/packages

# Two targets of one `make -j` must not install at once.
exec 9<"$table"
flock 9 2>/dev/null || true

# The lines of a target, after those of the targets that it names.
list_lines() { # target
    for other in $(sed -n "s/^$1://p" "$table"); do
        list_lines "$other"
    done
    sed -n "/^$1:/,/^\$/s/^  //p" "$table"
}

is_there() { # sign
    case $1 in
    *.h) $CC -E -include "$1" -x c /dev/null ;;
    *.pc) pkg-config --exists "${1%.pc}" ;;
    *.sty | *.tfm) kpsewhich "$1" ;;
    font:*) fc-list "${1#font:}" | grep . ;;
    python:*) /usr/bin/python3 -c "import ${1#python:}" ;;
    /*) [ -e "$1" ] ;;
    -*) echo 'int LLVMFuzzerTestOneInput(void) { return 0; }' |
        clang "$1" -x c - -o /dev/null ;;
    *) command -v "$1" ;;
    esac >/dev/null 2>&1
}

# Whether the first package of "a|b" is the one for this system.
is_first() { # packages, signs
    is_there "${2%%|*}" || apt-cache show "${1%%|*}" >/dev/null 2>&1
}

# Of lines "package sign purpose", the packages that are missing.
list_missing() {
    while read -r package sign purpose; do
        case $package in
        CC) package=${CC%% *} sign=${CC%% *} ;;
        *'|'*)
            if is_first "$package" "$sign"; then
                package=${package%%|*} sign=${sign%%|*}
            else
                package=${package#*|} sign=${sign#*|}
            fi ;;
        esac
        is_there "$sign" && continue
        package=$(echo "$package" | tr ',' ' ')
        echo "$package is missing; it $purpose." >&2
        echo "$package"
    done
}

missing=$(list_lines "$target" | awk '!seen[$1]++' | list_missing | tr '\n' ' ')
[ "$missing" ] || exit 0

command -v apt-get >/dev/null || {
    echo "These are Debian's names; install the packages, then run make again." >&2
    exit 1
}
install="apt-get update; apt-get install -y --no-install-recommends $missing"
as_root=none
if [ "$(id -u)" = 0 ]; then
    as_root=env
elif command -v sudo >/dev/null; then
    as_root='sudo env'
fi
if [ "$as_root" != none ]; then
    echo "Installing: $install"
    $as_root DEBIAN_FRONTEND=noninteractive sh -c "$install" && exit 0
fi
echo "To install them, run as root: $install" >&2
exit 1

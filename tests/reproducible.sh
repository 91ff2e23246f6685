# See that two builds of the commit at hand give the same bytes:
#
#     MAKE=make BUILD=dir reproducible.sh
#
# They differ in all that should not matter: the folder, the name of the build,
# the locale and the time zone.  What changes with -g is compared as well.
set -eu

scratch=$BUILD/reproducible
products='libtanglefree.a libtanglefree.so tanglefree tanglefree-draw include
    single figures book/html'

build() { # folder, name of the build
    mkdir -p "$scratch/$1"
    git archive HEAD | tar -x -C "$scratch/$1"
    echo "build   $scratch/$1"
    $MAKE -C "$scratch/$1" all single BUILD="$2" CFLAGS='-O2 -g' \
        >"$scratch/$1.txt" 2>&1 || { tail -n 20 "$scratch/$1.txt"; exit 1; }
}

rm -rf "$scratch"
export LC_ALL=C.UTF-8 TZ=UTC
build one build
export LC_ALL=C TZ=Asia/Tokyo
build another/place output

wrong=0
for product in $products; do
    diff -rq "$scratch/one/build/$product" \
        "$scratch/another/place/output/$product" || wrong=1
done
[ $wrong = 0 ] || exit 1
echo "the same bytes:" $products

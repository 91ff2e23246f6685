# Compare the binary interface of the library with that of an older one:
#
#     CC=cc compare.sh OLD FOLDER
#
# where OLD is a description and FOLDER is where describe.sh has described the
# present library.  Lists what was added, and fails if anything is incompatible,
# which means that programs compiled for the older one must be compiled again.
set -eu

here=$(dirname "$0")
old=$1
folder=$2

awk -f "$here/description.awk" -f "$here/trim.awk" "$old" \
    "$folder/tanglefree.abi" >"$folder/trimmed.abi" 2>"$folder/added"
cat "$folder/added"

# What abidiff takes for harmless includes names of members, which sources need.
same=true
abidiff --harmless --leaf-changes-only --no-added-syms "$old" \
    "$folder/trimmed.abi" >"$folder/changes" ||
    { cat "$folder/changes" && same=false; }
awk -f "$here/description.awk" -f "$here/layouts.awk" "$old" \
    >"$folder/layouts.c"
$CC -std=c17 -I "$folder" -fsyntax-only "$folder/layouts.c" || same=false
$same

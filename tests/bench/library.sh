# Time the library, see measure.sh:
#
#     library.sh PROGRAM...
set -eu

for program; do
    "$program" --csv
done

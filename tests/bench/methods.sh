# Compare the methods, see measure.sh:
#
#     methods.sh COMPARE PUBLISHED
#
# The numbers are those of the program COMPARE and of the file PUBLISHED.
set -eu

"$1" --csv
cat "$2"

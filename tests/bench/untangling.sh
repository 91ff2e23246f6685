# Untangle surfaces, with all rungs and without some, see measure.sh:
#
#     untangling.sh UNTANGLING
set -eu
"$1"

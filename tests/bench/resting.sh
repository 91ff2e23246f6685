# Watch whether a stack of sheets comes to rest, see measure.sh:
#
#     resting.sh RESTING
set -eu
"$1"

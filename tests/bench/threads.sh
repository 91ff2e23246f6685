# Time tasks on several threads, see measure.sh:
#
#     threads.sh THREADS
set -eu

"$1"

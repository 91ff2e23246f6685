# Try random merges, pinches and drops, see measure.sh:
#
#     topology.sh TOPOLOGY COUNT FROM
#
# The numbers are: for each operation how often it was done, was impossible, and
# was refused by each test; how many merges joined two parts and pinches made
# two; and how many surfaces were judged, and faults found.
set -eu
topology=$1
count=$2
from=$3

echo "operations,$count,"

{ "$topology" "$count" "$from" || true; } | awk '
    /^stream/ { faults++ }
    /^(merge|pinch|drop) / {
        split("done impossible D S V", name, " ")
        for (i = 1; i <= 5; i++)
            row[++rows] = $1 " " name[i] "," $(i + 1)
        row[++rows] = $1 " E," $8
    }
    /merges joined/ { joined = $1; parted = $6 }
    /^judged:/ { judged = $2 }
    END {
        print "faults," faults + 0 ","
        for (i = 1; i <= rows; i++)
            print row[i] ","
        print "joined," joined ","
        print "parted," parted ","
        print "judged," judged ","
    }'

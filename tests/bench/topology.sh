# Try random merges, pinches and drops and print what figures/topology.csv
# holds:
#
#     topology.sh COMPILER FLAGS TOPOLOGY COUNT FROM
#
# A head of lines "# what: text" says where the numbers are from.  Then comes a
# line a number, "name,value,unit": for each operation how often it was done,
# was impossible, and was refused by each test; how many merges joined two parts
# and pinches made two; and how many surfaces were judged, and faults found.
# `make measure-topology` runs this.
set -eu
topology=$3
count=$4
from=$5

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure-topology\`; the book reads it.
# machine: ${machine:-$(uname -m)}
# compiler: $($1 --version | head -n 1), $2
# date: $(date +%Y-%m-%d)
# command: make measure-topology
name,value,unit
operations,$count,
END

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

# Leave out tests of surgery, see measure.sh:
#
#     surgery.sh SURGERY COUNT
#
# The numbers are, for each choice of tests: how many operations were tried and
# done, in runs of 500 that end with the first fault, how many runs had one, and
# of which kind.
set -eu
surgery=$1
count=$2

# run NAME LEFT_OUT
run() {
    { "$surgery" "$count" 0 "$2" || true; } |
        awk -v name="$1" -v runs=$((count / 500)) '
        /^stream/ {
            faults++
            if (/tangle/)
                tangled++
            else if (/collinear/)
                collinear++
            else
                passed++
        }
        /^(split|move|collapse|flip)/ {
            first = NF - 6
            done += $first
            for (i = first; i <= NF; i++)
                tried += $i
        }
        END {
            print name " runs," runs ","
            print name " tried," tried ","
            print name " done," done ","
            print name " faults," faults + 0 ","
            print name " tangled," tangled + 0 ","
            print name " collinear," collinear + 0 ","
            print name " passed," passed + 0 ","
        }'
}

# The bits are those of the outcomes with which the tests refuse.
run all 0
run without-D 8
run without-S 16
run without-V 32
run without-E 64
run without-X 128
run without-VEX 224

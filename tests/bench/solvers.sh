# Compare the solvers of zones, and numbers of sweeps, see measure.sh:
#
#     solvers.sh SOLVERS SWEEPS ZONES
set -eu

solvers=$1 sweeps=$2 zones=$3

# The first word of a line names the solver, and the last ten are numbers.
"$solvers" "$zones" | awk '
    NR == 1 {
        sub(/,/, "")
        print "zones," $1 ","
        print "least rows," $4 ","
        print "most rows," $6 ","
        print "median rows," $NF ","
    }
    NF >= 11 && $NF + 0 > 0 {
        split("iterations|most iterations|residual|worst residual|dup|" \
              "worst dup|dup10|worst dup10|part|time", what, "|")
        for (i = 1; i <= 10; i++)
            print $1 " " what[i] "," $(NF - 10 + i) "," (i == 10 ? "ms" : "")
    }'
"$sweeps" --csv

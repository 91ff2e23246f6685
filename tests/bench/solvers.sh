# Compare the solvers of zones, and numbers of sweeps, and print what
# figures/solvers.csv holds:
#
#     solvers.sh COMPILER FLAGS ZONES SOLVERS SWEEPS
#
# A head of lines "# what: text" says where the numbers are from.  Then comes a
# line a number, "name,value,unit".  `make measure-solvers` runs this.
set -eu

compiler=$1 flags=$2 zones=$3 solvers=$4 sweeps=$5

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure-solvers\`; the book reads it.
# machine: ${machine:-$(uname -m)}
# compiler: $($compiler --version | head -n 1), $flags
# date: $(date +%Y-%m-%d)
# command: make measure-solvers
name,value,unit
END

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

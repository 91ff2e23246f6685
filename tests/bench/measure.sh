# Time the library and print what figures/measured.csv holds:
#
#     measure.sh COMPILER FLAGS PROGRAM...
#
# A head of lines "# what: text" says where the numbers are from.  Then comes a
# line a number, "name,value,unit".  `make measure` runs this.
set -eu

compiler=$1 flags=$2
shift 2

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure\`; figures/kit/measured.c and the book read it.
# machine: ${machine:-$(uname -m)}
# compiler: $($compiler --version | head -n 1), $flags
# date: $(date +%Y-%m-%d)
# command: make measure
END
for program; do
    "$program" --csv
done

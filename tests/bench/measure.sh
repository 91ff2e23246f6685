# Print what figures/measured/NAME.csv holds:
#
#     measure.sh NAME COMPILER FLAGS PROGRAM... ARGUMENT...
#
# Lines "# what: text" say where the numbers are from.  Then come "name,value,unit"
# and a line a number in that form, which NAME.sh prints.  tests/bench/rules.mk has
# the programs and arguments of each name; `make measure-NAME` runs this.
set -eu

name=$1 compiler=$2 flags=$3
shift 3

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure-$name\`; the book and its figures read it.
# machine: ${machine:-$(uname -m)}
# compiler: $($compiler --version | head -n 1), $flags
# date: $(date +%Y-%m-%d)
# command: make measure-$name
name,value,unit
END
sh "tests/bench/$name.sh" "$@"

# Let surfaces flow and print what figures/flowing.csv holds:
#
#     flowing.sh COMPILER FLAGS FLOWING
#
# A head of lines "# what: text" says where the numbers are from.  Then comes a
# line a number, "name,value,unit": some that were measured once, and those that
# the program FLOWING prints.  `make measure-flowing` runs this.
set -eu

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure-flowing\`; the book reads it.
# machine: ${machine:-$(uname -m)}
# compiler: $($1 --version | head -n 1), $2
# date: $(date +%Y-%m-%d)
# command: make measure-flowing
name,value,unit
END

# On 2026-11-23: with splits on the level; with flips of up to a tenth of the
# cube of an edge; and by El Topo, with its enright-parameters.txt.
cat <<END
level 320 rms,13.3,1e-3
level 1280 rms,1.62,1e-3
level 1280 max,16.6,1e-3
level 5120 rms,0.404,1e-3
level 5120 max,4.4,1e-3
flip 1280 rms,1.609,1e-3
flip 5120 rms,0.359,1e-3
El Topo volume,-0.23,%
El Topo time,2.12,
El Topo most,25252,
END
"$3"

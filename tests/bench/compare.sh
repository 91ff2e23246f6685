# Compare the methods and print what figures/roads.csv holds:
#
#     compare.sh COMPILER FLAGS COMPARE PUBLISHED
#
# A head of lines "# what: text" says where the numbers are from.  Then comes a
# line a number, "name,value,unit": those of the program COMPARE, and the file
# PUBLISHED.  `make measure-roads` runs this.
set -eu

machine=$(sed -n 's/^model name[^:]*: *//p' /proc/cpuinfo | head -n 1)

cat <<END
# Written by \`make measure-roads\`; figures/kit/measured.c and the book read it.
# machine: ${machine:-$(uname -m)}
# compiler: $($1 --version | head -n 1), $2
# date: $(date +%Y-%m-%d)
# command: make measure-roads
# published: other systems, measured side by side on one machine (an Intel Xeon with AVX-512, single thread, g++ 12 -O3 -march=native, 2026-11-21; TDIB 2026-11-22): costs as ratios to the cubic of El Topo in the same run, good to 20 %, and errors on 2,835 point-triangle and 4,120 edge-edge queries of the public erleben sets
END
"$3" --csv
cat "$4"

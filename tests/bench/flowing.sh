# Let surfaces flow, see measure.sh:
#
#     flowing.sh FLOWING
#
# The numbers are some that were measured once, and those that the program
# FLOWING prints.
set -eu

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
"$1"

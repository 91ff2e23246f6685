# Run the scenes of the simulator, see measure.sh:
#
#     simulation.sh TANGLEFREE COUPLING
#
# The numbers are those of each scene at its usual size, and of the first steps
# of the sphere at growing sizes ("growth 22", cells along a side).  Times are
# of a step, on the mean.  Those of COUPLING, tests/bench/coupling, are of the
# processor, by the response alone and by the parts of the coupling.
set -eu
program=$1
coupling=$2
growth_steps=60

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
folder=$scratch/frames
summary=$scratch/summary

# run NAME SCENE OPTIONS...
run() {
    name=$1
    shift
    rm -rf "$folder"
    "$program" simulate "$@" --threads 1 -o "$folder" >"$summary"
    sed -n "s/^\(vertices\|triangles\): \([0-9]*\)$/$name \1,\2,/p" \
        "$summary"
    vertices=$(sed -n 's/^vertices: //p' "$summary")
    awk -F, -v name="$name" -v vertices="$vertices" '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; next }
        {
            steps++
            zones = $at["zone_rounds"]
            failsafe = $at["failsafe_rounds"]
            if (failsafe > 0)
                by_failsafe++
            else if (zones > 0)
                by_zones++
            else
                clear++
            contacts += $at["contacts"]
            held += $at["held"]
            rounds += zones + failsafe
            if ($at["grouped"] > grouped)
                grouped = $at["grouped"]
            if ($at["stretch"] > stretch)
                stretch = $at["stretch"]
            dynamics += $at["dynamics_seconds"]
            response += $at["response_seconds"]
        }
        END {
            print name " steps," steps ","
            print name " clear," clear + 0 ","
            print name " by zones," by_zones + 0 ","
            print name " by failsafe," by_failsafe + 0 ","
            print name " contacts," contacts ","
            printf "%s rounds,%.2f,\n", name, rounds / steps
            print name " held," held ","
            printf "%s grouped,%.2f,%%\n", name, 100 * grouped / vertices
            printf "%s stretch,%.2f,\n", name, stretch
            printf "%s dynamics,%.3f,ms\n", name, 1000 * dynamics / steps
            printf "%s response,%.3f,ms\n", name, 1000 * response / steps
        }' "$folder/steps.csv"
}

for scene in sphere stack twist knot curtain flag plane-chain; do
    run $scene $scene
done
echo "growth steps,$growth_steps,"
for size in 22 39 69 123 181; do
    run "growth $size" sphere --size $size --steps $growth_steps
done
"$coupling"

# Remesh meshes made by another program, see measure.sh:
#
#     remeshing.sh TANGLEFREE [STL]
#
# The meshes are examples of Open CASCADE, as Debian's package occt-misc has
# them in the folder STL.
set -eu
program=$1
examples=${2:-/usr/share/opencascade/data/stl}

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

# Triangles given by the places of their corners become an OBJ: corners at the
# same place become one vertex.
unite() {
    tr -d '\r' <"$1" | awk '
        $1 == "vertex" {
            at = ($2 + 0) " " ($3 + 0) " " ($4 + 0)
            if (!(at in number)) {
                number[at] = ++vertices
                printf "v %.17g %.17g %.17g\n", $2, $3, $4
            }
            corner[count++] = number[at]
        }
        END {
            for (i = 0; i < count; i += 3)
                print "f", corner[i], corner[i + 1], corner[i + 2]
        }'
}

# The least angles of an OBJ and its volume, in lines "name,value".
measure() {
    awk '
        function side(i, j,   k, sum) {
            for (k = 0; k < 3; k++)
                sum += (x[i, k] - x[j, k]) ^ 2
            return sqrt(sum)
        }
        function angle(a, b, c,   cosine) { # opposite to a
            cosine = (b * b + c * c - a * a) / (2 * b * c)
            if (cosine > 1) cosine = 1
            if (cosine < -1) cosine = -1
            return atan2(sqrt(1 - cosine * cosine), cosine) * 45 / atan2(1, 1)
        }
        function least(a, b) { return a < b ? a : b }
        $1 == "v" { n++; for (k = 0; k < 3; k++) x[n, k] = $(k + 2) }
        $1 == "f" {
            a = side($3, $4); b = side($4, $2); c = side($2, $3)
            here = least(angle(a, b, c), least(angle(b, c, a), angle(c, a, b)))
            all = count++ ? least(all, here) : here
            thin += here < 30
            bin[int(least(here, 59.9) / 5)]++
            for (k = 0; k < 3; k++) {
                l = (k + 1) % 3; m = (k + 2) % 3
                minor = x[$3, l] * x[$4, m] - x[$3, m] * x[$4, l]
                volume += x[$2, k] * minor / 6
            }
        }
        END {
            printf "angle,%.4f\nthin,%.3f\nvolume,%.9g\n", all,
                100 * thin / count, volume
            for (i = 0; i < 12; i++)
                printf "%d,%.3f\n", i, 100 * bin[i] / count
        }' "$1"
}

# run NAME FILE EDGE
run() {
    unite "$examples/$2" >"$folder/in.obj"
    "$program" remesh "$folder/in.obj" --edge "$3" -o "$folder/out.obj" \
        >"$folder/report"
    measure "$folder/in.obj" >"$folder/before"
    measure "$folder/out.obj" >"$folder/after"
    sed -n "s/^\([0-9]*\),/$1 before \1,/p" "$folder/before" | sed 's/$/,%/'
    sed -n "s/^\([0-9]*\),/$1 after \1,/p" "$folder/after" | sed 's/$/,%/'
    awk -F, -v name="$1" '
        NR == FNR { before[$1] = $2; next }
        $1 == "angle" {
            print name " angle before," before[$1] ",degrees"
            print name " angle," $2 ",degrees"
        }
        $1 == "thin" {
            print name " thin before," before[$1] ",%"
            print name " thin," $2 ",%"
        }
        $1 == "volume" {
            change = 100 * ($2 / before[$1] - 1)
            printf "%s volume,%.4f,%%\n", name, change < 0 ? -change : change
        }' "$folder/before" "$folder/after"
    awk -F': ' -v name="$1" -v edge="$3" '
        BEGIN {
            kinds = split("impossible collinear overlapping vertices edges " \
                          "triangles", kind, " ")
        }
        /^triangles/ { print name " " $1 "," $2 "," }
        /^distance/ { printf "%s distance,%.3f,%%\n", name, 100 * $2 / edge }
        /^seconds/ { printf "%s seconds,%.2f,s\n", name, $2 }
        /^(splits|collapses|flips|moves):/ {
            print name " " $1 "," $2 ","
            tried += $2
            done += $2
        }
        / (splits|collapses|flips|moves)|(splits|collapses|flips|moves) / {
            tried += $2
            for (i = 1; i <= kinds; i++)
                if (index($1, kind[i]))
                    refused[i] += $2
        }
        END {
            print name " edge," edge ","
            print name " tried," tried ","
            print name " done," done ","
            for (i = 1; i <= kinds; i++)
                print name " " (kind[i] == "triangles" ? "passed" : kind[i]) \
                    "," refused[i] + 0 ","
        }' "$folder/report"
}

run clamp shape.stl 8
run piston sh1.stl 3
run fitting sh2.stl 2

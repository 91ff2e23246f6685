# Check that each file of the renderer uses only those before it:
#
#     nm -P -A scene.o sheets.o ... | awk -f figures/renderer/order.awk
#
# reads the names of the objects in the files' order, and fails with each name
# that a file uses and a later one defines.

{ file = $1; sub(/.*\//, "", file); sub(/\.o.*/, "", file) }

$3 == "U" && !($2 in definer) { users[$2] = users[$2] " " file }

$3 ~ /^[A-TV-Z]$/ {
    definer[$2] = file
    if ($2 in users) {
        print file ".c defines " $2 ", which is used before, by" users[$2] \
            ": see RENDERER in figures/rules.mk" > "/dev/stderr"
        wrong = 1
    }
}

END { exit wrong }

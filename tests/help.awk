# List the targets of makefiles in groups, as `make help` shows them:
#
#     awk -v order='Build|Check' -f tests/help.awk Makefile tests/rules.mk
#
# "##@ Group" begins a group, in any file and as often as needed; a target of it
# is a line "target: prerequisites ## what it does".  Fails if a group isn't in
# the order, or a line is wider than 80 columns.

BEGIN {
    groups = split(order, group, "|")
    for (i = 1; i <= groups; i++)
        lines[group[i]] = ""
}

/^##@ / {
    name = substr($0, 5)
    if (!(name in lines))
        fail("the order of groups lacks '" name "'")
}

/^[a-z-]+:.* ## / {
    line = sprintf("  %-18s  %s", substr($1, 1, index($1, ":") - 1),
                   substr($0, index($0, " ## ") + 4))
    if (length(line) > 80)
        fail("wider than 80 columns in the help")
    lines[name] = lines[name] line "\n"
}

END {
    for (i = 1; i <= groups; i++)
        printf "%s%s:\n%s", (i > 1 ? "\n" : ""), group[i], lines[group[i]]
    exit wrong
}

function fail(why) {
    print FILENAME ":" FNR ": " why > "/dev/stderr"
    wrong = 1
}

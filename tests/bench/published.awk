# Print published.csv as a table, a line a system: what a query costs, as a
# multiple of the cubic's cost, and how often it is wrong.

BEGIN {
    FS = ","
    columns = split("soup point-triangle,soup edge-edge,near point-triangle," \
        "near edge-edge,handcrafted point-triangle extra," \
        "handcrafted point-triangle missed,handcrafted edge-edge extra," \
        "handcrafted edge-edge missed", column)
    printf "\n%-26s %15s %15s %15s %15s\n", "published, cubics", "soup", "near",
        "handmade pt", "handmade ee"
    printf "%-26s %7s %7s %7s %7s %7s %7s %7s %7s\n", "", "pt", "ee", "pt",
        "ee", "extra", "missed", "extra", "missed"
}

# The first line says where the numbers are from.
/^#/ {
    next
}

{
    for (i = 1; i <= columns; i++) {
        size = length($1) - length(column[i])
        if (size > 0 && substr($1, size + 1) == column[i])
            value[substr($1, 11, size - 11), i] = $2
    }
    name = $1
    sub(/^published /, "", name)
    sub(/ (soup|near|handcrafted|start|origin|wrong) .*/, "", name)
    if (!(name in seen)) {
        seen[name]
        system_name[++systems] = name
    }
}

END {
    for (s = 1; s <= systems; s++) {
        printf "%-26s", system_name[s]
        for (i = 1; i <= columns; i++)
            printf " %7s", value[system_name[s], i]
        print ""
    }
}

# Read the description of a library; trim.awk and layouts.awk do.

# An attribute of the element that the line begins.
function attribute(name) {
    if (!match($0, " " name "='[^']*'"))
        return ""
    name = substr($0, RSTART, RLENGTH)
    gsub(/^[^']*'|'$/, "", name)
    return name
}

# The structs that may grow: see growing.awk.
NR == FNR && /^<!-- Tanglefree / {
    count = split($0, word)
    for (i = 1; i <= count; i++)
        grows[word[i]]
}

# The struct or enumeration that the line is in.
/<(class|enum)-decl .*[^\/]>$/ {
    type = attribute("name")
}

/<data-member / {
    offset = attribute("layout-offset-in-bits")
}

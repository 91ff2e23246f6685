# Leave out of the description of a library what may be added to that of an
# older one:
#
#     awk -f description.awk -f trim.awk OLD NEW
#
# prints NEW without the values that enumerations of OLD have got, and without
# the members that its structs have got at their end, if they may grow.  So what
# is still different then is incompatible.  Added functions, which stay, and all
# that is left out are listed on standard error.

function say(what) {
    print "added: " what >"/dev/stderr"
}

# The old one ------------------------------------------------------------------

NR == FNR && /<elf-symbol / {
    symbols[attribute("name")]
}

NR == FNR && /<class-decl / && type {
    size[type] = attribute("size-in-bits")
    end[type] = ""
}

# Where new members begin.  What begins with its size is read up to that, so
# they come after it; elsewhere they may come right after the last member.
NR == FNR && /<var-decl / && type {
    name = attribute("name")
    members[type, name]
    if (end[type] == "")
        sized[type] = name == "size"
    end[type] = sized[type] ? size[type] : offset + 1
}

NR == FNR && /<enumerator / {
    enumerations[type]
    values[type, attribute("name")]
}

NR == FNR {
    if (/<\/(class|enum)-decl>/)
        type = ""
    next
}

# The new one ------------------------------------------------------------------

/<elf-symbol / && !(attribute("name") in symbols) {
    name = attribute("name")
    sub(/^type_/, "type ", name)
    say(name)
}

/<class-decl / && type in grows && type in size {
    sub(/size-in-bits='[0-9]+'/, "size-in-bits='" size[type] "'")
}

/<enumerator / && type in enumerations {
    name = attribute("name")
    if (!((type, name) in values)) {
        say(name " of enum " type)
        next
    }
}

# A member is three lines.
/<data-member / {
    opening = $0
    next
}

opening {
    name = attribute("name")
    drops = type in grows && type in size && offset + 0 >= end[type] + 0 && \
        !((type, name) in members)
    if (drops)
        say(name " of struct " type)
    else
        print opening
    opening = ""
}

!drops {
    print
}

/<\/data-member>/ {
    drops = 0
}

/<\/(class|enum)-decl>/ {
    type = ""
}

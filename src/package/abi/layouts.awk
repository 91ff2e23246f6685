# Turn the description of a library into a program, in C, that asserts where the
# members of its structs are, and what values its enumerations have:
#
#     awk -f description.awk -f layouts.awk DESCRIPTION
#
# It can be compiled, by any compiler and for any machine, as long as
# tanglefree.h is compatible.  Where pointers or longs are no 64 bits wide it
# asserts nothing.

function state(condition) {
    print "_Static_assert(" condition ", \"as it was recorded\");"
}

BEGIN {
    print "#include <limits.h>\n#include <stddef.h>\n#include <stdint.h>"
    print "#include <tanglefree.h>"
    print "#if LONG_MAX > INT_MAX && UINTPTR_MAX == ULONG_MAX"
}

/<class-decl / && type {
    bytes = attribute("size-in-bits") / 8
    first = ""
    state("sizeof(" type ") " (type in grows ? ">=" : "==") " " bytes)
}

/<var-decl / && type {
    member = attribute("name")
    first = first ? first : member
    state("offsetof(" type ", " member ") == " offset / 8)
}

# What begins with its size has no gap at its end, where a member that is added
# could come to lie within what callers take for its size.
/<\/class-decl>/ && first == "size" && type in grows {
    state("offsetof(" type ", " member ") + sizeof(((" type " *)0)->" \
          member ") == " bytes)
}

/<enumerator / {
    state(attribute("name") " == " attribute("value"))
}

/<\/(class|enum)-decl>/ {
    type = ""
}

END {
    print "#endif"
}

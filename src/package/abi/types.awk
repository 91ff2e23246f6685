# Declare an exported variable for each type of tanglefree.h, in C: a
# description of the library has only the types of what is exported, and some
# types are there to count with, or for callers alone.

function use(type, name) {
    print "TF_API " type " *type_" name ";"
}

/^enum [a-z0-9_]+ [{]/ {
    use("enum " $2, $2)
}

/^typedef (enum|struct) [a-z0-9_]+ [{]/ {
    use($3, $3)
}

# Of a function, for callbacks.
/^typedef [a-z_ *]*tf_[a-z0-9_]+[(]/ {
    sub(/[(].*/, "")
    sub(/.*[ *]/, "")
    use($0, $0)
}

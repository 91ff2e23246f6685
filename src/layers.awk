# Check that includes only go down the layers of src/, a folder a layer:
#
#     awk -f src/layers.awk src/*/*.[ch]
#
# prints the layers, the lowest first, and then "from to" for each module that
# another one includes, for the figure of the layers, and fails with the place
# of each arrow that goes up.  The program, and the files and the simulator in
# it, see of the library what its users see: public headers, besides base/ and
# vectors.

BEGIN {
    layers = split("base geometry arithmetic intersect query linear surface " \
                   "fast response surgery remesh topology flow files " \
                   "simulate program", layer)
    for (i = 1; i <= layers; i++) {
        rank[layer[i]] = i
        print layer[i]
    }
}

/^#include "/ {
    from = module_of(FILENAME)
    to = module_of("src/" substr($2, 2))
    if (!(layer_of(to) in rank))
        fail("includes " to ", which is in no layer of src/layers.awk")
    else if (rank[layer_of(to)] > rank[layer_of(from)])
        fail("includes " to ": move what it needs to " layer_of(from) \
             "/ or below")
    else if (is_client(from) && !is_client(to) && layer_of(to) != "base" &&
             to != "geometry/vector" && !is_public(to))
        fail("includes " to ", which is not public")
    else if (from != to && !(from " " to in printed)) {
        printed[from " " to]
        print from, to
    }
}

END { exit wrong }

function module_of(file) {
    sub(/^src\//, "", file)
    sub(/\.[ch]"?$/, "", file)
    return file
}

function layer_of(module) {
    sub(/\/.*/, "", module)
    return module
}

function is_client(module) {
    return layer_of(module) ~ /^(files|simulate|program)$/
}

function is_public(module,    text, found) {
    if (!(module in public)) {
        while ((getline text < ("src/" module ".h")) > 0)
            found = found || text == "#include \"base/api.h\""
        close("src/" module ".h")
        public[module] = found
    }
    return public[module]
}

function fail(what) {
    print FILENAME ":" FNR ": " what > "/dev/stderr"
    wrong = 1
}

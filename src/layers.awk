# Check the order of src/, a folder a layer, a header and its source a module:
#
#     awk -f src/layers.awk src/*/*.[ch]
#
# prints the layers, the lowest first, and then "from to" for each module that
# another one includes, for the figure of the layers.  Fails, and says where, if
# an include goes up the layers or closes a circle of modules, if a function is
# declared in the header of another module than defines it, if a module of the
# library allocates without base/memory.h, or if a folder has more than 45
# files.  The program, and the files, formats, writers, scenes, simulator and
# threads in it, see of the library what its users see: public headers, besides
# base/ and vectors.

BEGIN {
    layers = split("base geometry arithmetic intersect query linear surface " \
                   "fast distance response untangle surgery remesh topology flow files " \
                   "formats writers scenes simulate threads program", layer)
    for (i = 1; i <= layers; i++) {
        rank[layer[i]] = i
        print layer[i]
    }
}

FNR == 1 {
    from = module_of(FILENAME)
    if (++files[layer_of(from)] == 46)
        fail("is the 46th file of its folder: divide the folder")
}

/^#include "/ {
    to = module_of("src/" substr($2, 2))
    if (!(layer_of(to) in rank))
        fail("includes " to ", which is in no layer of src/layers.awk")
    else if (rank[layer_of(to)] > rank[layer_of(from)])
        fail("includes " to ": move what it needs to " layer_of(from) \
             "/ or below")
    else if (is_client(from) && !is_client(to) && layer_of(to) != "base" &&
             to != "geometry/vector" && !is_public(to))
        fail("includes " to ", which is not public")
    else if (from != to && !((from, to) in included)) {
        included[from, to]
        includes[from] = includes[from] " " to
        print from, to
    }
}

# In some C libraries qsort allocates, too.
/(^|[^a-z_])(malloc|calloc|realloc|aligned_alloc|strdup|qsort|free)\(/ {
    if (from != "base/memory" && !is_client(from))
        fail("use tf_allocate, tf_release or tf_sort of the library")
}

# The name of a function is before the first bracket of a line that begins with
# its type; the end of its declaration may be lines below.
/^[A-Za-z].*[ *]tf_[a-z0-9_]+\(/ && !/^(static|typedef)/ {
    match($0, /tf_[a-z0-9_]+\(/)
    name = substr($0, RSTART, RLENGTH - 1)
    place = FILENAME ":" FNR
}

name && /[;{]/ {
    if (/\{/)
        definer[name] = from
    else {
        declarer[name] = from
        declared[name] = place
    }
    name = ""
}

END {
    for (name in declarer)
        if (name in definer && definer[name] != declarer[name])
            complain(declared[name] ": declares " name ", which " \
                     definer[name] ".c defines")
    for (module in includes)
        visit(module)
    exit wrong
}

# Follow all includes of a module, in search of one that is still open.
function visit(module,    to, count, i) {
    if (module in state) {
        if (state[module] == "open")
            complain("a circle of includes: " circle_to(module))
        return
    }
    state[module] = "open"
    path[++depth] = module
    count = split(includes[module], to, " ")
    for (i = 1; i <= count; i++)
        visit(to[i])
    state[module] = "closed"
    depth--
}

function circle_to(module,    circle, i) {
    circle = module
    for (i = depth; path[i] != module; i--)
        circle = path[i] " - " circle
    return module " - " circle
}

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
    return layer_of(module) ~ /^(files|formats|writers|scenes|simulate|threads|program)$/
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
    complain(FILENAME ":" FNR ": " what)
}

function complain(what) {
    print what > "/dev/stderr"
    wrong = 1
}

# Make one file of the library, tanglefree.c, or of a library upon it; see
# source.awk.
#
# A header of src/ that is not public is pasted before the first file that
# includes it; the public ones are in tanglefree.h or its like.  What files name for
# themselves stays theirs: a macro ends with its file, and where two files give
# the same name to a function, an object, a type or a constant, each calls it
# otherwise.

BEGIN {
    for (i = 1; i < ARGC; i++) {
        add_file(ARGV[i] ".h")
        add_file(ARGV[i] ".c")
    }
    for (i = 1; i <= files; i++)
        find_names(file[i])

    out_top()
    for (i = 1; i <= files; i++)
        paste(file[i])
    exit
}

function add_file(name) {
    if (load(name) && is_made(name)) {
        file[++files] = name
        is_file[name] = 1
    }
}

function out_top() {
    out("// Tanglefree " version ", " (added ? added " " : "") \
        "in one file: exact continuous collision detection.")
    out("//")
    out("// Made of the library's modules; a line of dashes begins a file of " \
        "src/.")
    out("//")
    out_license("")
    out_extension()
    out("#include \"" made_name() ".h\"")
    out_standard(files, file)
    out("// A product and a sum that are rounded as one would give other bits.")
    out("#ifdef __clang__\n#pragma STDC FP_CONTRACT OFF\n#else")
    out("#pragma GCC optimize(\"fp-contract=off\")\n#endif")
}

# Before anything of the C library, and unless an option did it.
function out_extension(    name) {
    for (name in extended)
        if (name in is_file) {
            out("#ifndef _GNU_SOURCE\n#define _GNU_SOURCE\n#endif")
            return
        }
}

function paste(name,    i) {
    if (name in pasted || name ~ /\.h$/ && is_public(name))
        return
    if (!(name in is_file))
        fail("the library includes " src "/" name ", which is not in it")
    pasted[name] = 1
    for (i = 1; i <= uses[name]; i++)
        paste(used[name, i])
    out_heading(name)
    out_new_names(name)
    out_lines(name)
    out_ends(name)
}

# Names ------------------------------------------------------------------------

#   own[file, 1..owns[file]]         names at file scope without tf_
#   macro[file, 1..macros[file]]     macros, of .c files alone
#   owners[name]                     how many files have the name

function find_names(file,    i, text) {
    for (i = 1; i <= lines[file]; i++) {
        text = line[file, i]
        if (text ~ /^#define / && file ~ /\.c$/)
            add_macro(file, text)
        else if (text ~ /^[}] [a-z_0-9]+;/ && type)
            add_name(file, text)
        else if (text ~ /^[a-z_]/)
            i = read_declaration(file, i)
        if (constants)
            add_constants(file, line[file, i])
        if (text ~ /^[}]/)
            constants = type = 0
    }
}

# From the line i on; the last line that was read.
function read_declaration(file, i,    text) {
    text = line[file, i]
    while (text !~ /[;={(]/ && i < lines[file])
        text = text " " line[file, ++i]
    type = text ~ /^typedef /
    constants = text ~ /^(typedef )?enum [a-z_0-9 ]*[{]$/
    if (text ~ /^(static|typedef|struct|enum) /)
        add_name(file, text)
    return i
}

# The identifier before the parameters, size, value, body or end.
function add_name(file, text) {
    sub(/[[(={;].*/, "", text)
    sub(/ *$/, "", text)
    sub(/.*[^A-Za-z0-9_]/, "", text)
    if (text ~ /^$|^(tf|TF)_|^(struct|enum|union)$/ || (file, text) in has)
        return
    has[file, text] = 1
    own[file, ++owns[file]] = text
    owners[text]++
}

function add_constants(file, text,    i, n, part) {
    sub(/\/\/.*/, "", text)
    sub(/.*[{]/, "", text)
    sub(/[}].*/, "", text)
    n = split(text, part, ",")
    for (i = 1; i <= n; i++)
        add_name(file, part[i])
}

function add_macro(file, text) {
    sub(/^#define /, "", text)
    sub(/[^A-Za-z0-9_].*/, "", text)
    macro[file, ++macros[file]] = text
}

# What a name that others have too is called in this file: by its module.
function new_name(file, name) {
    gsub(/\//, "_", file)
    sub(/\..*/, "", file)
    return file "_" name
}

function out_new_names(file,    i, name) {
    for (i = 1; i <= owns[file]; i++) {
        name = own[file, i]
        if (owners[name] > 1)
            out("#define " name " " new_name(file, name))
    }
    out("")
}

function out_ends(file,    i) {
    for (i = 1; i <= macros[file]; i++)
        out("#undef " macro[file, i])
    for (i = 1; i <= owns[file]; i++)
        if (owners[own[file, i]] > 1)
            out("#undef " own[file, i])
}

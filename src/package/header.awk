# Make tanglefree.h of the library's public headers, or that of a library upon
# it; see source.awk.

BEGIN {
    for (i = 1; i < ARGC; i++)
        read_module(ARGV[i])
    put_study_last()
    check_order()
    keep_made()

    out_top()
    out_standard(headers, header)
    out("#ifdef __cplusplus\nextern \"C\" {\n#endif")
    for (i = 1; i <= headers; i++) {
        if (i == products + 1)
            out_study()
        out_heading(module_of(header[i]))
        out_lines(header[i])
    }
    out("#ifdef __cplusplus\n}\n#endif")
    out("")
    out("#endif")
    exit
}

function read_module(module,    file, i) {
    file = module ".h"
    if (!load(file))
        return
    if (is_public(file)) {
        header[++headers] = file
        return
    }
    for (i = 1; i <= lines[file]; i++)
        if (line[file, i] ~ /^TF_API /)
            fail(src "/" file " has TF_API, so it must include \"base/api.h\"")
}

# What is for study comes after the rest, in the same order.
#   header[1..products]            what products need
#   header[products + 1..headers]  what is for study
function put_study_last(    i, n, study) {
    for (i = 1; i <= headers; i++)
        if (is_for_study(header[i]))
            study[++n] = header[i]
        else
            header[++products] = header[i]
    for (i = 1; i <= n; i++)
        header[products + i] = study[i]
}

# Whether its names are in the group "study" of the reference.
function is_for_study(file,    i) {
    for (i = 1; i <= lines[file]; i++)
        if (line[file, i] ~ /^\/\/\/ @(addto|def)group study( |$)/)
            return 1
    return 0
}

function check_order(    i, j, file, other, seen) {
    for (i = 1; i <= headers; i++) {
        file = header[i]
        for (j = 1; j <= uses[file]; j++) {
            other = used[file, j]
            if (!is_public(other))
                fail(src "/" file " is public, but includes \"" other \
                     "\", which is not: it does not include \"base/api.h\"")
            if (!(other in seen))
                fail(src "/" file " includes \"" other "\", which comes " \
                     "later: in book/chapters, or as it is for study")
        }
        seen[file] = 1
    }
}

# The others are in tanglefree.h.
function keep_made(    i, count, kept) {
    for (i = 1; i <= headers; i++)
        if (is_made(header[i])) {
            header[++count] = header[i]
            kept += i <= products
        }
    products = kept
    headers = count
}

function module_of(file) {
    return substr(file, 1, length(file) - 2)
}

function out_top(    guard) {
    out("// Tanglefree " version ": exact continuous collision detection.")
    out("//")
    out_license("^Copyright")
    out("// SPDX-License-Identifier: MIT")
    out("//")
    out("// Made of the public headers of these modules, in this order:")
    out_modules(1, products)
    if (products < headers) {
        out("//\n// At the end is what is for study, and no product needs:")
        out_modules(products + 1, headers)
    }
    guard = toupper(made_name()) "_H"
    out("#ifndef " guard "\n#define " guard)
    if (added)
        out("\n#include \"tanglefree.h\"")
}

# In lines of at most 80 columns.
function out_modules(first, last,    i, text, name) {
    text = "//"
    for (i = first; i <= last; i++) {
        name = " " module_of(header[i]) (i < last ? "," : ".")
        if (length(text name) > 80) {
            out(text)
            text = "//"
        }
        text = text name
    }
    out(text)
}

function out_study(    rule) {
    rule = "// "
    while (length(rule) < 80)
        rule = rule "="
    out("")
    out(rule "\n// For study: no product needs what follows.\n" rule)
}

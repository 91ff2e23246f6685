# Read the files of src/ to paste them together; header.awk and single.awk do.
#
# They are called in the folder where LICENSE is, as
#
#     awk -f source.awk -f header.awk -v src=DIR -v version=V MODULE...
#
# with the library's modules in the order of book/chapters, and print what they
# make.  A header is public if it includes "base/api.h", or is it.
#
# With -v added=FOLDER they make the files of a library that is built upon it,
# tanglefree_FOLDER.h and .c, of those modules that are in this folder.

function is_made(file) {
    return !added || index(file, added "/") == 1
}

function made_name() {
    return added ? "tanglefree_" added : "tanglefree"
}

# Read a file of src/; false if there is none.
#   line[file, 1..lines[file]]   the code, without `#pragma once`, includes,
#                                their title and, in headers, all titles
#   used[file, 1..uses[file]]    what it includes of src/
#   asked[file, 1..asks[file]]   what it includes of the C library
#   extended[file]               whether it sees all of that: _GNU_SOURCE
function load(file,    path, text, title, depth, status) {
    path = src "/" file
    while ((status = getline text <path) > 0) {
        if (text ~ /^\/\/: /) {
            title = text
            continue
        }
        if (title && file ~ /\.c$/ && text !~ /^# *(include|define _GNU_SOURCE)/)
            add_line(file, title)
        title = ""
        depth += (text ~ /^# *if/) - (text ~ /^# *endif/)
        if (text ~ /^#/)
            read_directive(file, text, depth)
        else
            add_line(file, text)
    }
    close(path)
    return status == 0
}

function add_line(file, text) {
    sub(/\/\/: /, "// ", text)
    line[file, ++lines[file]] = text
}

# What is within #if stays there.
function read_directive(file, text, depth,    name) {
    name = text
    gsub(/^# *include *["<]|[">].*/, "", name)
    if (text ~ /^# *include *"/) {
        if (depth > 0)
            fail(src "/" file " includes \"" name "\" within #if")
        used[file, ++uses[file]] = name
    } else if (text ~ /^# *include *</ && depth == 0) {
        asked[file, ++asks[file]] = name
    } else if (text ~ /^#define _GNU_SOURCE/) {
        extended[file] = 1
    } else if (text != "#pragma once") {
        add_line(file, text)
    }
}

function is_public(file,    i) {
    for (i = 1; i <= uses[file]; i++)
        if (used[file, i] == "base/api.h")
            return 1
    return file == "base/api.h"
}

# Print a line; in place of any number of empty ones, one, but none on top.
function out(text) {
    if (text == "") {
        blank = 1
        return
    }
    if (blank && printed)
        print ""
    blank = 0
    printed = 1
    print text
}

function out_heading(title) {
    title = "// " title " "
    while (length(title) < 80)
        title = title "-"
    out("")
    out(title)
    out("")
}

function out_lines(file,    i) {
    for (i = 1; i <= lines[file]; i++)
        out(line[file, i])
    out("")
}

# The headers of the C library that these files include, sorted.
function out_standard(count, files,    i, j, n, sorted, seen) {
    for (i = 1; i <= count; i++)
        for (j = 1; j <= asks[files[i]]; j++)
            if (!seen[asked[files[i], j]]++)
                insert(sorted, ++n, asked[files[i], j])
    out("")
    for (i = 1; i <= n; i++)
        out("#include <" sorted[i] ">")
    out("")
}

function insert(sorted, n, name) {
    for (; n > 1 && sorted[n - 1] > name; n--)
        sorted[n] = sorted[n - 1]
    sorted[n] = name
}

# The lines of LICENSE that match a pattern, as comments.
function out_license(pattern,    text) {
    while ((getline text <"LICENSE") > 0)
        if (text ~ pattern)
            out(text == "" ? "//" : "// " text)
    close("LICENSE")
}

function fail(message) {
    print message >"/dev/stderr"
    exit 1
}

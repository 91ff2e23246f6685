# Make C of what the files of the manual pages have for --help: a text for each,
# its name, \v, and its paragraphs.
#
#     awk -f help.awk tanglefree-query.1 ...

FNR == 1 && NR > 1 { print_text() }
FNR == 1 {
    command = FILENAME
    gsub(/.*tanglefree-|\.1$/, "", command)
    count = inside = 0
}

/^\.Nd / { purpose = toupper(substr($0, 5, 1)) substr($0, 6) "." }

/^\.Help / {
    inside = $2
    count = $2 > count ? $2 : count
    paragraph[inside] = ""
    next
}
/^\.End$/ { inside = 0 }

# A line that ends with a stop ends a sentence.
inside {
    before = paragraph[inside]
    paragraph[inside] = before (before == "" ? "" : before ~ /\.$/ ? "  " : " ") $0
}

END { print_text() }

function print_text(    i) {
    printf "const char tf_%s_description[] =\n    \"%s\\v\"", command, purpose
    for (i = 1; i <= count; i++) {
        gsub(/["\\]/, "\\\\&", paragraph[i])
        printf "\n    \"%s%s\"", paragraph[i], i < count ? "\\n\\n" : ""
    }
    print ";"
}

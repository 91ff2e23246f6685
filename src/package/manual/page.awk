# Make the manual page of a command from its help and from a file of what else
# there is to say:
#
#     tanglefree query --help | awk -f page.awk - tanglefree-query.1
#
# The file is mdoc from DESCRIPTION on, with three macros more:
#
#     .Help N       the N-th paragraph of the help behind its options
#     .Commands     the list of the commands
#     .Options      the list of the options, up to .End: behind ".It NAME" is
#                   what follows the help of the option --NAME
#
# Each paragraph must be in the page, and each option that the file names must
# be one.

# The help ---------------------------------------------------------------------

NR == FNR && /^Usage: |^  or:  / {
    sub(/^Usage: |^  or:  /, "")
    sub(/\[OPTION\.\.\.\] ?/, "")
    usage[++usages] = $0
    next
}

# What the program is comes before its options.
NR == FNR && !seen_options && !/^ *-/ {
    purpose = join(purpose, $0)
    next
}

NR == FNR && /^ +(-.,)? *--[a-z]/ {
    seen_options = in_options = 1
    begin_option($0)
    next
}

NR == FNR && in_options && /^ /  {
    help[options] = join(help[options], trimmed($0))
    next
}

# argp says this of all options.
NR == FNR && /^Mandatory or optional arguments/ { skipping = 1 }

NR == FNR && /^$/ {
    in_options = in_commands = skipping = 0
    paragraph_ended = 1
    next
}

NR == FNR && /^Commands:$/ { in_commands = 1; next }

NR == FNR && in_commands {
    command[++commands] = $1
    sub(/^ *[a-z]+ */, "")
    does[commands] = $0
    next
}

NR == FNR && !skipping {
    paragraphs += paragraph_ended
    paragraph_ended = 0
    paragraph[paragraphs] = join(paragraph[paragraphs], $0)
}

NR == FNR { next }

# The page ---------------------------------------------------------------------

# The date comes first.
FNR == 1 {
    print
    print_head()
    next
}

/^\.Help / {
    sub(/^Exit status: /, "", paragraph[$2])
    print_text(paragraph[$2])
    used[$2] = 1
    next
}

/^\.Commands$/ { print_commands(); next }
/^\.Options$/ { in_list = 1; next }

/^\.It / && in_list && !/^\.It (Cm|Va|Ar)/ {
    current = $2
    known[current] = 0
    next
}

/^\.End$/ && in_list {
    print_options()
    in_list = 0
    next
}

in_list { more[current] = more[current] $0 "\n"; next }
{ print }

END {
    if (!options)
        fail("there is no help")
    for (i = 1; i <= paragraphs; i++)
        if (!(i in used))
            fail("paragraph " i " of the help is not in the page")
    for (name in known)
        if (!known[name])
            fail("there is no option --" name)
    exit wrong
}

# Text -------------------------------------------------------------------------

function fail(what) {
    print "page.awk: " FILENAME ": " what > "/dev/stderr"
    wrong = 1
}

function trimmed(text) {
    gsub(/^ +| +$/, "", text)
    return text
}

# A line that ends with a stop ends a sentence.
function join(before, line) {
    if (line == "")
        return before
    return before == "" ? line : before (before ~ /\.$/ ? "  " : " ") line
}

function escaped(text) {
    gsub(/\\/, "\\e", text)
    gsub(/--/, "\\-\\-", text)
    gsub(/e-/, "e\\-", text)
    gsub(/"-"/, "\"\\-\"", text)
    return text
}

# A sentence a line, as mdoc has it, folded to 78 columns.
function print_text(text,    words, word, count, i, line) {
    text = escaped(text)
    gsub(/\.  /, ".\n", text)
    count = split(text, sentence, "\n")
    for (s = 1; s <= count; s++) {
        words = split(sentence[s], word, " ")
        line = ""
        for (i = 1; i <= words; i++) {
            if (line != "" && length(line) + length(word[i]) > 77) {
                print line
                line = ""
            }
            if (line == "" && word[i] ~ /^[.']/)
                word[i] = "\\&" word[i]
            line = line (line == "" ? "" : " ") word[i]
        }
        print line
    }
}

# The parts of the page --------------------------------------------------------

# The program's own name is `tanglefree`, that of a command "tanglefree query".
function print_head(    name, i) {
    name = usage[1]
    match(name, /^[a-z ]+[a-z]/)
    name = substr(name, 1, RLENGTH)
    page = name
    gsub(/ /, "-", page)
    print ".Dt " toupper(page) " 1\n.Os\n.Sh NAME\n.Nm " page
    sub(/\.$/, "", purpose)
    print ".Nd " tolower(substr(purpose, 1, 1)) substr(purpose, 2)
    print ".Sh SYNOPSIS"
    for (i = 1; i <= usages; i++)
        print_usage(name, trimmed(substr(usage[i], length(name) + 1)), i == 1)
    print ".Nm " name "\n.Fl \\&? | V | Fl -help | -usage | -version"
}

function print_usage(name, operands, with_options,    count, word, i) {
    print ".Nm " name
    for (i = 1; i <= options && with_options; i++)
        if (!is_common(i))
            print (help[i] ~ /; required$/ ? "" : ".Op ") \
                (help[i] ~ /; required$/ ? "." : "") shortest(i)
    count = split(operands, word, " ")
    for (i = 1; i <= count; i++) {
        sub(/\.\.\./, " ...", word[i])
        if (word[i] ~ /^\[/) {
            gsub(/[\[\]]/, "", word[i])
            print ".Op Ar " word[i]
        } else if (word[i] ~ /^[a-z]/)
            print ".Cm " word[i]
        else
            print ".Ar " word[i]
    }
}

# "  -k, --kind=KIND   Which ..."
function begin_option(line,    field) {
    options++
    if (line ~ /^  -/)
        letter[options] = substr(line, 4, 1)
    match(line, /--[a-z-]+(=[A-Z]+)?/)
    field = substr(line, RSTART + 2, RLENGTH - 2)
    help[options] = trimmed(substr(line, RSTART + RLENGTH))
    name_of[options] = field
    sub(/=.*/, "", name_of[options])
    if (sub(/.*=/, "", field))
        argument[options] = field
}

# What all commands have, and argp describes.
function is_common(i) {
    return name_of[i] ~ /^(help|usage|version)$/
}

function shortest(i) {
    return letter[i] != "" \
        ? "Fl " shown_letter(i) (argument[i] ? " Ar " argument[i] : "") \
        : long_form(i)
}

function shown_letter(i) {
    return letter[i] == "?" ? "\\&?" : letter[i]
}

function long_form(i) {
    return "Fl -" name_of[i] (argument[i] ? " Ns = Ns Ar " argument[i] : "")
}

function print_options(    i) {
    print ".Pp\nThe options are:\n.Bl -tag -width Ds"
    for (i = 1; i <= options; i++) {
        print ".It " (letter[i] ? shortest(i) " , " : "") long_form(i)
        print_text(help[i] ".")
        if (name_of[i] in known)
            known[name_of[i]] = 1
        printf "%s", more[name_of[i]]
    }
    print ".El"
}

function print_commands(    i) {
    print ".Pp\nThe commands are:\n.Bl -tag -width Ds"
    for (i = 1; i <= commands; i++) {
        print ".It Cm " command[i]
        print toupper(substr(does[i], 1, 1)) substr(does[i], 2) "; see"
        print ".Xr tanglefree-" command[i] " 1 ."
    }
    print ".El"
}

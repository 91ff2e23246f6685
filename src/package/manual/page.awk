# Make the manual page of a command from its help and from its file here:
#
#     tanglefree query --help | awk -f page.awk - tanglefree-query.1
#
# The file begins with the date and the name (.Dd, .Nd), and is mdoc from
# DESCRIPTION on, with three macros more:
#
#     .Help N       up to .End, a paragraph that --help says, too: the N-th of
#                   those behind the options, as plain text
#     .Commands     the list of the commands
#     .Options      the list of the options, up to .End: behind ".It NAME" is
#                   what follows the help of the option --NAME

# The help ---------------------------------------------------------------------

NR == FNR && /^Usage: |^  or:  / {
    sub(/^Usage: |^  or:  /, "")
    sub(/\[OPTION\.\.\.\] ?/, "")
    usage[++usages] = $0
}

NR == FNR && /^$/ { in_options = in_commands = 0 }
NR == FNR && /^ +(-.,)? *--[a-z]/ { in_options = begin_option($0) }
NR == FNR && in_options && /^          / {
    help[options] = join(help[options], trimmed($0))
}

NR == FNR && in_commands {
    command[++commands] = $1
    sub(/^ *[a-z]+ */, "")
    does[commands] = $0
}
NR == FNR && /^Commands:$/ { in_commands = 1 }
NR == FNR { next }

# The page ---------------------------------------------------------------------

/^\.Nd / { print_head($0); next }
/^\.Commands$/ { print_commands(); next }
/^\.Help / { in_text = 1; text = ""; next }
/^\.Options$/ { in_list = 1; next }

/^\.End$/ {
    if (in_text)
        print_text(text)
    if (in_list)
        print_options()
    in_text = in_list = 0
    next
}

/^\.It / && in_list && !/^\.It (Cm|Va|Ar)/ {
    current = $2
    known[current] = 0
    next
}

in_text { text = join(text, $0); next }
in_list { more[current] = more[current] $0 "\n"; next }
{ print }

END {
    if (!options)
        fail("there is no help")
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
    sub(/^Exit status: /, "", text)
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
function print_head(purpose,    name, i) {
    name = usage[1]
    match(name, /^[a-z ]+[a-z]/)
    name = substr(name, 1, RLENGTH)
    page = name
    gsub(/ /, "-", page)
    print ".Dt " toupper(page) " 1\n.Os\n.Sh NAME\n.Nm " page
    print purpose "\n.Sh SYNOPSIS"
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
    return 1
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

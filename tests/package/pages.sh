# See that the manual pages and README.md show what is so.
. tests/package/common.sh

try_session() { # folder to be in, file of lines "$ command" and their output
    sed -n 's/^\$ //p' "$2" >"$2.sh"
    [ -s "$2.sh" ] || fail "$2 shows no command"
    (cd "$1" && PATH="$prefix/bin:$PATH" sh "$2.sh") >"$2.answers"
    grep -v '^\$ ' "$2" | diff - "$2.answers" ||
        fail "a session prints something else (>) than it shows (<)"
}

# As the help lists them: "  -k, --kind=KIND ...", "  -T, --at=T, --time=T ..."
# and "      --usage ...".
list_help_options() { # program; commands, "" for none
    program=$1
    shift
    for command; do
        "$prefix/bin/$program" $command --help |
            sed -n 's/^  \(-.\), \(--[a-z-]*\)[^ ]*, \(--[a-z-]*\).*/\1 \2 \3/p
                s/^  \(    \|-.\), *\(--[a-z-]*\).*/\1 \2/p
                s/^      \(--[a-z-]*\).*/\1/p' | tr -s ' ' '\n'
    done | grep . | LC_ALL=C sort -u
}

# As the page lists them: ".It Fl k Ar kind , Fl -kind ...".
list_page_options() { # page
    sed -n 's/^\.It Fl/Fl/p' "$1" | sed 's/\\&//g; s/Fl /\n-/g' |
        sed -n 's/^\(-[^ ]*\).*/\1/p' | LC_ALL=C sort -u
}

# Faults of a page, and its session.
check_text() { # page
    mandoc -T lint "$1" 2>&1 |
        grep -v 'referenced manual not found\|mandoc\.db' &&
        fail "$1 has faults"
    sed -n '/^\.Bd -literal/,/^\.Ed/{/^\./d;s/\\-/-/g;s/\\e/\\/g;p}' "$1" \
        >"$scratch/page"
    try_session "$scratch" "$scratch/page"
}

check_page() { # page, program, commands
    page=$prefix/share/man/man1/$1.1
    shift
    list_page_options "$page" >"$scratch/options"
    list_help_options "$@" | diff "$scratch/options" - ||
        fail "$page has other options (<) than --help (>)"
    check_text "$page"
}

check_page tanglefree tanglefree ''
check_page tanglefree-query tanglefree query
check_page tanglefree-detect tanglefree detect
check_page tanglefree-check tanglefree check
check_page tanglefree-resolve tanglefree resolve
check_page tanglefree-remesh tanglefree remesh
check_page tanglefree-simulate tanglefree simulate
check_page tanglefree-weld tanglefree weld
check_page tanglefree-untangle tanglefree untangle
check_page tanglefree-draw tanglefree-draw list figure query surface film
check_text "$prefix/share/man/man5/tanglefree-formats.5"
readme console | sed 's|build/tanglefree|tanglefree|' >"$scratch/session"
try_session . "$scratch/session"

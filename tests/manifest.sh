# Compare book/chapters and README.md with src/ and tests/, and print what does
# not fit.
set -eu
export LC_ALL=C

scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
: >"$scratch/complaints"

complain() { # why the lines of the input are wrong
    sed "s|\$| $1|" >>"$scratch/complaints"
}

# Of the lines of sorted files, those that only the first has.
without() {
    comm -23 "$scratch/$1" "$scratch/$2"
}

# Each file has modules, without endings; `code` those of them with a .c file.
awk '/^[a-z]/ { for (i = 2; i <= NF; i++) print $i }' book/chapters |
    sort >"$scratch/listed"
sort -u "$scratch/listed" >"$scratch/manifest"
(cd src && find * -name '*.[ch]') | sed 's/\.[ch]$//' | sort -u >"$scratch/src"
(cd src && find * -name '*.c') | sed 's/\.c$//' | sort >"$scratch/code"
(cd tests && find * -name '*.c') | sed 's/\.c$//' | sort |
    grep -Ev '^(support|whole|fuzz|soak|bench|renderer|draw|kit|figures|package)/' \
        >"$scratch/tests"

awk '/^[a-z]/ { print $1 }' book/chapters | sort | uniq -d |
    complain 'names two chapters'
uniq -d "$scratch/listed" | complain 'is in book/chapters twice'
without manifest src | complain 'is in book/chapters but not in src/'
without src manifest | complain 'is in src/ but in no line of book/chapters'
without tests src | complain 'is in tests/ but tests no module'
without code tests | grep -vx program/main |
    complain 'is in src/ but has no test in tests/'

# What README.md names, folders of src/ and modules by symptoms, and what
# CONTRIBUTING.md does.
(cd src && echo */) | tr ' ' '\n' | sort >"$scratch/folders"
sed -n 's|^. `src/\([a-z]*/\)`.*|\1|p' README.md | sort >"$scratch/shown"
grep -ohE '`(src/)?[a-z]+/[a-z_]+\.[ch]`' README.md CONTRIBUTING.md |
    tr -d '`' | sed 's/^src.//; s/\.[ch]$//' | sort -u >"$scratch/named"
without folders shown | complain 'is a folder of src/ that README.md lacks'
without shown folders | complain 'is in README.md but no folder of src/'
without named src | complain 'is in README.md or CONTRIBUTING.md but not in src/'

# MyST reads the words of a picture as YAML, to which ": " begins a value.
grep -n '^:alt: .*: ' book/*.md | cut -c1-60 | complain '... has ": " in its words'

cat "$scratch/complaints"
[ ! -s "$scratch/complaints" ]

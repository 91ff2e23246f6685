# Paste a small library of its own: names that files share stay apart, what is
# for study comes last, a library upon it has files of its own, and headers that
# do not go together are refused.
#
#     BUILD=dir paste.sh
#
# `make check-single` runs this in the folder of the Makefile.
set -eu

scratch=$BUILD/single/paste
src=$scratch/src

fail() {
    echo "check-single: $*" >&2
    exit 1
}

paste() { # what, modules
    script=src/package/$1.awk
    shift
    awk -f src/package/source.awk -f "$script" -v "src=$src" -v version=1 "$@"
}

file() { # path
    mkdir -p "$(dirname "$src/$1")"
    cat >"$src/$1"
}

# Two files that call all their own things alike: a macro, a constant, a type,
# an object and a function.
two_alike() {
    for letter in a b; do
        file one/$letter.c <<END
//: Include what it needs
#include "one/hidden.h"
#include "one/$letter.h"
#include <stdlib.h>

//: Name things
#define FACTOR $1
enum {
    FIRST = $1,
    SECOND,
};

typedef struct element {
    int number;
} element;

static const element elements[] = {{FACTOR}, {SECOND}};

static int
number(int i)
{
    return elements[i].number;
}

int tf_$letter(void)
{
    //: Add them
    return abs(-number(0)) + number(1) + FIRST + HIDDEN;
}
END
        printf '%s\n' '//: Declare it' '#pragma once' '' \
            '#include "base/api.h"' '' \
            "TF_API int tf_$letter(void); ///< all" | file one/$letter.h
        shift
    done
}

expect_numbers() {
    paste header base/api one/a one/b >"$scratch/tanglefree.h"
    paste single base/api one/hidden one/a one/b >"$scratch/tanglefree.c"
    cat >"$scratch/main.c" <<'END'
#include "tanglefree.h"
#include "tanglefree.h"
int main(void)
{
    return tf_a() == 4 + 5 && tf_b() == 31 + 5 ? 0 : 1;
}
END
    gcc -Wall -Wextra -Wpedantic -Werror "$scratch/tanglefree.c" \
        "$scratch/main.c" -o "$scratch/main"
    "$scratch/main" || fail "names that two files share got mixed up"
    [ "$(grep -c 'HIDDEN 5' "$scratch/tanglefree.c")" = 1 ] ||
        fail "a header is not pasted once"
    ! grep '//:' "$scratch"/tanglefree.[ch] || fail "a fragment title is left"
}

# A header for study comes last, and what products need does not include it.
expect_study_last() {
    printf '%s\n' '#pragma once' '#include "base/api.h"' \
        '/// @addtogroup study' 'TF_API extern int tf_study;' |
        file one/study.h
    paste header base/api one/study one/a one/b >"$scratch/tanglefree.h"
    order=$(sed -n 's/^TF_API.* \(tf_[a-z]*\).*/\1/p; s/^\/\/ For study.*/-/p' \
        "$scratch/tanglefree.h" | tr '\n' ' ')
    [ "$order" = 'tf_a tf_b - tf_study ' ] || fail "the order is $order"
}

# A library upon it sees what is public alone, and all of the C library.
expect_upon() {
    printf '%s\n' '#pragma once' '#include "base/api.h"' '#include "one/a.h"' \
        'TF_API int tf_upon(void);' | file upon/upon.h
    file upon/upon.c <<'END'
//: Include what it needs
#define _GNU_SOURCE // strchrnul
#include "upon/upon.h"
#include <string.h>

//: Count
int tf_upon(void)
{
    return tf_a() + *strchrnul("upon", 'x');
}
END
    paste header base/api one/a one/b >"$scratch/tanglefree.h"
    for what in header.h single.c; do
        paste ${what%.*} -v added=upon base/api one/hidden one/a one/b \
            upon/upon >"$scratch/tanglefree_upon.${what#*.}"
    done
    printf '%s\n' '#include "tanglefree_upon.h"' \
        'int main(void) { return tf_upon() == 4 + 5 ? 0 : 1; }' \
        >"$scratch/main.c"
    for option in -std=c17 -D_GNU_SOURCE; do
        gcc -Wall -Wextra -Wpedantic -Werror $option "$scratch/main.c" \
            "$scratch/tanglefree.c" "$scratch/tanglefree_upon.c" \
            -o "$scratch/main"
        "$scratch/main" || fail "a library upon it is wrong"
    done
    ! grep 'tf_b' "$scratch"/tanglefree_upon.[ch] || fail "too much is upon it"
    echo '#include "one/hidden.h"' >>"$src/upon/upon.c"
    expect_refusal 'one/hidden.h, which is not in it' single -v added=upon \
        base/api one/hidden one/a upon/upon
}

expect_refusal() { # words of the complaint, what, modules
    words=$1
    shift
    ! paste "$@" >/dev/null 2>"$scratch/complaint" ||
        fail "$* is not refused: $words"
    grep -qF "$words" "$scratch/complaint" || fail "$(cat "$scratch/complaint")"
}

rm -rf "$scratch"
printf '#pragma once\n#define TF_API\n' | file base/api.h
printf '#pragma once\n#define HIDDEN 5\n' | file one/hidden.h
two_alike 1 10
expect_numbers

printf '#pragma once\n#include "base/api.h"\n#include "one/hidden.h"\n' |
    file one/leak.h
expect_refusal 'one/leak.h is public, but includes "one/hidden.h"' \
    header base/api one/hidden one/leak
printf '#pragma once\n#include "base/api.h"\n#include "one/a.h"\n' |
    file one/early.h
expect_refusal 'one/early.h includes "one/a.h", which comes later' \
    header base/api one/early one/a
printf '#pragma once\n\nTF_API int tf_c(void);\n' | file one/c.h
expect_refusal 'one/c.h has TF_API, so it must include "base/api.h"' \
    header base/api one/c
expect_refusal 'one/hidden.h, which is not in it' single base/api one/a
expect_upon
expect_study_last
printf '#pragma once\n#include "base/api.h"\n#include "one/study.h"\n' |
    file one/product.h
expect_refusal 'one/product.h includes "one/study.h", which comes later' \
    header base/api one/study one/product
echo 'Names that files share stay apart, what is for study comes last, a library'
echo 'upon it has files of its own, and bad headers are refused.'

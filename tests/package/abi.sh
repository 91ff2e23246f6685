# Compare the binary interface of the library with the record of the last
# release, and see that changes which are planted in copies of the library are
# noticed, or are harmless to a program that was compiled before:
#
#     BUILD=dir CC=cc VERSION=x.y.z abi.sh RECORD
#
# `make check-abi` runs this in the folder of the Makefile, after describe.sh
# has described the library in BUILD/abi.
set -eu

record=$1
scripts=src/package/abi
present=$BUILD/abi
scratch=$present/planted

fail() {
    echo "check-abi: $*" >&2
    exit 1
}

# The record -------------------------------------------------------------------

recorded() { # file
    sed -n 's/^<!-- Tanglefree \([0-9.]*\);.*/\1/p' "$1"
}

check_record() {
    other=$(find $scripts -name 'tanglefree-*.abi')
    [ -e "$record" ] || [ ! "$other" ] ||
        fail "this is version $VERSION, but the record is $other:" \
            'programs must be compiled again. If that is on purpose,' \
            '`make abi-record` records the new interface.'
    [ -e "$record" ] || fail "there is no $record;" \
        '`make abi-record` records the interface of a release.'
    echo "Compared with version $(recorded "$record"):"
    sh $scripts/compare.sh "$record" "$present" || fail \
        "programs compiled for version $(recorded "$record") do not run." \
        'Undo the change, or raise the major version.'
}

# The library that is installed is compiled with other options than the one that
# is described.
list_symbols() { # library
    nm -D --defined-only -S "$1" | awk '$3 ~ /[BDRV]/ { print $2, $4; next }
        { print $NF }' | grep -v ' type_tf_' | LC_ALL=C sort
}

check_symbols() {
    list_symbols "$BUILD/libtanglefree.so" >"$scratch/installed"
    list_symbols "$present/libtanglefree.so" | diff "$scratch/installed" - ||
        fail 'the shared library (<) has other symbols than its description'
}

# Copies -----------------------------------------------------------------------

# Each change is a sed script for the header and one for the code.
plant() { # name, change of the header, change of the code
    copy=$scratch/$1
    mkdir -p "$copy"
    sed "$2" "$present/tanglefree.h" >"$copy/tanglefree.h"
    sed "$3" "$present/tanglefree.c" >"$copy/tanglefree.c"
    ! cmp -s "$present/tanglefree.h" "$copy/tanglefree.h" ||
        ! cmp -s "$present/tanglefree.c" "$copy/tanglefree.c" ||
        fail "nothing is planted: $1"
    sh $scripts/describe.sh "$copy" || fail "$1 does not compile"
}

expect_noticed() { # words of the complaint, then as above
    words=$1
    shift
    plant "$@"
    ! sh $scripts/compare.sh "$present/tanglefree.abi" "$copy" \
        >"$copy/output" 2>&1 || fail "unnoticed: $1"
    grep -q -- "$words" "$copy/output" ||
        fail "$1: no '$words' in $(cat "$copy/output")"
}

# What all compilers can see, too.
expect_asserted() { # the assertion, then as above
    assertion=$1
    shift
    expect_noticed "$@"
    grep -qF "_Static_assert($assertion" "$copy/output" ||
        fail "$2: the assertion of $assertion holds"
}

check_broken() {
    expect_asserted 'sizeof(tf_contact) ==' "'int planted'" 'a member more' \
        's/^} tf_contact;/    int planted;\n&/' ''
    expect_asserted 'offsetof(tf_contact, toi_lo)' "'double toi_lo' offset" \
        'a member before others' \
        's/^typedef struct tf_contact {/&\n    double planted;/' ''
    expect_asserted 'offsetof(tf_contact, toi_lo)' 'tf_contact.*toi_lo' \
        'a member renamed' \
        's/\<toi_lo\>/planted/' 's/\<toi_lo\>/planted/g'
    expect_asserted 'offsetof(tf_stage, total)' "'size_t total' offset" \
        'members of a growing struct swap' \
        's/^\( *size_t \)done;/\1planted;/; s/^\( *size_t \)total;/\1done;/
         s/^\( *size_t \)planted;/\1total;/' ''
    expect_asserted 'TF_HIT ==' TF_HIT 'a value before another' \
        's/^    TF_HIT,/    TF_PLANTED,\n&/' ''
    expect_noticed 'tf_version' 'a function removed' '' \
        's/^#include "tanglefree.h"/&\n#define tf_version planted/'
    expect_noticed "'int' to 'long int'" 'a parameter of another type' \
        's/\(^TF_API int tf_arithmetic_bits(.*\)int axes/\1long axes/' \
        's/\(^int tf_arithmetic_bits(.*\)int axes/\1long axes/'
    expect_noticed 'tf_flow_velocity\|float' 'a parameter of a callback' \
        's/^\(typedef void tf_flow_velocity(.*\)double time/\1float time/' ''
    expect_noticed 'tf_exact' 'a larger constant' '' \
        's/^    bool needs_indices;/    double planted;\n&/'
}

# Growth -----------------------------------------------------------------------

# Everything that may be added, everywhere: values of enumerations, members of
# the structs that may grow, a function and a constant.
grow() { # header
    awk -v growing="$(sed -n '2s/.*may grow:\(.*\) -->/\1/p' \
        "$present/tanglefree.abi")" '
        BEGIN {
            count = split(growing, name)
            for (i = 1; i <= count; i++)
                grows["} " name[i] ";"]
        }
        /^(typedef )?enum [a-z0-9_]+ [{]/ {
            enumeration = $1 == "enum" ? $2 : $3
        }
        /^[}]/ && enumeration {
            print (last == "," ? "" : ", ") "TF_PLANTED_" enumeration
            enumeration = ""
        }
        $0 in grows { print "    double planted;" }
        /^TF_API const char [*]tf_version/ {
            print "TF_API int tf_planted(void);"
            print "TF_API extern const int tf_planted_constant;"
        }
        { print }
        {
            sub(/[/][/].*/, "")
            gsub(/ /, "")
            if ($0)
                last = substr($0, length)
        }' "$1"
}

make_grown() {
    copy=$scratch/grown
    mkdir -p "$copy"
    grow "$present/tanglefree.h" >"$copy/tanglefree.h"
    { cat "$present/tanglefree.c"
      echo 'int tf_planted(void) { return 0; }'
      echo 'const int tf_planted_constant = 0;'; } >"$copy/tanglefree.c"
    sh $scripts/describe.sh "$copy" || fail 'the library cannot grow'
}

check_grown() {
    sh $scripts/compare.sh "$present/tanglefree.abi" "$copy" \
        >"$copy/output" 2>&1 || {
        cat "$copy/output"
        fail 'an addition breaks what was there'
    }
    for added in tf_planted tf_planted_constant \
        'TF_PLANTED_tf_verdict of enum tf_verdict' \
        'planted of struct tf_stage'; do
        grep -qx "added: $added" "$copy/output" ||
            fail "an addition is not listed: $added"
    done
}

# Programs that were compiled before -------------------------------------------

compile() { # program, source
    $CC -std=c17 -pthread -no-pie -fno-pie -I "$BUILD/include" "$2" -L "$BUILD" \
        -ltanglefree -lm -o "$scratch/$1" || fail "$2 does not compile"
}

# Without -fpie, programs have copies of the constants, as large as they were.
compile_programs() {
    sed -n '/^```c$/,/^```$/{/^```/d;p}' README.md >"$scratch/readme.c"
    compile readme "$scratch/readme.c"
    compile answers tests/package/answers.c
    compile steps tests/package/steps.c
    for example in examples/*.c; do
        compile "$(basename "$example" .c)" "$example"
    done
}

run_programs() { # folder of the library
    export LD_LIBRARY_PATH="$1"
    "$scratch/readme" &&
        "$scratch/answers" point-triangle <tests/queries/point-triangle.csv &&
        "$scratch/steps" || return
    for example in examples/*.c; do
        "$scratch/$(basename "$example" .c)" || return
    done
}

check_programs() {
    compile_programs
    run_programs "$BUILD" >"$scratch/expected" || fail 'the programs fail'
    for copy in grown 'a member before others'; do
        ln -sf libtanglefree.so \
            "$scratch/$copy/libtanglefree.so.${VERSION%%.*}"
    done
    run_programs "$scratch/grown" | diff "$scratch/expected" - ||
        fail 'with a library that has grown, programs print something else'
    ! run_programs "$scratch/a member before others" 2>&1 |
        cmp -s "$scratch/expected" - ||
        fail 'the programs did not run with another library'
}

rm -rf "$scratch"
mkdir -p "$scratch"
check_record
check_symbols
check_broken
make_grown
check_grown
check_programs
echo 'Programs of the last release still run.'

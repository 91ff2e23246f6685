#include "judge.h"

#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MARK = 0xa5,
    TEXT = 256 ///< more than any sentence that the library writes
};

/// The call that is being made, and how the last one ended that was judged.
static const char *current = "no call";
static tf_status last;

// The contract ----------------------------------------------------------------

static void stop_at_broken_contract(const char *file, int line,
                                    const char *condition)
{
    fprintf(stderr, "%s broke a contract: %s:%d: %s\n", current, file, line,
            condition);
    abort();
}

call call_begin(const char *name)
{
    tf_contract_set_handler(stop_at_broken_contract);
    current = name;
    return (call){.name = name};
}

// The status ------------------------------------------------------------------

static status_set set_of(tf_status status)
{
    return (status_set)1 << status;
}

void expect_fault(call *made, bool wrong, tf_status status)
{
    if (wrong)
        made->faults |= set_of(status);
}

void excuse(call *made, tf_status status)
{
    made->excuses |= set_of(status);
}

void require(const call *made, bool condition, const char *what)
{
    if (condition)
        return;
    fprintf(stderr, "%s, status %d: %s\n", made->name, (int)last, what);
    abort();
}

bool judge_status(const call *made, tf_status status)
{
    last = status;
    if (getenv("TF_JOURNAL"))
        fprintf(stderr, "%s: %d\n", made->name, (int)status);
    status_set wanted = made->faults ? made->faults : set_of(TF_OK);
    if ((unsigned)status < 32 && (wanted | made->excuses) & set_of(status))
        return status == TF_OK;
    fprintf(stderr, "%s: status %d, and not of the set %#x\n", made->name,
            (int)status, (unsigned)(wanted | made->excuses));
    abort();
}

// The error -------------------------------------------------------------------

static bool is_sentence(const char *text)
{
    size_t length = strlen(text);
    for (size_t i = 0; i < length; i++)
        if (!isprint((unsigned char)text[i]))
            return false;
    return length > 0 && text[length - 1] != '.';
}

/// Describes an error in a buffer that is too small, and compares that with the
/// whole sentence.
static void judge_cut(const call *made, const tf_error *error, size_t size,
                      const char *whole)
{
    char cut[TEXT];
    mark(cut, sizeof cut);
    size_t length = tf_describe(error, cut, size), kept = size - 1;
    require(made, length == strlen(whole), "a length depends on the buffer");
    if (kept > length)
        kept = length;
    require(made, memcmp(cut, whole, kept) == 0 && cut[kept] == '\0',
            "a sentence that is cut off is another one");
    judge_unset(made, cut + size, sizeof cut - size);
}

void judge_error(const call *made, tf_status status, const tf_error *error,
                 generator *random)
{
    last = status;
    require(made, error->status == status, "the error is about another status");
    require(made,
            error->time >= -1 && error->time <= 1 &&
                (unsigned)error->subject <= TF_EDGE_TRIANGLE_PAIR,
            "the error is not set");
    char whole[TEXT];
    size_t length = tf_describe(error, whole, sizeof whole);
    require(made, length < sizeof whole && length == strlen(whole),
            "a sentence is longer than it says");
    require(made, tf_describe(error, NULL, 0) == length,
            "a length depends on the buffer");
    require(made, is_sentence(whole), "an error is described by no sentence");
    judge_cut(made, error, 1 + (size_t)below(random, TEXT - 1), whole);
}

// The outputs -----------------------------------------------------------------

void mark(void *output, size_t size)
{
    if (size > 0)
        memset(output, MARK, size);
}

void judge_unset(const call *made, const void *output, size_t size)
{
    const unsigned char *byte = output;
    for (size_t i = 0; i < size; i++)
        require(made, byte[i] == MARK, "an output is set without TF_OK");
}

#include "support/failing_memory.h"

#include "base/allocator.h"
#include "support/support.h"
#include "support/watched_memory.h"

static watched_memory memory;

bool lacks_memory(tf_status status)
{
    if (status == TF_OK)
        return false;
    ck_assert_int_eq(status, TF_OUT_OF_MEMORY);
    ck_assert_int_eq(memory.left, 0);
    memory.left = -1;
    return true;
}

void let_each_fail(act_function *act)
{
    memory_watch(&memory);
    uint64_t expected = act();
    long calls = memory.calls, failures = 0;
    bool failed = true;
    for (; failed; failures++) {
        memory.left = failures;
        ck_assert_uint_eq(act(), expected);
        ck_assert_uint_eq(memory.blocks, 0);
        failed = memory.left < 0;
    }
    ck_assert_int_gt(calls, 0);
    ck_assert_int_eq(failures, calls + 1);
    memory_end(&memory);
}

void expect_told(size_t bytes)
{
    ck_assert_uint_eq(tf_memory_in_use(), memory.bytes);
    ck_assert_uint_le(bytes, memory.bytes);
    ck_assert_uint_le(memory.bytes, bytes + 64 * memory.blocks);
    ck_assert_uint_eq((memory.bytes - bytes) % 64, 0);
}

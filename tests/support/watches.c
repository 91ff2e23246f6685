#include "support/watches.h"

static bool listen(void *context, const tf_stage *stage)
{
    watched_call *call = context;
    (void)stage;
    if (++call->calls != call->last && call->last >= 0)
        return true;
    call->work = watched_work(call);
    return false;
}

tf_watch *watched_begin(watched_call *call, long last)
{
    *call = (watched_call){.last = last};
    tf_watch *watch = tf_watch_begin(&call->watch, listen, call);
    tf_watch_stage(watch, "work", 0);
    if (last < 0)
        tf_watch_done(watch, 0);
    return watch;
}

size_t watched_work(watched_call *call)
{
    return atomic_load(&call->watch.work);
}

size_t watched_work_after(watched_call *call)
{
    return watched_work(call) - call->work;
}

//: Begin to watch
#include "base/watch.h"

tf_watch *tf_watch_begin(tf_watch *watch, tf_progress *progress, void *context)
{
    if (!progress)
        return NULL;
    watch->progress = progress;
    watch->context = context;
    watch->stage = (tf_stage){.name = ""};
    atomic_init(&watch->done, 0);
    atomic_init(&watch->work, 0);
    atomic_init(&watch->cancelled, false);
    atomic_flag_clear(&watch->told);
    return watch;
}

void tf_watch_stage(tf_watch *watch, const char *name, size_t total)
{
    if (!watch)
        return;
    watch->stage = (tf_stage){.name = name, .total = total};
    atomic_store(&watch->done, 0);
}

//: Tell the caller
/// What is done, of a stage whose last part may be smaller than it says.
static size_t limited(size_t done, size_t total)
{
    return total > 0 && done > total ? total : done;
}

/// If another thread is telling already, the caller has heard enough.
bool tf_watch_done(tf_watch *watch, size_t more)
{
    if (!watch)
        return true;
    size_t done = atomic_fetch_add(&watch->done, more) + more;
    if (!atomic_load(&watch->cancelled) &&
        !atomic_flag_test_and_set(&watch->told)) {
        watch->stage.done = limited(done, watch->stage.total);
        if (!watch->progress(watch->context, &watch->stage))
            atomic_store(&watch->cancelled, true);
        atomic_flag_clear(&watch->told);
    }
    return !atomic_load(&watch->cancelled);
}

//: Ask whether the caller has cancelled
void tf_watch_advance(tf_watch *watch, size_t more)
{
    if (watch)
        atomic_fetch_add(&watch->done, more);
}

bool tf_watch_cancelled(tf_watch *watch)
{
    return watch && atomic_load(&watch->cancelled);
}

tf_status tf_watch_failure(tf_watch *watch)
{
    return tf_watch_cancelled(watch) ? TF_CANCELLED : TF_OUT_OF_MEMORY;
}

//: Count the work of loops
bool tf_watch_count(tf_watch *watch, size_t units)
{
    size_t before = atomic_fetch_add(&watch->work, units);
    size_t after = before + units;
    bool tells = before / TF_WATCHED_WORK != after / TF_WATCHED_WORK;
    return tells ? tf_watch_done(watch, 0) : !tf_watch_cancelled(watch);
}

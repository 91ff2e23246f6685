//: Include what resolvers need
#include "response/resolver.h"

#include "base/memory.h"
#include "base/require.h"
#include "response/levels.h"

//: Create a resolver
tf_status tf_resolver_create(tf_surface *surface, tf_resolver **resolver)
{
    TF_REQUIRE(surface && resolver);
    tf_resolver *made = tf_allocate_zeroed(sizeof *made);
    if (!made)
        return TF_OUT_OF_MEMORY;
    made->surface = surface;
    *resolver = made;
    return TF_OK;
}

//: Free a resolver
void tf_resolver_free(tf_resolver *resolver)
{
    if (!resolver)
        return;
    tf_pair_cache_free(&resolver->pairs);
    tf_buffer_free(&resolver->thickness.row);
    tf_buffer_free(&resolver->end);
    tf_buffer_free(&resolver->unpushed);
    tf_buffer_free(&resolver->base);
    tf_buffer_free(&resolver->ones);
    tf_buffer_free(&resolver->displacement);
    tf_buffer_free(&resolver->origin);
    tf_buffer_free(&resolver->part);
    tf_buffer_free(&resolver->flags);
    tf_buffer_free(&resolver->followed);
    tf_zones_free(&resolver->zones);
    tf_rigid_free(&resolver->rigid);
    tf_failsafe_free(&resolver->failsafe);
    tf_follow_free(&resolver->follow);
    tf_answers_free(&resolver->answers);
    tf_release(resolver, sizeof *resolver);
}

//: Lend what the last step did
static bool lend_answers(tf_resolver *resolver)
{
    return tf_answers_lend(&resolver->answers, resolver->zones.constraint.data,
                           resolver->zones.gap.data);
}

tf_status tf_resolver_contacts(tf_resolver *resolver, size_t *count,
                               const tf_answered_contact **contact)
{
    TF_REQUIRE(resolver && count && contact);
    if (!lend_answers(resolver))
        return TF_OUT_OF_MEMORY;
    *count = resolver->answers.answers;
    *contact = resolver->answers.row.data;
    return TF_OK;
}

tf_status tf_resolver_pushes(tf_resolver *resolver, size_t *count,
                             const double **push)
{
    TF_REQUIRE(resolver && count && push);
    if (!lend_answers(resolver))
        return TF_OUT_OF_MEMORY;
    *count = resolver->answers.answers;
    *push = resolver->answers.push.data;
    return TF_OK;
}

const unsigned char *tf_resolver_vertices(const tf_resolver *resolver)
{
    TF_REQUIRE(resolver);
    return resolver->has_resolved ? resolver->flags.data : NULL;
}

const double *tf_resolver_unpushed(const tf_resolver *resolver)
{
    TF_REQUIRE(resolver);
    return resolver->has_resolved ? resolver->unpushed.data : NULL;
}

const double *tf_resolver_followed(const tf_resolver *resolver)
{
    TF_REQUIRE(resolver);
    return resolver->has_resolved ? resolver->followed.data : NULL;
}

//: Count the memory of a resolver
size_t tf_resolver_memory(const tf_resolver *resolver)
{
    TF_REQUIRE(resolver);
    return sizeof *resolver + tf_pair_cache_memory(&resolver->pairs) +
           resolver->thickness.row.bytes + resolver->end.bytes +
           resolver->unpushed.bytes + resolver->base.bytes +
           resolver->ones.bytes + resolver->displacement.bytes +
           resolver->origin.bytes + resolver->part.bytes +
           resolver->flags.bytes + resolver->followed.bytes +
           tf_zones_memory(&resolver->zones) +
           tf_rigid_memory(&resolver->rigid) +
           tf_failsafe_memory(&resolver->failsafe) +
           tf_follow_memory(&resolver->follow) +
           tf_answers_memory(&resolver->answers);
}

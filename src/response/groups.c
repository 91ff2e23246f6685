//: Keep groups
#include "response/groups.h"

#include <stddef.h>

bool tf_groups_begin(tf_groups *groups, int count)
{
    if (!tf_buffer_reserve(&groups->storage, (size_t)count,
                           sizeof *groups->parent))
        return false;
    groups->count = count;
    groups->parent = groups->storage.data;
    for (int i = 0; i < count; i++)
        groups->parent[i] = i;
    return true;
}

int tf_groups_find(tf_groups *groups, int number)
{
    int *parent = groups->parent;
    while (parent[number] != number) {
        // Halving the path keeps it short from now on.
        parent[number] = parent[parent[number]];
        number = parent[number];
    }
    return number;
}

int tf_groups_unite(tf_groups *groups, int a, int b)
{
    a = tf_groups_find(groups, a);
    b = tf_groups_find(groups, b);
    int root = a < b ? a : b;
    groups->parent[a < b ? b : a] = root;
    return root;
}

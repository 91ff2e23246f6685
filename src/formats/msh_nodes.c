//: Include what nodes need
#include "formats/msh_nodes.h"

#include <stdlib.h>

//: Order nodes by their tags
static int compare_tags(const void *a, const void *b)
{
    const tf_msh_node *one = a, *other = b;
    return (one->tag > other->tag) - (one->tag < other->tag);
}

static bool are_consecutive(const tf_ints *tag)
{
    size_t i = 1;
    while (i < tag->count && tag->item[i] - 1 == tag->item[i - 1])
        i++;
    return i >= tag->count;
}

bool tf_msh_nodes_order(tf_msh_nodes *nodes, int *twice)
{
    size_t count = nodes->tag.count;
    *twice = 0;
    if (are_consecutive(&nodes->tag))
        return true;
    nodes->node = malloc(count * sizeof *nodes->node);
    if (!nodes->node)
        return false;
    for (size_t i = 0; i < count; i++)
        nodes->node[i] = (tf_msh_node){nodes->tag.item[i], (int)i};
    qsort(nodes->node, count, sizeof *nodes->node, compare_tags);
    for (size_t i = 1; i < count && *twice == 0; i++)
        if (nodes->node[i].tag == nodes->node[i - 1].tag)
            *twice = nodes->node[i].tag;
    return *twice == 0;
}

//: Find a node by its tag
int tf_msh_nodes_find(const tf_msh_nodes *nodes, int tag)
{
    size_t count = nodes->tag.count;
    if (nodes->node) {
        const tf_msh_node *found =
            bsearch(&(tf_msh_node){.tag = tag}, nodes->node, count,
                    sizeof *nodes->node, compare_tags);
        return found ? found->vertex : -1;
    }
    if (count == 0 || tag < nodes->tag.item[0] ||
        (size_t)(tag - nodes->tag.item[0]) >= count)
        return -1;
    return tag - nodes->tag.item[0];
}

//: Free nodes
void tf_msh_nodes_free(tf_msh_nodes *nodes)
{
    free(nodes->tag.item);
    free(nodes->node);
    *nodes = (tf_msh_nodes){0};
}

//: Include what defects need
#include "program/defects.h"

#include "program/obstacles.h"

//: Describe an edge of a file that no surface has
static bool fault_in_edge(tf_mesh_file *file, const tf_defect *defect)
{
    int first = file->first_index;
    int from = defect->vertex[0] + first, to = defect->vertex[1] + first;
    if (defect->triangle < 0)
        return tf_mesh_file_fault(
            file, file->edge_place.item[0],
            "the edge from vertex %d to %d belongs to no triangle; remove it",
            from, to);
    return tf_mesh_file_fault(
        file, file->triangle_place.item[defect->triangle],
        "another triangle passes the edge from vertex %d to %d in the same "
        "direction; turn one of them over, or divide the surface there",
        from, to);
}

//: Describe a vertex of a file that no surface has
static bool fault_in_vertex(tf_mesh_file *file, const tf_defect *defect)
{
    int vertex = defect->vertex[0];
    return tf_mesh_file_fault(
        file, file->vertex_place.item[vertex],
        "the triangles at vertex %d form more than one ring or fan; give each "
        "a vertex of its own",
        vertex + file->first_index);
}

//: Describe a defect
bool tf_defect_fault(tf_mesh_file *file, tf_status status,
                     const tf_defect *defect)
{
    switch (status) {
    case TF_EDGE_NOT_MANIFOLD:
        return fault_in_edge(file, defect);
    case TF_VERTEX_NOT_MANIFOLD:
        return fault_in_vertex(file, defect);
    case TF_COLLINEAR:
        return tf_mesh_file_fault(
            file, file->triangle_place.item[defect->triangle],
            "the corners of this triangle are on one line; remove it, or move "
            "a corner off");
    case TF_NOT_EMBEDDED:
        return tf_crossing_fault(file, &defect->crossing);
    default:
        return tf_mesh_file_fault(file, -1, "%s", tf_status_message(status));
    }
}

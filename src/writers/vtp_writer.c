//: Include what writing PolyData of a mesh needs
#include "writers/vtp_writer.h"

//: Add what vertices have to PolyData
static void add_columns(tf_polydata *data, const tf_columns *columns)
{
    for (int i = 0; columns && i < columns->count; i++)
        tf_polydata_add(data,
                        &(tf_polydata_array){.name = columns->column[i].name,
                                             .type = columns->column[i].type,
                                             .components = 1,
                                             .rows = columns->rows,
                                             .number = columns->value + i,
                                             .stride = (size_t)columns->count});
}

//: Make PolyData of a mesh
tf_polydata tf_polydata_of_mesh(const tf_mesh_content *content)
{
    const tf_mesh *mesh = &content->mesh;
    tf_polydata data =
        tf_polydata_of((size_t)mesh->vertices, content->position, mesh->axes);
    data.lines = tf_polydata_cells_of((size_t)mesh->edges, 2, mesh->edge);
    data.polys =
        tf_polydata_cells_of((size_t)mesh->triangles, 3, mesh->triangle);
    add_columns(&data, content->columns);
    if (content->velocity)
        tf_polydata_add(&data,
                        &(tf_polydata_array){.name = "velocity",
                                             .type = TF_DOUBLE,
                                             .components = 3,
                                             .rows = data.position.rows,
                                             .number = content->velocity,
                                             .stride = data.position.stride});
    return data;
}

void tf_vtp_write(FILE *stream, const tf_mesh_content *content)
{
    tf_polydata data = tf_polydata_of_mesh(content);
    tf_polydata_write(stream, &data);
}

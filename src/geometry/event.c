//: Include what events need
#include "geometry/event.h"

#include "base/require.h"

//: Join two positions by a worldline
tf_worldline tf_worldline_between(int axes, const double start[],
                                  const double end[])
{
    TF_REQUIRE(axes == 2 || axes == 3);
    tf_worldline line = {.at = {{.t = 0, .vertex = TF_NO_INDEX},
                                {.t = 1, .vertex = TF_NO_INDEX}}};
    for (int k = 0; k < axes; k++) {
        line.at[0].x[k] = start[k];
        line.at[1].x[k] = end[k];
    }
    return line;
}

void tf_worldline_set_vertex(tf_worldline *line, int vertex)
{
    line->at[0].vertex = line->at[1].vertex = vertex;
}

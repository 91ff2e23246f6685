// Films of cloth: a moving surface with light and shadow, on a ground.
//
// Each connected part has its own color, paler on its back, and pale stripes
// along its border, if it has one.  Gray are its obstacles, as far as it is told
// them; otherwise what keeps its shape in all frames if anything does not, or
// where all do, what does not move.  What lies level below all that is not gray is a floor, of
// which only the height counts.  A curve of the plane is drawn as lines.
#ifndef FIG_CLOTH_H
#define FIG_CLOTH_H

#include "kit/surface_shape.h"
#include "renderer/page.h"

typedef struct fig_cloth fig_cloth;

/// How cloth is looked at; zero-initialised: from where it is seen best as a
/// rule, on a ground, which is drawn only if the eye is above it.
typedef struct fig_cloth_look {
    bool turned;      ///< look from:
    double azimuth;   ///< degrees
    double elevation; ///< degrees
    bool groundless;  ///< there is nothing below
} fig_cloth_look;

/// Cloth without frames; the surface is borrowed.  `axes`, 2 or 3, is how many
/// coordinates a vertex has in each frame; the third axis points up.  NULL if
/// there is no memory.
fig_cloth *fig_cloth_new(const tf_surface *surface, int axes);

/// Let another axis than the third one of the frames point up.  To be called
/// before the first frame is added.
void fig_cloth_set_up(fig_cloth *cloth, fig_up up);

/// Tell which vertices are of obstacles.  To be called after the first frame is
/// added.  False if there is no memory.
bool fig_cloth_set_obstacles(fig_cloth *cloth, const bool of_obstacle[]);

/// Free cloth; NULL is none.
void fig_cloth_free(fig_cloth *cloth);

/// Add a frame: the places of `vertices` vertices, as many in all frames, with
/// finite coordinates.  False if there is no memory.
bool fig_cloth_add(fig_cloth *cloth, int vertices, const double x[]);

/// End the film, which must have a frame: fit it into a box, find what keeps
/// its shape.  No frame may be added later.  False if there is no memory.
bool fig_cloth_end(fig_cloth *cloth);

/// End films that are shown one after the other: as fig_cloth_end, but all fit
/// into one box, nothing is gray or striped, and all parts have one color.
bool fig_cloth_end_all(int count, fig_cloth *const cloth[]);

/// What there is.
int fig_cloth_frames(const fig_cloth *cloth);
const fig_shape *fig_cloth_shape(const fig_cloth *cloth);

/// Whether a part is gray.
bool fig_cloth_is_stiff(const fig_cloth *cloth, int part);

/// Draw a frame, from 0, in a box of the page.  In all frames the camera is the
/// same: all of them fit into the box.
void fig_cloth_draw(const fig_cloth *cloth, fig_page *page, fig_box box,
                    int frame, const fig_cloth_look *look);

#endif

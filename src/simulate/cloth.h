//: Declare cloth
#pragma once

#include "simulate/body.h"

/// What cloth is made of.
typedef struct tf_material {
    double density; ///< in kilograms per square meter
    double stretch; ///< what an edge resists, in newtons per meter
    double bend;    ///< what a fold resists, in newton meters; may be 0
} tf_material;

/// Gives mass and elastic elements to triangles: every edge resists being
/// stretched, and every two triangles at an edge resist being folded.
///
/// The curvature at an edge is linear in the positions as long as no edge
/// changes its length, so its weights are constants.  The cloth is flat at rest.
/// See "A quadratic bending model for inextensible surfaces", Bergou et al.,
/// 2006; a third of their energy is that of a plate that is rolled up along the
/// cells of a sheet.
/// @param first the first of the triangles, which go on to the last of the body
void tf_cloth_stiffen(tf_body *body, int first, const tf_material *material);

//: Declare sheets
/// A sheet of square cells, of two triangles each.
typedef struct tf_sheet {
    int across, along;                    ///< how many cells
    double corner[3];                     ///< where it begins, in meters
    double across_step[3], along_step[3]; ///< the sides of a cell
} tf_sheet;

/// Adds a sheet, whose vertices are in rows across.
/// @param material NULL: all of it is scripted
void tf_sheet_add(tf_body *body, const tf_sheet *sheet,
                  const tf_material *material);

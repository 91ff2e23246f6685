//: Declare collections of frames
#pragma once

#include "files/fault.h"
#include "writers/polydata.h"

enum {
    TF_COLLECTION_ROOM = 4096 ///< bytes of a path, with the 0 at its end
};

/// Frames for ParaView: a list NAME.pvd, and in the folder NAME beside it for
/// each frame mesh-00000.vtp and contacts-00000.vtp.  Each file appears whole, or
/// not at all, the list last.
typedef struct tf_collection {
    const char *path; ///< of the list; borrowed
    int frames;       ///< how many are there
    double bytes;     ///< of all their files
    tf_fault *fault;
    char file[TF_COLLECTION_ROOM]; ///< the path of the file that is at work
} tf_collection;

/// Whether a name is that of such a list.
bool tf_is_collection(const char *path);

/// Makes the folder, or takes one that is there.  This and all below are false
/// after an error, which is in the fault.
bool tf_collection_begin(tf_collection *collection, const char *path,
                         tf_fault *fault);

/// Adds a frame: the mesh, and the contacts of the step that ends there.
bool tf_collection_add(tf_collection *collection, const tf_polydata *mesh,
                       const tf_polydata *contacts);

/// Writes the list.
bool tf_collection_end(tf_collection *collection);

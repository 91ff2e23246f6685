// Scenes of the simulator, and whether their steps are free of tangles.
#ifndef SUPPORT_SIMULATIONS_H
#define SUPPORT_SIMULATIONS_H

#include "simulate/cloth_scenes.h"
#include "simulate/cloth_simulation.h"
#include "support/tangle.h"

/// A scene of cloth at its start; to be freed by cloth_simulation_free.
tf_cloth_simulation *cloth_of(const char *scene, int size);
void cloth_simulation_free(tf_cloth_simulation *cloth);

/// The setup of a scene at its start; its body is to be freed.
tf_scene_setup setup_of(const tf_scene *scene, double resolution);

/// How many scenes a list has.
int scene_count(const tf_scene list[]);

/// Makes a step, and expects that this succeeds; returns what it took.
tf_cloth_report simulate_step(tf_cloth_simulation *c,
                              const tf_parallel *parallel);

/// Makes a step through whatever is in the way.
void simulate_blindly(tf_cloth_simulation *c);

/// A judge of a body's elements.
tangle_judge *judge_of(const tf_body *body);

/// Expects that a body starts free of intersections, by the judge and by the
/// library.
void expect_clear(const tf_body *body);

#endif

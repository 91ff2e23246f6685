// Scenes of the simulator, and whether their steps are free of tangles.
#ifndef SUPPORT_SIMULATIONS_H
#define SUPPORT_SIMULATIONS_H

#include "simulate/simulation.h"
#include "support/tangle.h"

/// A scene at its start; to be freed.
tf_simulation *simulation_of(const tf_scene *scene, int size);

/// Its scene i of all.
const tf_scene *scene_number(int i);

/// How many scenes there are.
int scene_count(void);

/// Makes a step, and expects that this succeeds; returns what it took.
tf_step_cost simulate_step(tf_simulation *s, const tf_parallel *parallel);

/// Makes a step through whatever is in the way.
void simulate_blindly(tf_simulation *s);

/// A judge of a body's elements.
tangle_judge *judge_of(const tf_body *body);

/// Expects that a body starts free of intersections, by the judge and by the
/// library.
void expect_clear(const tf_body *body);

#endif

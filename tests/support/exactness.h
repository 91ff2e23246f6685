// What an arithmetic that is exact for all finite doubles must do, on
// determinants of all kinds.
#ifndef SUPPORT_EXACTNESS_H
#define SUPPORT_EXACTNESS_H

#include "arithmetic/arithmetic.h"
#include "support/matrices.h"

/// Expect the sign of a matrix, and its determinant rounded to nearest.
void expect_exact(const tf_arithmetic *arithmetic, const matrix *m);

/// What to try; called by the function that is given to exactness_add().
void exactness_use(const tf_arithmetic *arithmetic);

/// Add the tests; `use` calls exactness_use().
void exactness_add(Suite *suite, void (*use)(void));

#endif

// Draws vectors for random tests.
#ifndef TESTS_CHECK_VEC_H
#define TESTS_CHECK_VEC_H
#include "base/vec.h"
#include "check.h"

// Returns a vector with x and y in these ranges. It draws y first, as gcc did while both were arguments of one call, so
// that the machines of the tests' seeds stay the same.
static inline YkVec check_vec(uint64_t *seed, double x_low, double x_high, double y_low, double y_high)
{
    double y = check_uniform(seed, y_low, y_high), x = check_uniform(seed, x_low, x_high);
    return yk_vec(x, y);
}
#endif

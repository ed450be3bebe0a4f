// Tries every example of the gallery.
#ifndef TESTS_EXAMPLES_H
#define TESTS_EXAMPLES_H
#include <glob.h>
#include "check.h"

// Calls `check` with the path of each example and its number; under the sanitizers with every fourth one. Returns the
// sum of what it returns, as if all had been tried.
static inline size_t each_example(size_t (*check)(const char *path, size_t number))
{
    glob_t found;
    size_t sum = 0, step = check_cases(1000) == 1000 ? 1 : 4;
    assert_int_equal(glob(YOKE_ROOT "/examples/*.yaml", 0, NULL, &found), 0);
    for (size_t k = 0; k < found.gl_pathc; k += step) sum += check(found.gl_pathv[k], k);
    globfree(&found);
    return sum * step;
}

#endif

// Finds all solutions of a generic system by monodromy.
#include "configurations/generic.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/mix.h"
#include "num/complex.h"

enum { N_MAX = 2 * YK_SYSTEM_LOOPS_MAX, TRIANGLES_MAX = 200, IDLE_MAX = 8, UNKNOWN_MAX = 4000 };

static YkVec random_complex(uint64_t *seed)
{
    double size = 0.5 + yk_mix_unit(seed);
    return yk_scale(size, yk_unit(2 * YK_PI * yk_mix_unit(seed)));
}

// Invents a vector of the space of these loops, its constant 1. Returns false if there is none.
static bool invent(const YkShape *shape, const YkVec *loops, uint64_t *seed, YkVec *x)
{
    size_t width = shape->unknowns + 1, order[N_MAX + 1];
    YkVec A[YK_SYSTEM_LOOPS_MAX * (N_MAX + 1)], kernel[(N_MAX + 1) * (N_MAX + 1)];
    memcpy(A, loops, yk_coefficient_count(shape) * sizeof *A);
    size_t free_count = width - yk_complex_kernel(shape->loops, width, A, order, 1e-12, kernel);
    for (size_t k = 0; k < width; k++) x[k] = yk_vec(0, 0);
    for (size_t j = 0; j < free_count; j++) {
        YkVec share = random_complex(seed);
        for (size_t k = 0; k < width; k++) x[k] = yk_add_product(x[k], share, kernel[k * free_count + j]);
    }
    for (size_t k = 0; k < width; k++)
        if (!(yk_sum_norm(x[k]) > 1e-6)) return false;
    YkVec inverse = yk_inverse(x[width - 1]);
    for (size_t k = 0; k < width; k++) x[k] = yk_mul(x[k], inverse);
    return true;
}

static void scale_conjugates(const YkShape *shape, const YkVec *coefficients, const YkVec *scale, YkVec *out)
{
    size_t width = shape->unknowns + 1, half = yk_coefficient_count(shape);
    memcpy(out, coefficients, 2 * half * sizeof *out);
    for (size_t l = 0; l < shape->loops; l++)
        for (size_t k = 0; k + 1 < width; k++) {
            YkVec *a = &out[half + l * width + k];
            *a = yk_mul(*a, scale[k]);
        }
}

// Chooses right-hand sides for which vectors x and y of the two spaces are a solution.
static void fit(const YkShape *shape, const YkVec *x, const YkVec *y, YkVec *scale, YkVec *solution)
{
    for (size_t k = 0; k < shape->angles; k++) {
        solution[k] = x[k];
        scale[k] = yk_mul(x[k], y[k]);
    }
    for (size_t k = shape->angles; k < shape->unknowns; k++) {
        int turning = shape->turning[k];
        solution[k] = turning < 0 ? x[k] : yk_mul(x[k], yk_inverse(x[turning]));
        YkVec other = turning < 0 ? yk_vec(1, 0) : yk_inverse(x[turning]); // multiplies the distance in the conjugate
        scale[k] = yk_mul(y[k], yk_inverse(yk_mul(solution[k], other)));
    }
}

static bool is_known(const YkGeneric *start, const YkShape *shape, const YkVec *x)
{
    YkVec off[N_MAX];
    for (size_t s = 0; s < start->count; s++) {
        const YkVec *known = start->solutions + s * shape->unknowns;
        for (size_t k = 0; k < shape->unknowns; k++) off[k] = yk_sub(x[k], known[k]);
        if (yk_relative_change(shape, known, off) < 1e-7) return true;
    }
    return false;
}

static bool keep(YkGeneric *start, const YkShape *shape, const YkVec *x)
{
    size_t n = shape->unknowns;
    if (start->count == start->capacity) {
        size_t capacity = 2 * start->capacity + 16;
        YkVec *solutions = realloc(start->solutions, capacity * n * sizeof *solutions);
        if (!solutions) return false;
        start->solutions = solutions;
        start->capacity = capacity;
    }
    memcpy(start->solutions + start->count++ * n, x, n * sizeof *x);
    return true;
}

// Sends all solutions round a triangle of right-hand sides. Returns false when out of memory or stopped.
static bool go_round(YkGeneric *start, const YkShape *shape, const YkVec *pose, YkVec *corners, uint64_t *seed,
                     size_t wanted, YkPace *pace)
{
    size_t n = shape->unknowns, all = 2 * yk_coefficient_count(shape);
    YkVec scale[N_MAX], x[N_MAX];
    for (int corner = 0; corner < 2; corner++) {
        for (size_t k = 0; k < n; k++) scale[k] = random_complex(seed);
        scale_conjugates(shape, pose, scale, corners + (size_t)corner * all);
    }
    for (size_t s = 0; s < start->count && start->count != wanted && start->count < UNKNOWN_MAX; s++) {
        memcpy(x, start->solutions + s * n, n * sizeof *x);
        bool arrived = yk_path_follow(shape, start->coefficients, corners, x, pace) &&
                       yk_path_follow(shape, corners, corners + all, x, pace) &&
                       yk_path_follow(shape, corners + all, start->coefficients, x, pace);
        if (yk_pace_is_stopped(pace)) return false;
        if (arrived && !is_known(start, shape, x) && !keep(start, shape, x)) return false;
    }
    return true;
}

// Makes the coefficients and the first solution.
static bool begin(YkGeneric *start, const YkShape *shape, const YkVec *coefficients, uint64_t *seed)
{
    YkVec x[N_MAX + 1], y[N_MAX + 1], scale[N_MAX], solution[N_MAX];
    bool found = false;
    for (int k = 0; k < 20 && !found; k++)
        found = invent(shape, coefficients, seed, x) &&
                invent(shape, coefficients + yk_coefficient_count(shape), seed, y);
    if (!found) return true; // no vector of the spaces has all coordinates: there is no solution
    fit(shape, x, y, scale, solution);
    scale_conjugates(shape, coefficients, scale, start->coefficients);
    return keep(start, shape, solution);
}

YkGenericStatus yk_generic_make(YkGeneric *start, const YkShape *shape, const YkVec *coefficients, size_t wanted,
                            YkPace *pace)
{
    uint64_t seed = 1;
    size_t all = 2 * yk_coefficient_count(shape), idle = 0;
    YkVec *corners = calloc(2 * all, sizeof *corners);
    *start = (YkGeneric){.coefficients = calloc(all, sizeof *start->coefficients)};
    bool ok = corners && start->coefficients && begin(start, shape, coefficients, &seed);
    for (int k = 0; ok && k < TRIANGLES_MAX && start->count > 0 && start->count != wanted && idle < IDLE_MAX; k++) {
        size_t before = start->count;
        ok = go_round(start, shape, coefficients, corners, &seed, wanted, pace);
        idle = start->count > before || wanted > 0 ? 0 : idle + 1;
        if (wanted > 0 && k > 40 && start->count == before) idle = IDLE_MAX;
    }
    free(corners);
    if (ok) return start->count == wanted ? YK_GENERIC_FULL : YK_GENERIC_SHORT;
    yk_generic_free(start);
    return yk_pace_is_stopped(pace) ? YK_GENERIC_STOPPED : YK_GENERIC_NO_MEMORY;
}

void yk_generic_free(YkGeneric *start)
{
    free(start->coefficients);
    free(start->solutions);
    *start = (YkGeneric){0};
}

// Finds all solutions of a generic system by monodromy.
#include "configurations/generic.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/mix.h"
#include "num/complex.h"

enum { N_MAX = 2 * YK_SYSTEM_LOOPS_MAX, TRIANGLES_MAX = 80, IDLE_MAX = 12, UNKNOWN_MAX = 4000 };
#define SPREAD_MIN 0.5 // of the moduli of right-hand sides
#define SPREAD_MAX 5.0

// Returns a number of modulus between e^-spread and e^spread.
static YkVec random_complex(uint64_t *seed, double spread)
{
    double size = yk_exp(spread * (2 * yk_mix_unit(seed) - 1));
    return yk_scale(size, yk_unit(2 * YK_PI * yk_mix_unit(seed)));
}

// Invents a vector of the space of these loops, its constant 1. Returns false if there is none.
static bool invent(const YkShape *shape, const YkVec *loops, uint64_t *seed, double spread, YkVec *x)
{
    size_t width = shape->unknowns + 1, order[N_MAX + 1];
    YkVec A[YK_SYSTEM_LOOPS_MAX * (N_MAX + 1)], kernel[(N_MAX + 1) * (N_MAX + 1)];
    memcpy(A, loops, yk_coefficient_count(shape) * sizeof *A);
    size_t free_count = width - yk_complex_kernel(shape->loops, width, A, order, 1e-12, kernel);
    for (size_t k = 0; k < width; k++) x[k] = yk_vec(0, 0);
    for (size_t j = 0; j < free_count; j++) {
        YkVec share = random_complex(seed, spread);
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

static bool is_known(const YkGeneric *generic, const YkShape *shape, const YkVec *x)
{
    YkVec off[N_MAX];
    for (size_t s = 0; s < generic->count; s++) {
        const YkVec *known = generic->solutions + s * shape->unknowns;
        for (size_t k = 0; k < shape->unknowns; k++) off[k] = yk_sub(x[k], known[k]);
        if (yk_relative_change(shape, known, off) < 1e-7) return true;
    }
    return false;
}

static bool keep(YkGeneric *generic, const YkShape *shape, const YkVec *x)
{
    size_t n = shape->unknowns;
    if (!YK_ROW_ROOM(generic->solutions, n, generic->count, generic->capacity)) return false;
    memcpy(generic->solutions + generic->count++ * n, x, n * sizeof *x);
    return true;
}

// The data of one search.
typedef struct Search {
    const YkShape *shape;
    const YkVec *pose; // coefficients
    YkVec *corners;    // of the present triangle, two
    size_t all;        // coefficients of one system
    size_t wanted;
    uint64_t seed;
    double spread; // of right-hand sides: it grows, since some solutions only permute round far ones
    YkPace *pace;
} Search;

// Invents a solution, and the right-hand sides for which it is one, as coefficients. Returns false if there is none:
// every vector of the space has a coordinate that vanishes.
static bool invent_solution(Search *search, YkVec *coefficients, YkVec *solution)
{
    YkVec x[N_MAX + 1], y[N_MAX + 1], scale[N_MAX];
    const YkVec *conjugates = search->pose + search->all / 2;
    bool found = false;
    for (int k = 0; k < 20 && !found; k++)
        found = invent(search->shape, search->pose, &search->seed, search->spread, x) &&
                invent(search->shape, conjugates, &search->seed, search->spread, y);
    if (!found) return false;
    fit(search->shape, x, y, scale, solution);
    scale_conjugates(search->shape, search->pose, scale, coefficients);
    return true;
}

// Keeps what a path has led to, if it is new. Returns false when out of memory or stopped.
static bool arrive(YkGeneric *generic, const Search *search, bool arrived, const YkVec *x)
{
    if (yk_pace_is_stopped(search->pace)) return false;
    return !arrived || is_known(generic, search->shape, x) || keep(generic, search->shape, x);
}

// Sends all solutions round a triangle of right-hand sides, after one more was invented elsewhere and led here. Returns
// false when out of memory or stopped.
static bool go_round(YkGeneric *generic, Search *search)
{
    const YkShape *shape = search->shape;
    size_t n = shape->unknowns;
    YkVec scale[N_MAX], x[N_MAX], *first = search->corners, *second = first + search->all;
    if (invent_solution(search, first, x)) {
        bool arrived = yk_path_follow(shape, first, generic->coefficients, x, search->pace);
        if (!arrive(generic, search, arrived, x)) return false;
    }
    for (int corner = 0; corner < 2; corner++) {
        for (size_t k = 0; k < n; k++) scale[k] = random_complex(&search->seed, search->spread);
        scale_conjugates(shape, search->pose, scale, corner == 0 ? first : second);
    }
    for (size_t s = 0; s < generic->count && generic->count != search->wanted && generic->count < UNKNOWN_MAX; s++) {
        memcpy(x, generic->solutions + s * n, n * sizeof *x);
        bool arrived = yk_path_follow(shape, generic->coefficients, first, x, search->pace) &&
                       yk_path_follow(shape, first, second, x, search->pace) &&
                       yk_path_follow(shape, second, generic->coefficients, x, search->pace);
        if (!arrive(generic, search, arrived, x)) return false;
    }
    return true;
}

static bool search_all(YkGeneric *generic, Search *search)
{
    YkVec solution[N_MAX];
    if (!invent_solution(search, generic->coefficients, solution)) return true;
    if (!keep(generic, search->shape, solution)) return false;
    int idle_max = search->wanted > 0 ? TRIANGLES_MAX : IDLE_MAX;
    for (int k = 0, idle = 0; k < TRIANGLES_MAX && generic->count != search->wanted && idle < idle_max; k++) {
        size_t before = generic->count;
        search->spread = fmin(SPREAD_MAX, SPREAD_MIN + 0.1 * k);
        if (!go_round(generic, search)) return false;
        idle = generic->count > before ? 0 : idle + 1;
    }
    return true;
}

YkGenericStatus yk_generic_make(YkGeneric *generic, const YkShape *shape, const YkVec *coefficients, size_t wanted,
                                YkPace *pace)
{
    size_t all = 2 * yk_coefficient_count(shape);
    Search search = {.shape = shape, .pose = coefficients, .all = all, .wanted = wanted, .seed = 1, .pace = pace};
    search.spread = SPREAD_MIN;
    search.corners = calloc(2 * all, sizeof *search.corners);
    *generic = (YkGeneric){.coefficients = calloc(all, sizeof *generic->coefficients)};
    bool ok = search.corners && generic->coefficients && search_all(generic, &search);
    free(search.corners);
    if (ok) return generic->count == wanted ? YK_GENERIC_FULL : YK_GENERIC_SHORT;
    yk_generic_free(generic);
    return yk_pace_is_stopped(pace) ? YK_GENERIC_STOPPED : YK_GENERIC_NO_MEMORY;
}

void yk_generic_free(YkGeneric *generic)
{
    free(generic->coefficients);
    free(generic->solutions);
    *generic = (YkGeneric){0};
}

static void *copy_of(const void *from, size_t bytes)
{
    void *to = malloc(bytes + 1);
    if (to) memcpy(to, from, bytes);
    return to;
}

bool yk_generic_copy(YkGeneric *to, const YkGeneric *from, const YkShape *shape)
{
    yk_generic_free(to);
    if (!from->coefficients) return true;
    to->coefficients = copy_of(from->coefficients, 2 * yk_coefficient_count(shape) * sizeof *to->coefficients);
    to->solutions = copy_of(from->solutions, from->count * shape->unknowns * sizeof *to->solutions);
    to->count = to->capacity = from->count;
    if (to->coefficients && to->solutions) return true;
    yk_generic_free(to);
    return false;
}

bool yk_generics_are_same(const YkGeneric *a, const YkGeneric *b, const YkShape *shape)
{
    if (a->count != b->count || !a->coefficients != !b->coefficients) return false;
    size_t bytes = 2 * yk_coefficient_count(shape) * sizeof *a->coefficients;
    return !a->coefficients || memcmp(a->coefficients, b->coefficients, bytes) == 0;
}

// Paths from the stored start solutions of Alt's problem to those of given points.
#include <math.h>
#include "base/mix.h"
#include "synthesis/nine_points/alt.h"

void yk_alt_pose(const YkVec *point, uint64_t seed, YkAltTask *task)
{
    double square = 0;
    *task = (YkAltTask){.origin = point[0], .seed = seed};
    for (size_t k = 0; k < YK_ALT_SIZE; k++) {
        task->places[k] = yk_sub(point[k + 1], point[0]);
        square += yk_dot(task->places[k], task->places[k]);
    }
    task->size = sqrt(square / YK_ALT_SIZE);
    for (size_t k = 0; k < YK_ALT_SIZE; k++) {
        task->places[k] = yk_scale(1 / task->size, task->places[k]);
        task->places[YK_ALT_SIZE + k] = yk_conj(task->places[k]);
    }
}

void yk_alt_lay(const YkAltTask *task, size_t number, YkAltRoute *route)
{
    const YkVec *start = yk_alt_start_places();
    uint64_t seed = yk_mix(task->seed * YK_ALT_ROUTES + number);
    route->z = yk_unit(2 * YK_PI * yk_mix_unit(&seed));
    route->hat = yk_unit(2 * YK_PI * yk_mix_unit(&seed));
    for (size_t k = 0; k < YK_ALT_PLACES; k++)
        route->from[k] = yk_mul(k < YK_ALT_SIZE ? route->z : route->hat, start[k]);
}

bool yk_alt_path(const YkAltTask *task, size_t piece, YkPace *pace, YkVec *x)
{
    enum { COGNATES = 3 };
    YkAltRoute route;
    YkVec start[YK_ALT_SIZE];
    if (!yk_alt_start(piece % YK_ALT_TRIPLES, start)) return false;
    yk_alt_lay(task, piece / YK_ALT_TRIPLES, &route);
    for (size_t k = 0; k < YK_ALT_SIZE; k++)
        start[k] = yk_mul(k % YK_ALT_DYAD < YK_ALT_X_HAT ? route.z : route.hat, start[k]);
    for (size_t k = 0; k < 2 * COGNATES; k++) {
        YkAltPath path = {route.from, task->places, k >= COGNATES, pace};
        yk_alt_name(k % COGNATES, start, x);
        if (yk_alt_follow(&path, x)) return true;
    }
    return false;
}

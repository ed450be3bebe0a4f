// Takes a variant's new values: loads, masses and equations are made anew, what the caller has set stays.
#include <stdlib.h>
#include <string.h>
#include "compile/variant.h"
#include "dynamics/dynamics.h"
#include "dynamics/holding.h"

// Gives the new loads what was set from outside.
static void keep_given(const YkLoads *old, YkLoads *loads)
{
    for (size_t k = 0; k < old->item_count; k++) {
        const YkLoadItem *item = &old->items[k];
        if (item->is_given) yk_loads_set_effort(loads, (size_t)item->coordinate, item->value[0].constant);
    }
}

static bool remake(YkDynamics *d)
{
    YkLoads *loads = yk_loads_new(d->mech);
    YkFreeBodies *bodies = yk_free_bodies_new(d->mech);
    double *power = loads ? calloc(loads->item_count + d->mech->coordinate_count + 1, sizeof *power) : NULL;
    bool good = loads && bodies && power;
    if (good) {
        keep_given(d->loads, loads);
        yk_loads_free(d->loads);
        yk_free_bodies_free(d->bodies);
        free(d->power);
        d->loads = loads;
        d->bodies = bodies;
        d->power = power;
        yk_holding_free(d->holding);
        d->holding = loads->has_dry ? yk_holding_new(d) : NULL;
        return !loads->has_dry || d->holding;
    }
    yk_loads_free(loads);
    yk_free_bodies_free(bodies);
    free(power);
    return false;
}

bool yk_dynamics_follow(YkDynamics *d)
{
    const YkVariant *variant = d->mech->variant;
    if (!variant || variant->changes == d->changes) return true;
    if (!remake(d)) return false;
    memset(d->q, 0, 5 * (d->mech->input_count + 1) * sizeof *d->q);
    d->changes = variant->changes;
    d->is_stale = true;
    return true;
}

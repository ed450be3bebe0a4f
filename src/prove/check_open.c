// Reads an equation that is to be checked, with all symbols of its machine.
#include <stdlib.h>
#include "base/problems.h"
#include "derive/blocks.h"
#include "derive/gears/gears.h"
#include "prove/check_inside.h"
#include "prove/equation.h"

// Enters all symbols and all names.
static bool prepare(YkDerivation *d, YkProblems *problems)
{
    if (!yk_derive_blocks(d) || !yk_derive_enter_forces(d)) {
        YkRingStatus why = yk_derivation_fault(d);
        yk_problem(problems, yk_derive_code(why), (YkPlace){0}, "the machine cannot be written in symbols: %s",
                   yk_ring_status_text(why));
        return false;
    }
    yk_derive_train(d); // omega1, ...: names of speeds
    yk_derive_enter_names(d);
    return true;
}

static bool make_room(YkCheck *check)
{
    YkDerivation *d = check->d;
    check->within_count = yk_equation_segments(d, &check->equation, check->within, YK_CHECK_SEGMENTS);
    check->has_time = yk_equation_speaks_of(d, check->equation.left, d->time) ||
                      yk_equation_speaks_of(d, check->equation.right, d->time);
    check->difference = yk_form_subtract(d->ring, check->equation.left, check->equation.right);
    for (size_t k = 0; k < d->model->parameter_count; k++) yk_derive_definition(d, k);
    if (!yk_derive_is_long(d)) yk_derive_body_angle(d, 0);
    check->value_count = yk_ring_symbol_count(d->ring) + 64;
    check->values = yk_derive_scratch(d, check->value_count, sizeof *check->values);
    check->elsewhere = yk_derive_scratch(d, check->value_count, sizeof *check->elsewhere);
    return check->values && check->elsewhere && check->difference;
}

YkCheckOpened yk_check_open(YkCheck *check, YkCheckPoses *poses, YkPlace place, YkProblems *problems)
{
    if (!prepare(check->d, problems) ||
        !yk_equation_read(check->d, check->text, check->length, place, problems, &check->equation))
        return YK_CHECK_NOT_READ;
    if (!make_room(check)) return YK_CHECK_NO_ROOM;
    check->poses = check->within_count > 0 ? &check->own_poses : poses;
    check->own_poses.is_of_segment = true;
    check->own_poses.seed = check->seed;
    return YK_CHECK_OPEN;
}

void yk_check_close(YkCheck *check)
{
    yk_check_free_poses(&check->own_poses);
    free(check->values);
    free(check->elsewhere);
}

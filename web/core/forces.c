// Forces in the joints at the pose, for arrows.
#include "core.h"
#include "exports.h"

static void write_reaction(const YkDynamics *dynamics, size_t joint, double *numbers)
{
    YkReaction reaction = yk_dynamics_reaction(dynamics, joint);
    numbers[0] = reaction.at[0];
    numbers[1] = reaction.at[1];
    numbers[2] = reaction.force[0];
    numbers[3] = reaction.force[1];
    numbers[4] = reaction.is_determinate;
}

// Writes what there is to say to the message. Returns the status.
static int tell(const YkProblems *problems, const YkDynamics *dynamics, YkStatus status)
{
    if (problems && yk_problems_count(problems) > 0)
        yk_text_puts(&yk_core.message, yk_problems_get(problems, 0)->message);
    else if (dynamics && status != YK_OK && status != YK_REDUNDANT)
        yk_text_puts(&yk_core.message, yk_dynamics_report(dynamics)->message);
    else if (dynamics && !yk_dynamics_has_loads(dynamics))
        yk_text_puts(&yk_core.message, "the machine has neither masses nor loads: all forces are 0");
    return status;
}

// Solves the dynamics with all inputs prescribed, on a copy of the state.
static YkStatus solve(YkDynamics *dynamics, YkState *copy)
{
    YkStatus status = yk_state_copy(copy, yk_core_shown());
    for (size_t i = 0; i < yk_input_count(yk_core.mech); i++) yk_dynamics_prescribe(dynamics, i, true);
    return status < 0 ? status : yk_dynamics_solve(dynamics, copy, YK_METHOD_REDUCED);
}

// Writes the numbers: for each joint x, y, m, the force that its first body exerts on its second, fx, fy, N, in the
// ground's axes, and 1 if it is determinate (0: one of many, the least). The inputs move as they do in the pose.
// Returns a status; where it is negative, or at a dead point or change point, there are no numbers, and the message
// says why.
YK_DOOR(ys_forces) int ys_forces(void)
{
    yk_core.number_count = 0;
    yk_text_clear(&yk_core.message);
    if (!yk_core.mech || !yk_state_has_pose(yk_core_shown())) return YK_BAD_ARGUMENT;
    YkProblems *problems = yk_problems_new();
    YkDynamics *dynamics = problems ? yk_dynamics_new(yk_core.mech, problems) : NULL;
    YkState *copy = yk_state_new(yk_core.mech);
    YkStatus status = !problems || !copy ? YK_NO_MEMORY : !dynamics ? YK_BAD_MODEL : solve(dynamics, copy);
    size_t joints = yk_sketch_joint_count(yk_core.sketch);
    double *numbers = status == YK_OK || status == YK_REDUNDANT ? yk_core_room(5 * joints) : NULL;
    for (size_t j = 0; numbers && j < joints; j++) write_reaction(dynamics, j, numbers + 5 * j);
    tell(problems, dynamics, status);
    yk_state_free(copy);
    yk_dynamics_free(dynamics);
    yk_problems_free(problems);
    return status;
}

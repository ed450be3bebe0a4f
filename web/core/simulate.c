// Lets go: simulates from the present pose under loads, with a spring by which the hand pulls.
#include <math.h>
#include "core.h"
#include "exports.h"

enum { STEPS_AT_ONCE = 3000 }; // of the integrator, a call: then it says how far it came

static size_t steps_left;

const YkState *yk_core_simulated(double *time)
{
    if (!yk_core.simulation) return NULL;
    if (time) *time = yk_simulation_time(yk_core.simulation);
    return yk_simulation_state(yk_core.simulation);
}

void yk_core_stop(void)
{
    yk_simulation_free(yk_core.simulation);
    yk_core.simulation = NULL;
}

static bool goes_on(void *context, double time)
{
    (void)context, (void)time;
    return steps_left-- > 1;
}

static int refuse(const YkProblems *problems)
{
    const char *why = "the machine cannot be let go";
    for (size_t k = 0; problems && k < yk_problems_count(problems); k++)
        if (yk_problems_get(problems, k)->severity == YK_SEVERITY_ERROR) why = yk_problems_get(problems, k)->message;
    return yk_core_tell(yk_core.state, YK_BAD_MODEL, why);
}

YK_DOOR(ys_release) int ys_release(void)
{
    if (!yk_core.state || !yk_state_has_pose(yk_core.state)) return ys_pose();
    YkProblems *problems = yk_problems_new();
    YkSimulationOptions options = yk_default_simulation_options();
    yk_core_settle();
    options.pose = yk_core.state;
    options.start = yk_state_time(yk_core.state);
    options.pulls = 1;
    options.goes_on = goes_on;
    if (problems) yk_core.simulation = yk_simulation_new(yk_core.model, &options, problems);
    int status = yk_core.simulation ? yk_core_tell(yk_core_shown(), YK_OK, "") : refuse(problems);
    yk_problems_free(problems);
    return status;
}

// Sets the spring between a point of a body, in its axes, and a place in the world; stiffness 0 lets go. The damping is
// that of the mass that it pulls, if that alone hung on it.
YK_DOOR(ys_pull) int ys_pull(size_t body, double x, double y, double to_x, double to_y, double stiffness)
{
    if (!yk_core.simulation || body >= yk_model_body_count(yk_core.model)) return YK_BAD_ARGUMENT;
    YkVec to = yk_core_in_model(body, yk_vec(to_x, to_y));
    YkPull pull = {.body = body, .place = {x, y}, .target = {to.x, to.y}, .stiffness = stiffness};
    pull.damping = 2 * sqrt(stiffness * yk_model_body_mass(yk_core.model, body));
    return yk_simulation_act_pull(yk_core.simulation, 0, stiffness > 0 ? &pull : NULL);
}

// Goes on by a span of time, s. A motion that needs very many steps stops on the way: ys_time says where.
YK_DOOR(ys_step) int ys_step(double seconds)
{
    if (!yk_core.simulation) return yk_core_tell(yk_core.state, YK_BAD_ARGUMENT, "the machine was not let go");
    steps_left = STEPS_AT_ONCE;
    YkStatus status = yk_simulation_step(yk_core.simulation, seconds);
    const char *why = status < 0 ? yk_simulation_report(yk_core.simulation)->message : "";
    return yk_core_tell(yk_core_shown(), status, why);
}

// Ends the simulation; the machine stays where it came to.
YK_DOOR(ys_hold) int ys_hold(void)
{
    if (!yk_core.simulation) return ys_pose();
    YkStatus status = yk_state_adopt(yk_core.state, yk_simulation_state(yk_core.simulation));
    yk_core.is_scheduled = false;
    yk_core_settle();
    return yk_core_tell(yk_core.state, status, status == YK_SINGULAR ? "" : NULL);
}

// Any bytes as a model file: loaded, dynamics at the start by both methods, moved a tenth of a second, laid to rest. No
// answer is NaN or infinite, and all of it ends.
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>
#include <yoke/yoke.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

enum { COORDINATES_MAX = 60, STEPS_MAX = 300, STARTS = 2, FREEDOM_MAX = 8 };

static void demand(bool condition)
{
    if (!condition) abort();
}

static void check_forces(const YkModel *model, const YkDynamics *dynamics)
{
    for (size_t j = 0; j < yk_model_joint_count(model); j++) {
        YkReaction r = yk_dynamics_reaction(dynamics, j);
        demand(isfinite(r.force[0]) && isfinite(r.force[1]) && isfinite(r.moment) && isfinite(r.at[0]) &&
               isfinite(r.at[1]));
    }
    YkEnergy e = yk_dynamics_energy(dynamics);
    demand(isfinite(e.kinetic) && isfinite(e.potential));
    for (size_t b = 1; b < yk_model_body_count(model); b++) demand(isfinite(yk_dynamics_balance(dynamics, b).residual));
}

static void check_dynamics(const YkModel *model, const YkMechanism *mech, YkProblems *problems)
{
    YkState *state = yk_state_new(mech);
    YkDynamics *dynamics = state ? yk_dynamics_new(mech, problems) : NULL;
    if (dynamics && yk_state_set_time(state, 0, problems) >= 0 && yk_state_assemble(state) >= 0)
        for (int method = 0; method < 2; method++) {
            YkStatus status = yk_dynamics_solve(dynamics, state, (YkMethod)method);
            if (status >= 0 && status != YK_SINGULAR) check_forces(model, dynamics);
            if (status < 0 || status == YK_SINGULAR) demand(yk_dynamics_report(dynamics)->message[0] != '\0');
            yk_dynamics_count(dynamics);
        }
    yk_dynamics_free(dynamics);
    yk_state_free(state);
}

static void simulate(const YkModel *model, YkIntegrator integrator, YkProblems *problems)
{
    YkSimulationOptions options = yk_default_simulation_options();
    options.integrator = integrator;
    options.tolerance = 1e-6;
    options.step = 1e-2;
    options.steps_max = STEPS_MAX;
    options.horizon = integrator == YK_INTEGRATOR_DOP853 ? 0.1 : 0;
    YkSimulation *sim = yk_simulation_new(model, &options, problems);
    for (int row = 0; sim && row <= 4; row++) {
        YkStatus status = yk_simulation_advance(sim, 0.025 * row);
        const YkState *state = yk_simulation_state(sim);
        for (size_t c = 0; c < yk_coordinate_count(yk_state_mechanism(state)); c++) {
            YkMotion m = yk_state_coordinate(state, c);
            demand(isfinite(m.position) && isfinite(m.velocity) && isfinite(m.acceleration));
        }
        demand(isfinite(yk_simulation_time(sim)));
        if (status < 0) demand(yk_simulation_report(sim)->message[0] != '\0');
        if (status < 0) break;
        yk_simulation_dynamics(sim);
    }
    if (sim) demand(!isnan(yk_simulation_summary(sim).energy_error));
    yk_simulation_free(sim);
}

static void rest(const YkModel *model, YkProblems *problems)
{
    YkRestOptions options = yk_default_rest_options();
    options.starts = STARTS;
    YkRest *found = yk_rest_find(model, &options, problems);
    for (size_t k = 0; found && k < yk_rest_count(found); k++) {
        demand(isfinite(yk_rest_equilibrium(found, k).potential));
        for (size_t m = 0; m < yk_rest_freedom(found); m++) demand(isfinite(yk_rest_mode(found, k, m).frequency));
        yk_rest_state(found, k);
    }
    yk_rest_free(found);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    YkProblems *problems = yk_problems_new();
    YkModel *model = problems ? yk_model_parse((const char *)data, size, "fuzz", NULL, problems) : NULL;
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    if (mech && yk_coordinate_count(mech) <= COORDINATES_MAX) {
        check_dynamics(model, mech, problems);
        bool few = yk_input_count(mech) <= FREEDOM_MAX;
        if (few) rest(model, problems);
        for (int integrator = 0; few && integrator < 3; integrator++)
            simulate(model, (YkIntegrator)integrator, problems);
    }
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return 0;
}

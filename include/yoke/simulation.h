// Simulation: motion in time under loads, from `start:`.
#ifndef YOKE_SIMULATION_H
#define YOKE_SIMULATION_H

#include <yoke/dynamics.h>

typedef enum YkIntegrator { YK_INTEGRATOR_DOP853, YK_INTEGRATOR_SDIRK4, YK_INTEGRATOR_RK4 } YkIntegrator;

typedef struct YkStartValue {
    const char *coordinate; // a coordinate of the tree
    bool is_rate;
    double value; // rad, m, rad/s, m/s
} YkStartValue;

typedef struct YkSimulationOptions {
    YkIntegrator integrator;
    double tolerance; // relative error per step, and absolute in the coordinate's size; default 1e-9
    double step;      // RK4: its fixed step, s
    double start;     // initial time, s
    double horizon;   // the last time that will be asked for, s: lets steps pass the rows (0: each row ends a step)
    size_t steps_max; // largest number of accepted steps and events, in all (0: no limit)
    bool (*goes_on)(void *context,
                    double time); // asked after every step (NULL: yes); false ends yk_simulation_advance there
    void *context;
    const YkStartValue *values; // replace those of `start:`
    size_t value_count;
    const YkCompileOptions *compile; // NULL: defaults
    const YkState
        *pose; // where it begins: a state of the machine, whatever its inputs; NULL: assembled as `start:` says
} YkSimulationOptions;
YK_API YkSimulationOptions yk_default_simulation_options(void);

typedef struct YkSimulation YkSimulation;

// Assembles the machine at its start. Start rates that the loops do not allow are projected, with a note. Returns
// NULL with problems added: no assembly, a freedom without inertia, stops that exclude the start. The model must
// outlive the simulation.
YK_API YkSimulation *yk_simulation_new(const YkModel *model, const YkSimulationOptions *options, YkProblems *problems);
YK_API void yk_simulation_free(YkSimulation *simulation);
// Also reports zero crossings of a channel minus a value, as events called `name` (copied). direction: +1, -1, 0: both.
YK_API YkStatus yk_simulation_watch(YkSimulation *simulation, const char *name, YkChannel channel, double value,
                                    int direction);
// Replaces the effort that `efforts:` gives along a coordinate by a constant; only before the first advance.
YK_API YkStatus yk_simulation_set_effort(YkSimulation *simulation, const char *coordinate, double effort);
// Advances to time `to`. The state then stands exactly at `to` (dense output, loops closed by the position solver). On
// failure it stands at the last good time and the status is below 0: YK_LIMIT (also if a drive goes past a stop),
// YK_NOT_CONVERGED (step too small, too many steps), YK_NO_MEMORY. The report says why, with a status of its own:
// YK_SINGULAR if a dead point or a freedom without inertia stopped it. YK_BAD_ARGUMENT for a time that is past or not
// finite, which changes nothing. If options.goes_on said no, the status is YK_OK and yk_simulation_time tells how far
// it came.
YK_API YkStatus yk_simulation_advance(YkSimulation *simulation, double to);
YK_API double yk_simulation_time(const YkSimulation *simulation);
// State, mechanism and dynamics are valid until the next advance, which may choose other coordinates. Coordinates,
// joints, bodies and points keep their indices; blocks (channels of transmission angles) may not.
YK_API YkState *yk_simulation_state(YkSimulation *simulation);       // pose, rates and accelerations at that time
YK_API YkDynamics *yk_simulation_dynamics(YkSimulation *simulation); // forces at that time, solved when first asked for
YK_API double yk_simulation_channel(YkSimulation *simulation, YkChannel channel);
YK_API const YkReport *yk_simulation_report(const YkSimulation *simulation);

typedef enum YkHappeningKind {
    YK_HAPPENING_STOP,
    YK_HAPPENING_RELEASE,
    YK_HAPPENING_STICK,
    YK_HAPPENING_SLIP,
    YK_HAPPENING_CHANGE_POINT, // of a block: two branches meet, and momentum carries through
    YK_HAPPENING_DEAD_POINT,   // of the one coordinate that the machine was started by: it reverses, the rest goes on
    YK_HAPPENING_CROSSING
} YkHappeningKind;
typedef struct YkHappening {
    YkHappeningKind kind;
    double time;
    const char *name; // of the coordinate, joint or watched expression
    double value;     // STOP: rate before; CROSSING: the value watched
} YkHappening;
YK_API size_t yk_simulation_happening_count(const YkSimulation *simulation);
YK_API YkHappening yk_simulation_happening(const YkSimulation *simulation, size_t index);

typedef struct YkSimulationSummary {
    size_t steps, rejected, evaluations, recoordinations; // the last counts changes of the independent coordinates
    double energy_error;   // |E - E(0) - work of loads and drives| at worst, over the largest energy (kinetic + span of
                           // potential)
    double worst_residual; // of the loops, over the machine's size
    double energy_start, energy_end;
} YkSimulationSummary;
YK_API YkSimulationSummary yk_simulation_summary(const YkSimulation *simulation);
// Work done so far by every load without a potential (efforts, forces, dampers, friction, drives, stops): its name, and
// J.
YK_API size_t yk_simulation_work_count(const YkSimulation *simulation);
YK_API const char *yk_simulation_work_name(const YkSimulation *simulation, size_t index);
YK_API double yk_simulation_work(const YkSimulation *simulation, size_t index);

#endif

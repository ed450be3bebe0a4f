// Simulation: motion in time under loads, from `start:`.
#ifndef YOKE_SIMULATION_H
#define YOKE_SIMULATION_H

#include <yoke/dynamics.h>

#ifdef __cplusplus
extern "C" {
#endif

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
    double horizon;   // the last time that will be requested, s: lets steps pass the rows (0: each row ends a step)
    size_t steps_max; // largest number of accepted steps and events, in all (0: no limit)
    bool (*goes_on)(void *context,
                    double time); // called after every step (NULL: goes on); false ends yk_simulation_advance there
    void *context;
    const YkStartValue *values; // replace those of `start:`
    size_t value_count;
    const YkCompileOptions *compile; // NULL: defaults
    const YkState
        *pose;    // where it begins: a state of the machine, whatever its inputs; NULL: assembled as `start:` says
    size_t pulls; // how many pulls the host may exert at a time (yk_simulation_act_pull); 0: none
} YkSimulationOptions;
YK_API YkSimulationOptions yk_default_simulation_options(void);

typedef struct YkSimulation YkSimulation;

// Assembles the machine at its start. Start rates that the loops do not allow are projected, with a note. Returns
// NULL with problems added: no assembly, a freedom without inertia, stops that exclude the start. The model, and all
// that the options point to, must outlive the simulation.
YK_API YkSimulation *yk_simulation_new(const YkModel *model, const YkSimulationOptions *options, YkProblems *problems);
YK_API void yk_simulation_free(YkSimulation *simulation);
// Also reports the times at which a channel passes a value, as events called `name` (copied). direction: +1 rising, -1
// falling, 0 both.
YK_API YkStatus yk_simulation_watch(YkSimulation *simulation, const char *name, YkChannel channel, double value,
                                    int direction);
// Replaces the effort that `efforts:` gives along a coordinate by a constant; only before the first advance. From then
// on yk_simulation_act_effort may change it at any time.
YK_API YkStatus yk_simulation_set_effort(YkSimulation *simulation, const char *coordinate, double effort);
// Advances to time `to`. The state is then exactly at `to` (dense output, loops closed by the position solver). On
// failure it is at the last good time and the status is below 0: YK_LIMIT (also if a drive goes past a stop),
// YK_NOT_CONVERGED (step too small, too many steps), YK_NO_MEMORY. The report says why, with a status of its own:
// YK_SINGULAR if a dead point or a freedom without inertia stopped it. Returns YK_BAD_ARGUMENT, and changes nothing, if
// the time is in the past or not finite. If options.goes_on returned false, the status is YK_OK, and yk_simulation_time
// gives the time reached.
YK_API YkStatus yk_simulation_advance(YkSimulation *simulation, double to);
YK_API double yk_simulation_time(const YkSimulation *simulation);
// State, mechanism and dynamics are valid until the next advance, which may choose other coordinates. Coordinates,
// joints, bodies and points keep their indices; blocks (channels of transmission angles) may not.
YK_API YkState *yk_simulation_state(YkSimulation *simulation);       // pose, rates and accelerations at that time
YK_API YkDynamics *yk_simulation_dynamics(YkSimulation *simulation); // forces at that time, solved when first asked for
YK_API double yk_simulation_channel(YkSimulation *simulation, YkChannel channel);
YK_API const YkReport *yk_simulation_report(const YkSimulation *simulation);

// Lets a certifier (yoke/certificate.h) watch the motion from here on: the poses at the ends of steps, at events and
// wherever the simulation is advanced to. It may have been made for any mechanism of the model, and may have watched
// the motion of options.pose before; it must outlive the simulation, or the next call. A step that is proved to have
// gone over to another configuration is taken back and repeated with shorter ones; if that does not help, the motion
// ends with YK_NOT_CONVERGED. Otherwise the motion has the same bits as without. Clones have none. NULL ends this.
typedef struct YkCertifier YkCertifier;
YK_API void yk_simulation_set_certifier(YkSimulation *simulation, YkCertifier *certifier);

// Advances by a span of time, s >= 0.
YK_API YkStatus yk_simulation_step(YkSimulation *simulation, double span);

// Acting on the machine, between advances and in a control. What is set holds from the simulation's present time until
// it is set again; the state and the forces at that time are those before the change. The integrator starts anew at
// that time, but only if something has changed. Coordinates and bodies are given by number (yk_coordinate_find). Each
// function returns YK_BAD_ARGUMENT, and changes nothing, if there is no such thing or a number is not finite.

// Sets the effort along a coordinate, N m or N: one that `efforts:` or yk_simulation_set_effort names.
YK_API YkStatus yk_simulation_act_effort(YkSimulation *simulation, size_t coordinate, double effort);
// Takes over a driven coordinate: it continues from its present position and rate with this acceleration (rad/s^2 or
// m/s^2), in place of its drive.
YK_API YkStatus yk_simulation_act_drive(YkSimulation *simulation, size_t coordinate, double acceleration);
// A force on a point of a body: force + stiffness (target - point) - damping (velocity of the point), world axes. With
// a stiffness it is the spring by which a mouse pulls. It is evaluated within the steps, and its work counts as that of
// "pulls".
typedef struct YkPull {
    size_t body;
    double place[2];  // of the point, in the body's axes, m
    double target[2]; // in the world, m
    double stiffness; // N/m
    double damping;   // N s/m
    double force[2];  // N
} YkPull;
// Sets pull number `index`, which is below options.pulls; NULL lets go.
YK_API YkStatus yk_simulation_act_pull(YkSimulation *simulation, size_t index, const YkPull *pull);

// Calls `control` now and after every further `period`, s, exactly at these times: the integrator ends a step there,
// and the state is at that time. What the control sets is held until the next sample. If it returns false, the advance
// ends there, as with options.goes_on. The control must not advance, reset, restore or free the simulation. There is
// one control at a time; NULL removes it. Returns YK_BAD_ARGUMENT for a period that is not positive.
typedef bool (*YkControl)(void *context, YkSimulation *simulation, double time);
YK_API YkStatus yk_simulation_set_control(YkSimulation *simulation, double period, YkControl control, void *context);
// The number of calls of the present control, and the time of call `index`.
YK_API size_t yk_simulation_sample_count(const YkSimulation *simulation);
YK_API double yk_simulation_sample_time(const YkSimulation *simulation, size_t index);

// Goes back to the start, as if nothing had happened or been set since the first advance. Efforts set before it,
// watches and the control stay; the control's samples begin at the start again. What follows has the same bits as the
// first time. On failure (YK_NO_MEMORY) nothing changes.
YK_API YkStatus yk_simulation_reset(YkSimulation *simulation);
// Makes a second simulation in the same condition, which goes on with the same bits. It has the same options and the
// same control, with their contexts. Returns NULL when out of memory.
YK_API YkSimulation *yk_simulation_clone(YkSimulation *simulation);
// Writes the simulation as bytes, at most `capacity` of them, and returns how many it needs; writes nothing if they
// do not fit. The bytes contain a format version, the machine's fingerprint and a checksum.
YK_API size_t yk_simulation_save(YkSimulation *simulation, void *bytes, size_t capacity);
// Brings a simulation of the same machine to the point at which another one was saved: its options, acts, watches and
// results, but not the callbacks, which stay those of `simulation`. It goes on with the same bits as the saved one.
// Returns YK_BAD_ARGUMENT if the bytes are damaged, incomplete, or of another version; YK_BAD_MODEL if they belong to
// another machine. On failure nothing changes.
YK_API YkStatus yk_simulation_restore(YkSimulation *simulation, const void *bytes, size_t count);

typedef enum YkHappeningKind {
    YK_HAPPENING_STOP,
    YK_HAPPENING_RELEASE,
    YK_HAPPENING_STICK,
    YK_HAPPENING_SLIP,
    YK_HAPPENING_CHANGE_POINT, // of a block: two branches meet, and momentum carries through
    YK_HAPPENING_DEAD_POINT,   // of the coordinate that started the machine: it reverses while the others continue
    YK_HAPPENING_CROSSING,
    YK_HAPPENING_LIFT_OFF, // of a cam: its follower leaves it and flies free
    YK_HAPPENING_LAW_LEFT, // the argument of a law leaves its range for the first time (yoke/laws.h)
    YK_HAPPENING_LANDING,  // of a cam: its follower meets it again, and stays (a plastic impact)
    YK_HAPPENING_PULL      // of a cam: from here on it would have to pull its follower, which cannot fly, since no mass
                           // determines how; the motion goes on as if they stayed in contact
} YkHappeningKind;
typedef struct YkHappening {
    YkHappeningKind kind;
    double time;
    const char *name; // of the coordinate, joint, force, spring or watched expression
    double value;     // STOP: rate before; CROSSING: the value watched; LIFT_OFF and PULL: angle of the cam's
                      // joint, rad; LANDING: rate at which it closes in on the cam, below 0; LAW_LEFT: the argument, SI
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
// Work done so far by every load without a potential (efforts, forces, dampers, friction, drives, pulls, stops and
// landings on cams): the name of the load, and the work in J.
YK_API size_t yk_simulation_work_count(const YkSimulation *simulation);
YK_API const char *yk_simulation_work_name(const YkSimulation *simulation, size_t index);
YK_API double yk_simulation_work(const YkSimulation *simulation, size_t index);

#ifdef __cplusplus
}
#endif

#endif

// The inside of YkSimulation.
#ifndef SIMULATE_SIMULATION_H
#define SIMULATE_SIMULATION_H
#include <yoke/move.h>
#include <yoke/simulation.h>
#include "dynamics/dynamics.h"
#include "num/bounded.h"
#include "num/ode.h"

// A block near a singular position: the angle between its two columns, as last known, and how it goes on.
typedef struct YkNear {
    size_t block;
    double angle, rate, acceleration; // its sine's sign is the branch
} YkNear;

// What holds a coordinate: a stop that it rests against, or dry friction that makes it stick.
typedef struct YkContact {
    size_t item;      // of the loads: COULOMB or STOP
    double low, high; // what it can exert
} YkContact;

typedef struct YkEventWatch {
    const char *name;
    YkChannel channel;
    double level;
    int direction;
    double last; // its value at the last accepted step
} YkEventWatch;

typedef enum YkPendingKind {
    YK_PENDING_NONE,
    YK_PENDING_STOP,
    YK_PENDING_STICK,
    YK_PENDING_RELEASE // a contact can no longer hold
} YkPendingKind;

typedef struct YkCommand { // of a driven coordinate that the host has taken over
    bool is_set;
    double time, position, rate, acceleration; // from that time on
} YkCommand;

typedef struct YkSampling { // of the control
    YkControl control;      // NULL: none
    void *context;
    double from, period;
    size_t count; // samples taken
} YkSampling;

struct YkSimulation {
    const YkModel *model;
    YkSimulationOptions options;
    YkArena *arena; // names
    YkMechanism *mech;
    YkState *state;
    YkDynamics *dynamics;
    YkOde *ode;
    int32_t *free_input; // inputs that are free
    size_t free_count;
    size_t work_count, item_count; // quadratures: items of the loads, then driven inputs, then stops
    int32_t *chosen;               // the coordinates that were asked for as inputs, in their order
    size_t chosen_count;
    double *effort; // [2][coordinate]: set from outside, now and before the first advance
    bool *has_effort;
    YkCommand *commands; // per coordinate; NULL: none yet
    bool has_acted;      // since the stepper began
    bool is_in_control;
    YkSampling sampling;
    double *y, *dense, *rate, *work; // [2 free + works]; work[work_count] at `time`
    double time;
    bool has_drives, is_lean; // lean: an open tree with nothing to watch between rows
    bool has_forces;          // the dynamics' forces are those of `time`
    // singular positions
    YkNear *near, *near_next, *near_memory;
    size_t near_count;
    double near_time;                 // of the step at which they were looked at
    double *moved, *sampled, *looked; // scratch, as y
    double *pose_sum;                 // a pose that is interpolated: as the state's space
    bool is_flat;                     // the start is a change point; flat_slope: of the angle there, by the free input
    double flat_slope, flat_kinetic;
    // contacts
    YkContact *contacts;
    size_t contact_count;
    double *response, *matrix, *bias, *lambda, *wanted; // [contact][input], [contact][contact], [contact]
    double *kept, *contact_work;                        // [contact], scratch of num/bounded
    YkBounds *bounds;
    size_t *contact_order;
    int sweeps_max;  // over the contacts
    bool is_testing; // contacts exert no more than their bounds allow; within steps they hold whatever it takes
    double fastest;  // rate of an impact so far
    size_t pending_item;
    YkPendingKind pending;
    double pending_time, last_event;
    size_t stalled, events; // events since time last went on; in all
    // dead points
    int32_t first; // the coordinate that a machine with one freedom and loops was started by; otherwise YK_NONE
    double first_rate;
    // findings
    YkEventWatch *watches;
    size_t watch_count, watch_capacity;
    YkHappening *happenings;
    size_t happening_count, happening_capacity;
    YkSimulationSummary summary;
    double energy_low, energy_high; // potential
    double kinetic_high, energy_off;
    bool has_energy, has_begun;
    bool is_new_step;   // its end has not been looked at yet
    bool is_elsewhere;  // the state stands at a row, not at the end of the last step
    double target;      // time asked for
    YkOdeCounts counts; // of steppers that were replaced
    YkReport report;
    YkStatus status;
};

// simulation.c: a simulation that stands nowhere yet, with the efforts, watches and control of another one (NULL: none).
YkSimulation *yk_simulation_blank(const YkModel *model, const YkSimulationOptions *options, const YkSimulation *like);
// Takes the place of another one, which is freed, at the same address.
void yk_simulation_replace(YkSimulation *simulation, YkSimulation *by);

// act.c: what the host does.
bool yk_simulation_make_efforts(YkSimulation *simulation); // room for them; false when out of memory
// The inputs at a time, as drives and the host's commands say.
YkStatus yk_simulation_set_time(const YkSimulation *simulation, YkState *state, double time, YkProblems *problems);
double yk_simulation_next_sample(const YkSimulation *simulation); // HUGE_VAL where there is no control

// results.c: takes account of the energy at the pose that stands.
void yk_simulation_count_energy(YkSimulation *sim);

// initial_rates.c
typedef struct YkStartRate { // a rate that the start asks for
    size_t coordinate;
    double rate;
} YkStartRate;
// given[as many as `start:` and the options have, and one]: without those of drives. Returns how many.
size_t yk_simulation_given_rates(const YkSimulation *sim, YkStartRate *given);
// singular_start.c: the start stands at a dead point or change point. Takes other coordinates, or a branch with its
// rates; false with a problem added where nothing tells how it goes on.
bool yk_simulation_is_singular(const YkSimulation *sim);
bool yk_simulation_start_singular(YkSimulation *sim, YkProblems *problems);
// Rates of the inputs from what `start:` gives, as well as the loops allow.
bool yk_simulation_start_rates(YkSimulation *sim, YkProblems *problems);

// right_hand_side.c: the right-hand side.
void yk_simulation_powers(YkSimulation *sim, double *power); // of all works, at the pose just accelerated
int yk_simulation_motion(void *simulation, double t, const double *y, double *dydt);
// Sets the inputs of the state for (t, y); signs of near blocks too. False where a drive has no value.
bool yk_simulation_set(YkSimulation *sim, double t, const double *y);
// The state's pose at (t, y) with its accelerations. Sets sim->status and the report on failure. stand_at: without a
// closer look at what is near, and leaving angles' references and sim->time as they are.
bool yk_simulation_stand_at(YkSimulation *sim, double t, const double *y);
bool yk_simulation_pose(YkSimulation *sim, double t, const double *y);

// crossing.c and its neighbours: change points.
void yk_simulation_look_near(YkSimulation *sim, double t); // at the pose that stands: which blocks are near
// Before a pose within the last step, or at its end: looks at near blocks again a little before it where it lies so
// near to a singular position that the prediction from the step's start may have the wrong sign.
void yk_simulation_look_closer(YkSimulation *sim, double t);
void yk_simulation_set_signs(YkSimulation *sim, double t);
// For how long, at the rates of the pose that stands, no block that is not near comes to a singular position.
double yk_simulation_reach(YkSimulation *sim);
double yk_simulation_margin(const YkSimulation *sim);
double yk_simulation_input_scale(const YkSimulation *sim, size_t free); // 1 rad, or the machine's size
// interpolation.c: is the pose so near that they are interpolated?
bool yk_simulation_in_zone(const YkSimulation *sim, double t);
// Accelerations and powers next to a singular position, by interpolation along the motion. LEFT: the pose itself tells
// them better.
typedef enum YkInterpolation { YK_INTERPOLATION_DONE, YK_INTERPOLATION_LEFT, YK_INTERPOLATION_FAILED } YkInterpolation;
YkInterpolation yk_simulation_interpolate(YkSimulation *sim, double t, const double *y, double *dydt);

// The pose at (t, y) where it is so near to a singular position that it does not tell its own rates: the sum of poses
// before and after it, false where it needs none or has none. Then, when the state stands there, takes it.
bool yk_simulation_sum_poses(YkSimulation *sim, double t, const double *y, const double *acceleration);
void yk_simulation_take_sum(YkSimulation *sim);

// coordinates.c: other independent coordinates.
// Are others better here? Then takes them: everything is made anew for them, the pose stays. False on failure.
bool yk_simulation_recoordinate(YkSimulation *sim, bool *changed);
// Takes the coordinates order[free] as independent ones in the pose that stands; it stays as it is (*changed is left)
// where they do not fit. False on failure.
bool yk_simulation_take(YkSimulation *sim, const size_t *order, bool *changed);
void yk_simulation_unbuild(YkSimulation *sim);
bool yk_simulation_stepper(YkSimulation *sim); // keeps the address of sim: after all else stands
bool yk_simulation_build(YkSimulation *sim, const YkCompileOptions *compile, YkProblems *problems);

// contact.c
bool yk_simulation_contacts_start(
    YkSimulation *sim); // which stops are touched, which joints stick, at the pose that stands
// Accelerations with what the contacts exert, into dynamics->acceleration.
YkStatus yk_simulation_accelerate(YkSimulation *sim);
// Of a contact's coordinate, under what the contacts exert by the last evaluation; exactly 0 where it is no more than
// rounding leaves.
double yk_simulation_contact_acceleration(const YkSimulation *sim, size_t contact);
bool yk_simulation_contacts_check(YkSimulation *sim); // contacts that cannot hold let go, one at a time
// impact.c: the stop is hit, with all others that are reached now, or the rate of the dry joint has become 0.
bool yk_simulation_hit(YkSimulation *sim, size_t item);

// events.c
void yk_simulation_note(YkSimulation *sim, YkHappeningKind kind, double time, const char *name, double value);
void yk_simulation_look(YkSimulation *sim); // after a step: what happened in it
bool yk_simulation_look_dead(YkSimulation *sim);
void yk_simulation_watch_start(YkSimulation *sim);

// --- standstill.c: after a failure
// The pose of the last time that was reached, with the accelerations found there.
void yk_simulation_stand_still(YkSimulation *simulation);
// Where no reason is known, what the pose tells, into the report: status YK_SINGULAR near a dead point, the
// simulation's own elsewhere.
void yk_simulation_explain(YkSimulation *simulation);

#endif

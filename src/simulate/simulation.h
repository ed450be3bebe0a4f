// The inside of YkSimulation.
#ifndef SIMULATE_SIMULATION_H
#define SIMULATE_SIMULATION_H
#include <yoke/move.h>
#include <yoke/simulation.h>
#include "dynamics/dynamics.h"
#include "dynamics/law_uses.h"
#include "num/bounded.h"
#include "num/ode/ode.h"
#include "solve/state.h"

// A block near a singular position: the last known angle between its two columns, and how it continues.
typedef struct YkNear {
    size_t block;
    double angle, rate, acceleration; // the sign of its sine is the branch
} YkNear;

// A search for the least margin of a near block (apart.c), from rounds of four samples around `at`.
typedef struct YkSearch {
    size_t block;
    double at, h; // the outer samples are at +-h
    double f[4];  // the margins in them
    int rounds;
    bool is_open, is_with; // not decided yet; takes part in this round
    bool is_touched;       // the decision
} YkSearch;

// Something that holds a coordinate: a stop against which it rests, or dry friction that makes it stick; in an impact
// also a cam that its follower reaches or touches.
typedef struct YkContact {
    size_t item;      // of the loads: COULOMB or STOP; unused for a cam
    int32_t cam;      // of the model; otherwise YK_NONE
    double low, high; // range of what it can exert
} YkContact;

// A cam of the model.
typedef struct YkFlight {
    double way;    // +1 if its follower's coordinate grows as it leaves, otherwise -1; known once it has left
    bool is_held;  // its follower cannot fly, since nothing would determine its motion
    bool is_about; // within an impact: it touches its follower
} YkFlight;

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
    YK_PENDING_RELEASE, // a contact can no longer hold
    YK_PENDING_LIFT_OFF,
    YK_PENDING_LANDING // pending_item is the cam
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
    YkArena *room;  // arrays of the machine as it is compiled now
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
    bool forces_are_known;    // false at a dead point or change point
    // Singular positions:
    YkNear *near, *near_next;
    YkSearch *searches; // [block], scratch
    size_t near_count;
    bool keeps_apart; // the blocks that are near keep their signs: branches come close there, and do not meet (apart.c)
    double near_time; // of the step at which they were examined
    double *moved, *sampled, *looked; // scratch, as y
    double *pose_sum;                 // an interpolated pose, like the state's space
    YkState *guide;                   // where drives alone move the machine: the same pose, followed as sweeps do
    bool is_flat; // the start is a change point; flat_slope: slope of the angle there, by the free input
    double flat_slope, flat_kinetic;
    // Contacts:
    YkContact *contacts;
    size_t contact_count;
    double *response, *matrix, *bias, *lambda, *wanted; // [contact][input], [contact][contact], [contact]
    double *kept, *contact_work;                        // [contact], scratch of num/bounded
    YkBounds *bounds;
    size_t *contact_order;
    bool *open; // per cam: whether its follower is off it
    YkFlight *flights;
    int sweeps_max;  // over the contacts
    bool is_testing; // contacts exert no more than their bounds allow; within steps they hold at any effort
    double fastest;  // rate of an impact so far
    size_t pending_item;
    YkPendingKind pending;
    double pending_time, last_event;
    size_t stalled, events; // events since time last advanced; in total
    // Dead points:
    int32_t first; // the coordinate by which a machine with one freedom and loops was started; otherwise YK_NONE
    double first_rate;
    // Findings:
    YkEventWatch *watches;
    size_t watch_count, watch_capacity;
    YkLawWatch *laws; // the uses of laws that can be left; nothing is noted in it
    YkHappening *happenings;
    size_t happening_count, happening_capacity;
    YkSimulationSummary summary;
    double energy_low, energy_high; // potential
    double kinetic_high, energy_off;
    bool has_energy, has_begun;
    bool is_new_step;   // its end has not been examined yet
    bool is_elsewhere;  // the state is at a row, not at the end of the last step
    double target;      // requested time
    YkOdeCounts counts; // of steppers that were replaced
    YkReport report;
    YkStatus status;
    // Certificates (witness.c):
    YkWitness *witness; // or NULL
    YkState *home;      // the last pose that it received as a step; NULL: none yet, or no groups
    double redo_until, redo_step;
    int redone; // times in succession that a step was taken back
};

// witness.c: tells the witness that the motion begins at the state, which has the pose of `from`, a state of another
// mechanism; NULL: it begins anywhere.
void yk_simulation_tell_start(YkSimulation *sim, const YkState *from);
// Passes it the present pose. Returns false, with a report, if that is proved to be on another configuration.
bool yk_simulation_tell(YkSimulation *sim, YkWitnessed kind);
// Returns whether the step that the integrator has just made is proved to end on another configuration.
bool yk_simulation_has_jumped(YkSimulation *sim);
// Takes that step back: the state stands at its beginning, and the next ones will be shorter. Returns false if that has
// not helped before.
bool yk_simulation_go_home(YkSimulation *sim);

// simulation.c: makes a simulation without a pose, with the efforts, watches and control of another one (NULL: none).
YkSimulation *yk_simulation_blank(const YkModel *model, const YkSimulationOptions *options, const YkSimulation *like);
// Replaces a simulation at the same address by another one, and frees the old one.
void yk_simulation_replace(YkSimulation *simulation, YkSimulation *by);

// act.c: actions of the host.
bool yk_simulation_make_efforts(YkSimulation *simulation); // makes room for them; false when out of memory
// Sets the inputs at a time, from drives and the host's commands.
YkStatus yk_simulation_set_time(const YkSimulation *simulation, YkState *state, double time, YkProblems *problems);
double yk_simulation_next_sample(const YkSimulation *simulation); // HUGE_VAL if there is no control

// results.c: accounts for the energy at the present pose.
void yk_simulation_count_energy(YkSimulation *sim);
// Returns whether the balance of energy is off by more than steps of that tolerance can be: the poses are not the
// machine's motion. Fixed steps are as coarse as they were asked to be.
bool yk_simulation_has_lost_energy(const YkSimulation *sim);

// initial_rates.c
typedef struct YkStartRate { // a rate requested for the start
    size_t coordinate;
    double rate;
} YkStartRate;
// Fills given[number in `start:` and the options, plus one], without the rates of drives. Returns how many.
size_t yk_simulation_given_rates(const YkSimulation *sim, YkStartRate *given);
// Finds rates of the inputs from those in `start:`, as well as the loops allow.
bool yk_simulation_start_rates(YkSimulation *sim, YkProblems *problems);

// singular_start.c: handles a start at a dead point or change point. Takes other coordinates, or a branch with its
// rates; returns false with a problem added if nothing determines how it continues.
bool yk_simulation_is_singular(const YkSimulation *sim);
bool yk_simulation_start_singular(YkSimulation *sim, YkProblems *problems);

// stage.c: sets the state's inputs for (t, y), and the signs of near blocks. Returns false if a drive has no value.
bool yk_simulation_set(YkSimulation *sim, double t, const double *y);
void yk_simulation_powers(YkSimulation *sim, double *power); // of all works, at the pose accelerated last

// right_hand_side.c
int yk_simulation_motion(void *simulation, double t, const double *y, double *dydt);
// Solves the state's pose at (t, y) with its accelerations, without a closer look at near blocks; leaves the angles'
// references and sim->time unchanged. Sets sim->status and the report on failure.
bool yk_simulation_stand_at(YkSimulation *sim, double t, const double *y);

// crossing.c and its neighbours: change points.
void yk_simulation_look_near(YkSimulation *sim, double t); // finds which blocks are near at the present pose
// Solves the pose at (t, y) as yk_simulation_stand_at does, with a closer look at near blocks, and moves there.
bool yk_simulation_pose(YkSimulation *sim, double t, const double *y);
// apart.c: returns whether the last step took a sign for another though branches do not meet there; near blocks keep
// their signs from then on, and the step must be repeated.
bool yk_simulation_must_keep_apart(YkSimulation *sim);
// Looks along the only free input whether branches meet where near blocks are heading. Returns false if the pose, at
// sim->time, cannot be solved again.
bool yk_simulation_look_whether_apart(YkSimulation *sim);
// Returns how long a step may be, s, near such a place.
double yk_simulation_reach_apart(const YkSimulation *sim);
// reach.c: returns for how long, at the present rates, no block that is not near reaches a singular position.
double yk_simulation_reach(YkSimulation *sim);
// interpolation.c: returns whether the pose is so near that accelerations are interpolated.
bool yk_simulation_in_zone(const YkSimulation *sim, double t);
// Interpolates accelerations and powers next to a singular position, along the motion. LEFT: the pose itself gives them
// better.
typedef enum YkInterpolation { YK_INTERPOLATION_DONE, YK_INTERPOLATION_LEFT, YK_INTERPOLATION_FAILED } YkInterpolation;
YkInterpolation yk_simulation_interpolate(YkSimulation *sim, double t, const double *y, double *dydt);

// Sums up poses before and after (t, y) if it is so near to a singular position that it does not determine its own
// rates; returns false if it needs no sum or has none. The second takes the sum once the state is there.
bool yk_simulation_sum_poses(YkSimulation *sim, double t, const double *y, const double *acceleration);
bool yk_simulation_take_sum(YkSimulation *sim);

// choose.c: takes other independent coordinates if they are better here: everything is remade for them, the pose stays.
// Returns false on failure.
bool yk_simulation_recoordinate(YkSimulation *sim, bool *changed);
// coordinates.c: takes the coordinates order[free] as independent ones at the present pose; leaves everything (and
// *changed) as it is if they do not fit. Returns false on failure.
bool yk_simulation_take(YkSimulation *sim, const size_t *order, bool *changed);
void yk_simulation_unbuild(YkSimulation *sim);
bool yk_simulation_stepper(YkSimulation *sim); // keeps the address of sim: call it after everything else is made
bool yk_simulation_build(YkSimulation *sim, const YkCompileOptions *compile, YkProblems *problems);

// Takes other independent coordinates by name, or as many as there are with the cams that are open now. Returns false
// on failure; *changed: whether they fit.
bool yk_simulation_take_named(YkSimulation *sim, const char *const *names, size_t count, size_t free_count,
                              bool *changed);
static inline size_t yk_simulation_contacts_max(const YkSimulation *sim)
{
    return sim->item_count + sim->model->cam_count;
}

// cam_gap.c
YkMotion yk_simulation_gap(const YkSimulation *sim, size_t cam); // above 0 off the cam; without acceleration

// flight.c: followers off their cams.
// Returns whether this cam can lose its follower, and has not.
bool yk_simulation_is_loose(const YkSimulation *sim, size_t cam);
double yk_simulation_pull(YkSimulation *sim,
                          size_t cam);                      // above 0 if it would have to pull; 0 if forces are unknown
bool yk_simulation_lift_off(YkSimulation *sim, size_t cam); // at the present pose; false on failure
bool yk_simulation_open_touching(YkSimulation *sim);        // before an impact: all cams, those that touch are marked
bool yk_simulation_close_touching(YkSimulation *sim);       // after it: those from which the follower does not part

// contact.c
bool yk_simulation_contacts_start(
    YkSimulation *sim); // which stops are touched, which joints stick, at the present pose
// Finds accelerations including the contacts' efforts, in dynamics->acceleration.
YkStatus yk_simulation_accelerate(YkSimulation *sim);
// Returns the acceleration of a contact's coordinate, under the contacts' efforts by the last evaluation; exactly 0 if
// it is no more than rounding.
double yk_simulation_contact_acceleration(const YkSimulation *sim, size_t contact);
bool yk_simulation_contacts_check(YkSimulation *sim); // releases contacts that cannot hold, one at a time
// impact.c: hits the stop, with all others that are reached now, or handles the rate of the dry joint reaching 0.
bool yk_simulation_hit(YkSimulation *sim, size_t item);
// The follower reaches its cam: a plastic impact.
bool yk_simulation_land(YkSimulation *sim, size_t cam);

// scales.c
double yk_simulation_input_scale(const YkSimulation *sim, size_t free); // 1 rad, or the machine's size
// Returns the energy of the machine as one rigid body that turns at 1 rad/s.
double yk_simulation_energy_scale(const YkSimulation *sim);
// Lower rates count as rest, rad/s or machine sizes per second.
double yk_simulation_rate_floor(const YkSimulation *sim);
double yk_simulation_margin(const YkSimulation *sim); // of the present pose

// happenings.c: keeps what happens, up to a fixed number.
void yk_simulation_note(YkSimulation *sim, YkHappeningKind kind, double time, const char *name, double value);

// events.c
void yk_simulation_look(YkSimulation *sim); // after a step: finds what happened in it
bool yk_simulation_look_dead(YkSimulation *sim);
void yk_simulation_watch_start(YkSimulation *sim);

// --- standstill.c: after a failure
// Takes the pose of the last time that was reached, with the accelerations found there.
void yk_simulation_stand_still(YkSimulation *simulation);
// Explains the pose in the report if no reason is known yet: status YK_SINGULAR near a dead point, elsewhere the
// simulation's own.
void yk_simulation_explain(YkSimulation *simulation);

#endif

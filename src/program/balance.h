// The balance of all bodies: three equations each - two of forces, one of moments over a unit of length - whose
// unknowns are what joints, inputs and teeth transmit: forces, and couples over that unit.
#ifndef PROGRAM_BALANCE_H
#define PROGRAM_BALANCE_H
#include "program/forces.h"

typedef struct YkUnknown { // a unit wrench on a joint's second body, its opposite on the first; or a mesh's
    int32_t joint, input;  // input: YK_NONE for a reaction
    int32_t relation;      // whose mesh it is, or YK_NONE
    YkRefVec force;        // of a mesh: on its second body
    bool is_couple;
    YkRef moment;  // of a mesh that transmits couples alone: on its second body
    size_t radial; // gears with a force: the right side of its radial component; cams with two rollers: of half the
                   // first one's force less half the second's, as in free_bodies/meshes; 0: none
} YkUnknown;

typedef struct YkBalanceSystem {
    YkForces *f;
    YkRates velocities, accelerations;
    double unit; // of length, m
    YkUnknown *columns;
    size_t count;
    size_t n,
        sides; // unknowns, those of least_norm.c after the columns; right sides: 1 and the radial forces of gears, N for each newton across the teeth
    YkRef *system;               // [n][n + sides]; while it is made, [3 for each moving body][n + sides]
    YkRef *solution;             // [n][sides], once it is solved
    size_t first_dry, dry_count; // right sides of dry friction; 0: none
    YkRef *factor;               // [sides], with dry friction: the factor of a right side
    YkRefVec *radial;            // [sides]: a gear's radial force on its second wheel
    bool ran_out;                // of memory, while it was made or solved
} YkBalanceSystem;

// reactions.c: makes the unknowns, then the equations for a pose with these rates, with this unit of length. Returns
// false when out of memory, or if the unknowns are fewer than the equations, or more unless f->takes_least
// (f->why_no_reactions is then set).
bool yk_balance_make(YkBalanceSystem *balance, YkForces *f, const YkRates *velocities, const YkRates *accelerations,
                     double unit);
// Returns an unknown: that of the balance, less what the radial forces of the teeth add to the loads.
YkRef yk_balance_value(const YkBalanceSystem *balance, size_t k);
// Reads what joints transmit from the solution: force x, y, moment of each, into f->reaction; what contacts do into
// f->contact.
bool yk_balance_read(YkBalanceSystem *balance);
// least_norm.c: widens the equations by those of the solution of least norm, where constraints repeat others.
bool yk_balance_widen(YkBalanceSystem *balance);
// balance_solve.c: solves it in symbols. Returns false when out of memory, or if it has no solution whatever the pose.
bool yk_balance_solve(YkBalanceSystem *balance);

// force_channels.c: returns the value of a channel of forces or energies, once the solution is read; YK_NONE for any
// other channel.
YkRef yk_balance_channel(YkBalanceSystem *balance, YkChannel channel);

// dry_sides.c: enters the right sides of dry friction: 1 N or N m along each joint, and what it accelerates.
void yk_dry_enter(YkBalanceSystem *balance);

// balance_wrench.c: adds a wrench on a body, about its centre of mass, to a column or right side.
void yk_balance_add(YkBalanceSystem *balance, size_t column, int32_t body, YkRefVec force, YkRef moment);
// Adds a force on a body at a place of the world; its opposite if the sign is -1.
void yk_balance_push(YkBalanceSystem *balance, size_t column, int32_t body, double sign, YkRefVec place,
                     YkRefVec force);
// Adds a couple on each of three bodies, in proportion; a force on the second body, and its opposite on the first.
void yk_balance_couples(YkBalanceSystem *balance, size_t column, const int32_t *bodies, const YkRef *couples);
void yk_balance_force(YkBalanceSystem *balance, size_t column, const int32_t *bodies, YkRefVec place, YkRefVec force);
// Returns where the force of a column or right side on its second body is kept.
YkRefVec *yk_balance_force_of(YkBalanceSystem *balance, size_t column);

// meshes.c: the columns of gears and other relations, after those of the joints; what those contain (as in
// free_bodies/meshes).
void yk_meshes_columns(YkBalanceSystem *balance);
void yk_meshes_enter(YkBalanceSystem *balance, size_t column);
// meshes_laws.c: cams, and coordinates that follow others by a law.
bool yk_meshes_cam_has_pair(const YkCam *cam); // of rollers whose places are known
void yk_meshes_cam(YkBalanceSystem *balance, size_t column, const YkRelation *relation, const YkCam *cam);
void yk_meshes_follow(YkBalanceSystem *balance, size_t column, const YkRelation *relation, const YkFollow *follow);

#endif

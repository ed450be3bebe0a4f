// The balance of all bodies: a system of three equations each - two of forces, one of moments over the machine's size -
// with what joints, inputs and teeth transmit as unknowns.
#ifndef CODE_BALANCE_H
#define CODE_BALANCE_H
#include "code/forces.h"

typedef struct YkUnknown { // a unit wrench on a joint's second body, its opposite on the first; or a mesh's
    int32_t joint, input;  // input: YK_NONE of a reaction
    int32_t relation;      // YK_NONE, or whose mesh it is
    YkRefVec force;
    bool is_couple;
    size_t radial; // of gears with a force: which right side holds what its size does across the teeth; 0: none
} YkUnknown;

typedef struct YkBalanceSystem {
    YkForces *f;
    YkUnknown *columns;
    size_t count;
    size_t n, sides; // right sides: 1 and the radial forces of gears, N for each newton across the teeth
    YkRef *system;   // [n][n + sides]
} YkBalanceSystem;

// A wrench on a body, about its centre of mass, into a column or right side.
void yk_balance_add(YkBalanceSystem *balance, size_t column, int32_t body, YkRefVec force, YkRef moment);
// A force on a body at a place of the world; its opposite where the sign is -1.
void yk_balance_push(YkBalanceSystem *balance, size_t column, int32_t body, double sign, YkRefVec place,
                     YkRefVec force);

// meshes.c: what free_bodies/meshes has gears and the like transmit. Their columns, behind those of the
// joints; what those hold.
void yk_meshes_columns(YkBalanceSystem *balance);
void yk_meshes_enter(YkBalanceSystem *balance, size_t column);
// A couple on each of three bodies, in proportion; a force on the second body, its opposite on the first.
void yk_meshes_couples(YkBalanceSystem *balance, size_t column, const int32_t *bodies, const YkRef *couples);
void yk_meshes_force(YkBalanceSystem *balance, size_t column, const int32_t *bodies, YkRefVec place, YkRefVec force);
// meshes_laws.c: cams, and coordinates that follow others by a law.
void yk_meshes_cam(YkBalanceSystem *balance, size_t column, const YkRelation *relation, const YkCam *cam);
void yk_meshes_follow(YkBalanceSystem *balance, size_t column, const YkRelation *relation, const YkFollow *follow);

#endif

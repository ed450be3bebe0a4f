// The forces of gears, racks, belts, cams and laws: what the files that write them share.
#ifndef DERIVE_FORCES_MESHES_H
#define DERIVE_FORCES_MESHES_H
#include "derive/forces/free_bodies.h"
#include "derive/relations.h"

// One relation as it is written.
typedef struct YkMeshMaking {
    YkDeriveForces *f;
    YkDerivation *d;
    YkRing *ring;
    size_t index;
    const YkDeriveRelation *tie;
    YkDeriveMesh *mesh;
    const char *between, *point; // point: the name of where it acts
    const YkPoisson *unknown;
    const char *by[2]; // who pushes each body, if not the other one
} YkMeshMaking;

// The joints that keep a body in the place that a relation assumes.
typedef struct YkMeshHeld {
    YkDeriveHolder *holders;
    size_t count;
} YkMeshHeld;
YkMeshHeld yk_mesh_held_by(YkMeshMaking *m, int32_t joint, int side);

// A wheel's axis, from body to body over the pins and welds that lie on it.
typedef struct YkMeshAxis {
    YkMeshMaking *m;
    int32_t carrier;
    bool *seen;
    YkMeshHeld held;     // from the wheel to the carrier
    const YkPoisson *at; // on the carrier
} YkMeshAxis;
// `at` is NULL if the axis cannot be followed in symbols.
YkMeshAxis yk_mesh_axis(YkMeshMaking *m, int32_t wheel, int32_t carrier);

// Makes the unknown that the relation transmits, named by a letter and the two bodies' "12"; word: what it is.
void yk_mesh_unknown(YkMeshMaking *m, const char *letter, const int32_t body[2], const char *word);

// --- Pushes (mesh_parts.c)
// Keeps a contact of the relation, at its point.
void yk_mesh_add_contact(YkMeshMaking *m, YkDeriveContact contact);
// Adds a force on body[1] and its opposite on body[0]; the arms lead from their references to where it acts.
void yk_mesh_force(YkMeshMaking *m, const char *letter, const int32_t body[2], const YkMeshHeld held[2],
                   const YkPoisson *const arm[2], const YkPoisson *force);
// Adds a couple, as a multiple of the unknown, under a name of its own: of a belt's wheels, neither carries the other's
// opposite.
void yk_mesh_couple(YkMeshMaking *m, int32_t body, const YkPoisson *multiple);
// Adds couples on two bodies, and the remainder on a third; the unknown's value is that of the second.
void yk_mesh_couples(YkMeshMaking *m, const int32_t body[2], int32_t third, const YkPoisson *a, const YkPoisson *b);

// --- Places
// Return the vectors from a body's reference to its origin, and to a place of the world.
const YkPoisson *yk_mesh_center(YkMeshMaking *m, int32_t body);
const YkPoisson *yk_mesh_arm(YkMeshMaking *m, int32_t body, const YkPoisson *place);
// Returns where a joint holds its first or second body, in that body's axes.
const YkPoisson *yk_mesh_at(YkMeshMaking *m, int32_t joint, int side);
// Returns the unit vector along a slide's line in the world, forwards for its second body.
const YkPoisson *yk_mesh_line(YkMeshMaking *m, int32_t joint);

// --- Kinds that fill files
void yk_mesh_gear(YkMeshMaking *m, const YkRelation *of);
void yk_mesh_cam(YkMeshMaking *m, const YkRelation *of);

#endif

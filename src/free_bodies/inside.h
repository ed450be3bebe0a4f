// The inside of YkFreeBodies.
//
// Every unknown of the joints is a *wrench*: a unit force or couple on the joint's second body and its opposite on the
// first, both at the same place in the world. The wrenches are the columns of the matrix A, which has three rows for
// each body; forces in equal units, moments and couples over the machine's size, so that all entries are near 1:
// - inertia - loads = A f (balance of every body)
// - A^T accelerations = bias (+ q'' of an input) (the joints' constraints, differentiated twice)
// Bodies that joints connect other than through the ground form a *part*; parts are solved separately.
#ifndef FREE_BODIES_INSIDE_H
#define FREE_BODIES_INSIDE_H
#include "free_bodies/free_bodies.h"
#include "num/sparse.h"

typedef enum YkWrenchKind {
    YK_WRENCH_X, // a force along the world's axes,
    YK_WRENCH_Y,
    YK_WRENCH_NORMAL, // normal to the joint's line,
    YK_WRENCH_LINE,   // along it,
    YK_WRENCH_COUPLE, // or a couple;
    YK_WRENCH_MESH    // what a gear, rack, belt or cam transmits
} YkWrenchKind;

typedef struct YkWrenchColumn {
    int32_t joint, input; // input: YK_NONE for a reaction; joint: YK_NONE for a mesh
    int32_t relation;     // MESH: its index
    int32_t body[2];
    int32_t third, fourth; // MESH: further bodies that bear a share; 0 if there are none (or it is the ground)
    YkWrenchKind kind;
    // At the pose:
    YkVec force;      // on the second body
    YkVec at[2];      // MESH with a force: where it acts while its share is positive, negative; world axes
    double moment[2]; // about the reference points of both bodies, over the size; on the first with its sign
    YkVec other;      // MESH: on the third, its opposite on the fourth
    double third_moment, fourth_moment;
    YkVec radial; // MESH of gears and cams with two rollers: on the second body for each newton of the force's
                  // magnitude; turns nothing
    double radial_moment[2]; // ... about the reference points, m
    double bias;             // 1/s^2: value of A^T accelerations when the coordinate does not accelerate
    // Solved:
    double share;    // its part of the whole, N
    double freeness; // redundant parts: how far it could differ; 0 when it is determined
} YkWrenchColumn;

enum { YK_WRENCH_ENTRIES = 12 }; // most entries of a column: three for each of four bodies

// A sparse system that is assembled by emitting its entries in a fixed order.
typedef struct YkBodySystem {
    YkSparse *sparse; // NULL: not made yet
    size_t n, count, capacity;
    int32_t *row, *column; // while the pattern is collected
    int32_t *place;        // afterwards: where an emitted entry is stored
    double *value;
} YkBodySystem;

typedef struct YkBodyPart {
    const int32_t *bodies, *columns; // [body_count], [column_count]
    size_t body_count, column_count;
    bool is_redundant;    // more unknowns than equations
    double mass;          // kg: the largest, 1 if all are 0; the unit of forces in forward dynamics
    YkBodySystem balance; // A; of redundant parts the saddle point of least norm
    YkBodySystem motion;  // forward dynamics
    YkBodySystem soft;    // ... with a little inertia and compliance, to find freedoms without inertia
} YkBodyPart;

struct YkFreeBodies {
    const YkMechanism *mech;
    YkArena *arena;
    double size;
    YkVec *reference; // per body
    YkWrenchColumn *columns;
    size_t column_count, first_mesh; // meshes in the order of the relations
    uint32_t *joint_first;           // [joints + 1]: where its reactions begin among the columns
    int32_t *input_column;           // per input
    YkBodyPart *parts;
    size_t part_count;
    int32_t *body_row; // per body: three times its index in its part
    int32_t *part_of;  // per body
    int32_t *part_bodies, *part_columns;
    bool *is_prescribed; // per input, of the last forward solution
    bool has_prescribed;
    // Three for each body, moments over the size:
    double *load;         // N
    double *acceleration; // of the reference point, m/s^2; of the angle, times the size
    double *inertia;      // N
    double *b, *y, *x;    // [3 bodies + columns] scratch
};

// Makes the columns of all joints and inputs, and the parts. Returns false when out of memory.
bool yk_wrenches_build(YkFreeBodies *f);
bool yk_parts_build(YkFreeBodies *f);
void yk_parts_end(YkFreeBodies *f);
// Computes directions, moments and biases at a pose.
void yk_wrenches_pose(YkFreeBodies *f, const YkSpace *space);

// Make the columns of the relations; compute their forces at a pose.
void yk_meshes_build(YkFreeBodies *f);
void yk_mesh_pose(const YkFreeBodies *f, const YkSpace *space, YkWrenchColumn *column);

// Systems. Emitting collects the pattern until _finish, and values afterwards, starting over with _begin.
bool yk_body_system_start(YkBodySystem *system, size_t n, size_t most);
bool yk_body_system_finish(YkBodySystem *system); // false when out of memory
void yk_body_system_end(YkBodySystem *system);
void yk_body_system_begin(YkBodySystem *system);
static inline void yk_body_system_emit(YkBodySystem *system, size_t row, size_t column, double value)
{
    size_t k = system->count++;
    if (system->place) {
        system->value[system->place[k]] = value;
    } else {
        system->row[k] = (int32_t)row;
        system->column[k] = (int32_t)column;
    }
}
// Emits the entries of a wrench, times sign, on the rows of its bodies in `column`; transposed: as a row.
void yk_body_system_wrench(const YkFreeBodies *f, YkBodySystem *system, const YkWrenchColumn *wrench, size_t column,
                           double sign, bool transposed);
// Returns the product of the entries of an input's wrench with x; a mesh may have more bodies.
double yk_wrench_dot(const YkFreeBodies *f, const YkWrenchColumn *wrench, const double *x);

// Finds the shares of a part that balance inertia - load. is_prescribed (may be NULL: all): other inputs have no
// effort.
YkStatus yk_part_balance(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed);
// Finds the accelerations of a part's bodies.
YkStatus yk_part_motion(YkFreeBodies *f, YkBodyPart *part, const bool *is_prescribed, double *accelerations,
                        int *culprit);
void yk_part_clear(YkFreeBodies *f, const YkBodyPart *part);

// Pivots below this, relative to their columns, are rounding.
#define YK_PIVOT_TOLERANCE 1e-13

#endif

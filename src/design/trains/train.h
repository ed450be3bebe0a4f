// The analysis of gear trains inside: the equations between speeds, their solution, and what follows from it.
#ifndef DESIGN_TRAIN_H
#define DESIGN_TRAIN_H
#include <yoke/train.h>
#include "base/memory.h"
#include "base/problems.h"
#include "base/text.h"
#include "num/exact_system.h"
#include "model/model.h"
#include "ring/ring.h"

// One equation: the sum of sign * symbol * speed is 0, or equals an input.
typedef enum YkTrainRowKind {
    YK_ROW_GROUND, // the ground stands
    YK_ROW_KEPT,   // a slide or weld keeps two bodies' angle: index of the joint
    YK_ROW_GEARS,  // index of the gears
    YK_ROW_BELT,
    YK_ROW_RACK,
    YK_ROW_HOLD, // index of the hold in the lock
    YK_ROW_JOIN, // index of the pair in the lock
    YK_ROW_INPUT // index of the input
} YkTrainRowKind;
typedef struct YkTrainTerm {
    int32_t column, sign, symbol; // symbol -1: the number 1
} YkTrainTerm;
typedef struct YkTrainRow {
    YkTrainRowKind kind;
    int32_t index, input; // input: right-hand side, or -1
    int32_t count;
    YkTrainTerm terms[4];
} YkTrainRow;

// A number of teeth, or a radius.
typedef struct YkTrainSymbol {
    const char *name;
    const YkExpr *expr; // the expression it was read from
    YkFraction value;
} YkTrainSymbol;

typedef struct YkTrainDrive {
    YkTrainInput shown;
    YkExact exact;      // of the speed
    int32_t coordinate; // or YK_NONE: the unit turn of body
    int32_t body;
    bool is_joint; // the rate of `joint`, whether the file names it or not, instead of the coordinate's
    int32_t joint;
} YkTrainDrive;

// The unknowns: the speeds of the train's bodies, the ground first, then the rates of its racks.
typedef struct YkTrainNet {
    const YkModel *model;
    YkArena *arena;
    int32_t *column_of;      // per body of the model; -1: not in the train
    int32_t *body_of;        // per column; racks: -1
    int32_t columns, bodies; // bodies: columns that are bodies
    YkTrainSymbol *symbols;
    int32_t symbol_count;
    int32_t (*symbol_of)[2]; // per mesh: gears, then belts, then racks
    int32_t mesh_count;
    bool is_exact;    // whether all symbols are
    YkTrainRow *rows; // those that hold in every case
    int32_t row_count;
} YkTrainNet;

// One case of the train: with a lock, with inputs.
typedef struct YkTrainCase {
    const YkTrainNet *net;
    const YkLock *lock; // or NULL
    YkTrainRow *rows;
    int32_t row_count, input_count, rights;
    YkExactSystem system; // reduced; rights: the inputs
    YkTrainStatus status;
    const char *message;
} YkTrainCase;

bool yk_train_net_build(YkTrainNet *net, const YkModel *model, YkArena *arena); // false: out of memory
// Returns the row of a mesh: gears, then belts, then racks.
const YkTrainRow *yk_train_mesh_row(const YkTrainNet *net, int32_t mesh);

// Solves the case for the given inputs. Returns false when out of memory or on overflow (case->system.overflow).
bool yk_train_case_solve(YkTrainCase *one, const YkTrainNet *net, const YkLock *lock, const YkTrainDrive *drives,
                         int32_t drive_count, YkArena *arena);
void yk_train_case_free(YkTrainCase *one);
YkFraction yk_train_coefficient(const YkTrainNet *net, const YkTrainRow *row, int32_t term);  // sign * value
const YkFraction *yk_train_case_share(const YkTrainCase *one, int32_t column, int32_t input); // of a determined column
int yk_train_case_freedom(const YkTrainCase *one);       // of a case without inputs
const char *yk_train_keep(YkArena *arena, YkText *text); // a copy of the text, which is emptied; NULL: out of memory

// Returns the share of an input in a column's speed as a formula, or its reciprocal (inverse); NULL if there is none.
const char *yk_train_formula(const YkTrainCase *one, int32_t column, int32_t input, bool is_inverse, YkArena *arena);
// Does the same with elements of a ring that has symbols for the net's (symbols[net->symbol_count]): over / under,
// with over 0 if the input has no part in it. Returns false if there is no formula, or the ring gave up (see its
// status).
bool yk_train_share_in(const YkTrainCase *one, int32_t column, int32_t input, YkRing *ring,
                       const YkPoisson *const *symbols, const YkPoisson **over, const YkPoisson **under);

// A quotient of polynomials in factored form: content * product of over / product of under.
enum { YK_TRAIN_FACTORS_MAX = 40 };
typedef struct YkTrainFactors {
    const YkPoisson *items[YK_TRAIN_FACTORS_MAX];
    int32_t count;
    bool is_negative;
} YkTrainFactors;
typedef struct YkTrainQuotient {
    YkRing *ring;
    const YkPoisson *content; // a single term
    YkTrainFactors over, under;
} YkTrainQuotient;
bool yk_train_quotient(YkRing *ring, const YkPoisson *over, const YkPoisson *under, YkTrainQuotient *quotient);
bool yk_train_write_quotient(const YkTrainQuotient *quotient, YkText *text);
// Returns the quotient as one element, `1 + N1 N3/(N2 N4)`, if that reads well; NULL if a fraction of products is
// better.
const YkPoisson *yk_train_quotient_sum(const YkTrainQuotient *quotient);
// Returns the part of the content above or below the line, without negative powers.
const YkPoisson *yk_train_quotient_term(const YkTrainQuotient *quotient, bool is_above);

typedef struct YkTrainGroup { // a tabular method
    int32_t carrier, count;
    size_t *body;
    YkFraction *turn;
    struct YkTrainStep { // how a wheel's turn follows: over the mesh from its side `side`, of an earlier wheel
        int32_t from, mesh;
        int side;
    } * step;
    const char **turns;
    double *turns_value;
    const char *exact_x, *exact_y;
    double x, y;
    bool has_speeds;
} YkTrainGroup;

typedef struct YkTrainMeshPower {
    bool is_known;
    double torque[2], carrier_torque, rolling_power, loss;
    int driver;
} YkTrainMeshPower;

struct YkTrain {
    const YkModel *model;
    YkArena *arena;
    YkTrainOptions options;
    YkTrainNet net;
    YkTrainCase motion; // with the drives
    YkTrainDrive *drives;
    int32_t drive_count;
    int freedom;
    YkTrainBody *bodies;  // without the ground
    YkTrainShare *shares; // [body][drive]
    YkTrainRatio ratio;
    YkTrainGear *gears;
    size_t gear_count;
    const char **willis;
    double *rack_speeds; // per mesh
    YkTrainGroup *groups;
    size_t group_count;
    YkTrainRemark *remarks;
    size_t remark_count;
    YkTrainMeshPower *mesh_power;
    YkTrainTorque *torques;
    size_t torque_count;
    YkTrainPower power;
};

bool yk_train_drives(YkTrain *train, int32_t in);
// Returns whether the angle, or the distance, of a joint turns the train.
bool yk_train_has_joint(const YkTrainNet *net, int32_t joint, bool is_distance);
// Returns the speed as text if all inputs that take part are exact and of one kind: "460/29 rpm".
const char *yk_train_exact_speed(const YkTrain *train, const YkFraction *shares, int32_t count, bool is_distance);
bool yk_train_tables(YkTrain *train);
bool yk_train_remarks(YkTrain *train);
bool yk_train_torques(YkTrain *train, YkProblems *problems);

#endif

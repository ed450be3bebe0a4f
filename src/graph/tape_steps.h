// The operations of a tape, shared by the files that make them and the file that runs them.
#ifndef GRAPH_TAPE_STEPS_H
#define GRAPH_TAPE_STEPS_H
#include "elementary/kernel.h"
#include "graph/tape.h"

// Sums of products are one operation on rows, but every part of them is rounded as if it stood alone.
typedef enum YkTapeOp {
    YK_TAPE_ADD,          // a + b
    YK_TAPE_SUBTRACT,     // a - b
    YK_TAPE_MULTIPLY,     // a b
    YK_TAPE_DIVIDE,       // a / b
    YK_TAPE_MINUS,        // -a
    YK_TAPE_PRODUCT_PLUS, // a b + c
    YK_TAPE_PRODUCT_LESS, // a b - c
    YK_TAPE_LESS_PRODUCT, // c - a b
    YK_TAPE_DOT,          // a b + c d
    YK_TAPE_CROSS,        // a b - c d
    YK_TAPE_PLUS_DOT,     // e + (a b + c d)
    YK_TAPE_LESS_DOT,     // e - (a b + c d)
    YK_TAPE_DOT_LESS,     // (a b + c d) - e
    YK_TAPE_PLUS_CROSS,   // e + (a b - c d)
    YK_TAPE_LESS_CROSS,   // e - (a b - c d)
    YK_TAPE_CROSS_LESS,   // (a b - c d) - e
    YK_TAPE_PLUS_PLUS,    // (e + a b) + c d
    YK_TAPE_PLUS_LESS,    // (e + a b) - c d
    YK_TAPE_LESS_PLUS,    // (e - a b) + c d
    YK_TAPE_LESS_LESS,    // (e - a b) - c d
    YK_TAPE_SPIN,         // a (c c) + b d, and as its second result a d - b (c c)
    YK_TAPE_ROOT,
    YK_TAPE_SIZE,
    YK_TAPE_NONZERO, // |a| + 1e-200
    YK_TAPE_CHOOSE,  // a < 0 ? b : c
    YK_TAPE_RARE,    // a function of formulas, or a call: lane by lane
    YK_TAPE_COPY,
    YK_TAPE_END // of the operations of one lane
} YkTapeOp;

enum { YK_TAPE_OPERANDS = 5 };
typedef struct YkTapeStep {
    YkTapeOp op;
    int32_t scalars; // bits: which of yk_tape_scalar_operand are the same in all lanes, so that only the first is read
    int32_t out, in[YK_TAPE_OPERANDS]; // rows
    YkValueKind kind;                  // RARE: of the value
    YkFunction function;
    int32_t call;   // RARE: of the tape's calls, or YK_NONE
    int32_t second; // SPIN: the row of its second result
} YkTapeStep;

typedef struct YkTapeCall {
    YkCallKind kind;
    int32_t index, n, m;
    size_t argument_count, result_count;
    int32_t *arguments, *results; // rows; YK_NONE for a result that is not needed
} YkTapeCall;

typedef struct YkTapeOne YkTapeOne; // tape_one.c: the same for one lane

struct YkTape {
    YkArena *arena;
    YkTapeLaws laws;
    size_t lanes;
    double **row;            // rows of the leaves, then those of the roots, then the tape's own
    double **own_row;        // [leaf]: what yk_tape_set fills; NULL for a leaf that nothing depends on
    const double **constant; // [root]: its number, if it is the same in all lanes
    bool *tells;             // [root]: it is one of those that decide whether all are finite
    bool *is_parameter;      // [leaf]: it depends on parameters alone
    size_t leaf_count, root_count, row_count;
    int32_t *wide; // rows of parameters that some step reads lane by lane; all others have one number
    size_t wide_count;
    YkTapeStep *steps;
    size_t prelude_count, step_count; // the first steps depend on parameters alone
    YkTapeCall *calls;
    double *scratch; // of a call
    YkTapeOne *one;
};

typedef struct YkTapeMaker { // what makes a tape
    YkTape *tape;
    const YkGraph *graph;
    int32_t *uses;     // per value: how many needed values, and roots, depend on it
    int32_t *in_sums;  // per value: how many of these are operands of sums
    bool *is_within;   // per value: a product or sum that its only user computes itself
    YkRef *inner;      // per sum: the sum within it, or YK_NONE
    YkTapeStep **spin; // per sum: the step that computes it with another one, or NULL
    bool *is_beside;   // per value: the step of another one computes it, or does without it
    int32_t *of_call;  // per call of the graph: that of the tape, or YK_NONE
    YkRef *made;       // per step: the value that it computes
    size_t call_count, most_arguments;
    bool failed;
} YkTapeMaker;

static inline const YkValue *yk_tape_value(const YkTapeMaker *maker, YkRef value)
{
    return &maker->graph->values[value];
}

// Returns the step that computes a sum with another one, or NULL.
static inline const YkTapeStep *yk_tape_spin(const YkTapeMaker *maker, YkRef sum)
{
    return YK_KNOWS_BLOCKS ? maker->spin[sum] : NULL;
}
// Returns whether a value has no step because that of another one computes it, or does without it.
static inline bool yk_tape_is_beside(const YkTapeMaker *maker, YkRef value)
{
    return YK_KNOWS_BLOCKS && maker->is_beside[value];
}
// Returns whether a step has a second result.
static inline bool yk_tape_is_spin(const YkTapeStep *step)
{
    return YK_KNOWS_BLOCKS && step->op == YK_TAPE_SPIN;
}

// Makes a step whose operands are values.
static inline YkTapeStep yk_tape_step(YkTapeOp op, YkRef a, YkRef b, YkRef c, YkRef d)
{
    return (YkTapeStep){.op = op, .in = {a, b, c, d, YK_NONE}, .call = YK_NONE};
}
// tape_sums.c: finds the products and sums that the step of another sum computes, once uses are counted.
void yk_tape_find_sums(YkTapeMaker *maker);
// Makes the step of a sum.
YkTapeStep yk_tape_sum(const YkTapeMaker *maker, YkRef value);

// tape_spins.c: finds pairs of sums that one step computes, once products are found.
void yk_tape_find_spins(YkTapeMaker *maker);

// tape_scalars.c: puts factors that depend on parameters alone second, and marks operands of a pose's step that do.
void yk_tape_mark_scalars(const YkTapeMaker *maker, YkTapeStep *step);
// Returns the operand of an operation that the first or second bit of `scalars` is about; YK_NONE if there is none.
int32_t yk_tape_scalar_operand(YkTapeOp op, int32_t bit);
// Returns whether a step reads its operand lane by lane.
bool yk_tape_reads_lanes(const YkTapeStep *step, int32_t operand);

// tape_signs.c: leaves out steps of a pose that only turn a sign round. Returns false when out of memory.
bool yk_tape_turn_signs(YkTapeMaker *maker, YkArena *work, const YkRef *roots);

// tape_order.c: puts the steps of a pose into an order in which few values wait. Returns false when out of memory.
bool yk_tape_order(YkTapeMaker *maker, YkArena *work, const YkRef *roots);

// tape_rows.c: replaces the values in the steps by rows, which are reused once their values are no longer needed.
// made[k]: the value that step k computes. Returns false when out of memory, or if a leaf that is needed is not among
// the leaves.
bool yk_tape_place(YkTape *tape, YkArena *work, const YkGraph *graph, const YkRef *leaves, const YkRef *roots,
                   const YkRef *made);
// tape_finite.c: finds the roots that decide whether all are finite. Returns false when out of memory.
bool yk_tape_find_telling(YkTapeMaker *maker, YkArena *work, const YkRef *roots);
// tape_run.c: runs steps over n lanes.
void yk_tape_run_steps(const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n);
// Evaluates one lane of a rare operation, whose calls and operands name these rows.
void yk_tape_run_rare(const YkTape *tape, const YkTapeCall *calls, double *const *row, const YkTapeStep *step,
                      size_t lane);

// tape_one.c: makes the operations of one lane from those on rows, once these are placed. Returns false when out of
// memory.
bool yk_tape_make_one(YkTape *tape, YkArena *work);
// Gives the operations the address of a pose whose numbers are leaves; NULL: these have numbers of their own.
void yk_tape_read_pose(YkTape *tape, const double *pose);
// Takes the values that depend on parameters alone.
void yk_tape_prepare_one(YkTape *tape);

#endif

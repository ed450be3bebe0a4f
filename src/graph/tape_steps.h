// The operations of a tape, shared by the files that make them and the file that runs them.
#ifndef GRAPH_TAPE_STEPS_H
#define GRAPH_TAPE_STEPS_H
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
    YK_TAPE_ROOT,
    YK_TAPE_SIZE,
    YK_TAPE_CHOOSE, // a < 0 ? b : c
    YK_TAPE_RARE,   // a function of formulas, or a call: lane by lane
    YK_TAPE_COPY
} YkTapeOp;

typedef struct YkTapeStep {
    YkTapeOp op;
    int32_t out, in[4]; // rows
    YkValueKind kind;   // RARE: of the value
    YkFunction function;
    int32_t call; // RARE: of the tape's calls, or YK_NONE
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
    double **row;     // rows of the leaves, then those of the roots, then the tape's own
    double **own_row; // [leaf]: what yk_tape_set fills; NULL for a leaf that nothing depends on
    size_t leaf_count, root_count, row_count;
    YkTapeStep *steps;
    size_t prelude_count, step_count; // the first steps depend on parameters alone
    YkTapeCall *calls;
    double *scratch; // of a call
    YkTapeOne *one;
};

// tape_rows.c: replaces the values in the steps by rows, which are reused once their values are no longer needed.
// made[k]: the value that step k computes. Returns false when out of memory, or if a leaf that is needed is not among
// the leaves.
bool yk_tape_place(YkTape *tape, YkArena *work, const YkGraph *graph, const YkRef *leaves, const YkRef *roots,
                   const YkRef *made);
// tape_run.c: runs steps over n lanes.
void yk_tape_run_steps(const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n);
// Evaluates one lane of a rare operation, whose calls and operands name these rows.
void yk_tape_run_rare(const YkTape *tape, const YkTapeCall *calls, double *const *row, const YkTapeStep *step,
                      size_t lane);

// tape_one.c: makes the operations of one lane from those on rows, once these are placed. Returns false when out of
// memory.
bool yk_tape_make_one(YkTape *tape, YkArena *work);
// Takes the values that depend on parameters alone.
void yk_tape_prepare_one(YkTape *tape);

#endif

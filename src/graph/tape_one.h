// The data from which one lane of a tape runs.
#ifndef GRAPH_TAPE_ONE_H
#define GRAPH_TAPE_ONE_H
#include "graph/tape_steps.h"

typedef struct YkTapeNumber { // a number of one lane that is read from a row: of a constant, or of a leaf
    int32_t row, place;
} YkTapeNumber;

typedef struct YkTapeOperation { // where it reads; its result
    const double *a, *b, *c, *d, *e;
    double out;
    YkTapeOp op;
    bool has_like; // the next one is of the same kind
} YkTapeOperation;

typedef struct YkTapeRead { // where the address of a leaf's number stands
    const double **from;
    int32_t leaf;
} YkTapeRead;

#define YK_TAPE_OWN ((size_t)-1)

struct YkTapeOne {
    double *value;      // per place: of leaves, of what depends on parameters alone, and results of calls
    double **at;        // per place: its address, as rows of one lane
    int32_t *leaf;      // per leaf: its place, or YK_NONE
    size_t *number;     // per leaf: which of a pose's numbers it is, or YK_TAPE_OWN
    const double *pose; // the numbers from which such leaves are read now; NULL: all have their own
    YkTapeRead *reads;
    size_t read_count;
    const double **result; // per root: its number
    YkTapeNumber *numbers; // what depends on parameters alone
    size_t number_count;
    YkTapeOperation *operations; // the last one is YK_TAPE_END
    YkTapeStep *rare;            // the rare operations, by places
    YkTapeCall *calls;
};

#endif

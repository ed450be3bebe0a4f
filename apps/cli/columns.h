// Columns: the quantities that --of names.
#ifndef CLI_COLUMNS_H
#define CLI_COLUMNS_H
#include "cli.h"

typedef struct YkAnswerColumn {
    const char *name;
    YkChannel channel;
} YkAnswerColumn;

struct YkAnswerColumns {
    YkAnswerColumn *items; // as --of names them
    size_t count, capacity;
};

// Adds a column. Returns false when out of memory, or for an unknown name, with a problem.
bool yk_columns_add(YkSession *session, YkAnswerColumns *columns, const char *name);
// Reads --of a,b,c (nothing without it). Reports all bad names; then returns false.
bool yk_columns_read(YkSession *session, YkAnswerColumns *columns);
bool yk_columns_need_forces(const YkAnswerColumns *columns);
void yk_columns_free(YkAnswerColumns *columns);
// Returns a column's value at a pose; NaN if it is undetermined there: rates at a dead point, forces if
// session->dynamics found none.
double yk_column_value(const YkSession *session, const YkState *state, YkChannel channel);
// Returns a value in the file's unit, with noise set to zero; kinetic energies, sums of squares, have none.
double yk_column_shown(const YkSession *session, double value, YkChannel channel);

#endif

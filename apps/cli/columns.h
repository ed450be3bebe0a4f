// Columns: what --of asks for, by name.
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

// Adds one column. Returns false when out of memory or where nothing has this name: a problem says so.
bool yk_columns_add(YkSession *session, YkAnswerColumns *columns, const char *name);
// Reads --of a,b,c (nothing without it). All bad names are reported; then it returns false.
bool yk_columns_read(YkSession *session, YkAnswerColumns *columns);
bool yk_columns_need_forces(const YkAnswerColumns *columns);
void yk_columns_free(YkAnswerColumns *columns);
// Returns a column's value at a pose, or NaN where it is not determined there: rates at a dead point, forces where
// session->dynamics has found none.
double yk_column_value(const YkSession *session, const YkState *state, YkChannel channel);
// Returns it in the file's unit, with noise taken for zero; kinetic energies, sums of squares, have none.
double yk_column_shown(const YkSession *session, double value, YkChannel channel);

#endif

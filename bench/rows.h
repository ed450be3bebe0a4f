// Medians over rounds, and the rows of docs/speed.md.
#ifndef BENCH_ROWS_H
#define BENCH_ROWS_H
#include <stdbool.h>
#include <stddef.h>

// Sorts; the middle one.
double median(double *values, size_t count);

// A row of docs/speed.md, as bench/run gathers them: the task, time by hand and ours, the ratio that is asked (0: none)
// and how far the two are apart. Returns whether the ratio is kept.
bool row(const char *task, double by_hand, double ours, const char *unit, double asked, double difference);

#endif

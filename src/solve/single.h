// Runs the steps of one pose over values instead of lanes.
#ifndef SOLVE_SINGLE_H
#define SOLVE_SINGLE_H
#include "solve/run.h"

// Runs steps [from, to) in a space of stride 1, with the lanes' arithmetic: the same bits. Rare steps go through the
// lanes themselves.
void yk_run_single(const YkRun *run, size_t from, size_t to);
// Computes one sum in that space.
void yk_run_single_sum(const YkRun *run, const YkSum *sum, YkPlane out);

#endif

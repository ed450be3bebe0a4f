// Shared by the benches of dynamics: a machine from its text or file, and medians over rounds.
#ifndef BENCH_MACHINE_H
#define BENCH_MACHINE_H
#include <stdio.h>
#include <yoke/yoke.h>
#include "rows.h"

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDynamics *dynamics;
} Machine;

// Loads, compiles and assembles at the file's start. On failure the problems go to standard error.
bool machine_load(Machine *machine, const char *path);
bool machine_parse(Machine *machine, const char *text);
void machine_end(Machine *machine);

// Accelerations at the state's inputs; ends the program where they fail.
void machine_accelerate(Machine *machine, double *accelerations);
// A simulation at a tolerance, from the file's start up to a horizon; ends the program where it cannot start.
YkSimulation *machine_simulate(Machine *machine, double tolerance, double horizon);

// Texts of machines of any length; NULL when out of memory.
char *chain_text(size_t rods); // hanging, of 1 m and 1 kg, pins J0, J1, ...
char *arm_text(size_t links);  // a chain whose every link has parameters of its own: length, centre, mass, inertia
char *n_four_bar_text(size_t loops); // rods of 1 m and 1 kg, upright, turning clockwise at 1 rad/s
char *
separate_loops_text(size_t loops); // four-bars beside each other, each swinging from a pose and at a rate of its own

#endif

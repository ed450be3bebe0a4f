// Chooses which coordinates are inputs: as many as the machine has freedoms.
#ifndef COMPILE_INPUTS_H
#define COMPILE_INPUTS_H
#include "compile/topology.h"

// Fills mech->inputs and makes the plan. Order of preference: options->inputs, drives, `start:`, any other coordinate.
// Reports drives beyond the freedom and unknown inputs.
bool yk_inputs_choose(YkMechanism *mech, const YkIncidence *incidence, const YkCompileOptions *options,
                      YkProblems *problems);

#endif

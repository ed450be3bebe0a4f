// Relations over lanes: gears, racks, belts, cams.
#ifndef SOLVE_RELATIONS_H
#define SOLVE_RELATIONS_H
#include "solve/state.h"

// Sets the relation's target - an orientation or a distance - with its rates.
void yk_run_relation(const YkRun *run, size_t relation);
// References of the angles that relations start from: from the guesses of `start:`; from the pose that stands.
void yk_relations_guess(YkState *state);
void yk_relations_refer(YkState *state);

#endif

// A simulation as bytes, piece by piece. Each function writes and reads.
#ifndef SIMULATE_ARCHIVE_H
#define SIMULATE_ARCHIVE_H
#include "simulate/simulation.h"

// The options from which the mechanism is made, so that reading can make it ...
void yk_simulation_archive_options(YkSimulation *simulation, YkArchive *archive);
void yk_simulation_archive_flights(YkSimulation *simulation, YkArchive *archive); // which cams have lost their follower
// ... the mechanism's inputs ([count], below coordinate_count) ...
void yk_simulation_archive_choice(YkArchive *archive, int32_t *chosen, size_t count, size_t coordinate_count);
// ... and, once it is made, all the rest. Reading fails where the bytes do not fit the machine.
void yk_simulation_archive_rest(YkSimulation *simulation, YkArchive *archive);

#endif

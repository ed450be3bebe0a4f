// One number for a machine: simulations that are saved are restored to the same machine alone.
#ifndef SIMULATE_FINGERPRINT_H
#define SIMULATE_FINGERPRINT_H
#include "model/model.h"

// Returns a hash of all of a model that its motion depends on.
uint64_t yk_fingerprint(const YkModel *model);

#endif

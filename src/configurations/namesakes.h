// Names of configurations: their labels, with a number where several at one pose share a label.
#ifndef CONFIGURATIONS_NAMESAKES_H
#define CONFIGURATIONS_NAMESAKES_H
#include <yoke/configurations.h>
#include "base/text.h"

typedef struct YkRollEntry {
    YkText label;
    double *positions; // [coordinate]
} YkRollEntry;

// The configurations at some inputs, in the order of the search.
typedef struct YkRoll {
    bool is_made;
    double *inputs; // [input]: where
    YkRollEntry *entries;
    size_t count, capacity;
} YkRoll;

typedef struct YkNamesakes {
    YkRoll here, start; // where a name was last asked for; where the machine was assembled
    YkText name;        // the last one
} YkNamesakes;

void yk_namesakes_end(YkNamesakes *namesakes);
// Returns whether names can be written at the inputs of a state: the configurations there are known, or no two of the
// machine can share a label, because all its blocks are dyads.
bool yk_namesakes_are_ready(const YkNamesakes *namesakes, const YkState *state);
// Enumerates the configurations at the inputs of a state and, if labels repeat there, at the start.
YkStatus yk_namesakes_prepare(YkNamesakes *namesakes, YkConfigurations *all, const YkState *state,
                              const YkConfigurationsOptions *options);
// Writes the name of a state's configuration, where names are ready, into namesakes->name.
YkStatus yk_namesakes_write(YkNamesakes *namesakes, const YkState *state);

#endif

// The machine's structure as a picture: bodies and joints as a graph.
#ifndef REPORT_GRAPH_H
#define REPORT_GRAPH_H
#include <stdbool.h>
#include <yoke/mechanism.h>
#include "base/text.h"

// Writes the picture as SVG. Returns false if the machine has too many bodies for one (more than 40), or out of memory
// (then svg->failed). Deterministic. Cost O(bodies^2) for some hundred rounds.
bool yk_structure_write(const YkMechanism *mech, YkText *svg);

#endif

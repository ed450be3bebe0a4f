// Starts of a search for paths: bars drawn at random, with the rest by linear least squares.
#ifndef SYNTHESIS_PATH_START_H
#define SYNTHESIS_PATH_START_H
#include "synthesis/paths/path_fit.h"

// Draws a bar with its input's angles. Returns false if it does not close at every point.
bool yk_path_draw(const YkPathProblem *problem, YkPathWork *work, uint64_t *seed, YkPathTry *try);
// Draws the random numbers of a bar alone, so that the next one is what it would be after yk_path_draw.
void yk_path_skip(const YkPathProblem *problem, uint64_t *seed, YkPathTry *scratch);

#endif

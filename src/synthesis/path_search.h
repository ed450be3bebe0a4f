// A search for paths: its problem, whole and with a part of the points, and what it has found.
#ifndef SYNTHESIS_PATH_SEARCH_H
#define SYNTHESIS_PATH_SEARCH_H
#include "synthesis/path_start.h"
#include "synthesis/synthesis.h"

enum { YK_PATH_HOPEFUL = 6, YK_PATH_POOL = 400 };

typedef struct YkPathSearch {
    YkSynthesis *s;
    YkPathProblem problem, coarse; // all points, and every `stride`th
    YkPathWork work;
    YkPathTry try[YK_PATH_HOPEFUL + 1], whole; // of a part of the points, the last one is drawn into; of all
    size_t stride;
    YkPathTry pool[YK_PATH_POOL]; // that passed, best first
    size_t pooled, most, exact;   // `most`: as many are kept
    YkVec *path;                  // [count]
    uint64_t seed;
} YkPathSearch;

// path_problem.c: states the problem of a task for one kind of bar; takes every so many points, so that some 16 remain.
void yk_path_pose(const YkTask *task, YkDesignKind kind, YkPathProblem *problem);
bool yk_path_thin(YkPathSearch *search);

// path_batch.c: draws starts, improves the best of them, and leaves the best of these in `whole`. Returns false if none
// closes.
bool yk_path_batch(YkPathSearch *search, size_t batch);
// Puts a try among the first `*count` of a list, best first, at most `most`.
void yk_path_insert(const YkPathProblem *problem, YkPathTry *list, size_t *count, size_t most, const YkPathTry *try);

#endif

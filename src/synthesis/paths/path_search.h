// A search for paths: its problem, whole and with a part of the points, and what it has found.
#ifndef SYNTHESIS_PATH_SEARCH_H
#define SYNTHESIS_PATH_SEARCH_H
#include "synthesis/paths/path_start.h"
#include "synthesis/synthesis.h"

// The most batches that the search runs for one kind of bar, or of machine with a dyad, whose batches are larger.
enum { YK_PATH_HOPEFUL = 6, YK_PATH_POOL = 400, YK_PATH_BATCHES = 600, YK_CHAIN_BATCHES = 60 };
size_t yk_path_batch_count(YkDesignKind kind);
// Lists the kinds that a task asks for. Returns their number.
size_t yk_path_kinds(const YkTask *task, YkDesignKind kind[YK_DESIGN_KINDS]);

// Computes batches of starts, each of them by its number alone.
typedef struct YkPathBatches {
    YkPathProblem problem, coarse; // all points, and every `stride`th
    YkPathWork work;
    YkPathTry try[YK_PATH_HOPEFUL + 1], whole; // of a part of the points, the last one is drawn into; of all
    size_t stride;
    uint64_t first_seed, seed;
    size_t next; // the batch to which `seed` belongs
} YkPathBatches;

typedef struct YkPathSearch {
    YkSynthesis *s;
    YkPathBatches batches;
    size_t first_piece, kinds; // pieces: those of all kinds that are sought take turns
    size_t first;              // the last batch without a bar that passes all points to rounding
    bool is_done;
    double *numbers;              // of a piece
    YkPathTry pool[YK_PATH_POOL]; // that passed, best first
    size_t pooled, most, exact;   // `most`: as many are kept
    YkVec *path;                  // [count]
} YkPathSearch;

// path_exact.c: returns whether the task has nine points and nothing else, so that all its four-bars can be found.
bool yk_path_is_exact(const YkTask *task);
// Pieces of the exact search, before those of other searches: paths of Alt's problem as numbers[yk_path_width].
size_t yk_path_exact_pieces(const YkTask *task);
void yk_path_exact_piece(const YkTask *task, uint64_t seed, size_t piece, YkPace *pace, double *numbers);
// Finds all four-bars and judges those that are real, as the part of the call from 0 to `to`. Returns whether none of
// the solutions is missing. Cost: 3 to 10 s.
bool yk_synthesise_exact_path(YkSynthesis *s, double to);

// path_problem.c: states the problem of a task for one kind of bar, and a coarse version of it with about 16 of the
// points, evenly spaced.
bool yk_path_batches_new(YkArena *arena, const YkTask *task, YkDesignKind kind, uint64_t seed, YkPathBatches *batches);

// path_batch.c: draws starts, improves the best of them, and then the best of these to the end, in `whole`. Returns
// false if it does not close.
bool yk_path_batch(YkPathBatches *batches, size_t batch);
// Counts its work, microseconds.
size_t yk_path_batch_work(const YkPathBatches *batches);
// Puts a try among the first `*count` of a list, best first, at most `most`.
void yk_path_insert(const YkPathProblem *problem, YkPathTry *list, size_t *count, size_t most, const YkPathTry *try);
// Write what a batch found as numbers, and read it: numbers[yk_path_width].
size_t yk_path_width(const YkTask *task);
void yk_path_pack(const YkPathBatches *batches, bool closes, double *numbers);
bool yk_path_unpack(YkPathBatches *batches, const double *numbers);

#endif

// The inside of a synthesis: the machines that were found, best first, and those that were left out.
#ifndef SYNTHESIS_SYNTHESIS_H
#define SYNTHESIS_SYNTHESIS_H
#include "base/pace.h"
#include "synthesis/design.h"

enum { YK_DEFECTS_KEPT = 10000, YK_PARAMETERS_MAX = 16 };

// A machine that passed, or was left out.
typedef struct YkFound {
    YkDesign design;
    YkDefect defect;
    double error, worst, transmission[2];
    double interpolating; // largest error before it was evened out, rad or m; otherwise NaN
    double merit;         // larger is better
    size_t order;         // in which it was found, to break ties
    const char *model, *file;
    const double *curve; // [2 * rows]
    const double *value; // [free parameters] of a machine, SI, or NULL
    const double *angle; // [points of a path] of the input, rad, or NULL
    const double *before; // [2 * YK_CURVE_ROWS]: input and error before it was evened out, or NULL
    size_t rows;
    bool is_told; // to the caller's findings
} YkFound;

typedef struct YkFoundList {
    YkFound *items;
    size_t count, capacity;
} YkFoundList;

struct YkSynthesis {
    YkArena *arena;
    const YkTask *task;
    YkSynthesisOptions options;
    YkPace pace;
    YkDyad *dyads;
    unsigned char *sides; // per dyad: 1: may be the input's, 2: the output's
    size_t dyad_count, dyad_capacity;
    YkFoundList candidates, defects;
    size_t left_out[YK_DEFECT_COUNT];
    bool is_complete, has_solutions, was_stopped, failed;
    size_t complex_count, real_count;
    const double *own; // [2 * own_rows]: the curve of a machine as its file gives it, or NULL
    size_t own_rows;
    YkText picture, sheet[2];
};

// found.c: adds a dyad that may stand on these sides.
void yk_synthesis_add_dyad(YkSynthesis *s, const YkDyad *dyad, unsigned sides);
// Counts work of some microseconds; returns whether to go on.
static inline bool yk_synthesis_goes_on(YkSynthesis *s, size_t microseconds)
{
    return !s->failed && yk_pace_spend(&s->pace, 1000 * (uint64_t)microseconds);
}
// Gets a piece from the source of the options. Returns false if the search is to end.
bool yk_synthesis_fetch(YkSynthesis *s, size_t piece, double *numbers);
// Writes a design, judges it, and returns what became of it; its file's text is in `text`.
YkDefect yk_synthesis_try(YkSynthesis *s, const YkDesign *design, const YkJourney *journey, YkText *text,
                          YkVerdict *verdict);
// Keeps a machine that passed, with its text and verdict. Returns it, or NULL if nothing is kept any more.
YkFound *yk_synthesis_keep(YkSynthesis *s, const YkDesign *design, const YkText *text, const YkVerdict *verdict,
                           double merit);
// Counts one that did not.
void yk_synthesis_leave(YkSynthesis *s, const YkDesign *design, YkDefect defect, const YkVerdict *verdict);
// Sorts the candidates, keeps the best, and gives their files names.
void yk_synthesis_rank(YkSynthesis *s);

enum { YK_PAIR_POSES = 9 };

// Two dyads that take a body through positions in common.
typedef struct YkPair {
    const YkPose *pose; // [count], at most YK_PAIR_POSES
    size_t count;
    bool
        is_motion; // the angles of the positions are the task's; otherwise only the body's origin is to pass the points
    bool turns;    // the input is to turn through, whatever the task requires
    YkDyad dyad[YK_SIDES];
    int index[YK_SIDES];      // of the dyads among those of the answer; -1: they are not among them
    bool may_drive[YK_SIDES]; // may be the input
} YkPair;
// Judges the machine of two dyads, driven from either side that may be, and keeps the better one or counts its defect
// (pair.c).
void yk_synthesis_take_pair(YkSynthesis *s, const YkPair *pair);

// Returns what a caller sees of a machine (answers.c).
YkCandidate yk_found_candidate(const YkFound *found);

// The kinds of tasks, one file each. They return false with a problem where nothing can be sought.
bool yk_synthesise_motion(YkSynthesis *s, YkProblems *problems);
bool yk_synthesise_function(YkSynthesis *s, YkProblems *problems);
bool yk_synthesise_stroke(YkSynthesis *s, YkProblems *problems);
bool yk_synthesise_path(YkSynthesis *s, YkProblems *problems);
bool yk_synthesise_machine(YkSynthesis *s, YkProblems *problems);

#endif

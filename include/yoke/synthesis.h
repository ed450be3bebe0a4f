// Synthesis: from a task to machines that fulfil it.
//
// A task asks for points of a path, positions of a body, a function between two angles, a stroke, or goals that a given
// machine meets by other parameters. Every machine that the methods find is written as a model file, and the ordinary
// engine judges the file: it assembles the machine once, and drives it through the whole task, in order, without
// changing branch or circuit. Machines that pass are candidates; the others are counted by reason, and kept.
#ifndef YOKE_SYNTHESIS_H
#define YOKE_SYNTHESIS_H

#include <yoke/design.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct YkTask YkTask;

// Reads and validates a task file (man yoke-task). Adds every problem of the file to `problems`, also when it loads.
// Returns NULL if there was an error. Cost: linear in the size of the file.
YK_API YkTask *yk_task_load(const char *path, YkProblems *problems);
// Does the same for text in memory; `name` stands for the file's name in messages.
YK_API YkTask *yk_task_parse(const char *text, size_t length, const char *name, YkProblems *problems);
YK_API void yk_task_free(YkTask *task);
YK_API const char *yk_task_name(const YkTask *task);
YK_API const char *yk_task_kind(const YkTask *task); // "path", "motion", "function", "stroke", "machine"
// Returns the unit in which the file gives lengths or angles: its name ("mm"), and its size in SI.
YK_API const char *yk_task_unit(const YkTask *task, YkQuantity quantity, double *size);

// Returns the unit in which the machine of a task gives a free parameter: its name ("mm"), and its size in SI; NULL
// where the task has no machine, past the last parameter, and for plain numbers (of size 1).
YK_API const char *yk_task_parameter_unit(const YkTask *task, size_t index, double *size);

// Where a search gets its pieces (yk_pieces_new) if it does not compute them itself. `get` fills
// numbers[yk_pieces_width] of a piece and returns YK_OK; or YK_STOPPED or YK_NO_MEMORY, which end the search. It is
// asked in ascending order, and not for all pieces.
typedef struct YkPieceSource {
    YkStatus (*get)(void *context, size_t piece, double *numbers);
    void *context;
} YkPieceSource;

typedef struct YkCandidate YkCandidate;
// Receives machines while a search runs. `tell` takes a machine that passed and is among the best so far, unlike all
// better ones, and its place among those received: 0, the best, to `best` - 1. Its texts are valid during the call; it
// has no `file` yet, and the parameters of a task's machine are not available.
typedef struct YkFindings {
    void (*tell)(void *context, const YkCandidate *candidate, size_t place, size_t best);
    void *context;
} YkFindings;

typedef struct YkSynthesisOptions {
    uint64_t seed; // of samples, where a task leaves a choice; default 1
    size_t best;   // how many candidates are kept; 0: as the task says, or 10
    // Watches the search; {NULL}: not watched. Where it ends the search, the candidates found so far are the answer.
    YkProgress progress;
    YkFindings findings;  // {NULL}: there are machines at the end only
    YkPieceSource pieces; // {NULL}: the search computes them itself
} YkSynthesisOptions;
YK_API YkSynthesisOptions yk_default_synthesis_options(void);

typedef struct YkSynthesis YkSynthesis;
// Finds machines for a task, which must outlive the result. Returns NULL with problems added when out of memory or when
// the task has no exact solution that could be sought. Cost: some 0.5 ms for every pair of dyads, most of it the
// engine's judgement; of a path 0.1 to 10 s, of exactly nine points 3 s or more. The work is counted, so that a seed
// determines the answer.
YK_API YkSynthesis *yk_synthesis_run(const YkTask *task, const YkSynthesisOptions *options, YkProblems *problems);
YK_API void yk_synthesis_free(YkSynthesis *synthesis);
YK_API bool yk_synthesis_was_stopped(const YkSynthesis *synthesis);
// Returns whether every solution was sought: false if a task leaves a choice, which is sampled, and for all paths
// except those through exactly nine points.
YK_API bool yk_synthesis_is_complete(const YkSynthesis *synthesis);
// Finds how many solutions the task's equations have. Returns false if that number is not finite.
YK_API bool yk_synthesis_solutions(const YkSynthesis *synthesis, size_t *complex_count, size_t *real_count);

// The pieces of a search, for programs that distribute it over threads, processes or machines. A piece is a start of
// the search, improved to its end, as numbers. It depends only on the task, the seed and its number, so it does not
// matter who computes it, or when. Paths and machines are sought in pieces.
typedef struct YkPieces YkPieces;
// Prepares to compute pieces of a task, which must outlive them. `progress` and `seed` of the options count. Returns
// NULL with problems added when out of memory or when the task's machine cannot be assembled.
YK_API YkPieces *yk_pieces_new(const YkTask *task, const YkSynthesisOptions *options, YkProblems *problems);
YK_API void yk_pieces_free(YkPieces *pieces);
// Returns how many numbers a piece has; 0 if the task is not sought in pieces.
YK_API size_t yk_pieces_width(const YkPieces *pieces);
// Returns how many pieces there are at most.
YK_API size_t yk_pieces_count(const YkPieces *pieces);
// Returns a number that distinguishes these pieces from those of another task, seed or version.
YK_API uint64_t yk_pieces_signature(const YkPieces *pieces);
// Computes a piece: numbers[yk_pieces_width]. Returns YK_OK, YK_STOPPED or YK_BAD_ARGUMENT. Cost: some milliseconds;
// cheapest in ascending order.
YK_API YkStatus yk_pieces_compute(YkPieces *pieces, size_t piece, double *numbers);

// A dyad: a link between the ground and the moving body. World and body coordinates, m.
typedef enum YkDyadKind {
    YK_DYAD_RR, // two pins: the moving pivot is on a circle about the fixed one
    YK_DYAD_PR, // a slide on the ground: the moving pivot is on a line
    YK_DYAD_RP  // a slide on the body: a line of the body goes through the fixed pivot
} YkDyadKind;
typedef struct YkDyad {
    YkDyadKind kind;
    double fixed[2];  // pivot in the ground; PR: the foot of the line, nearest to the origin
    double moving[2]; // pivot in the body's axes; RP: the foot of the line, nearest to the body's origin
    double length;    // of the link; 0 with a slide
    double direction; // of the line, rad: PR in the ground, RP in the body; otherwise 0
} YkDyad;
YK_API size_t yk_synthesis_dyad_count(const YkSynthesis *synthesis);
YK_API YkDyad yk_synthesis_dyad(const YkSynthesis *synthesis, size_t index);

// Why a machine was left out.
typedef enum YkDefect {
    YK_DEFECT_NONE,
    YK_DEFECT_ASSEMBLY,     // the written file does not assemble at its first position
    YK_DEFECT_CIRCUIT,      // some positions can only be reached by taking the machine apart
    YK_DEFECT_BRANCH,       // a dead point of the input lies between the positions
    YK_DEFECT_ORDER,        // the positions are not passed in their order
    YK_DEFECT_INPUT,        // the input does not turn through
    YK_DEFECT_TRANSMISSION, // its angle falls below the one required
    YK_DEFECT_BOUNDS,       // a length, pivot or coupler point lies outside its bounds
    YK_DEFECT_SIZE,         // the longest link over the shortest is more than allowed
    YK_DEFECT_REQUIRE,      // a claim of `require` does not hold
    YK_DEFECT_COUNT
} YkDefect;
YK_API const char *yk_defect_name(YkDefect defect); // "branch"

// A machine that was found. Texts belong to the synthesis.
struct YkCandidate {
    const char *file;       // "01-four-bar.yaml"; NULL for one that was left out
    const char *model;      // the model file
    const char *mechanism;  // "four-bar", "slider-crank", ...; "machine" has parameters and no other dimensions
    const char *type;       // "crank-rocker", ...: as driven
    double error;           // sum of squares: of distances (path, m^2), angles (rad^2), or both by weight (motion)
    double worst;           // largest single deviation: m, or rad of a function
    double transmission[2]; // least and largest transmission angle over the motion, rad
    double size;            // length of the longest link, m; of functions: over the ground's
    size_t circuits;
    double pivots[2][2]; // of the ground: input's, output's, m
    double lengths[4];   // ground, input, coupler, output, m
    double offset;       // slider-crank: of the slider's line from the input's pivot, positive to its left, m;
                         // inverted: of the output's pivot from the coupler's line; others: NaN
    double point[2];     // coupler point in the coupler's axes: x along the coupler from the input side, m
    int dyads[2];        // those of the input and of the output side; -1: none
    YkDefect defect;     // why it was left out; NONE for candidates
};
YK_API size_t yk_synthesis_count(const YkSynthesis *synthesis);
YK_API YkCandidate yk_synthesis_candidate(const YkSynthesis *synthesis, size_t index); // best first
// The machines that were left out: how many for a reason, and each of them (at most 10,000 are kept).
YK_API size_t yk_synthesis_left_out(const YkSynthesis *synthesis, YkDefect reason);
YK_API size_t yk_synthesis_defect_count(const YkSynthesis *synthesis);
YK_API YkCandidate yk_synthesis_defect(const YkSynthesis *synthesis, size_t index);
// Parameters of a candidate's file by name and SI value; NULL past the last.
YK_API const char *yk_synthesis_parameter(const YkSynthesis *synthesis, size_t candidate, size_t index, double *value);
// Returns the input's absolute angles at the points of a path, rad, and their number in `count`; NULL and 0 for other
// tasks. The array belongs to the synthesis.
YK_API const double *yk_synthesis_angles(const YkSynthesis *synthesis, size_t candidate, size_t *count);
// Returns the largest error of the function generator that meets five points, from which the candidate was evened out,
// rad; NaN for a candidate that was not.
YK_API double yk_synthesis_interpolating(const YkSynthesis *synthesis, size_t candidate);
// Returns whether a function generator's input, or output, begins its range half a turn from the angle that the task
// fixes. A textbook writes its length as negative.
YK_API bool yk_synthesis_is_reversed(const YkSynthesis *synthesis, size_t candidate, bool output);
// The path of the coupler point over the motion, xy[2 * count] in m; functions: input angle and error, rad. Returns
// the count; the array belongs to the synthesis.
YK_API size_t yk_synthesis_curve(const YkSynthesis *synthesis, size_t candidate, const double **xy);
// All candidates side by side with the task and their curves, as SVG. The text belongs to the synthesis. NULL when out
// of memory.
YK_API const char *yk_synthesis_picture(YkSynthesis *synthesis);
// Further pictures, as SVG: Burmester's curves of a motion through four or five positions, with the pivots of the dyads
// to choose from; the errors of function generators over the range, evened out and before. The text belongs to the
// synthesis. NULL if the task has none, or when out of memory: then *ran_out (may be NULL) becomes true.
typedef enum YkSynthesisSheet { YK_SHEET_BURMESTER, YK_SHEET_ERRORS } YkSynthesisSheet;
YK_API const char *yk_synthesis_sheet(YkSynthesis *synthesis, YkSynthesisSheet sheet, bool *ran_out);

// Cognates: other machines that trace the same coupler curve. A four-bar has two, a slider-crank one. Source: Roberts
// 1875; Hartenberg & Denavit 1964, ch. 6.
typedef struct YkCognates YkCognates;
// Finds the cognates for a point of the coupler (YK_NOT_FOUND: its first point that is not a joint's). The state is
// assembled. Returns NULL with a problem if the machine has no four-bar or slider-crank on the ground with such a
// point.
YK_API YkCognates *yk_cognates_new(const YkState *state, size_t point, YkProblems *problems);
YK_API void yk_cognates_free(YkCognates *cognates);
YK_API size_t yk_cognates_count(const YkCognates *cognates); // without the machine itself
YK_API size_t yk_cognates_point(const YkCognates *cognates); // the model's point
// Returns a cognate as a candidate: its file and dimensions; `worst` is the largest distance between the curves as the
// engine measured it over the motion, m. Index YK_NOT_FOUND: the machine itself, without a file.
YK_API YkCandidate yk_cognates_at(const YkCognates *cognates, size_t index);
// The machine and its cognates drawn over one another, with the curve, as SVG. NULL when out of memory.
YK_API const char *yk_cognates_picture(YkCognates *cognates);

#ifdef __cplusplus
}
#endif

#endif

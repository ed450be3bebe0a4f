// Strands: real solutions of the blocks, one on top of the other, followed along the input with proof.
//
// A strand of level l is one solution of block l - 1 on top of a strand of level l - 1, which it follows over an
// interval of the input. Its cells cover that interval. In each of them Krawczyk's operator has shown that exactly one
// solution lies about the cell's centre, for every input of the cell and for all that the strands below may be. Level 0
// is the input alone.
#ifndef MAP_STRAND_H
#define MAP_STRAND_H
#include "configurations/certify.h"
#include "configurations/group.h"
#include "map/piece.h"
#include "solve/state.h"

typedef struct YkCell {
    double from, to;
    double middle;                      // where the line x + rate (input - middle) starts
    double radius, within, rate_within; // as in YkPathCertificate
    YkVec *x, *rate;                    // [unknowns]
} YkCell;

typedef struct YkStrand {
    size_t level;
    struct YkStrand *below; // NULL at level 0
    YkCell *cells;          // ascending; each ends where the next begins
    size_t count, capacity;
    size_t index; // among those of its level
    size_t last;  // the cell asked for last
} YkStrand;

typedef struct YkStrands {
    YkStrand **items;
    size_t count, capacity;
} YkStrands;

typedef enum YkTieKind { YK_TIE_LIMIT, YK_TIE_CHANGE, YK_TIE_ROUND, YK_TIE_PASS } YkTieKind;

// A tie: the machine passes from an end of a strand to an end of another one, at a limit, through a change point, by a
// whole turn of the input, or where it would have a change point if constraints that repeat others did not close on one
// branch alone.
typedef struct YkTie {
    YkTieKind kind;
    YkStrand *strand[2];
    int end[2]; // 0: where it begins, 1: where it ends
    double at;  // the input there
    size_t block;
    size_t event;        // ties of one event have the same number
    size_t source_event; // of the tie below from which it was carried
} YkTie;

typedef struct YkTies {
    YkTie *items;
    size_t count, capacity;
} YkTies;

// The data of following strands.
typedef struct YkTracer {
    YkArena *arena; // of the lists by piece
    const YkMechanism *mech;
    YkPiece *pieces; // in their order
    size_t piece_count;
    YkGroupKept *kept;
    YkGroupSolutions *solutions;
    size_t *expected;                   // per piece: as many solutions as were counted, at most
    YkDiscs discs, over;                // at one input; over an interval about it
    YkDiscCoefficients coefficients[2]; // scratch
    YkPace *pace;
    YkStrand **chain; // scratch: the strands below one, by level
    double scale;     // of the input: 1 rad, or the machine's size
    bool is_angle;
    double period;     // of an angle: whole turns after which everything repeats
    double low, high;  // the input's domain
    YkStrands *levels; // [piece_count + 1]
    YkTies *ties;      // [piece_count + 1]
    size_t event_count;
    bool out_of_memory;
    size_t steps_left; // of those that following may still take on this strand
    // The first thing that could not be proved.
    bool is_unproved;
    double unproved_at;
    size_t unproved_block;
    bool is_searched; // at many inputs only, on top of a piece in real unknowns: the first of them
    size_t searched_piece;
    const YkState *start; // where the relations of groups are read; NULL: such groups are not mapped
    bool repeats;         // blocks repeat constraints of others: what their loops leave is sifted (repeated.c)
    double single[8];     // inputs near which they may close in single poses beside the strands, the first of them
    size_t single_count;
    double single_last;
} YkTracer;

// Steps at most this, and at least that, over the scale.
#define YK_TRACE_LONGEST 0.05
#define YK_TRACE_SHORTEST 1e-12
// Solutions that meet are followed to within about the first of these; where rounding does not let them be told apart
// there, to within the second: at change points, to the square root of rounding. Events that lie closer together are
// one.
#define YK_TRACE_ZONE 1e-10
#define YK_TRACE_BLUR 1e-5
#define YK_MAP_CLOSE 1e-9 // over the scale: inputs that are the same event
// How many steps each solution may take over a strand, on average: some 130 for a whole turn, and up to a few thousand
// about each event. If a machine is so nearly special that it takes more, the map is not complete.
#define YK_TRACE_STEPS 30000

// --- following (tracer.c)

bool yk_map_refuse(YkProblems *problems, const char *what, const char *label); // NO_MAP; returns false
bool yk_tracer_begin(YkTracer *tracer, const YkMechanism *mech);               // returns false when out of memory
void yk_tracer_end(YkTracer *tracer);
// Reads the pieces. Returns false with a problem if one cannot be mapped.
bool yk_tracer_read(YkTracer *tracer, YkProblems *problems);
// Returns the angle, rad, after which everything repeats, whole turns of the inputs; 0 if that is not found.
double yk_tracer_period(const YkTracer *tracer);
// Returns what a piece is called after; *kind: the word before it.
const char *yk_tracer_label(const YkTracer *tracer, size_t piece, const char **kind);
// Returns a length that no distance of the machine exceeds while its loops are bounded by their links.
double yk_tracer_reach(const YkMechanism *mech);

// --- strands (strand.c)

YkStrand *yk_strand_new(YkTracer *tracer, size_t level, YkStrand *below); // NULL when out of memory, which is noted
bool yk_strand_keep(YkTracer *tracer, YkStrand *strand); // in the list of its level, which then owns it
void yk_strand_free(YkStrand *strand);
static inline double yk_strand_from(const YkStrand *s)
{
    return s->cells[0].from;
}
static inline double yk_strand_to(const YkStrand *s)
{
    return s->cells[s->count - 1].to;
}
// Adds a cell, with copies of x and rate. Returns false when out of memory.
bool yk_strand_add(YkTracer *tracer, YkStrand *strand, YkCell cell, const YkVec *x, const YkVec *rate);
void yk_strand_shorten(YkStrand *strand, size_t count); // forgets all cells after the first `count`
// Returns the cell that contains [from, to], or NULL if none does.
const YkCell *yk_strand_cell(YkStrand *strand, double from, double to);
// Returns where the cell of the strand that contains `at` ends, in a direction (+1, -1).
double yk_strand_cell_end(YkStrand *strand, double at, int direction);
void yk_note_unproved(YkTracer *tracer, double at, size_t block);

void yk_strand_reverse(YkStrand *strand); // the order of its cells

// --- enclosing (enclose.c)

// Takes the steps between two blocks: those before block `level` and after the one before it.
void yk_trace_steps(YkTracer *tracer, YkDiscs *discs, size_t level);
// Encloses the pose of a strand at one input in tracer->discs, and takes all steps up to the next block's. Returns
// false if it has no cell there.
bool yk_trace_place(YkTracer *tracer, YkStrand *strand, double at);
// Does the same in the middle of an interval, within one cell of the strand and of all below it, and in tracer->over
// for all inputs of the interval, with derivatives. half: half its length.
bool yk_trace_place_path(YkTracer *tracer, YkStrand *strand, double from, double to, double *half);
// Places what lies at two ends that are tied, and all between: from a to b, and 1.5 times as wide.
bool yk_trace_place_between(YkTracer *tracer, YkStrand *a, double at_a, YkStrand *b, double at_b);
// Finds the unknowns of a strand at an input, after placing the strands below it.
bool yk_trace_read(YkTracer *tracer, YkStrand *strand, double at, YkVec *x, double *within);
// Finds the solution of block `level` on top of the placed pose near x, which it improves, and encloses it: at one
// input, or over the interval placed.
bool yk_trace_enclose(YkTracer *tracer, size_t level, YkVec *x, YkCertificate *certificate);
bool yk_trace_enclose_path(YkTracer *tracer, size_t level, double half, YkVec *x, YkPathCertificate *certificate);
void yk_cell_at(const YkPiece *piece, const YkCell *cell, double at, YkVec *x); // the cell's line
// Returns whether a solution at y within `within` lies in the discs about x of `radius`.
bool yk_trace_is_inside(const YkPiece *piece, const YkVec *x, double radius, const YkVec *y, double within);

// --- following (follow.c)

// Follows a solution x of block `level` on top of `below` from `from` towards `to`. Adds cells to `strand` unless it is
// NULL; those of a way down are added in descending order. Returns where it ends: at `to`, or where steps became too
// short or too many. x is the solution there.
double yk_trace_follow(YkTracer *tracer, YkStrand *below, double from, double to, YkVec *x, YkStrand *strand);

// --- levels (level.c)

// Finds all strands of a level on top of those of the level below, and the ties between them.
void yk_trace_level(YkTracer *tracer, size_t level);
// Finds the strands of a piece in real unknowns on top of one strand, and their ties (search.c).
void yk_trace_search(YkTracer *tracer, YkStrand *below);
bool yk_trace_tie(YkTracer *tracer, size_t level, YkTie tie); // returns false when out of memory
// Ties the strands of a level where those below are tied (carry.c).
void yk_trace_carry(YkTracer *tracer, size_t level);

// --- constraints that repeat others (repeated.c)

// Keeps the strands of the last level on which the loops that repeat others close. Those are analytic on a strand: they
// close everywhere on it or in single poses, which are noted.
void yk_repeated_sift(YkTracer *tracer);

#endif

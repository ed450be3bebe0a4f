// Nine points at any angles: all four-bars whose coupler point passes them, from the paths of Alt's problem.
#include <string.h>
#include "synthesis/nine_points/alt_certify.h"
#include "synthesis/paths/path_search.h"

enum { NUMBERS = 2 * YK_ALT_SIZE + 1, HOPELESS = 32 }; // numbers of a piece: whether it arrived, and where

typedef struct Exact {
    YkSynthesis *s;
    YkAltTask task;
    YkVec (*x)[YK_ALT_SIZE]; // [YK_ALT_TRIPLES], proved and different
    YkAltProof *proof;       // [YK_ALT_TRIPLES]
    size_t count;
    double *numbers; // of a piece
} Exact;

bool yk_path_is_exact(const YkTask *task)
{
    const YkPathTask *path = &task->path;
    bool is_fixed = path->pivot[0].is_given || path->pivot[1].is_given || path->ground_angle.is_given;
    return task->has_four_bar && path->count == YK_ALT_POINTS && path->timing == YK_TIMING_ANY && !is_fixed;
}

size_t yk_path_exact_pieces(const YkTask *task)
{
    return yk_path_is_exact(task) ? YK_ALT_ROUTES * YK_ALT_TRIPLES : 0;
}

void yk_path_exact_piece(const YkTask *task, uint64_t seed, size_t piece, YkPace *pace, double *numbers)
{
    YkAltTask alt;
    YkVec x[YK_ALT_SIZE];
    yk_alt_pose(task->path.point, seed, &alt);
    memset(numbers, 0, NUMBERS * sizeof *numbers);
    if (!yk_alt_path(&alt, piece, pace, x)) return;
    numbers[0] = 1;
    memcpy(numbers + 1, x, sizeof x);
}

// Proves a solution by one of its names, and gives it that name.
static bool prove(const YkAltTask *task, YkVec *x, YkAltProof *proof)
{
    YkVec named[YK_ALT_SIZE];
    for (size_t name = 0; name < YK_ALT_NAMES / 2; name++) {
        yk_alt_name(name, x, named);
        if (!yk_alt_certify(task->places, named, proof)) continue;
        memcpy(x, named, sizeof named);
        return true;
    }
    return false;
}

// Keeps a solution that can be proved, unless its triple is there.
static void take(Exact *exact, const double *numbers)
{
    YkVec *x = exact->x[exact->count];
    YkAltProof *proof = &exact->proof[exact->count];
    if (numbers[0] != 1) return;
    memcpy(x, numbers + 1, YK_ALT_SIZE * sizeof *x);
    if (!prove(&exact->task, x, proof)) return;
    for (size_t k = 0; k < exact->count; k++)
        if (!yk_alt_are_different(proof, &exact->proof[k])) return;
    exact->count++;
}

// Computes a piece, or gets it, and takes what it holds. Returns false if the search is to end.
static bool follow_one(Exact *exact, size_t piece)
{
    YkSynthesis *s = exact->s;
    if (s->options.pieces.get) {
        if (!yk_synthesis_fetch(s, piece, exact->numbers)) return false;
    } else {
        yk_path_exact_piece(s->task, s->options.seed, piece, &s->pace, exact->numbers);
    }
    if (!yk_synthesis_goes_on(s, 100)) return false;
    take(exact, exact->numbers);
    return true;
}

// Follows all paths along one route after the other, until every triple is there or a route shows nothing new: special
// points have fewer solutions. If the first paths show none at all, as with points on a line or one point given twice,
// solutions are not isolated, and none can be proved. Returns false if stopped.
static bool follow_all(Exact *exact)
{
    for (size_t route = 0, before = 0; route < YK_ALT_ROUTES; route++, before = exact->count) {
        for (size_t k = 0; k < YK_ALT_TRIPLES && exact->count < YK_ALT_TRIPLES; k++) {
            yk_pace_reach(&exact->s->pace, (double)k / YK_ALT_TRIPLES);
            if (!follow_one(exact, route * YK_ALT_TRIPLES + k)) return false;
            if (exact->count == 0 && k + 1 == HOPELESS) return true;
        }
        if (exact->count == before || exact->count == YK_ALT_TRIPLES) break;
    }
    return true;
}

// --- machines

// Puts one dyad of a solution as one that is to be judged.
static YkDyad dyad_of(const Exact *exact, const YkVec *x)
{
    const YkAltTask *task = &exact->task;
    YkVec moving = yk_scale(task->size, x[YK_ALT_X]), fixed = yk_scale(task->size, x[YK_ALT_A]);
    YkDyad dyad = {.kind = YK_DYAD_RR, .length = yk_norm(yk_sub(moving, fixed))};
    fixed = yk_add(task->origin, fixed);
    dyad.moving[0] = moving.x;
    dyad.moving[1] = moving.y;
    dyad.fixed[0] = fixed.x;
    dyad.fixed[1] = fixed.y;
    return dyad;
}

// Judges one of a triple's three four-bars.
static void judge(Exact *exact, const YkVec *x)
{
    YkSynthesis *s = exact->s;
    YkPose pose[YK_ALT_POINTS] = {{.at = s->task->path.point[0]}};
    YkPair pair = {.pose = pose, .count = YK_ALT_POINTS, .turns = s->task->path.is_closed, .index = {-1, -1}};
    for (size_t j = 0; j < YK_ALT_SIZE; j++) {
        YkVec turn;
        if (!yk_alt_turn(exact->task.places, x, j, &turn)) turn = yk_vec(1, 0); // the engine then finds it elsewhere
        pose[j + 1] = (YkPose){.at = s->task->path.point[j + 1], .angle = yk_atan2(turn.y, turn.x)};
    }
    for (size_t side = 0; side < YK_SIDES; side++) {
        pair.dyad[side] = dyad_of(exact, x + side * YK_ALT_DYAD);
        pair.may_drive[side] = true;
    }
    yk_synthesis_take_pair(s, &pair);
}

static void judge_all(Exact *exact, size_t real)
{
    enum { COGNATES = 3 };
    YkSynthesis *s = exact->s;
    for (size_t k = 0, done = 0; k < exact->count; k++) {
        if (exact->proof[k].reality != YK_ALT_REAL) continue;
        for (size_t name = 0; name < COGNATES; name++) {
            YkVec x[YK_ALT_SIZE];
            yk_pace_reach(&s->pace, (double)(COGNATES * done + name) / (double)(COGNATES * real));
            if (!yk_synthesis_goes_on(s, 1)) return;
            yk_alt_name(name, exact->x[k], x);
            yk_alt_polish(exact->task.places, x);
            judge(exact, x);
        }
        done++;
    }
}

bool yk_synthesise_exact_path(YkSynthesis *s, double to)
{
    static const double paths_share = 0.9;
    Exact exact = {.s = s};
    size_t real = 0;
    exact.x = yk_arena_alloc(s->arena, YK_ALT_TRIPLES + 1, sizeof *exact.x);
    exact.proof = YK_NEW(s->arena, YkAltProof, YK_ALT_TRIPLES + 1);
    exact.numbers = YK_NEW(s->arena, double, yk_path_width(s->task));
    if (!exact.x || !exact.proof || !exact.numbers) return false;
    yk_alt_pose(s->task->path.point, s->options.seed, &exact.task);
    yk_pace_stage(&s->pace, 0, paths_share * to);
    if (!follow_all(&exact)) return false;
    for (size_t k = 0; k < exact.count; k++) real += exact.proof[k].reality == YK_ALT_REAL;
    s->has_solutions = exact.count > 0;
    s->complex_count = YK_ALT_NAMES * exact.count;
    s->real_count = YK_ALT_NAMES * real;
    yk_pace_stage(&s->pace, paths_share * to, to);
    judge_all(&exact, real);
    return exact.count == YK_ALT_TRIPLES;
}

// Proves that the motion from one pose to the next follows one configuration: tubes about its way, each with exactly one
// solution in it, and each with the end of the one before.
#include <yoke/certificate.h>
#include <stdlib.h>
#include <string.h>
#include "base/text.h"
#include "map/tube.h"
#include "solve/state.h"

enum { TUBES_MAX = 512 };            // between two poses
static const double NEAR = 1e-7;     // how far a pose may be from the solution that it stands for
static const double SHORTEST = 1e-6; // tube, of the way between two poses

typedef struct Pose { // of all pieces
    YkVec *x;
    double *within; // [piece]: of x
} Pose;

typedef struct Chain { // the blocks up to the last group
    const YkMechanism *mech;
    YkPiece *pieces;
    size_t piece_count;
    YkDiscs discs, over; // in the middle of an interval, and over it
    YkDiscCoefficients coefficients[2];
} Chain;

struct YkCertifier {
    YkWitness witness;
    Chain chain;
    size_t *first; // [piece]: of its unknowns
    size_t unknowns;
    double *memory, *from, *way; // [input]
    Pose before, here, trial;
    YkTube *tubes;       // [piece]: the last ones
    const char *outside; // why nothing can be proved, or NULL
    bool has_before;     // a pose to go on from
    double stride;       // of the last tubes, in units of the inputs' way
    YkMotionCertificate found;
};

// --- what is proved

static const char *read_pieces(YkCertifier *c, size_t steps)
{
    Chain *t = &c->chain;
    for (size_t k = 0; k < steps; k++) {
        const YkStep *step = &t->mech->steps[k];
        if (step->kind != YK_STEP_BLOCK && !yk_discs_can_take(t->mech, step))
            return "a cam, a law, or a gear is moved by links that loops place before a group, or a law jumps";
        if (step->kind != YK_STEP_BLOCK) continue;
        YkPiece *piece = &t->pieces[t->piece_count];
        YkPieceStatus status = yk_piece_read(piece, t->mech, k);
        if (status == YK_PIECE_REPEATED) continue;
        if (status == YK_PIECE_REDUNDANT) return "constraints of a group repeat others";
        if (status == YK_PIECE_RELATIONS)
            return "gears, belts, cams or laws are solved together with the loops of a group";
        if (status == YK_PIECE_LARGE) return "a group has more than seven loops";
        if (status != YK_PIECE_READ) return "a distance of a group runs along more than one line";
        c->first[t->piece_count++] = c->unknowns;
        c->unknowns += piece->shape.unknowns;
    }
    return NULL;
}

// Returns the number of steps up to the last group's.
static size_t steps_to_groups(const YkMechanism *mech)
{
    size_t steps = 0;
    for (size_t k = 0; k < mech->step_count; k++) {
        bool is_group =
            mech->steps[k].kind == YK_STEP_BLOCK && mech->blocks[mech->steps[k].target].kind == YK_BLOCK_GROUP;
        if (is_group) steps = k + 1;
    }
    return steps;
}

// --- poses

static void read_pose(const YkCertifier *c, const YkState *s, Pose *pose)
{
    const YkMechanism *mech = c->chain.mech;
    for (size_t level = 0; level < c->chain.piece_count; level++) {
        const YkPiece *piece = &c->chain.pieces[level];
        const YkBlock *block = &mech->blocks[piece->block];
        for (size_t k = 0; k < piece->shape.unknowns; k++) {
            YkColumn column = block->kind == YK_BLOCK_GROUP
                                  ? mech->group_columns[block->first_column + piece->shape.column[k]]
                                  : block->column[k];
            YkVec *x = &pose->x[c->first[level] + k];
            if (column.is_distance) {
                *x = yk_vec(yk_space_slide(&s->space, column.index).d[0] / mech->size, 0);
            } else {
                YkTurn turn = yk_space_turn(&s->space, column.index);
                *x = yk_vec(turn.c[0], turn.s[0]);
            }
        }
    }
}

// Takes the steps between the blocks before a level and its own.
static void take_steps(const Chain *t, YkDiscs *discs, size_t level)
{
    for (size_t k = level == 0 ? 0 : t->pieces[level - 1].step + 1; k < t->pieces[level].step; k++)
        yk_discs_take(discs, &t->mech->steps[k]);
}

// Improves and encloses a pose at a place of the way. Returns false if there is no proof that one solution is there, no farther
// away than `near`.
static bool enclose(YkCertifier *c, double at, Pose *pose, double near)
{
    Chain *t = &c->chain;
    YkTube point = {.middle = at};
    t->discs.input = yk_ball(yk_vec(at, 0), 0);
    for (size_t level = 0; level < t->piece_count; level++) {
        const YkPiece *piece = &t->pieces[level];
        YkVec *x = pose->x + c->first[level];
        size_t bytes = piece->shape.unknowns * sizeof *x;
        memcpy(point.x, x, bytes);
        take_steps(t, &t->discs, level);
        yk_piece_coefficients(piece, &t->discs, &t->coefficients[0]);
        if (!yk_tube_make(piece, &t->coefficients[0], NULL, 0, &point)) return false;
        for (size_t k = 0; k < piece->shape.unknowns; k++)
            if (!(yk_sum_norm(yk_sub(x[k], point.x[k])) < near)) return false;
        memcpy(x, point.x, bytes);
        pose->within[level] = point.within;
        yk_tube_place(piece, &point, &t->discs);
    }
    return true;
}

// --- tubes

// Makes tubes from one place of the way to another, about the solution near `guess` in their middle. Returns false if they are
// not proved to contain exactly one solution everywhere.
static bool make_tubes(YkCertifier *c, double from, double to, const YkVec *guess)
{
    Chain *t = &c->chain;
    double middle = from + 0.5 * (to - from), half = YK_BALL_OUT(fmax(to - middle, middle - from));
    YkDiscCoefficients *at_middle = &t->coefficients[0], *over = &t->coefficients[1];
    YkTube point;
    t->discs.input = yk_ball(yk_vec(middle, 0), 0);
    t->over.input = yk_ball(yk_vec(middle, 0), half);
    for (size_t level = 0; level < t->piece_count; level++) {
        const YkPiece *piece = &t->pieces[level];
        YkTube *tube = &c->tubes[level];
        tube->middle = middle;
        memcpy(tube->x, guess + c->first[level], piece->shape.unknowns * sizeof *guess);
        take_steps(t, &t->discs, level);
        take_steps(t, &t->over, level);
        yk_piece_coefficients(piece, &t->discs, at_middle);
        yk_piece_coefficients(piece, &t->over, over);
        if (!yk_tube_make(piece, at_middle, over, half, tube)) return false;
        if (level + 1 == t->piece_count) break;
        point = *tube;
        if (!yk_tube_make(piece, at_middle, NULL, 0, &point)) return false;
        if (!yk_tube_contains(piece, tube, middle, point.x, point.within)) return false;
        yk_tube_place(piece, tube, &t->over);
        yk_tube_place(piece, &point, &t->discs);
    }
    return true;
}

static void read_line(const YkCertifier *c, double at, YkVec *x)
{
    for (size_t level = 0; level < c->chain.piece_count; level++)
        yk_tube_at(&c->chain.pieces[level], &c->tubes[level], at, x + c->first[level]);
}

typedef enum Verdict { PROVED, REFUTED, OPEN } Verdict;

// Returns whether an enclosed pose is that of the tubes at a place: a pose in them is, for there is only one.
static Verdict is_in_tubes(const YkCertifier *c, double at, const Pose *pose)
{
    for (size_t level = 0; level < c->chain.piece_count; level++) {
        const YkPiece *piece = &c->chain.pieces[level];
        const YkVec *x = pose->x + c->first[level];
        if (yk_tube_contains(piece, &c->tubes[level], at, x, pose->within[level])) continue;
        return yk_tube_excludes(piece, &c->tubes[level], at, x, pose->within[level]) ? REFUTED : OPEN;
    }
    return PROVED;
}

// --- from pose to pose

// Returns how far the inputs go: rad, or lengths over the size.
static double way_length(const YkCertifier *c)
{
    double longest = 0;
    for (size_t i = 0; i < c->chain.mech->input_count; i++)
        longest = fmax(longest, fabs(c->way[i]) / yk_input_unit(c->chain.mech, i));
    return longest;
}

static void swap_poses(Pose *a, Pose *b)
{
    Pose other = *a;
    *a = *b;
    *b = other;
}

// Follows the solution of the pose before, tube by tube, to the pose here.
static Verdict follow(YkCertifier *c)
{
    double at = 0, length = way_length(c), h = fmin(0.5, 1.2 * c->stride / length);
    Verdict verdict = OPEN;
    Pose *now = &c->before;
    YkVec *guess = c->trial.x;
    memcpy(guess, now->x, c->unknowns * sizeof *guess);
    for (size_t tubes = 0; tubes < TUBES_MAX && h > SHORTEST && verdict != PROVED; tubes++) {
        double to = at + h < 1 ? at + h : 1;
        if (!make_tubes(c, at, to, guess) || is_in_tubes(c, at, now) != PROVED) {
            memcpy(guess, now->x, c->unknowns * sizeof *guess);
            h *= 0.5;
            continue;
        }
        if (to == 1) {
            verdict = is_in_tubes(c, 1, &c->here);
            if (verdict != OPEN) return verdict;
        }
        read_line(c, to, c->trial.x);
        if (!enclose(c, to, &c->trial, INFINITY) || is_in_tubes(c, to, &c->trial) != PROVED) {
            memcpy(guess, now->x, c->unknowns * sizeof *guess);
            h *= 0.5;
            continue;
        }
        if (to == 1) return OPEN;
        c->stride = h * length;
        swap_poses(now, &c->trial);
        guess = c->trial.x;
        at = to;
        h *= 1.3;
        read_line(c, fmin(at + 0.5 * h, 1), guess);
    }
    return verdict;
}

static Verdict prove(YkCertifier *c)
{
    YkVec *guess = c->trial.x;
    if (way_length(c) > 2 * c->stride) return follow(c);
    for (size_t k = 0; k < c->unknowns; k++) guess[k] = yk_scale(0.5, yk_add(c->before.x[k], c->here.x[k]));
    if (make_tubes(c, 0, 1, guess) && is_in_tubes(c, 0, &c->before) == PROVED) {
        Verdict verdict = is_in_tubes(c, 1, &c->here);
        if (verdict != OPEN) return verdict;
    }
    c->stride = 0.5 * way_length(c);
    return follow(c);
}

static void set_way(YkCertifier *c, const YkState *s, const double *from)
{
    for (size_t i = 0; i < c->chain.mech->input_count; i++) {
        c->from[i] = from ? from[i] : s->valid_input[3 * i];
        c->way[i] = s->valid_input[3 * i] - c->from[i];
    }
}

static void begin(YkWitness *witness, const YkState *s)
{
    YkCertifier *c = (YkCertifier *)witness;
    c->has_before = false;
    if (c->outside || c->chain.piece_count == 0 || !s->has_pose) return;
    set_way(c, s, NULL);
    read_pose(c, s, &c->before);
    c->has_before = enclose(c, 0, &c->before, NEAR);
}

static void note_step(YkCertifier *c, Verdict verdict)
{
    size_t most = 0;
    const YkMechanism *mech = c->chain.mech;
    c->found.steps++;
    c->found.proved += verdict == PROVED;
    c->found.is_refuted |= verdict == REFUTED;
    if (verdict == PROVED || c->found.input >= 0) return;
    for (size_t i = 1; i < mech->input_count; i++)
        if (fabs(c->way[i]) / yk_input_unit(mech, i) > fabs(c->way[most]) / yk_input_unit(mech, most)) most = i;
    c->found.input = mech->input_count > 0 ? (int)most : -1;
    c->found.from = c->from[most];
    c->found.to = c->from[most] + c->way[most];
}

static bool moves(const YkCertifier *c)
{
    bool moves = false;
    for (size_t i = 0; i < c->chain.mech->input_count; i++) moves |= c->way[i] != 0;
    return moves;
}

static void step(YkWitness *witness, const YkState *s)
{
    YkCertifier *c = (YkCertifier *)witness;
    c->found.steps += c->outside != NULL;
    if (c->outside || c->chain.piece_count == 0) return;
    double *last = c->memory;
    for (size_t i = 0; i < c->chain.mech->input_count; i++) last[i] = c->from[i] + c->way[i];
    set_way(c, s, last);
    if (!moves(c) && c->has_before) return;
    read_pose(c, s, &c->here);
    bool stands = enclose(c, 1, &c->here, NEAR);
    note_step(c, stands && c->has_before ? prove(c) : OPEN);
    c->has_before = stands;
    swap_poses(&c->before, &c->here);
}

// --- the door

static bool allocate(YkCertifier *c, const YkMechanism *mech)
{
    size_t blocks = mech->block_count + 1, most = blocks * YK_PIECE_UNKNOWNS, inputs = mech->input_count;
    size_t vectors = 3 * most, numbers = 3 * inputs + 3 * blocks;
    c->first = calloc(blocks, sizeof *c->first);
    c->memory = calloc(2 * vectors + numbers, sizeof *c->memory);
    c->tubes = calloc(blocks, sizeof *c->tubes);
    c->chain.pieces = calloc(blocks, sizeof *c->chain.pieces);
    bool has_discs = yk_discs_start(&c->chain.discs, mech);
    has_discs = yk_discs_start(&c->chain.over, mech) && has_discs;
    if (!c->first || !c->memory || !c->tubes || !c->chain.pieces || !has_discs) return false;
    c->from = c->memory + inputs;
    c->way = c->from + inputs;
    double *next = c->way + inputs;
    YkVec *x = (YkVec *)(next + 3 * blocks);
    Pose *poses[] = {&c->before, &c->here, &c->trial};
    for (size_t k = 0; k < 3; k++) *poses[k] = (Pose){x + k * most, next + k * blocks};
    return true;
}

YkCertifier *yk_certifier_new(const YkMechanism *mech)
{
    YkCertifier *c = calloc(1, sizeof *c);
    if (!c) return NULL;
    c->witness = (YkWitness){begin, step};
    c->found.input = -1;
    c->stride = INFINITY;
    c->chain.mech = mech;
    if (!allocate(c, mech)) {
        yk_certifier_free(c);
        return NULL;
    }
    c->outside = read_pieces(c, steps_to_groups(mech));
    YkDiscs *discs[] = {&c->chain.discs, &c->chain.over};
    for (size_t k = 0; k < 2; k++) {
        discs[k]->others = c->from;
        discs[k]->ways = c->way;
    }
    return c;
}

void yk_certifier_free(YkCertifier *c)
{
    if (!c) return;
    yk_discs_end(&c->chain.discs);
    yk_discs_end(&c->chain.over);
    free(c->chain.pieces);
    free(c->first);
    free(c->memory);
    free(c->tubes);
    free(c);
}

YkStatus yk_state_set_certifier(YkState *state, YkCertifier *certifier)
{
    if (certifier && certifier->chain.mech != state->mech) return YK_BAD_ARGUMENT;
    state->witness = certifier ? &certifier->witness : NULL;
    return YK_OK;
}

YkMotionCertificate yk_certifier_report(const YkCertifier *c)
{
    YkMotionCertificate found = c->found;
    YkText text = {0};
    found.is_needed = c->outside || c->chain.piece_count > 0;
    found.is_certified = !c->outside && found.steps == found.proved;
    if (c->outside)
        yk_text_format(&text, "not certified: %s", c->outside);
    else if (c->chain.piece_count == 0)
        yk_text_puts(&text, "certified: no group, all in closed form");
    else if (found.is_certified)
        yk_text_puts(&text, "certified: proved to stay on one configuration");
    else if (found.is_refuted)
        yk_text_puts(&text, "refuted: the motion is proved to have gone over to another configuration");
    else
        yk_text_format(&text, "not certified: %z of %z steps are not proved to stay on one configuration",
                       found.steps - found.proved, found.steps);
    yk_text_move(&text, found.message, sizeof found.message);
    return found;
}

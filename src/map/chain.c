// Follows one configuration of a machine's blocks along a way of its inputs, with proof.
#include "map/chain.h"
#include <stdlib.h>
#include <string.h>

enum { TUBES_MAX = 512 };            // on one way
static const double SHORTEST = 1e-6; // tube, of the way

// --- what is proved

static const char *name_piece(YkPieceStatus status)
{
    if (status == YK_PIECE_REDUNDANT) return "constraints of a group repeat others";
    if (status == YK_PIECE_RELATIONS) return "gears, belts, cams or laws are solved together with the loops of a group";
    if (status == YK_PIECE_LARGE) return "a group has more than seven loops";
    return "a distance of a group runs along more than one line";
}

static const char *read_pieces(YkChain *t, size_t steps)
{
    t->outside_block = YK_NOT_FOUND;
    for (size_t k = 0; k < steps; k++) {
        const YkStep *step = &t->mech->steps[k];
        if (step->kind != YK_STEP_BLOCK && !yk_discs_can_take(t->mech, step))
            return "a cam, a law, or a gear is moved by links that loops place before a group, or a law jumps";
        if (step->kind != YK_STEP_BLOCK) continue;
        YkPiece *piece = &t->pieces[t->piece_count];
        YkPieceStatus status = yk_piece_read(piece, t->mech, k);
        if (status == YK_PIECE_REPEATED) continue;
        if (status != YK_PIECE_READ) {
            t->outside_block = (size_t)step->target;
            return name_piece(status);
        }
        t->first[t->piece_count++] = t->unknowns;
        t->unknowns += piece->shape.unknowns;
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

// --- memory

bool yk_chain_start(YkChain *t, const YkMechanism *mech)
{
    size_t blocks = mech->block_count + 1, inputs = mech->input_count;
    *t = (YkChain){.mech = mech, .stride = INFINITY};
    t->first = calloc(blocks, sizeof *t->first);
    t->tubes = calloc(blocks, sizeof *t->tubes);
    t->pieces = calloc(blocks, sizeof *t->pieces);
    bool has_discs = yk_discs_start(&t->discs, mech);
    has_discs = yk_discs_start(&t->over, mech) && has_discs;
    if (!t->first || !t->tubes || !t->pieces || !has_discs) return false;
    t->outside = read_pieces(t, steps_to_groups(mech));
    size_t pose = yk_chain_pose_size(t);
    double *memory = t->memory = calloc(2 * (pose + inputs) + 1, sizeof *memory);
    if (!memory) return false;
    t->now = yk_chain_pose_in(t, memory);
    t->trial = yk_chain_pose_in(t, memory + pose);
    t->from = memory + 2 * pose;
    t->way = t->from + inputs;
    YkDiscs *discs[] = {&t->discs, &t->over};
    for (size_t k = 0; k < 2; k++) {
        discs[k]->others = t->from;
        discs[k]->ways = t->way;
    }
    return true;
}

void yk_chain_end(YkChain *t)
{
    yk_discs_end(&t->discs);
    yk_discs_end(&t->over);
    free(t->pieces);
    free(t->first);
    free(t->tubes);
    free(t->memory);
    *t = (YkChain){0};
}

size_t yk_chain_pose_size(const YkChain *t)
{
    return 2 * (t->unknowns + t->piece_count);
}

YkChainPose yk_chain_pose_in(const YkChain *t, double *memory)
{
    double *within = memory + 2 * t->unknowns;
    return (YkChainPose){(YkVec *)memory, within, within + t->piece_count};
}

void yk_chain_copy(const YkChain *t, const YkChainPose *to, const YkChainPose *from)
{
    if (t->piece_count > 0) memcpy(to->x, from->x, yk_chain_pose_size(t) * sizeof(double));
}

// --- poses

void yk_chain_read(const YkChain *t, const YkState *s, YkChainPose *pose)
{
    const YkMechanism *mech = t->mech;
    for (size_t level = 0; level < t->piece_count; level++) {
        const YkPiece *piece = &t->pieces[level];
        const YkBlock *block = &mech->blocks[piece->block];
        for (size_t k = 0; k < piece->shape.unknowns; k++) {
            YkColumn column = block->kind == YK_BLOCK_GROUP
                                  ? mech->group_columns[block->first_column + piece->shape.column[k]]
                                  : block->column[k];
            YkVec *x = &pose->x[t->first[level] + k];
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
static void take_steps(const YkChain *t, YkDiscs *discs, size_t level)
{
    for (size_t k = level == 0 ? 0 : t->pieces[level - 1].step + 1; k < t->pieces[level].step; k++)
        yk_discs_take(discs, &t->mech->steps[k]);
}

bool yk_chain_enclose(YkChain *t, double at, YkChainPose *pose, double near)
{
    YkTube point = {.middle = at};
    t->discs.input = yk_ball(yk_vec(at, 0), 0);
    for (size_t level = 0; level < t->piece_count; level++) {
        const YkPiece *piece = &t->pieces[level];
        YkVec *x = pose->x + t->first[level];
        size_t bytes = piece->shape.unknowns * sizeof *x;
        t->level = level;
        memcpy(point.x, x, bytes);
        take_steps(t, &t->discs, level);
        yk_piece_coefficients(piece, &t->discs, &t->coefficients[0]);
        if (!yk_tube_make(piece, &t->coefficients[0], NULL, 0, &point)) return false;
        for (size_t k = 0; k < piece->shape.unknowns; k++)
            if (!(yk_sum_norm(yk_sub(x[k], point.x[k])) < near)) return false;
        memcpy(x, point.x, bytes);
        pose->within[level] = point.within;
        pose->radius[level] = point.radius;
        yk_tube_place(piece, &point, &t->discs);
    }
    return true;
}

bool yk_chain_is_same(const YkChain *t, const YkChainPose *pose, const YkChainPose *other, double off)
{
    for (size_t level = 0; level < t->piece_count; level++)
        for (size_t k = 0; k < t->pieces[level].shape.unknowns; k++) {
            YkVec apart = yk_sub(pose->x[t->first[level] + k], other->x[t->first[level] + k]);
            if (!(1.2 * yk_sum_norm(apart) + off < 0.5 * pose->radius[level])) return false; // half: for all rounding
        }
    return true;
}

bool yk_chain_is_other(const YkChain *t, const YkChainPose *pose, const YkChainPose *other)
{
    for (size_t level = 0; level < t->piece_count; level++)
        for (size_t k = 0; k < t->pieces[level].shape.unknowns; k++) {
            YkVec a = pose->x[t->first[level] + k], b = other->x[t->first[level] + k];
            double size = fmax(1, fmax(yk_sum_norm(a), yk_sum_norm(b)));
            double within = 2 * (pose->within[level] + other->within[level]) * size; // chords are shorter than angles
            if (yk_sum_norm(yk_sub(a, b)) > within + 1e-13 * size) return true;
        }
    return false;
}

// --- tubes

// Makes tubes from one place of the way to another, about the solution near `guess` in their middle. Returns false if
// they are not proved to contain exactly one solution everywhere.
static bool make_tubes(YkChain *t, double from, double to, const YkVec *guess)
{
    double middle = from + 0.5 * (to - from), half = YK_BALL_OUT(fmax(to - middle, middle - from));
    YkDiscCoefficients *at_middle = &t->coefficients[0], *over = &t->coefficients[1];
    YkTube point;
    t->discs.input = yk_ball(yk_vec(middle, 0), 0);
    t->over.input = yk_ball(yk_vec(middle, 0), half);
    for (size_t level = 0; level < t->piece_count; level++) {
        const YkPiece *piece = &t->pieces[level];
        YkTube *tube = &t->tubes[level];
        t->level = level;
        tube->middle = middle;
        memcpy(tube->x, guess + t->first[level], piece->shape.unknowns * sizeof *guess);
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

static void read_line(const YkChain *t, double at, YkVec *x)
{
    for (size_t level = 0; level < t->piece_count; level++)
        yk_tube_at(&t->pieces[level], &t->tubes[level], at, x + t->first[level]);
}

// Returns whether an enclosed pose is that of the tubes at a place: a pose in them is, for there is only one.
static YkVerdict is_in_tubes(YkChain *t, double at, const YkChainPose *pose)
{
    for (size_t level = 0; level < t->piece_count; level++) {
        const YkPiece *piece = &t->pieces[level];
        const YkVec *x = pose->x + t->first[level];
        t->level = level;
        if (yk_tube_contains(piece, &t->tubes[level], at, x, pose->within[level])) continue;
        return yk_tube_excludes(piece, &t->tubes[level], at, x, pose->within[level]) ? YK_WAY_REFUTED : YK_WAY_OPEN;
    }
    return YK_WAY_PROVED;
}

// --- from pose to pose

// Returns how far the inputs go: rad, or lengths over the size.
static double way_length(const YkChain *t)
{
    double longest = 0;
    for (size_t i = 0; i < t->mech->input_count; i++)
        longest = fmax(longest, fabs(t->way[i]) / yk_input_unit(t->mech, i));
    return longest;
}

static void swap_poses(YkChainPose *a, YkChainPose *b)
{
    YkChainPose other = *a;
    *a = *b;
    *b = other;
}

// Follows the solution tube by tube.
static YkVerdict follow(YkChain *t, const YkChainPose *there)
{
    double at = 0, length = way_length(t), h = fmin(0.5, 1.2 * t->stride / length);
    YkVec *guess = t->trial.x;
    memcpy(guess, t->now.x, t->unknowns * sizeof *guess);
    for (size_t tubes = 0; tubes < TUBES_MAX && h > SHORTEST; tubes++) {
        double to = at + h < 1 ? at + h : 1;
        if (!make_tubes(t, at, to, guess) || is_in_tubes(t, at, &t->now) != YK_WAY_PROVED) {
            memcpy(guess, t->now.x, t->unknowns * sizeof *guess);
            h *= 0.5;
            continue;
        }
        if (to == 1 && there) {
            YkVerdict verdict = is_in_tubes(t, 1, there);
            if (verdict != YK_WAY_OPEN) return verdict;
        }
        read_line(t, to, t->trial.x);
        if (!yk_chain_enclose(t, to, &t->trial, INFINITY) || is_in_tubes(t, to, &t->trial) != YK_WAY_PROVED) {
            memcpy(guess, t->now.x, t->unknowns * sizeof *guess);
            h *= 0.5;
            continue;
        }
        if (to == 1 && there) return YK_WAY_OPEN;
        t->stride = h * length;
        swap_poses(&t->now, &t->trial);
        if (to == 1) return YK_WAY_PROVED;
        guess = t->trial.x;
        at = to;
        h *= 1.3;
        read_line(t, fmin(at + 0.5 * h, 1), guess);
    }
    return YK_WAY_OPEN;
}

YkVerdict yk_chain_follow(YkChain *t, const YkChainPose *there)
{
    YkVec *guess = t->trial.x;
    if (!there || way_length(t) > 2 * t->stride) return follow(t, there);
    for (size_t k = 0; k < t->unknowns; k++) guess[k] = yk_scale(0.5, yk_add(t->now.x[k], there->x[k]));
    if (make_tubes(t, 0, 1, guess) && is_in_tubes(t, 0, &t->now) == YK_WAY_PROVED) {
        YkVerdict verdict = is_in_tubes(t, 1, there);
        if (verdict != YK_WAY_OPEN) return verdict;
    }
    t->stride = 0.5 * way_length(t);
    return follow(t, there);
}

// Reports what went wrong: which block, which joint, by how much.
#include <string.h>
#include "base/number.h"
#include "elementary/elementary.h"
#include "solve/assemble.h"
#include "solve/relations.h"
#include "solve/state.h"

// Returns the first block in the order of solution that does not close, or the one nearest to a dead point.
static int worst_block(const YkState *s, const YkSpace *space, YkStatus status)
{
    int worst = -1;
    double least = 2;
    for (size_t b = 0; b < s->mech->block_count; b++) {
        const YkBlock *block = &s->mech->blocks[b];
        if (block->kind == YK_BLOCK_LINK || block->kind == YK_BLOCK_CHECK) continue;
        double m = space->block_margin[b];
        if (status != YK_SINGULAR && !(m >= YK_LIMIT_MARGIN)) return (int)b;
        if (m < least) {
            least = m;
            worst = (int)b;
        }
    }
    return status == YK_SINGULAR ? worst : -1;
}

static int redundant_block(const YkState *s)
{
    for (size_t b = 0; b < s->mech->block_count; b++)
        if (s->mech->blocks[b].kind == YK_BLOCK_LINK || s->mech->blocks[b].kind == YK_BLOCK_CHECK) return (int)b;
    return -1;
}

// Returns the relation that repeats others and fits worst, and by how much, as a length; NULL if there is none.
static const YkRelation *redundant_relation(YkState *s, const YkSpace *space, double *worst)
{
    const YkRelation *relation = NULL;
    YkSpace view = *space;
    double miss;
    view.gap = &miss;
    YkRun run = yk_state_run(s, &view);
    *worst = 0;
    for (size_t k = 0; k < s->mech->step_count; k++) {
        const YkStep *step = &s->mech->steps[k];
        if (step->kind != YK_STEP_CHECK) continue;
        miss = 0;
        yk_run_relation_check(&run, (size_t)step->target);
        if (!(miss > *worst)) continue;
        *worst = miss;
        relation = &s->mech->relations[step->target];
    }
    return relation;
}

// Returns by how much the first angle that the relation ties is off, rad, or its distance, m.
static double own_miss(const YkMechanism *mech, const YkRelation *r, double miss, bool *is_angle)
{
    const YkRelationTerm *terms = mech->relation_terms + r->first_term, *own = terms;
    for (uint32_t k = 0; k < r->term_count; k++)
        if (terms[k].is_distance) own = &terms[k];
    *is_angle = r->term_count > 0 && !own->is_distance;
    return r->term_count > 0 ? miss / (yk_relation_weight(mech, r) * fabs(own->factor)) : miss;
}

static double length_at(const YkRun *run, const YkSum *sum, YkPlane scratch)
{
    yk_run_sum(run, sum, scratch);
    return yk_hypot(scratch.x[0], scratch.y[0]);
}

static YkVec line_of(const YkSpace *space, const YkBlock *b, int line)
{
    YkTurn turn = yk_space_turn(space, b->line_slot[line]);
    return turn.c ? yk_mul(yk_vec(turn.c[0], turn.s[0]), b->line[line]) : b->line[line];
}

// Returns how many metres a block's loop misses; for parallel lines that should meet, their distance.
static double gap_of(YkState *s, const YkSpace *space, int index)
{
    const YkBlock *b = &s->mech->blocks[index];
    YkRun run = yk_state_run(s, space);
    YkPlane K = yk_space_scratch(space, YK_SCRATCH_KNOWN), A = yk_space_scratch(space, YK_SCRATCH_ARM_1);
    if (b->kind == YK_BLOCK_GROUP) return yk_group_miss(&run, (size_t)index);
    if (b->kind > YK_BLOCK_PP) return space->gap[0];
    double k = length_at(&run, &b->known, K);
    if (b->kind == YK_BLOCK_PP) return fabs(yk_cross(yk_vec(K.x[0], K.y[0]), line_of(space, b, 0)));
    double U = length_at(&run, &b->aside->arm[0], A);
    YkVec arm = yk_vec(A.x[0], A.y[0]), e = line_of(space, b, 0);
    if (b->kind == YK_BLOCK_RRR) {
        double W = length_at(&run, &b->aside->arm[1], A);
        return k > U + W ? k - (U + W) : fmax(0, fabs(U - W) - k);
    }
    if (b->kind == YK_BLOCK_RRP) return fmax(0, fabs(yk_cross(yk_vec(K.x[0], K.y[0]), e)) - U);
    return fmax(0, fabs(yk_cross(arm, e)) - k);
}

// A sentence: head, the joint's label, middle, a number, tail. Written without allocation.
typedef struct Sentence {
    const char *head, *middle, *tail;
} Sentence;
static const Sentence no_assembly = {"the loop that joint `",
                                     "` closes cannot be assembled with these inputs: it misses by ", " m"};
static const Sentence past_limit = {"past a limit position: on this configuration the loop that joint `",
                                    "` closes misses by ", " m"};
static const Sentence dead_point = {"dead point at joint `", "`: the sine of its transmission angle is ",
                                    ", so velocities are not determined"};
static const Sentence past_group = {"past a limit position: the group that joint `",
                                    "` labels does not close near its last pose", NULL}; // no number
static const Sentence no_group = {
    "no way to close the group that joint `",
    "` labels was found from the guesses or from many other starts; there may still be one", NULL};
static const Sentence gave_up = {"gave up looking for an assembly at joint `",
                                 "`: there are too many combinations of branches to try them all; one may still close",
                                 NULL};
static const Sentence parallel_lines = {"the two lines that should meet at joint `",
                                        "` are parallel with these inputs, and apart by ", " m"};
static const Sentence same_line = {
    "the two lines that should meet at joint `",
    "` coincide with these inputs: the position along them is not determined, nor what depends on it", NULL};
static const Sentence same_point = {
    "the two points that the dyad of joint `",
    "` connects coincide with these inputs: its direction is not determined, nor what depends on it", NULL};
static const Sentence just_limit = {
    "at a limit position: the links that joint `",
    "` closes are in line with these inputs, and short of each other by no more than rounding", NULL};
static const Sentence undetermined = {
    "a coincidence at joint `",
    "`: lines or points coincide there, which leaves a position open; with the position taken, what depends on it "
    "does not close",
    NULL};
static const Sentence unfit = {"the constraint that joint `", "` repeats does not fit: its loop misses by ", " m"};

static const Sentence unmatched = {"`",
                                   "` repeats other gears, belts, racks, cams or laws and does not fit them: it "
                                   "misses by ",
                                   " m; check the phases that `start:` gives"};
static const char unmatched_angle[] = " rad; check the phases that `start:` gives";

static void append(char *message, size_t capacity, const char *part, size_t most)
{
    size_t at = strlen(message);
    for (size_t k = 0; part[k] && k < most && at + 1 < capacity; k++) message[at++] = part[k];
    message[at] = 0;
}

YkStatus yk_state_refuse(YkState *s, YkStatus status, const char *message)
{
    yk_state_tell(s, &s->spare, YK_OK);
    append(s->report.message, sizeof s->report.message, message, sizeof s->report.message);
    return s->report.status = status;
}

static void write_sentence(YkReport *r, const Sentence *sentence, const char *label, double value)
{
    char number[YK_NUMBER_SIZE];
    yk_number_write_digits(value, 3, number);
    r->message[0] = 0;
    const char *parts[] = {sentence->head, label, sentence->middle, number, sentence->tail};
    for (size_t k = 0; k < (sentence->tail ? 5 : 3); k++)
        append(r->message, sizeof r->message, parts[k], k == 1 ? 80 : sizeof r->message);
}

static void tell_block(YkState *s, const YkSpace *space, int index, const Sentence *sentence, double value)
{
    YkReport *r = &s->report;
    const YkBlock *block = &s->mech->blocks[index];
    r->block = index;
    if (block->aside->joint_count > 0)
        r->joint = s->mech->block_members[block->aside->first_joint + block->aside->joint_count / 2];
    r->determinant = sqrt(fmax(0, space->block_margin[index]));
    write_sentence(r, sentence, block->label, value);
}

static double rounding_of(const YkState *s)
{
    return 1e-12 * s->mech->size;
}

// Returns whether two lines coincide, or the points that a dyad connects: its loop then leaves a position open.
static bool is_open(YkState *s, const YkSpace *space, int index)
{
    const YkBlock *b = &s->mech->blocks[index];
    if (b->kind == YK_BLOCK_PP) return fabs(yk_cross(line_of(space, b, 0), line_of(space, b, 1))) <= 1e-7;
    if (b->kind != YK_BLOCK_RRR && b->kind != YK_BLOCK_RPR) return false;
    YkRun run = yk_state_run(s, space);
    return length_at(&run, &b->known, yk_space_scratch(space, YK_SCRATCH_KNOWN)) <= rounding_of(s);
}

// Returns what is true of a dyad that does not close though it misses by no more than rounding; NULL if it misses by
// more.
static const Sentence *coincidence(YkState *s, const YkSpace *space, int index, double gap)
{
    const YkBlock *b = &s->mech->blocks[index];
    if (b->kind > YK_BLOCK_PP) return NULL;
    if (gap > rounding_of(s)) return b->kind == YK_BLOCK_PP ? &parallel_lines : NULL;
    if (!is_open(s, space, index)) return &just_limit;
    return b->kind == YK_BLOCK_PP ? &same_line : &same_point;
}

// Returns a block before the one that does not close whose loop leaves a position open, or -1.
static int open_before(YkState *s, const YkSpace *space, int block)
{
    for (int b = 0; b < block; b++)
        if (!(space->block_margin[b] > YK_SINGULAR_MARGIN) && is_open(s, space, b)) return b;
    return -1;
}

static const Sentence *sentence_of(YkState *s, const YkSpace *space, YkStatus status, int *block)
{
    const YkBlock *b = &s->mech->blocks[*block];
    if (status == YK_SINGULAR) return &dead_point;
    int before = open_before(s, space, *block);
    if (before >= 0) {
        *block = before;
        return &undetermined;
    }
    if (b->kind == YK_BLOCK_GROUP) return status == YK_LIMIT ? &past_group : &no_group;
    const Sentence *special = coincidence(s, space, *block, gap_of(s, space, *block));
    return special ? special : status == YK_LIMIT ? &past_limit : &no_assembly;
}

static void explain_unfit(YkState *s, const YkSpace *space, YkStatus status)
{
    YkReport *r = &s->report;
    int b = status == YK_NO_ASSEMBLY ? redundant_block(s) : -1;
    int before = status == YK_NO_ASSEMBLY ? open_before(s, space, (int)s->mech->block_count) : -1;
    double miss = 0;
    if (before >= 0) {
        tell_block(s, space, before, &undetermined, 0);
        return;
    }
    const YkRelation *relation = b < 0 && status == YK_NO_ASSEMBLY ? redundant_relation(s, space, &miss) : NULL;
    if (relation) {
        bool is_angle;
        Sentence sentence = unmatched;
        r->gap = miss;
        miss = own_miss(s->mech, relation, miss, &is_angle);
        if (is_angle) sentence.tail = unmatched_angle;
        write_sentence(r, &sentence, relation->name, miss);
    } else if (b < 0) {
        append(r->message, sizeof r->message, "the machine cannot be assembled with these inputs", sizeof r->message);
    } else {
        r->gap = space->gap[0];
        tell_block(s, space, b, &unfit, r->gap);
    }
}

void yk_state_explain(YkState *s, const YkSpace *space, YkStatus status)
{
    YkReport *r = &s->report;
    int b = status == YK_NOT_CONVERGED ? s->search->gave_up_at : worst_block(s, space, status);
    if (b < 0) {
        explain_unfit(s, space, status);
        return;
    }
    const Sentence *sentence = status == YK_NOT_CONVERGED
                                   ? (s->mech->blocks[b].kind == YK_BLOCK_GROUP ? &no_group : &gave_up)
                                   : sentence_of(s, space, status, &b);
    r->gap = status == YK_SINGULAR || sentence == &undetermined || status == YK_NOT_CONVERGED ? 0 : gap_of(s, space, b);
    tell_block(s, space, b, sentence, status == YK_SINGULAR ? sqrt(fmax(0, space->block_margin[b])) : r->gap);
}

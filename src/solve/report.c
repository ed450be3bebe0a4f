// What went wrong: which block, which joint, by how much.
#include <string.h>
#include "base/number.h"
#include "solve/relations.h"
#include "solve/state.h"

// The first block in the order of solution that does not close, or the one nearest to a dead point.
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

// The relation that repeats others and fits worst, and by how much; NULL where there is none.
static const char *redundant_relation(YkState *s, const YkSpace *space, double *worst)
{
    const char *name = NULL;
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
        name = s->mech->relations[step->target].name;
    }
    return name;
}

static double length_at(const YkRun *run, const YkSum *sum, YkPlane scratch)
{
    yk_run_sum(run, sum, scratch);
    return hypot(scratch.x[0], scratch.y[0]);
}

// By how many metres a dyad's loop misses.
static double gap_of(YkState *s, YkSpace *space, int index)
{
    const YkBlock *b = &s->mech->blocks[index];
    YkRun run = yk_state_run(s, space);
    YkPlane K = yk_space_scratch(space, YK_SCRATCH_KNOWN), A = yk_space_scratch(space, YK_SCRATCH_ARM_1);
    if (b->kind > YK_BLOCK_RPR) return space->gap[0];
    double U = length_at(&run, &b->arm[0], A);
    YkVec arm = yk_vec(A.x[0], A.y[0]);
    if (b->kind == YK_BLOCK_RRR) {
        double W = length_at(&run, &b->arm[1], A), k = length_at(&run, &b->known, K);
        return k > U + W ? k - (U + W) : fmax(0, fabs(U - W) - k);
    }
    double k = length_at(&run, &b->known, K);
    YkTurn line = yk_space_turn(space, b->line_slot[0]);
    YkVec e = line.c ? yk_mul(yk_vec(line.c[0], line.s[0]), b->line[0]) : b->line[0];
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
static const Sentence unfit = {"the constraint that joint `", "` repeats does not fit: its loop misses by ", " m"};

static const Sentence unmatched = {"`",
                                   "` repeats other gears, belts, racks, cams or laws and does not fit them: it "
                                   "misses by ",
                                   " m; mind the phases that `start:` gives"};

static void append(char *message, size_t capacity, const char *part, size_t most)
{
    size_t at = strlen(message);
    for (size_t k = 0; part[k] && k < most && at + 1 < capacity; k++) message[at++] = part[k];
    message[at] = 0;
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

void yk_state_explain(YkState *s, const YkSpace *space, YkStatus status)
{
    YkReport *r = &s->report;
    YkSpace view = *space;
    const Sentence *sentence = status == YK_LIMIT ? &past_limit : status == YK_SINGULAR ? &dead_point : &no_assembly;
    int b = worst_block(s, space, status);
    if (b < 0 && status == YK_NO_ASSEMBLY) {
        b = redundant_block(s);
        sentence = &unfit;
    }
    double miss = 0;
    const char *relation = b < 0 && status == YK_NO_ASSEMBLY ? redundant_relation(s, space, &miss) : NULL;
    if (relation) {
        r->gap = miss;
        write_sentence(r, &unmatched, relation, miss);
        return;
    }
    if (b < 0) {
        append(r->message, sizeof r->message, "the machine cannot be assembled with these inputs", sizeof r->message);
        return;
    }
    const YkBlock *block = &s->mech->blocks[b];
    if (block->kind == YK_BLOCK_GROUP && status == YK_LIMIT) sentence = &past_group;
    r->block = b;
    if (block->joint_count > 0) r->joint = s->mech->block_members[block->first_joint + block->joint_count / 2];
    r->determinant = sqrt(fmax(0, space->block_margin[b]));
    r->gap = status == YK_SINGULAR ? 0 : gap_of(s, &view, b);
    write_sentence(r, sentence, block->label, status == YK_SINGULAR ? r->determinant : r->gap);
}

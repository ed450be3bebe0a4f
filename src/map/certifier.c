// Proves that a motion, pose after pose, follows one configuration.
#include <yoke/certificate.h>
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "base/text.h"
#include "map/chain.h"

enum { CHORDS_MAX = 64 };               // of a step
static const double NEAR = 1e-7;        // how far a pose may be from the solution that it stands for
static const double CHORD_MOST = 0.002; // how far the inputs may be from a chord: rad, or lengths over the size

// A pose of the motion.
typedef struct Place {
    double *input, *rate; // [input]
    double time;
    YkChainPose pose;
    bool stands; // the pose is enclosed
} Place;

struct YkCertifier {
    YkWitness witness; // first
    YkChain chain;
    double *memory;
    Place last, aside, here; // the last step, the last pose behind it, and the one that is reported
    bool is_aside;
    YkMotionCertificate found, *kept;
    size_t kept_count;
    bool has_failed;           // out of memory
    YkArena *names;            // of what is found: a simulation frees the machines that it leaves
    const char *outside_joint; // because of which nothing can be proved
};

static bool is_outside(const YkCertifier *c)
{
    return c->has_failed || c->chain.outside;
}

static bool is_idle(const YkCertifier *c)
{
    return is_outside(c) || c->chain.piece_count == 0;
}

// --- places

static void swap_places(Place *a, Place *b)
{
    Place other = *a;
    *a = *b;
    *b = other;
}

static void read_place(const YkCertifier *c, const YkState *s, Place *place)
{
    for (size_t i = 0; i < c->chain.mech->input_count; i++) {
        place->input[i] = s->valid_input[3 * i];
        place->rate[i] = s->valid_input[3 * i + 1];
    }
    place->time = s->time;
    yk_chain_read(&c->chain, s, &place->pose);
}

// Returns an input at a part of the way between two places: on the cubic that has their positions and rates.
static double input_at(const Place *a, const Place *b, size_t i, double part)
{
    double rest = 1 - part, time = b->time - a->time, way = b->input[i] - a->input[i];
    double bend = rest * (a->rate[i] * time - way) - part * (b->rate[i] * time - way);
    return a->input[i] + part * way + part * rest * bend;
}

// Returns how many chords it takes from place to place. A single input goes to and fro on a line, whatever its rates.
static size_t count_chords(const YkCertifier *c, const Place *a, const Place *b)
{
    size_t inputs = c->chain.mech->input_count;
    double most = 0;
    for (size_t i = 0; i < inputs && inputs > 1 && a->time != b->time; i++)
        for (int k = 1; k < 4; k++) {
            double straight = a->input[i] + 0.25 * k * (b->input[i] - a->input[i]);
            most = fmax(most, fabs(input_at(a, b, i, 0.25 * k) - straight) / yk_input_unit(c->chain.mech, i));
        }
    double chords = ceil(sqrt(most / CHORD_MOST));
    return chords > 1 ? (chords < CHORDS_MAX ? (size_t)chords : CHORDS_MAX) : 1;
}

// Lays the way along a chord. Returns whether anything moves there.
static bool set_way(YkCertifier *c, const Place *a, const Place *b, size_t chord, size_t count)
{
    bool moves = false;
    double from = (double)chord / (double)count, to = (double)(chord + 1) / (double)count;
    for (size_t i = 0; i < c->chain.mech->input_count; i++) {
        c->chain.from[i] = chord > 0 ? input_at(a, b, i, from) : a->input[i];
        double end = chord + 1 < count ? input_at(a, b, i, to) : b->input[i];
        c->chain.way[i] = end - c->chain.from[i];
        moves |= c->chain.way[i] != 0;
    }
    return moves;
}

// --- what is found

// Returns the certifier's own copy of a name; "" for NULL.
static const char *copy_of(YkCertifier *c, const char *name)
{
    const char *copy = name ? yk_arena_copy(c->names, name, strlen(name)) : "";
    c->has_failed |= !copy;
    return copy ? copy : "";
}

static const char *joint_of(const YkChain *chain)
{
    return chain->mech->blocks[chain->pieces[chain->level].block].label;
}

// Notes the first step that is not proved.
static void note_gap(YkCertifier *c, const Place *a, const Place *b, const char *why, const char *joint)
{
    size_t most = 0;
    const YkMechanism *mech = c->chain.mech;
    YkMotionCertificate *found = &c->found;
    double longest = -1;
    if (found->why[0]) return;
    found->why = why;
    found->joint = copy_of(c, joint);
    found->from_time = a->time;
    found->to_time = b->time;
    for (size_t i = 0; i < mech->input_count; i++) {
        double way = fabs(b->input[i] - a->input[i]) / yk_input_unit(mech, i);
        if (!(way > longest)) continue;
        longest = way;
        most = i;
    }
    if (mech->input_count == 0) return;
    found->input = (int)most;
    found->coordinate = copy_of(c, mech->coordinates[mech->inputs[most]].name);
    found->from = a->input[most];
    found->to = b->input[most];
}

static void note_outside(const YkCertifier *c, YkMotionCertificate *found)
{
    found->why = c->has_failed ? "out of memory" : c->chain.outside;
    found->joint = c->outside_joint;
}

static const char *const no_start = "no interval encloses the pose from which the step starts",
                         *const no_end =
                             "no interval encloses the pose to which the step leads: two solutions are too near "
                             "each other there",
                         *const no_way =
                             "no chain of intervals leads from one pose to the other: two solutions come too near "
                             "each other on the way",
                         *const other_end = "the configuration that the step follows leads to another pose",
                         *const not_same = "the same inputs have a pose that is not proved to be the same";

// --- from place to place

// Proves the way from a place to `here`. Returns why it is not proved, or NULL.
static const char *prove(YkCertifier *c, const Place *from, YkVerdict *verdict)
{
    YkChain *t = &c->chain;
    Place *here = &c->here;
    size_t count = count_chords(c, from, here);
    *verdict = YK_WAY_OPEN;
    bool moves = set_way(c, from, here, count - 1, count);
    here->stands = yk_chain_enclose(t, 1, &here->pose, NEAR);
    if (!from->stands) return no_start;
    if (!here->stands) return no_end;
    if (count == 1 && !moves) {
        bool is_same = yk_chain_is_same(t, &from->pose, &here->pose, 0);
        bool is_other = !is_same && yk_chain_is_other(t, &from->pose, &here->pose);
        *verdict = is_same ? YK_WAY_PROVED : is_other ? YK_WAY_REFUTED : YK_WAY_OPEN;
        return is_same ? NULL : is_other ? other_end : not_same;
    }
    yk_chain_copy(t, &t->now, &from->pose);
    for (size_t k = 0; k < count; k++) {
        if (!set_way(c, from, here, k, count) && k + 1 < count) continue;
        *verdict = yk_chain_follow(t, k + 1 < count ? NULL : &here->pose);
        if (*verdict != YK_WAY_PROVED) return *verdict == YK_WAY_REFUTED ? other_end : no_way;
    }
    return NULL;
}

// Returns whether nothing has moved since a place, and its pose is still the same.
static bool is_at(const YkCertifier *c, const Place *place)
{
    for (size_t i = 0; i < c->chain.mech->input_count; i++)
        if (c->here.input[i] != place->input[i]) return false;
    return place->stands && yk_chain_is_same(&c->chain, &place->pose, &c->here.pose, 0);
}

static bool step(YkWitness *witness, const YkState *s, YkWitnessed kind)
{
    YkCertifier *c = (YkCertifier *)witness;
    YkVerdict verdict;
    if (is_outside(c)) {
        c->found.steps++;
        if (!c->found.why[0]) note_outside(c, &c->found);
    }
    if (is_idle(c)) return true;
    Place *from = kind == YK_WITNESS_ASIDE && c->is_aside ? &c->aside : &c->last;
    read_place(c, s, &c->here);
    if (is_at(c, from)) {
        if (kind != YK_WITNESS_ASIDE) c->is_aside = false;
        return true;
    }
    const char *why = prove(c, from, &verdict);
    if (verdict == YK_WAY_REFUTED && kind == YK_WITNESS_TRY) return false;
    c->found.steps++;
    c->found.proved += !why;
    c->found.is_refuted |= verdict == YK_WAY_REFUTED;
    if (why) note_gap(c, from, &c->here, why, why == no_start ? NULL : joint_of(&c->chain));
    c->is_aside = kind == YK_WITNESS_ASIDE;
    swap_places(c->is_aside ? &c->aside : &c->last, &c->here);
    return verdict != YK_WAY_REFUTED;
}

static void begin(YkWitness *witness, const YkState *s)
{
    YkCertifier *c = (YkCertifier *)witness;
    c->last.stands = c->is_aside = false;
    if (is_idle(c) || !s->has_pose) return;
    read_place(c, s, &c->last);
    set_way(c, &c->last, &c->last, 0, 1);
    c->last.stands = yk_chain_enclose(&c->chain, 0, &c->last.pose, NEAR);
}

// --- what comes between

static bool make_chain(YkCertifier *c, const YkMechanism *mech)
{
    yk_chain_end(&c->chain);
    free(c->memory);
    c->memory = NULL;
    c->last.stands = c->is_aside = false;
    if (!yk_chain_start(&c->chain, mech)) return false;
    size_t block = c->chain.outside_block;
    c->outside_joint = copy_of(c, block != YK_NOT_FOUND ? mech->blocks[block].label : NULL);
    size_t inputs = mech->input_count, pose = yk_chain_pose_size(&c->chain);
    double *next = c->memory = calloc(3 * (2 * inputs + pose) + 1, sizeof *next);
    if (!next) return false;
    Place *places[] = {&c->last, &c->aside, &c->here};
    for (size_t k = 0; k < 3; k++, next += 2 * inputs + pose)
        *places[k] =
            (Place){.input = next, .rate = next + inputs, .pose = yk_chain_pose_in(&c->chain, next + 2 * inputs)};
    return true;
}

// Returns how far the unknowns of a group may be apart in two states of one model; INFINITY if that is not known.
static double gap_between(const YkState *from, const YkState *to)
{
    const YkMechanism *mech = from->mech;
    double most = 0;
    if (to->mech->coordinate_count != mech->coordinate_count) return INFINITY;
    for (size_t k = 0; k < mech->coordinate_count; k++) {
        double off = yk_state_coordinate(from, k).position - yk_state_coordinate(to, k).position;
        most = fmax(most, fabs(mech->coordinates[k].is_distance ? off / mech->size : yk_nearest_turn(off, 0)));
        if (isnan(off)) return INFINITY;
    }
    return most * (double)(mech->coordinate_count +
                           1); // they are angles between bodies, and so sums of coordinates, or distances
}

// Returns whether the last place stands for the pose of a state of this mechanism and for all within `off` of it.
static bool stands_for(YkCertifier *c, const YkState *s, double off)
{
    read_place(c, s, &c->here);
    return is_at(c, &c->last) && yk_chain_is_same(&c->chain, &c->last.pose, &c->last.pose, off);
}

static void note_change(YkCertifier *c)
{
    c->found.steps++;
    note_gap(c, &c->last, &c->here, "other inputs have a pose that is not proved to be the same", NULL);
}

static void change(YkWitness *witness, const YkState *from, const YkState *to)
{
    YkCertifier *c = (YkCertifier *)witness;
    if (c->has_failed || !to) {
        c->last.stands = false;
        return;
    }
    bool goes_on = from && from->has_pose && from->mech == c->chain.mech && !is_outside(c);
    bool was_closed = goes_on && c->chain.piece_count == 0; // all in closed form: only the new groups decide
    double off = goes_on ? gap_between(from, to) : 0;
    if (goes_on && !was_closed && c->last.stands && !stands_for(c, from, off)) note_change(c);
    if (!make_chain(c, to->mech)) c->has_failed = true;
    begin(witness, to);
    if (was_closed && c->last.stands && !stands_for(c, to, off)) note_change(c);
}

static void keep(YkWitness *witness, size_t number)
{
    YkCertifier *c = (YkCertifier *)witness;
    if (number >= c->kept_count) {
        size_t count = 2 * number + 4;
        YkMotionCertificate *kept = realloc(c->kept, count * sizeof *kept);
        c->has_failed |= !kept;
        if (!kept) return;
        c->kept = kept;
        c->kept_count = count;
    }
    c->kept[number] = c->found;
}

static void recall(YkWitness *witness, size_t number)
{
    YkCertifier *c = (YkCertifier *)witness;
    if (!c->has_failed) c->found = c->kept[number];
}

// --- the door

YkCertifier *yk_certifier_new(const YkMechanism *mech)
{
    YkCertifier *c = calloc(1, sizeof *c);
    if (!c) return NULL;
    c->witness = (YkWitness){begin, step, change, keep, recall};
    c->found = (YkMotionCertificate){.input = -1, .why = "", .joint = "", .coordinate = ""};
    c->names = yk_arena_new();
    if (c->names && make_chain(c, mech) && !c->has_failed) return c;
    yk_certifier_free(c);
    return NULL;
}

void yk_certifier_free(YkCertifier *c)
{
    if (!c) return;
    yk_chain_end(&c->chain);
    yk_arena_free(c->names);
    free(c->memory);
    free(c->kept);
    free(c);
}

YkStatus yk_state_set_certifier(YkState *state, YkCertifier *certifier)
{
    if (certifier && certifier->chain.mech != state->mech) return YK_BAD_ARGUMENT;
    state->witness = certifier ? &certifier->witness : NULL;
    return YK_OK;
}

static void word_message(const YkMotionCertificate *found, YkText *text)
{
    if (!found->is_needed)
        yk_text_puts(text, "certified: no group, all in closed form");
    else if (found->is_certified)
        yk_text_puts(text, "certified: proved to stay on one configuration");
    else if (found->is_refuted)
        yk_text_puts(text, "refuted: the motion is proved to have gone over to another configuration");
    else
        yk_text_format(text, "not certified: %z of %z steps are not proved to stay on one configuration",
                       found->steps - found->proved, found->steps);
}

YkMotionCertificate yk_certifier_report(const YkCertifier *c)
{
    YkMotionCertificate found = c->found;
    YkText text = {0};
    found.has_run_out = c->has_failed;
    found.is_needed = is_outside(c) || c->chain.piece_count > 0 || found.steps > 0;
    found.is_certified = !is_outside(c) && found.steps == found.proved;
    if (is_outside(c) && !found.why[0]) note_outside(c, &found);
    if (is_outside(c))
        yk_text_format(&text, "not certified: %s", found.why);
    else
        word_message(&found, &text);
    found.has_run_out |= text.failed;
    yk_text_move(&text, found.message, sizeof found.message);
    return found;
}

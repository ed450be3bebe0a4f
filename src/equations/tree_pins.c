// Forward dynamics of open trees of pins.
#include "equations/tree_pins.h"
#include "equations/short_chain.h"
#include "equations/tree_noise.h"

typedef struct Link {     // constant
    YkVec at;             // its pin on the parent, in the parent's axes, relative to the parent's pin
    YkVec moment;         // mass * centre
    double mass, inertia; // about the pin
} Link;

// Kept by the inward pass for the outward one: how the parent's pin (a) and the parent's rotation (alpha) move this
// link.
typedef struct Answer {
    YkVec bias, across; // its pin: a + bias + alpha across
    double by, turn;    // its rotation: by - on . a - turn alpha
    YkVec on;
} Answer;

typedef struct Fork { // a link with a child that does not come right after it
    YkArticulated sum;
    YkInertia noise;
    YkVec a;
    double alpha;
} Fork;

typedef struct ChainPart { // a link of a short chain, constant, in its own axes: see short_chain.h
    YkVec moment, end;
    double behind;
} ChainPart;

struct YkTreePins {
    YkTreeAngles angles;
    ChainPart chain[YK_CHAIN_MOST];
    bool is_chain;  // two or three links, each on the one before
    Link *link;     // [link]
    Answer *answer; // [link]
    Fork *fork;     // [fork]
    YkVec gravity;
};

static void find_chain(YkTreePins *pins)
{
    size_t links = pins->angles.count - 1;
    double mass_out = 0;
    pins->is_chain = links > 1 && links <= YK_CHAIN_MOST;
    for (size_t k = links; pins->is_chain && k > 0; k--) {
        ChainPart *own = &pins->chain[k - 1];
        *own = (ChainPart){.moment = pins->link[k].moment, .behind = pins->link[k].inertia};
        pins->is_chain = pins->angles.turn[k].parent == (int32_t)k - 1;
        if (k < links) {
            own->end = pins->link[k + 1].at;
            own->moment = yk_add(own->moment, yk_scale(mass_out, own->end));
            own->behind += mass_out * yk_dot(own->end, own->end);
        }
        mass_out += pins->link[k].mass;
    }
}

YkTreePins *yk_tree_pins_new(const YkTreeLinks *links, YkVec gravity, YkArena *arena)
{
    size_t n = links->count;
    YkTreePins *pins = YK_NEW(arena, YkTreePins, 1);
    if (!pins || !yk_tree_angles_start(&pins->angles, links, arena)) return NULL;
    pins->gravity = gravity;
    pins->link = YK_NEW(arena, Link, n);
    pins->answer = YK_NEW(arena, Answer, n);
    pins->fork = YK_NEW(arena, Fork, pins->angles.fork_count);
    if (yk_arena_failed(arena)) return NULL;
    for (size_t k = 0; k < n; k++) {
        const YkTreeLink *l = &links->link[k];
        pins->link[k] = (Link){.at = l->at,
                               .moment = yk_scale(l->mass, l->center),
                               .mass = l->mass,
                               .inertia = l->inertia + l->mass * yk_dot(l->center, l->center)};
    }
    find_chain(pins);
    return pins;
}

// Visits children before parents: releases each pin and passes the rest to the parent. A child that comes right after
// its parent passes it on in registers.
static int inward(const YkTreePins *pins, const double *effort)
{
    const YkTreeAngles angles = pins->angles;
    const double *c = angles.c, *s = angles.s, *w = angles.w;
    const YkArticulated nothing = {0};
    const YkInertia none = {0};
    YkArticulated A = nothing;
    YkInertia noise = none;
    for (size_t k = angles.count - 1; k > 0; k--) {
        const Link *link = &pins->link[k];
        YkLinkTurn t = angles.turn[k];
        size_t p = (size_t)t.parent;
        double torque = effort ? (double)t.sense * effort[t.input] : 0;
        if (t.fork != YK_NONE) {
            yk_articulated_add(&A, &pins->fork[t.fork].sum);
            yk_inertia_add(&noise, &pins->fork[t.fork].noise);
        }
        yk_articulated_add_body(&A, link->mass, yk_mul(yk_vec(c[k], s[k]), link->moment), link->inertia, w[k]);
        yk_noise_add_body(&noise, link->mass, link->inertia);
        if (!(A.of.J > YK_LEAST_OVER_NOISE * noise.J)) return t.input;
        double trace = yk_inertia_trace(&A.of);
        YkAnswer answer = yk_articulated_release_turn(&A, torque);
        if (p == 0) { // the ground needs nothing
            pins->answer[k] = (Answer){.by = answer.by, .on = answer.on};
            A = nothing;
            noise = none;
            continue;
        }
        YkVec arm = yk_mul(yk_vec(c[p], s[p]), link->at), bias = yk_scale(-w[p] * w[p], arm);
        YkVec across = yk_quarter(arm);
        double by = answer.by - yk_dot(answer.on, bias);
        pins->answer[k] = (Answer){bias, across, by, yk_dot(answer.on, across), answer.on};
        yk_noise_release_turn(&noise, answer.on, trace);
        noise = yk_noise_move_force(&noise, across, yk_inertia_trace(&A.of));
        A = yk_articulated_move_force(&A, arm, bias);
        if (p != k - 1) {
            yk_articulated_add(&pins->fork[angles.turn[p].fork].sum, &A);
            yk_inertia_add(&pins->fork[angles.turn[p].fork].noise, &noise);
            A = nothing;
            noise = none;
        }
    }
    return -1;
}

// Visits parents before children. The ground accelerates against gravity, which thus acts on every mass.
static void outward(const YkTreePins *pins, double *out)
{
    const YkLinkTurn *turn = pins->angles.turn;
    YkVec a = yk_scale(-1, pins->gravity); // of the pin of the previous link
    double alpha = 0;
    if (turn[0].fork != YK_NONE) pins->fork[turn[0].fork].a = a;
    for (size_t k = 1; k < pins->angles.count; k++) {
        const Answer *answer = &pins->answer[k];
        YkLinkTurn t = turn[k];
        if (t.parent != (int32_t)k - 1) {
            const Fork *fork = &pins->fork[turn[t.parent].fork];
            a = fork->a;
            alpha = fork->alpha;
        }
        double own = (answer->by - yk_dot(answer->on, a)) - answer->turn * alpha;
        a = yk_add(yk_add(a, answer->bias), yk_scale(alpha, answer->across));
        out[t.input] = (double)t.sense * (own - alpha);
        alpha = own;
        if (t.fork != YK_NONE) {
            pins->fork[t.fork].a = a;
            pins->fork[t.fork].alpha = alpha;
        }
    }
}

// Places a link of a short chain, on which `torque` acts at its pin and `next` at the pin of the next one.
YK_INLINE ChainLink place_part(const YkTreePins *pins, size_t k, double torque, double next)
{
    const ChainPart *own = &pins->chain[k];
    YkVec e = yk_vec(pins->angles.c[k + 1], pins->angles.s[k + 1]);
    double w = pins->angles.w[k + 1];
    ChainLink link = {.moment = yk_mul(e, own->moment), .square = w * w, .behind = own->behind};
    link.end = yk_mul(e, own->end);
    link.effort = torque - next + yk_cross(link.moment, pins->gravity);
    return link;
}

YK_INLINE int accelerate_chain(const YkTreePins *pins, const double *effort, double *out, size_t links)
{
    const YkLinkTurn *turn = pins->angles.turn + 1;
    ChainLink link[YK_CHAIN_MOST];
    double next = 0;
#pragma GCC unroll 4
    for (size_t k = links; k-- > 0;) {
        double torque = effort ? (double)turn[k].sense * effort[turn[k].input] : 0;
        link[k] = place_part(pins, k, torque, next);
        next = torque;
    }
#pragma GCC unroll 4
    for (size_t k = 1; k < links; k++) link[k].couple = chain_couple_of(link[k - 1].end, link[k].moment);
    chain_couple(link, links);
    if (!(links == 2 && chain_solve_two(&link[0], &link[1])) && !chain_solve(link, links)) {
        size_t k = links - 1;
        while (k > 0 && chain_resists(link, k)) k--;
        return turn[k].input;
    }
#pragma GCC unroll 4
    for (size_t k = 0; k < links; k++)
        out[turn[k].input] = (double)turn[k].sense * (k > 0 ? link[k].alpha - link[k - 1].alpha : link[k].alpha);
    return -1;
}

int yk_tree_pins_accelerate(YkTreePins *pins, const double *q, const double *v, const double *effort, double *a)
{
    yk_tree_angles_find(&pins->angles, q, v);
    if (pins->is_chain && pins->angles.count == 3) return accelerate_chain(pins, effort, a, 2);
    if (pins->is_chain) return accelerate_chain(pins, effort, a, 3);
    for (size_t k = 0; k < pins->angles.fork_count; k++) pins->fork[k] = (Fork){0};
    int culprit = inward(pins, effort);
    if (culprit < 0) outward(pins, a);
    return culprit;
}

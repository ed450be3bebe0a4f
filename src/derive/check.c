// The verdict on an equation: identity, proof on the loops, many poses.
#include "derive/check.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "derive/blocks.h"
#include "derive/frame.h"
#include "derive/free_bodies.h"
#include "derive/relations.h"
#include "derive/gears.h"

enum { FIELD_POINTS = 4, POSES = 24, POSES_MIN = 8, TRIES = 100, STEPS = 96 };
static const double EQUAL = 1e-9;

typedef struct Check {
    YkDerivation *d;
    YkState *state, *start;
    double start_margin;
    YkDynamics *dynamics;
    const YkEquation *equation;
    const YkForm *difference;
    const char *text;
    double *values;
    uint64_t seed;
} Check;

static double uniform(Check *check, double low, double high) // splitmix64 (Steele et al. 2014)
{
    uint64_t z = (check->seed += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return low + (high - low) * (double)((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

// --- Over the prime field

typedef enum Proof { PROVED, REFUTED, NO_PROOF } Proof;

// Has it an e^(i angle) in it?
static bool has_turns(YkRing *ring, const YkForm *form)
{
    const YkPoisson *a = yk_form_element(form), *one = yk_ring_rational(ring, 1, 1);
    for (size_t k = 0; !a && k < yk_form_part_count(form); k++)
        if (has_turns(ring, yk_form_part(form, k))) return true;
    for (size_t s = 0; a && s < yk_ring_symbol_count(ring); s++) {
        if (!yk_ring_is_angle(ring, (int32_t)s) || !yk_ring_mentions(ring, a, (int32_t)s)) continue;
        const YkRingChange change = {(int32_t)s, NULL, one};
        if (!yk_ring_is_same(a, yk_ring_substitute(ring, a, &change, 1))) return true;
    }
    return false;
}

// Gears bind angles at the points of the field, but not their unit vectors: what speaks of rates alone is refuted
// there.
static bool can_refute(Check *check, const YkForm *form)
{
    const YkDerivation *d = check->d;
    return d->tie_count == 0 || (d->loop_count == 0 && !has_turns(d->ring, form));
}

static Proof prove(Check *check, const YkForm *form)
{
    int points = 0;
    const YkDeriveForces *forces = yk_derive_forces(check->d);
    bool has_roots = forces && forces->length_count > 0; // then only some seeds lead to a point
    for (uint64_t seed = 1; points < FIELD_POINTS && seed < (has_roots ? 40u : 4u) * FIELD_POINTS; seed++) {
        bool is_possible;
        uint64_t value;
        YkFieldPoint *point = yk_derive_loop_point(check->d, seed * 7919, &is_possible);
        if (!point && !has_roots) return NO_PROOF;
        if (!point) continue;
        bool has_value = yk_form_field(check->d->ring, form, point, &value);
        yk_field_point_free(point);
        if (!has_value) continue; // a division by zero
        if (value != 0) return can_refute(check, form) ? REFUTED : NO_PROOF;
        points++;
    }
    return points == FIELD_POINTS ? PROVED : NO_PROOF;
}

static bool is_identity(Check *check)
{
    return yk_form_compare(check->d->ring, check->equation->left, check->equation->right, FIELD_POINTS, 17) ==
           YK_FORM_EQUAL;
}

// --- At poses

static bool solve_pose(Check *check)
{
    YkStatus status = check->dynamics ? yk_dynamics_solve(check->dynamics, check->state, YK_METHOD_REDUCED)
                                      : yk_state_solve(check->state);
    return status >= 0 && yk_state_has_rates(check->state);
}

// The smallest transmission angle of the dyads: at 0 two configurations meet.
static double margin(const Check *check)
{
    const YkMechanism *mech = check->d->mech;
    double least = YK_PI;
    for (size_t b = 0; b < mech->block_count; b++)
        if (mech->blocks[b].kind <= YK_BLOCK_RPR) least = fmin(least, yk_state_transmission(check->state, b));
    return least;
}

static void go(Check *check, const YkMotion *target, double part)
{
    for (size_t i = 0; i < check->d->mech->input_count; i++) {
        YkMotion motion = target[i], from = yk_state_input(check->start, i);
        motion.position = from.position + part * (motion.position - from.position);
        yk_state_set_input(check->state, i, motion);
    }
}

static YkMotion random_input(Check *check, size_t input)
{
    const YkDerivation *d = check->d;
    int32_t c = d->mech->inputs[input];
    bool is_distance = d->coordinates[c].is_distance;
    YkMotion from = yk_state_input(check->start, input);
    if (d->coordinates[c].is_held) return (YkMotion){.position = from.position};
    double size = is_distance ? d->mech->size : 1, reach = is_distance ? 0.5 * fabs(from.position) + 0.1 * size : YK_PI;
    return (YkMotion){from.position + uniform(check, -reach, reach), size * uniform(check, 0.3, 2),
                      size * uniform(check, -2, 2)};
}

// From the start towards random inputs in small steps, and no further than to where another configuration comes near:
// with special dimensions (a parallelogram) what holds in one does not hold in the other.
static bool move_to_random_pose(Check *check, YkMotion *target)
{
    const YkMechanism *mech = check->d->mech;
    double reached = 0, least = fmin(0.1, 0.5 * check->start_margin);
    for (size_t i = 0; i < mech->input_count; i++) target[i] = random_input(check, i);
    yk_state_copy(check->state, check->start);
    for (int step = 1; step <= STEPS; step++) {
        go(check, target, (double)step / STEPS);
        if (yk_state_solve(check->state) < 0 || margin(check) < least) break;
        reached = (double)step / STEPS;
    }
    go(check, target, reached);
    return solve_pose(check);
}

static void fill_values(Check *check)
{
    yk_derive_values(check->d, check->state, check->dynamics, check->values);
}

static double distance_of(Check *check)
{
    YkVec difference = yk_form_value(check->d->ring, check->difference, check->values);
    return yk_norm(difference);
}

// How far apart the sides are when the coordinates are *not* on the machine: the measure for "equal".
static double distance_at_random(Check *check)
{
    const YkDerivation *d = check->d;
    for (size_t k = 0; k < d->coordinate_count; k++) {
        const YkDeriveCoordinate *c = &d->coordinates[k];
        double size = c->is_distance ? d->mech->size : 1;
        check->values[c->position] += size * uniform(check, 0.2, 1);
        check->values[c->rate] += size * uniform(check, 0.2, 1);
        check->values[c->acceleration] += size * uniform(check, 0.2, 1);
    }
    for (size_t k = 0; k < d->tie_count; k++) // laws: in a dwell their slopes are no more than rounding
        for (int32_t order = 0; d->ties[k].function >= 0 && order < YK_TIE_ORDERS; order++)
            check->values[d->ties[k].function + order] += d->mech->size * uniform(check, 0.2, 1);
    for (size_t b = 0; b < d->model->body_count; b++)
        if (d->bodies[b].angle >= 0) check->values[d->bodies[b].angle] += uniform(check, 0.2, 1);
    yk_ring_complete(d->ring, check->values);
    return distance_of(check);
}

static void note_sides(Check *check, YkCheckVerdict *verdict)
{
    fill_values(check);
    verdict->left = yk_form_value(check->d->ring, check->equation->left, check->values).x;
    verdict->right = yk_form_value(check->d->ring, check->equation->right, check->values).x;
}

// The sizes of all summands: what rounding is measured by, beside what the sides differ by off the machine.
static double size_of_terms(Check *check)
{
    double size = 0;
    for (size_t k = 0; k < check->equation->term_count; k++)
        size += yk_norm(yk_form_value(check->d->ring, check->equation->terms[k].form, check->values));
    return size;
}

// Compares at one pose; true when the sides differ there by more than rounding.
static bool differs_here(Check *check, size_t *poses)
{
    fill_values(check);
    double distance = distance_of(check), size = size_of_terms(check), elsewhere = distance_at_random(check);
    if (!isfinite(distance) || !isfinite(size)) return false;
    ++*poses;
    return distance > EQUAL * (isfinite(elsewhere) ? fmax(size, elsewhere) : size);
}

// The start first, then random poses. Stops at a pose that shows a difference.
static bool differs_somewhere(Check *check, size_t *poses)
{
    YkMotion *target = calloc(check->d->mech->input_count + 1, sizeof *target);
    check->start = yk_state_new(check->d->mech);
    bool differs = false;
    if (target && check->start && yk_state_copy(check->start, check->state) >= 0) {
        check->start_margin = margin(check);
        for (int k = 0; k < TRIES && *poses < POSES && !differs; k++)
            if (k == 0 ? solve_pose(check) : move_to_random_pose(check, target)) differs = differs_here(check, poses);
    }
    yk_state_free(check->start);
    free(target);
    return differs;
}

// --- What would have been right

static const YkForm *without_slip(Check *check, const YkEquationTerm *term)
{
    YkRing *ring = check->d->ring;
    // The difference is left - right: a term there with its sign turned is the difference minus twice its share.
    const YkForm *twice = yk_form_multiply(ring, yk_form_of(ring, yk_ring_rational(ring, 2, 1)), term->form);
    bool is_subtracted = term->is_negative != term->is_right;
    return is_subtracted ? yk_form_add(ring, check->difference, twice)
                         : yk_form_subtract(ring, check->difference, twice);
}

static const char *find_slip(Check *check)
{
    const YkEquation *equation = check->equation;
    for (size_t k = equation->term_count; k > 0 && equation->term_count > 1;
         k--) { // the first has often no sign of its own
        const YkEquationTerm *term = &equation->terms[k - 1];
        if (prove(check, without_slip(check, term)) != PROVED) continue;
        YkText text = {0}, words = {0};
        yk_text_add(&words, check->text + term->start, term->end - term->start);
        yk_text_format(&text, "with the other sign before %q it would be true", yk_text_get(&words));
        const char *slip = yk_arena_copy(check->d->arena, yk_text_get(&text), text.length);
        yk_text_free(&text);
        yk_text_free(&words);
        return slip;
    }
    return NULL;
}

static void decide(Check *check, YkCheckVerdict *verdict)
{
    verdict->is_identity = is_identity(check);
    Proof proof = verdict->is_identity ? PROVED : prove(check, check->difference);
    bool differs = !verdict->is_identity && differs_somewhere(check, &verdict->poses);
    if (differs) {
        verdict->kind = proof == PROVED ? YK_CHECK_UNDECIDED : YK_CHECK_FALSE;
        note_sides(check, verdict);
        if (verdict->kind == YK_CHECK_FALSE) verdict->slip = find_slip(check);
    } else if (proof == PROVED) {
        verdict->kind = YK_CHECK_TRUE;
    } else {
        verdict->kind = verdict->poses >= POSES_MIN ? YK_CHECK_TRUE_HERE : YK_CHECK_UNDECIDED;
        verdict->is_for_these_numbers = proof == NO_PROOF;
    }
}

YkCheckVerdict yk_derive_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text, size_t length,
                               YkPlace place, YkProblems *problems)
{
    YkEquation equation;
    YkCheckVerdict verdict = {.kind = YK_CHECK_UNREADABLE};
    if (!yk_derive_blocks(d) || !yk_derive_enter_forces(d)) {
        yk_problem(problems, YK_CODE_DERIVATION, (YkPlace){0}, "the machine cannot be written in symbols: %s",
                   yk_ring_status_text(yk_ring_status(d->ring)));
        return verdict;
    }
    yk_derive_train(d); // omega1, ...: names of speeds
    yk_derive_enter_names(d);
    if (!yk_equation_read(d->ring, text, length, place, problems, &equation)) return verdict;
    Check check = {.d = d, .state = state, .dynamics = dynamics, .equation = &equation, .text = text, .seed = 2024};
    check.difference = yk_form_subtract(d->ring, equation.left, equation.right);
    for (size_t k = 0; k < d->model->parameter_count; k++)
        yk_derive_definition(d, k); // enters all symbols there will be
    yk_derive_body_angle(d, 0);
    check.values = calloc(yk_ring_symbol_count(d->ring) + 64, sizeof *check.values);
    verdict.kind = YK_CHECK_UNDECIDED;
    if (check.values && check.difference) decide(&check, &verdict);
    free(check.values);
    return verdict;
}

// Decides whether an equation is true: identity, proof on the loops, many poses.
#include <stdlib.h>
#include <string.h>
#include "base/problems.h"
#include "derive/forces/free_bodies.h"
#include "prove/check_inside.h"

static bool is_identity(YkCheck *check)
{
    enum { TERMS_MAX = 2000 };
    YkRing *ring = check->d->ring;
    const YkDeriveForces *forces = yk_derive_forces(check->d);
    bool has_roots = forces && forces->length_count > 0;
    int points = has_roots ? YK_CHECK_POINTS_OF_ROOTS : YK_CHECK_POINTS;
    YkFormVerdict verdict =
        yk_form_compare_at(ring, check->equation.left, check->equation.right, points, check->shared->anywhere);
    if (verdict != YK_FORM_UNDECIDED) return verdict == YK_FORM_EQUAL;
    // Roots that the field does not have keep their values.
    const YkPoisson *difference = yk_form_expand(ring, check->difference, TERMS_MAX);
    bool is = difference && yk_ring_is_equal(ring, difference, yk_ring_rational(ring, 0, 1));
    yk_ring_clear(ring);
    return is;
}

static void refute(YkCheck *check, YkCheckVerdict *verdict)
{
    verdict->kind = YK_CHECK_FALSE;
    yk_check_show(check, check->d->arena, &verdict->shown);
    verdict->slip = yk_check_slip(check);
}

// Tests an equation that contains t, or depends on the drives' motion, on that motion.
static void ask_drives(YkCheck *check, YkCheckVerdict *verdict)
{
    size_t times = 0;
    YkCheckShown shown = {0};
    yk_check_show(check, check->d->arena, &shown);
    bool differs = yk_check_has_drives(check) && yk_check_differs_in_drive(check, &times);
    if (!differs && times >= YK_CHECK_POSES_MIN) {
        verdict->kind = YK_CHECK_TRUE_DRIVEN;
        verdict->poses = times;
        return;
    }
    if (differs && check->has_time) yk_check_show(check, check->d->arena, &shown);
    verdict->kind = YK_CHECK_FALSE;
    verdict->shown = shown;
    verdict->slip = yk_check_slip(check);
}

// Tests an equation that is true with the file's numbers but not proved for others: with others, and with bonds.
static void look_farther(YkCheck *check, YkProof proof, YkCheckVerdict *verdict)
{
    verdict->kind = verdict->poses >= YK_CHECK_POSES_MIN ? YK_CHECK_TRUE_HERE : YK_CHECK_UNDECIDED;
    verdict->is_too_large = yk_loop_is_large(check->d);
    if (verdict->is_too_large) return;
    yk_check_machines(check, verdict);
    if (!verdict->is_false_there && check->points->ground != YK_GROUND_FIRM) {
        const YkLoopBonds *bonds = yk_check_find_bonds(check);
        if (bonds) yk_check_bind(check, bonds);
        if (bonds) proof = yk_check_prove(check, check->difference);
    }
    if (proof == YK_PROVED) verdict->kind = YK_CHECK_TRUE;
    verdict->is_refuted = proof == YK_REFUTED;
}

static void decide(YkCheck *check, YkCheckVerdict *verdict)
{
    verdict->is_identity = is_identity(check);
    verdict->is_in_segment = check->within_count > 0;
    bool differs = !verdict->is_identity && yk_check_differs(check, YK_CHECK_POSES, &verdict->poses);
    YkProof proof = verdict->is_identity ? YK_PROVED : yk_check_prove(check, check->difference);
    if (proof == YK_PROVED) {
        verdict->kind = differs ? YK_CHECK_UNDECIDED : YK_CHECK_TRUE;
    } else if (differs) {
        ask_drives(check, verdict);
    } else if (yk_check_exactly(check) == YK_EXACT_DIFFERENT) {
        yk_state_copy(check->state, check->start);
        yk_check_solve(check);
        yk_check_fill_values(check);
        refute(check, verdict);
    } else {
        look_farther(check, proof, verdict);
    }
}

static YkCheckVerdict check_equation(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text,
                                     size_t length, YkPlace place, YkProblems *problems)
{
    YkCheckVerdict verdict = {.kind = YK_CHECK_UNREADABLE};
    YkCheckSeen seen = {.motion = yk_derive_scratch(d, 2 * d->tree_count * YK_CHECK_SEEN_MAX + 1, sizeof *seen.motion)};
    YkCheckShared *shared = yk_check_share(d, state, dynamics);
    YkCheck check = {.d = d,
                     .state = state,
                     .dynamics = dynamics,
                     .text = text,
                     .length = length,
                     .seed = 2024,
                     .seen = &seen,
                     .shared = shared};
    YkCheckOpened opened =
        shared && seen.motion ? yk_check_open(&check, &shared->poses, place, problems) : YK_CHECK_NO_ROOM;
    if (shared) check.start = shared->start, check.points = &shared->points;
    if (opened != YK_CHECK_NOT_READ) verdict.kind = YK_CHECK_UNDECIDED;
    if (opened == YK_CHECK_OPEN) decide(&check, &verdict);
    if (opened == YK_CHECK_NO_ROOM || check.failed || yk_derivation_ran_out(d)) {
        verdict = (YkCheckVerdict){.kind = YK_CHECK_UNREADABLE};
        if (!yk_problems_ran_out(problems))
            yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while the equation was checked");
    }
    yk_check_close(&check);
    free(seen.motion);
    return verdict;
}

YkCheckVerdict yk_derive_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *text, size_t length,
                               YkPlace place, YkProblems *problems)
{
    YkCheckVerdict verdict = {.kind = YK_CHECK_UNREADABLE};
    if (yk_derivation_begin(d)) verdict = check_equation(d, state, dynamics, text, length, place, problems);
    yk_derivation_end(d);
    if (d->pace.is_stopped) {
        verdict = (YkCheckVerdict){.kind = YK_CHECK_UNREADABLE};
        yk_problem_stopped(problems);
    }
    return verdict;
}

YkCheckVerdict yk_derivation_check(YkDerivation *d, YkState *state, YkDynamics *dynamics, const char *equation,
                                   YkProblems *problems)
{
    YkCheckVerdict verdict = {.kind = YK_CHECK_UNREADABLE};
    YkProblems *found = yk_problems_new();
    if (found)
        verdict = yk_derive_check(d, state, dynamics, equation, strlen(equation), (YkPlace){1, 1, 0}, found);
    else
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while the equation was checked");
    yk_problems_pass_on(problems, found, equation);
    yk_problems_free(found);
    return verdict;
}

const char *yk_check_kind_name(YkCheckKind kind)
{
    static const char *const names[] = {"true", "true-here", "true-driven", "false", "undecided", "unreadable"};
    return names[kind];
}

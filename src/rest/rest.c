// Finds equilibria: poses in which nothing accelerates.
#include "rest/rest.h"
#include <stdlib.h>
#include <string.h>
#include <yoke/move.h>
#include "base/problems.h"
#include "solve/relations.h"

YkRestOptions yk_default_rest_options(void)
{
    return (YkRestOptions){.starts = 100};
}

static int by_energy(const void *a, const void *b)
{
    const YkRestPoint *p = a, *q = b;
    if (p->at.potential != q->at.potential) return p->at.potential > q->at.potential ? 1 : -1;
    return p->order < q->order ? -1 : p->order > q->order;
}

// Limits how many starts are tried: a start takes some twenty factorisations, and each equilibrium its modes. Reports
// it if they are fewer; fails if even the start pose would be too much.
static bool limit_starts(const YkRest *rest, size_t *starts, YkProblems *problems)
{
    const double work_max = 2e10; // multiplications: about ten seconds
    double f = (double)rest->freedom, n = (double)(rest->mech->step_count + rest->freedom + 1);
    double work = 40 * f * f * f + 80 * f * 40 * n, most = work_max / work;
    if (most < 1) {
        yk_problem(problems, YK_CODE_REST_TOO_LARGE, (YkPlace){0},
                   "the search for equilibria uses all freedoms at once, and %z of them are too many", rest->freedom);
        yk_problem_hint(problems,
                        "hold or drive some coordinates, or let the machine settle in `yoke simulate`, with dampers");
        return false;
    }
    if ((double)*starts + 1 <= most) return true;
    *starts = (size_t)most - 1;
    yk_problem(problems, YK_CODE_REST_FEW_STARTS, (YkPlace){0},
               "with %z freedoms only %z starts besides `start:` are tried: there may be other equilibria",
               rest->freedom, *starts);
    return true;
}

static bool prepare(YkRest *rest, const YkModel *model, const YkRestOptions *options, size_t *starts,
                    YkProblems *problems)
{
    rest->arena = yk_arena_new();
    YkCompileOptions compile = options->compile ? *options->compile : yk_default_compile_options();
    compile.progress = yk_pace_within(rest->pace);
    rest->mech = yk_mechanism_compile(model, &compile, problems);
    if (!rest->arena || !rest->mech) return false;
    rest->state = yk_state_new(rest->mech);
    rest->dynamics = yk_dynamics_new(rest->mech, problems);
    size_t n = rest->mech->input_count + 1;
    if (!rest->state || !rest->dynamics) return false;
    yk_state_lend(rest->state, rest->pace);
    for (size_t i = 0; i < rest->mech->input_count; i++) rest->freedom += rest->dynamics->is_free[i];
    if (!limit_starts(rest, starts, problems)) return false;
    rest->input = YK_NEW(rest->arena, int32_t, n);
    rest->q = YK_NEW(rest->arena, double, 9 * n + n * n);
    rest->pivot = YK_NEW(rest->arena, int, n);
    rest->order = YK_NEW(rest->arena, size_t, n);
    if (yk_arena_failed(rest->arena)) return false;
    rest->a = rest->q + n;
    rest->step = rest->a + 4 * n;
    rest->trial = rest->step + n;
    rest->scale = rest->trial + n;
    rest->jacobian = rest->scale + n;
    for (size_t i = 0, k = 0; i < rest->mech->input_count; i++) {
        if (!rest->dynamics->is_free[i]) continue;
        rest->scale[k] = yk_input_unit(rest->mech, i);
        rest->input[k++] = (int32_t)i;
    }
    return true;
}

// Returns whether the machine has inertia. A freedom may lack it in one pose and have it in all others, as an arm of no
// length does: the machine is refused if no pose that was tried has it.
static bool has_inertia(const YkRest *rest, YkProblems *problems)
{
    if (rest->has_inertia || rest->lack.status != YK_SINGULAR) return true;
    yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0}, "%s", rest->lack.message);
    return false;
}

static bool assemble(YkRest *rest, double time, YkProblems *problems)
{
    YkState *s = rest->state;
    if (yk_state_set_time(s, time, problems) < 0) return false;
    for (size_t i = 0; i < rest->mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
    YkStatus status = rest->pose ? yk_state_adopt(s, rest->pose) : yk_state_assemble(s);
    for (size_t i = 0; i < rest->mech->input_count; i++) s->input[3 * i + 1] = s->input[3 * i + 2] = 0;
    if (status >= 0) return true;
    if (status == YK_NO_MEMORY || status == YK_STOPPED) return false; // reported with the rest
    yk_problem(problems, status == YK_LIMIT ? YK_CODE_POSE_LIMIT : YK_CODE_POSE_NO_ASSEMBLY, (YkPlace){0},
               "the search for equilibria cannot start: %s", s->report.message);
    return false;
}

YkRest *yk_rest_find(const YkModel *model, const YkRestOptions *options, YkProblems *problems)
{
    YkRestOptions defaults = yk_default_rest_options();
    if (!options) options = &defaults;
    YkRest *rest = calloc(1, sizeof *rest);
    if (!rest) return NULL;
    size_t starts = options->starts;
    rest->time = options->time;
    rest->pose = options->pose;
    rest->progress = options->progress;
    YkPace pace;
    rest->pace = &pace;
    yk_pace_begin(&pace, rest->progress);
    yk_pace_stage(&pace, 0, YK_REST_STARTED);
    bool ok = prepare(rest, model, options, &starts, problems) && assemble(rest, options->time, problems);
    if (ok && !rest->dynamics->has_mass) {
        yk_problem(problems, YK_CODE_CANNOT_START, (YkPlace){0},
                   "no body has mass or inertia, so the machine has no motion of its own");
        ok = false;
    }
    if (ok) ok = yk_rest_search(rest, starts) && has_inertia(rest, problems) && !rest->dynamics->ran_out;
    if (!ok || pace.is_stopped) {
        if (pace.is_stopped)
            yk_problem_stopped(problems);
        else if (problems && yk_problems_error_count(problems) == 0)
            yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while looking for equilibria");
        yk_rest_free(rest);
        return NULL;
    }
    rest->pace = NULL;
    yk_state_lend(rest->state, NULL);
    size_t first = rest->of_start; // that of `start:` stays first
    for (size_t k = first; k < rest->count; k++) rest->points[k].order = k;
    if (rest->count > first + 1) qsort(rest->points + first, rest->count - first, sizeof *rest->points, by_energy);
    return rest;
}

void yk_rest_free(YkRest *rest)
{
    if (!rest) return;
    yk_dynamics_free(rest->dynamics);
    yk_state_free(rest->state);
    yk_mechanism_free(rest->mech);
    free(rest->points);
    yk_arena_free(rest->arena);
    free(rest);
}

size_t yk_rest_count(const YkRest *rest)
{
    return rest->count;
}
bool yk_rest_is_complete(const YkRest *rest)
{
    return rest->is_complete;
}
bool yk_rest_is_wound(const YkRest *rest)
{
    return rest->is_wound;
}
const YkMechanism *yk_rest_mechanism(const YkRest *rest)
{
    return rest->mech;
}
size_t yk_rest_freedom(const YkRest *rest)
{
    return rest->freedom;
}
size_t yk_rest_input(const YkRest *rest, size_t k)
{
    if (k >= rest->freedom) return YK_NOT_FOUND;
    return yk_rest_free_coordinate(rest, k);
}
YkEquilibrium yk_rest_equilibrium(const YkRest *rest, size_t index)
{
    if (index >= rest->count) return (YkEquilibrium){YK_STABILITY_NONE, (double)NAN, (double)NAN, false, false};
    return rest->points[index].at;
}

YkState *yk_rest_state(YkRest *rest, size_t index)
{
    if (index >= rest->count) return NULL;
    YkState *s = rest->state;
    const YkRestPoint *point = &rest->points[index];
    memcpy(s->input, point->inputs, 3 * rest->mech->input_count * sizeof *s->input);
    memcpy(s->valid_input, s->input, 3 * rest->mech->input_count * sizeof *s->input); // no way from the last pose to it
    memcpy(s->branch, point->branch, rest->mech->block_count);
    for (size_t c = 0; c < rest->mech->coordinate_count; c++) {
        s->guess[c] = s->reference[c] = point->coordinates[c];
        s->is_guessed[c] = true;
    }
    yk_relations_guess(s);                            // meshes count turns too
    if (rest->mech->has_groups) yk_state_assemble(s); // tracked from the present poses: the guesses bring them there
    yk_state_solve(s);
    return s;
}

const double *yk_rest_mass(const YkRest *rest, size_t index)
{
    return index < rest->count ? rest->points[index].mass : NULL;
}
const double *yk_rest_damping(const YkRest *rest, size_t index)
{
    return index < rest->count ? rest->points[index].damping : NULL;
}
const double *yk_rest_stiffness(const YkRest *rest, size_t index)
{
    return index < rest->count ? rest->points[index].stiffness : NULL;
}

YkMode yk_rest_mode(const YkRest *rest, size_t index, size_t k)
{
    if (index >= rest->count || k >= rest->freedom) return (YkMode){(double)NAN, (double)NAN, NULL};
    const YkRestPoint *p = &rest->points[index];
    return (YkMode){p->frequency[k], p->ratio[k], p->shape + k * rest->freedom};
}

void yk_rest_root(const YkRest *rest, size_t index, size_t k, double *real, double *imaginary)
{
    *real = *imaginary = (double)NAN;
    if (index >= rest->count || k >= 2 * rest->freedom) return;
    *real = rest->points[index].real[k];
    *imaginary = rest->points[index].imaginary[k];
}

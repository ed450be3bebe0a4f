// A machine under test: an example, or a text, loaded, compiled and assembled; and what many tests ask of it.
#ifndef TESTS_SOLVE_MACHINE_H
#define TESTS_SOLVE_MACHINE_H
#include "check.h"
#include <stdlib.h>
#include <yoke/yoke.h>
#include "model/model.h"

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Machine;

static inline void machine_free(Machine *m)
{
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

// Compiles m->model; does not assemble.
static inline void machine_compile(Machine *m, const char *input)
{
    if (!m->model) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(m->model);
    YkCompileOptions options = {&input, input ? 1 : 0};
    m->mech = yk_mechanism_compile(m->model, &options, m->problems);
    if (!m->mech) print_error("%s", yk_problems_text(m->problems, 0));
    assert_non_null(m->mech);
    m->state = yk_state_new(m->mech);
    assert_non_null(m->state);
}

// From an example's file; `input` (may be NULL) is a coordinate to hold besides the drives.
static inline Machine machine_open(const char *file, const char *input)
{
    char path[512];
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, file);
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_load(path, NULL, m.problems);
    machine_compile(&m, input);
    return m;
}

// From a file that may not load or compile; state is then NULL. Does not assemble.
static inline Machine machine_try(const char *path)
{
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_load(path, NULL, m.problems);
    m.mech = m.model ? yk_mechanism_compile(m.model, NULL, m.problems) : NULL;
    m.state = m.mech ? yk_state_new(m.mech) : NULL;
    return m;
}

static inline Machine machine_load(const char *file)
{
    Machine m = machine_open(file, NULL);
    YkStatus status = yk_state_assemble(m.state);
    if (status < 0) print_error("%s: %s\n", file, yk_state_report(m.state)->message);
    assert_true(status >= 0);
    return m;
}

static inline Machine machine_parse_with(const char *text, const YkOverride *overrides, size_t count)
{
    Machine m = {.problems = yk_problems_new()};
    YkLoadOptions options = {overrides, count};
    m.model = yk_model_parse(text, strlen(text), "test.yaml", &options, m.problems);
    machine_compile(&m, NULL);
    return m;
}

// From a text; assembled when `assemble`.
static inline Machine machine_parse(const char *text, bool assemble)
{
    Machine m = machine_parse_with(text, NULL, 0);
    if (assemble && yk_state_assemble(m.state) < 0) {
        print_error("%s\n", yk_state_report(m.state)->message);
        fail();
    }
    return m;
}

static inline YkChannel machine_channel(const Machine *m, const char *name)
{
    YkChannel c = {0};
    if (yk_channel_parse(m->mech, name, &c, m->problems) != YK_OK) {
        print_error("%s", yk_problems_text(m->problems, 0));
        fail();
    }
    return c;
}

static inline double machine_ask(const Machine *m, const char *name)
{
    return yk_state_channel(m->state, machine_channel(m, name));
}

// Sets input 0 to a position with a rate and an acceleration, and solves.
static inline YkStatus machine_solve(const Machine *m, double position, double rate, double accel)
{
    yk_state_set_input(m->state, 0, (YkMotion){position, rate, accel});
    return yk_state_solve(m->state);
}

static inline YkSweep *machine_sweep(const Machine *m, const char *over, double from, double to, size_t steps,
                                     const char *const *names, size_t count)
{
    YkSweepOptions options = yk_default_sweep_options();
    YkChannel channels[32];
    assert_true(count <= 32);
    for (size_t i = 0; i < count; i++) channels[i] = machine_channel(m, names[i]);
    options.coordinate = over ? (int)yk_coordinate_find(m->mech, over) : -1;
    assert_true(!over || options.coordinate >= 0);
    options.from = from;
    options.to = to;
    options.steps = steps;
    YkSweep *sweep = yk_sweep_run(m->state, &options, channels, count, m->problems);
    assert_non_null(sweep);
    return sweep;
}

static inline size_t count_events(const YkSweep *sweep, YkEventKind kind)
{
    size_t count = 0;
    for (size_t k = 0; k < yk_sweep_event_count(sweep); k++) count += yk_sweep_event(sweep, k).kind == kind;
    return count;
}

// a - b, modulo a turn, in (-pi, pi].
static inline double angle_between(double a, double b)
{
    return remainder(a - b, 2 * YK_PI);
}

// The examples that load; the machine that has no loop and no drive is one of them.
static const char *const all_examples[] = {"andrews",
                                           "change-point-four-bar",
                                           "chebyshev",
                                           "crank-slotted-lever",
                                           "double-butterfly",
                                           "double-pendulum",
                                           "doubled-guide",
                                           "drag-link",
                                           "elliptic-trammel",
                                           "excavator",
                                           "five-bar",
                                           "four-bar",
                                           "hoeken",
                                           "inverted-slider-crank",
                                           "jansen",
                                           "kite",
                                           "klann",
                                           "marghitu",
                                           "non-grashof",
                                           "offset-slider-crank",
                                           "oscillating-cylinder",
                                           "parallelogram",
                                           "peaucellier",
                                           "pmks-slider-crank",
                                           "quick-return",
                                           "scotch-yoke",
                                           "slider-crank",
                                           "stephenson-awkward",
                                           "stephenson-six-bar",
                                           "three-crank-parallelogram",
                                           "toggle",
                                           "watt-six-bar",
                                           "whitworth-kg"};
enum { EXAMPLE_COUNT = sizeof all_examples / sizeof all_examples[0] };

// A place fixed in a body, as the answers for the body's angle and one of its points give it. False where the body has
// neither points nor a fixed origin that a channel knows.
typedef struct Place {
    YkVec place, rate, accel;
    double angle, spin;
} Place;

static inline bool body_place(const Machine *m, size_t body, YkVec at, Place *out)
{
    const YkBody *b = &m->model->bodies[body];
    YkMotion turn = yk_state_body(m->state, body);
    *out = (Place){at, {0, 0}, {0, 0}, turn.position, turn.velocity};
    if (body == 0) return true;
    if (b->point_count == 0) return false;
    YkPointMotion p = yk_state_point(m->state, (size_t)b->first_point);
    YkVec arm = yk_mul(yk_unit(turn.position), yk_sub(at, m->model->points[b->first_point].at));
    double w = turn.velocity, a = turn.acceleration;
    out->place = yk_add(yk_vec(p.position[0], p.position[1]), arm);
    out->rate = yk_add(yk_vec(p.velocity[0], p.velocity[1]), yk_scale(w, yk_quarter(arm)));
    out->accel = yk_add(yk_vec(p.acceleration[0], p.acceleration[1]),
                        yk_sub(yk_scale(a, yk_quarter(arm)), yk_scale(w * w, arm)));
    return true;
}

#endif

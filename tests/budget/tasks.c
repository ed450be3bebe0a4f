// One task by name, for tools/check-budgets: it is set up, run once to warm up, then `counted` - the function whose
// instructions are counted - runs it. Usage: tasks NAME
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/yoke.h>
#include "../../bench/machine.h"
#include "base/text.h"
#include "derive/derive.h"
#include "page/print.h"
#include "prove/check.h"
#include "simulate/simulation.h"

enum { POSES = 1024, LOOPS = 200, LINKS = 500, DESIGNS = 50 };

typedef struct Task {
    const char *name, *example; // example NULL: a text of its own
    char *(*text)(size_t n);
    size_t n;
    void (*run)(Machine *m);
} Task;

static void die(const char *what)
{
    fprintf(stderr, "tasks: %s\n", what);
    exit(1);
}

enum { CHANNELS = 6 };
static void run_channels(Machine *m, const char *const names[CHANNELS])
{
    static double angle[POSES], out[CHANNELS][POSES];
    double *outputs[CHANNELS];
    YkChannel channels[CHANNELS];
    const double *inputs[] = {angle, NULL, NULL};
    for (size_t c = 0; c < CHANNELS; c++) {
        outputs[c] = out[c];
        if (yk_channel_parse(m->mech, names[c], &channels[c], m->problems) != YK_OK) die("no channel");
    }
    for (size_t k = 0; k < POSES; k++) angle[k] = 3 * (double)k / POSES;
    YkBatch *batch = yk_batch_new(m->state, channels, CHANNELS);
    if (!batch || yk_batch_run(batch, inputs, outputs, NULL, POSES) != YK_OK) die("no batch");
    yk_batch_free(batch);
}

static void run_batch(Machine *m)
{
    static const char *const names[CHANNELS] = {"theta2", "d3", "theta4", "d5", "d5.rate", "d5.accel"};
    run_channels(m, names);
}

static void run_forces(Machine *m)
{
    static const char *const names[CHANNELS] = {"O.force.x",  "B.force.y",  "G.force.x",
                                                "E4.force.y", "E6.force.x", "beta.effort"};
    run_channels(m, names);
}

static void run_pose(Machine *m)
{
    for (int k = 0; k < 100; k++) {
        yk_state_set_input(m->state, 0, (YkMotion){0.01 * k, -0.5, 0});
        if (yk_state_solve(m->state) != YK_OK) die("no pose");
    }
}

static void run_accelerate(Machine *m)
{
    static double a[LINKS + 1];
    for (int k = 0; k < 20; k++) machine_accelerate(m, a);
}

// Whole motions, with all that happens between evaluations: where many loops pass singular positions together, the cost
// may only grow with their number.
static void run_motion(Machine *m, double tolerance, double span)
{
    YkSimulation *simulation = machine_simulate(m, tolerance, span);
    if (yk_simulation_advance(simulation, span) != YK_OK) die("no motion");
    yk_simulation_free(simulation);
}

static void run_second(Machine *m)
{
    run_motion(m, 1e-10, 1);
}

static void run_hundredths(Machine *m)
{
    run_motion(m, 1e-10, 0.03);
}

// A machine that its drive alone moves, which is compared with what follows the drive as a sweep does.
static void run_rows(Machine *m)
{
    YkSimulation *simulation = machine_simulate(m, 1e-8, 1);
    for (int k = 1; k <= 100; k++)
        if (yk_simulation_advance(simulation, 0.01 * k) != YK_OK) die("no motion");
    yk_simulation_free(simulation);
}

// The choice of independent coordinates, whose cost may only grow with the number of loops that move by themselves.
static void run_choice(Machine *m)
{
    YkSimulation *simulation = machine_simulate(m, 1e-8, 1);
    bool changed = true;
    if (!yk_simulation_recoordinate(simulation, &changed) || changed) die("no choice");
    yk_simulation_free(simulation);
}

// A turn of a cam at 3000 revolutions a minute, whose follower could lift off at any time.
static void run_turn(Machine *m)
{
    run_motion(m, 1e-8, 0.02);
}

static void run_study(Machine *m)
{
    static const char *const names[] = {"a", "b"};
    static double angle[360], a[DESIGNS], b[DESIGNS];
    static YkExtent extents[DESIGNS];
    YkChannel channel;
    if (yk_channel_parse(m->mech, "coupler.P.x", &channel, m->problems) != YK_OK) die("no channel");
    YkStudyOptions options = {names, 2, &channel, 1, 1, NULL};
    YkStudy *study = yk_study_new(m->state, &options, m->problems);
    const double *parameters[] = {a, b}, *inputs[] = {angle, NULL, NULL};
    for (size_t k = 0; k < 360; k++) angle[k] = 0.0174532925 * (double)k;
    for (size_t k = 0; k < DESIGNS; k++) a[k] = 0.04 + 1e-5 * (double)k, b[k] = 0.12 - 1e-5 * (double)k;
    YkStudyCase asked = {parameters, DESIGNS, inputs, 360, false};
    if (!study || yk_study_reduce(study, &asked, extents, NULL, NULL) != YK_OK) die("no study");
    yk_study_free(study);
}

// Accelerations of states with parameters of their own.
static void run_states(Machine *m)
{
    static const char *const names[] = {"l1", "lc2", "m1", "I2"};
    static double rows[8][POSES], a[2][POSES];
    const double *const parameters[] = {rows[0], rows[1], rows[2], rows[3]}, *const q[] = {rows[4], rows[5]};
    const double *const v[] = {rows[6], rows[7]};
    double *const accelerations[] = {a[0], a[1]};
    YkMotionBatch *batch = yk_motion_batch_new(m->state, names, 4, 1, m->problems);
    for (size_t p = 0; p < 8; p++)
        for (size_t k = 0; k < POSES; k++)
            rows[p][k] =
                p < 4 ? yk_model_parameter(m->model, names[p]) * (1 + 1e-4 * (double)k) : 1e-3 * (double)(p * k);
    YkMotionCase asked = {.parameters = parameters, .positions = q, .rates = v, .count = POSES};
    if (!batch) die("no batch");
    for (int k = 0; k < 50; k++)
        if (yk_motion_batch_run(batch, &asked, accelerations, NULL) != YK_OK) die("no accelerations");
    yk_motion_batch_free(batch);
}

static void run_derive(Machine *m)
{
    YkText text = {0};
    YkDerivation *d = yk_derivation_new(m->model, m->mech, m->problems);
    YkPage page = {.arena = yk_arena_new(), .ring = d ? d->ring : NULL};
    if (!d || !page.arena) die("no derivation");
    for (size_t k = 0; yk_derive_sections[k].name; k++)
        if (yk_derivation_has_section(d, k) && !yk_derive_write(d, k, &page)) die("no section");
    if (!yk_page_write(&page, YK_PAGE_TEXT, "budget", NULL, &text)) die("not printed");
    yk_arena_free(page.arena);
    yk_derivation_free(d);
    yk_text_free(&text);
}

// The free bodies of a long machine, streamed as the command does.
static bool pass_on(void *context, const char *text, size_t length)
{
    (void)context, (void)text, (void)length;
    return true;
}

static void run_free_bodies(Machine *m)
{
    bool *sections = calloc(yk_derivation_section_count(), sizeof *sections);
    YkDerivation *d = yk_derivation_new(m->model, m->mech, m->problems);
    if (!sections || !d) die("no derivation");
    sections[yk_derivation_section_find("free-bodies")] = true;
    YkPageOptions options = yk_default_page_options();
    options.sections = sections, options.write = pass_on;
    if (yk_derivation_page(d, &options, m->problems) != YK_OK) die("no page");
    yk_derivation_free(d);
    free(sections);
}

// Twenty equations of one derivation: what the first finds out serves the others.
static void run_check(Machine *m)
{
    static const char *const equations[] = {"rr*cos(beta) - d*cos(beta + Theta) = xb + ss*sin(gamma)",
                                            "gamma' = rr*sin(Theta)/(ss*cos(beta + Theta - gamma))*beta'",
                                            "delta'' = gamma''", "K2.rate = beta' + Theta'"};
    YkDerivation *d = yk_derivation_new(m->model, m->mech, m->problems);
    YkState *state = yk_state_new(m->mech);
    if (!d || !state) die("no derivation");
    for (int k = 0; k < 20; k++) {
        const char *equation = equations[k % 4];
        yk_state_copy(state, m->state);
        yk_derive_check(d, state, m->dynamics, equation, strlen(equation), (YkPlace){1, 1, 0}, NULL);
    }
    yk_state_free(state);
    yk_derivation_free(d);
}

static const Task tasks[] = {
    {"quick-return-batch", "quick-return", NULL, 0, run_batch},
    {"andrews-forces-batch", "andrews", NULL, 0, run_forces},
    {"quick-return-pose", "quick-return", NULL, 0, run_pose},
    {"double-pendulum-rhs", "double-pendulum", NULL, 0, run_accelerate},
    {"n-four-bar-rhs", NULL, n_four_bar_text, LOOPS, run_accelerate},
    {"chain-rhs", NULL, chain_text, LINKS, run_accelerate},
    {"n-four-bar-motion", NULL, n_four_bar_text, LOOPS, run_second},
    {"double-pendulum-motion", "double-pendulum", NULL, 0, run_second},
    {"andrews-motion", "andrews", NULL, 0, run_hundredths},
    {"valve-cam-motion", "valve-cam", NULL, 0, run_turn},
    {"geared-five-bar-motion", "geared-five-bar", NULL, 0, run_rows},
    {"separate-loops-choice", NULL, separate_loops_text, LOOPS, run_choice},
    {"double-pendulum-states", "double-pendulum", NULL, 0, run_states},
    {"four-bar-study", "four-bar", NULL, 0, run_study},
    {"check-andrews", "andrews", NULL, 0, run_check},
    {"derive-double-pendulum", "double-pendulum", NULL, 0, run_derive},
    {"derive-n-four-bar", NULL, n_four_bar_text, LOOPS, run_free_bodies},
};

// Its name is what callgrind looks for.
__attribute__((noinline)) void counted(const Task *task, Machine *m);
void counted(const Task *task, Machine *m)
{
    task->run(m);
    __asm__ volatile("" ::: "memory");
}

int main(int argc, char **argv)
{
    for (size_t k = 0; argc == 2 && k < sizeof tasks / sizeof *tasks; k++) {
        const Task *task = &tasks[k];
        Machine m;
        char path[512], *text = task->text ? task->text(task->n) : NULL;
        if (strcmp(task->name, argv[1]) != 0) continue;
        snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, task->example ? task->example : "");
        if (text ? !machine_parse(&m, text) : !machine_load(&m, path)) die("no machine");
        task->run(&m);
        counted(task, &m);
        machine_end(&m);
        free(text);
        return 0;
    }
    for (size_t k = 0; argc == 1 && k < sizeof tasks / sizeof *tasks; k++) printf("%s\n", tasks[k].name);
    return argc == 1 ? 0 : 2;
}

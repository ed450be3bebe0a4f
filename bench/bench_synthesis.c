// Synthesis: curves of four-bars found again, and gradients of machines' motions, in time on one thread.
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <yoke/yoke.h>
#include "base/mix.h"
#include "reference/common/bench.h"
#include "rows.h"
#include "synthesis/machines/machine_fit.h"

enum { POINTS = 60, CURVES = 20, RUNS = 200, ROUNDS = 5 };

// --- curves

// Writes the task of a random crank-rocker's curve of points; returns its size.
static double write_curve(uint64_t *seed, char *text, size_t size)
{
    double crank = 0.3 + 0.5 * yk_mix_unit(seed), coupler = 1.5 + yk_mix_unit(seed), rocker = 1.2 + yk_mix_unit(seed);
    double ground = 1.2 + 0.6 * (coupler + rocker - crank - 1.2) * yk_mix_unit(seed), x = 2 * yk_mix_unit(seed) - 0.5;
    double y = 2 * yk_mix_unit(seed) - 1, low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
    size_t at =
        (size_t)snprintf(text, size, "synthesis: path\nclosed: true\nmechanisms: [four-bar]\nbest: 1\npoints: [");
    for (int k = 0; k < POINTS; k++) {
        double theta = 2 * YK_PI * k / POINTS, ax = crank * cos(theta), ay = crank * sin(theta);
        double dx = ground - ax, d = hypot(dx, ay),
               cosine = (coupler * coupler + d * d - rocker * rocker) / (2 * coupler * d);
        if (!(fabs(cosine) < 1)) return write_curve(seed, text, size); // it does not turn through
        double phi = atan2(-ay, dx) + acos(cosine);
        double p[2] = {ax + x * cos(phi) - y * sin(phi), ay + x * sin(phi) + y * cos(phi)};
        for (int i = 0; i < 2; i++) low[i] = fmin(low[i], p[i]), high[i] = fmax(high[i], p[i]);
        at += (size_t)snprintf(text + at, size - at, "%s[%.15g, %.15g]", k > 0 ? ", " : "", p[0], p[1]);
    }
    snprintf(text + at, size - at, "]\n");
    return hypot(high[0] - low[0], high[1] - low[1]);
}

// Returns the seconds a curve; worst: the largest mean error of those found again, over their size.
static double find_again(double *worst, int *found)
{
    static char text[POINTS * 48 + 200];
    uint64_t seed = 7;
    double total = 0;
    *worst = *found = 0;
    for (int k = 0; k < CURVES; k++) {
        double size = write_curve(&seed, text, sizeof text), from = bench_now();
        YkTask *task = yk_task_parse(text, strlen(text), "curve.yaml", NULL);
        YkSynthesis *s = yk_synthesis_run(task, NULL, NULL);
        total += bench_now() - from;
        if (!task || !s) exit(1);
        double error = yk_synthesis_count(s) > 0 ? sqrt(yk_synthesis_candidate(s, 0).error / POINTS) / size : INFINITY;
        *found += error < 1e-6;
        if (error < 1e-6) *worst = fmax(*worst, error);
        yk_synthesis_free(s);
        yk_task_free(task);
    }
    return total / CURVES;
}

// --- gradients

typedef struct Fit {
    YkTask *task;
    YkArena *arena;
    YkMachineFit fit;
    YkMachineTry at;
} Fit;

static void open_fit(Fit *f, const char *text)
{
    *f = (Fit){.task = yk_task_parse(text, strlen(text), "bench.yaml", NULL), .arena = yk_arena_new()};
    if (!f->task || !f->arena || !yk_machine_fit_new(f->task, f->arena, &f->fit, NULL)) exit(1);
    for (size_t j = 0; j < f->task->machine.free_count; j++)
        f->at.value[j] = yk_model_parameter(f->task->machine.model, f->task->machine.name[j]);
    f->fit.weight = 1;
    if (!yk_machine_measure(&f->fit, f->fit.miss, &f->at)) exit(1);
}

static bool compare(const char *name, const char *text)
{
    Fit f;
    double motion[ROUNDS], gradient[ROUNDS];
    open_fit(&f, text);
    for (int round = 0; round < ROUNDS; round++) {
        double from = bench_now();
        for (int k = 0; k < RUNS; k++) yk_machine_measure(&f.fit, f.fit.miss, &f.at);
        double between = bench_now();
        for (int k = 0; k < RUNS; k++)
            if (!yk_machine_differentiate(&f.fit, &f.at)) exit(1);
        motion[round] = (between - from) / RUNS * 1e6;
        gradient[round] = (bench_now() - between) / RUNS * 1e6;
    }
    double one = median(motion, ROUNDS), other = median(gradient, ROUNDS);
    printf("%s: %.0f motions a second, %.0f gradients a second, %zu parameters\n", name, 1e6 / one, 1e6 / other,
           f.task->machine.free_count);
    bool keeps = row(name, one, other, "us", 0, 0);
    yk_machine_fit_free(&f.fit);
    yk_arena_free(f.arena);
    yk_task_free(f.task);
    return keeps;
}

int main(void)
{
    double worst;
    int found;
    double seconds = find_again(&worst, &found);
    printf("%d of %d curves found again, %.1f a second\n", found, CURVES, 1 / seconds);
    bool keeps = row("a four-bar from 60 points of its curve (by hand: the second allowed)", 1, seconds, "s", 1, worst);
    keeps &=
        compare("gradient of Jansen's stride by 11 lengths, over a motion",
                "synthesis: machine\nmachine: " YOKE_ROOT "/examples/jansen.yaml\n"
                "free: {b: [35, 48], c: [34, 45], d: [36, 44], e: [50, 60], f: [34, 45], g: [32, 42], h: [60, 70],\n"
                "       i: [45, 53], j: [45, 55], k: [57, 66], m: [12, 18]}\n"
                "over: {input: theta, range: [0 deg, 360 deg], steps: 90}\n"
                "goals: [{point: leg.foot, through: [[-65 mm, -90 mm], [-45 mm, -91 mm], [-25 mm, -90 mm]]}]\n"
                "units: {length: mm}\n");
    static const char thirty[] = "synthesis: machine\nmachine: " YOKE_ROOT "/tests/synthesis/thirty.yaml\nfree: {%s}\n"
                                 "over: {input: theta, range: [0 deg, 360 deg], steps: 90}\n"
                                 "goals: [{value: theta.effort, equals: 5}]\n";
    static const char *const free_ones[2] = {
        "a: [0, 1], b: [0, 1], c: [0, 1]",
        "a: [0, 1], b: [0, 1], c: [0, 1], g: [0, 1], tilt: [0, 1], px: [0, 1], py: [0, 1], m: [0, 9], J: [0, 1],\n"
        "       m2: [0, 9], J2: [0, 1], x2: [0, 1], y2: [0, 1], m1: [0, 9], J1: [0, 1], x1: [0, 1], y1: [0, 1], k: [0, "
        "900],\n"
        "       l0: [0, 1], sx: [-1, 1], sy: [-1, 1], qx: [-1, 1], qy: [-1, 1], k2: [0, 900], l2: [0, 1], tx: [-1, "
        "1],\n"
        "       ty: [-1, 1], damp: [0, 9], fx: [0, 99], fy: [-99, 0]"};
    static const char *const names[2] = {"gradient of an effort at each row by 3 parameters, over a motion",
                                         "gradient of an effort at each row by 30 parameters, over a motion"};
    for (int k = 0; k < 2; k++) {
        char text[1500];
        snprintf(text, sizeof text, thirty, free_ones[k]);
        keeps &= compare(names[k], text);
    }
    return keeps ? 0 : 2;
}

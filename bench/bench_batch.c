// Batches: ten machines of the gallery against closed forms written for each alone; the double pendulum with its own
// parameters in every state; a Monte-Carlo study of a four-bar on one thread and two.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "machine.h"
#include "reference/common/bench.h"
#include "reference/gallery.h"

enum { ROUNDS = 5, CHUNK = 1024, RUNS = 400, OUTPUTS = 6, STATES = 100000, DESIGNS = 1000000, POSES = 360 };

static double *rows_of(size_t count, size_t n)
{
    double *p = calloc(count * (n + 24), sizeof *p); // a little apart: see bench_quick_return.c
    if (!p) exit(1);
    return p;
}

static double part_of(size_t k)
{
    return fmod((double)(k + 1) * 0.6180339887498949, 1);
}

// --- the gallery
// -----------------------------------------------------------------------------------------------------------------

typedef struct Pair { // the same machine by hand and by us
    const GalleryMachine *by_hand;
    Machine machine;
    YkBatch *batch;
    size_t outputs;
    double *in[2], *rate, *accel, *hand[OUTPUTS], *own[OUTPUTS];
} Pair;

static const double W = 1.3, AL = 0.7;

static void open_pair(Pair *p, const GalleryMachine *g)
{
    char path[512], name[64];
    YkChannel channels[OUTPUTS];
    *p = (Pair){.by_hand = g};
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, g->file);
    if (!machine_load(&p->machine, path)) exit(1);
    for (const char *at = g->channels; *at; p->outputs++) {
        size_t length = strcspn(at, ",");
        snprintf(name, sizeof name, "%.*s", (int)length, at);
        if (yk_channel_parse(p->machine.mech, name, &channels[p->outputs], p->machine.problems) != YK_OK) exit(1);
        at += length + (at[length] == ',');
    }
    p->batch = yk_batch_new(p->machine.state, channels, p->outputs);
    double *rows = rows_of(4 + 2 * OUTPUTS, CHUNK);
    for (size_t k = 0; k < 4 + 2 * OUTPUTS; k++, rows += CHUNK + 24) {
        if (k < 2) p->in[k] = rows;
        if (k == 2) p->rate = rows;
        if (k == 3) p->accel = rows;
        if (k >= 4) (k < 4 + OUTPUTS ? p->hand : p->own)[(k - 4) % OUTPUTS] = rows;
    }
    for (size_t i = 0; i < CHUNK; i++) {
        p->rate[i] = W, p->accel[i] = AL;
        for (int k = 0; k < 2; k++) p->in[k][i] = g->from[k] + (g->to[k] - g->from[k]) * part_of(i + 100 * (size_t)k);
    }
}

static void close_pair(Pair *p)
{
    free(p->in[0]);
    yk_batch_free(p->batch);
    machine_end(&p->machine);
}

static void by_hand(Pair *p)
{
    p->by_hand->form((const double *const *)p->in, W, AL, p->hand, CHUNK);
}

static void by_batch(Pair *p)
{
    const double *in[] = {p->in[0], p->rate, p->accel, p->in[1], p->rate, p->accel};
    if (yk_batch_run(p->batch, in, p->own, NULL, CHUNK) != YK_OK) exit(1);
}

// Over the largest value; angles modulo a turn.
static double difference(Pair *p)
{
    double worst = 0;
    by_hand(p);
    by_batch(p);
    for (size_t k = 0; k < p->outputs; k++) {
        double largest = 1, off = 0;
        for (size_t i = 0; i < CHUNK; i++) {
            double d = p->own[k][i] - p->hand[k][i];
            if (k < p->outputs / 3) d = fmin(fabs(d), fabs(remainder(d, 2 * 3.14159265358979323846)));
            off = fmax(off, fabs(d));
            largest = fmax(largest, fabs(p->own[k][i]));
        }
        worst = fmax(worst, off / largest);
    }
    return worst;
}

static bool compare_gallery(void)
{
    double ratios[32], worst = 0;
    printf("%-24s %9s %9s %9s %12s\n", "batch, a pose", "by hand", "ours", "ratio", "difference");
    for (size_t m = 0; m < gallery_count; m++) {
        double ns[2][ROUNDS], at[2];
        Pair p;
        open_pair(&p, &gallery_machines[m]);
        double off = difference(&p);
        for (size_t r = 0; r < ROUNDS; r++)
            for (int way = 0; way < 2; way++) {
                double start = bench_now();
                for (size_t k = 0; k < RUNS; k++) (way ? by_batch : by_hand)(&p);
                ns[way][r] = (bench_now() - start) * 1e9 / (RUNS * CHUNK);
            }
        for (int way = 0; way < 2; way++) at[way] = median(ns[way], ROUNDS);
        printf("%-24s %9.2f %9.2f %9.2f %12.1e\n", p.by_hand->file, at[0], at[1], at[1] / at[0], off);
        ratios[m] = at[1] / at[0];
        worst = fmax(worst, off);
        close_pair(&p);
    }
    return row("ten machines of the gallery, batch: the median ratio", 1, median(ratios, gallery_count), "", 2, worst);
}

// --- the double pendulum
// ------------------------------------------------------------------------------------------------

static bool compare_pendulum(void)
{
    static const char *const names[] = {"l1", "lc1", "lc2", "m1", "m2", "I1", "I2"};
    double *row_of[7], *q[2], *v[2], *a[2][2], *none, ns[2][ROUNDS], worst = 0, largest = 0;
    Machine machine;
    if (!machine_load(&machine, YOKE_ROOT "/examples/double-pendulum.yaml")) exit(1);
    double *rows = rows_of(16, STATES), *first = rows;
    for (int p = 0; p < 7; p++, rows += STATES + 24) {
        row_of[p] = rows;
        for (size_t k = 0; k < STATES; k++)
            rows[k] = yk_model_parameter(machine.model, names[p]) * (0.8 + 0.4 * part_of(k + 1000 * (size_t)p));
    }
    for (int i = 0; i < 2; i++) {
        q[i] = rows, v[i] = rows + STATES + 24, a[0][i] = rows + 2 * (STATES + 24), a[1][i] = rows + 3 * (STATES + 24);
        rows += 4 * (STATES + 24);
        for (size_t k = 0; k < STATES; k++) q[i][k] = 6 * part_of(k + 17 * (size_t)i), v[i][k] = 3 - 6 * part_of(k);
    }
    none = rows;
    YkMotionBatch *batch = yk_motion_batch_new(machine.state, names, 7, 1, machine.problems);
    const double *const efforts[] = {none, none};
    YkMotionCase asked = {(const double *const *)row_of, (const double *const *)q, (const double *const *)v, efforts,
                          STATES};
    if (!batch) exit(1);
    for (size_t r = 0; r < ROUNDS; r++) {
        double start = bench_now();
        for (int k = 0; k < 20; k++)
            d1_batch((const double *const *)row_of, (const double *const *)q, (const double *const *)v, a[0], STATES);
        ns[0][r] = (bench_now() - start) * 1e9 / (20.0 * STATES);
        start = bench_now();
        for (int k = 0; k < 20; k++)
            if (yk_motion_batch_run(batch, &asked, a[1], NULL) != YK_OK) exit(1);
        ns[1][r] = (bench_now() - start) * 1e9 / (20.0 * STATES);
    }
    for (size_t k = 0; k < STATES; k++) {
        largest = fmax(largest, fabs(a[0][0][k]));
        worst = fmax(worst, fabs(a[0][0][k] - a[1][0][k]));
    }
    yk_motion_batch_free(batch);
    machine_end(&machine);
    free(first);
    return row("double pendulum, 1e5 states, each with its own parameters", median(ns[0], ROUNDS),
               median(ns[1], ROUNDS), "ns", 2.5, worst / largest);
}

// --- Monte Carlo
// ------------------------------------------------------------------------------------------------------------

static double run_study(const Machine *m, size_t threads, double *const *values, double *angles, YkExtent *extents)
{
    static const char *const names[] = {"a", "b", "c", "d"}, *const of[] = {"coupler.P.x", "coupler.P.y"};
    YkChannel channels[2];
    for (int c = 0; c < 2; c++) yk_channel_parse(m->mech, of[c], &channels[c], m->problems);
    YkStudyOptions options = {names, 4, channels, 2, threads, NULL};
    YkStudy *study = yk_study_new(m->state, &options, m->problems);
    const double *inputs[] = {angles, NULL, NULL};
    YkStudyCase asked = {(const double *const *)values, DESIGNS, inputs, POSES, false};
    double start = bench_wall();
    if (!study || yk_study_reduce(study, &asked, extents, NULL, NULL) != YK_OK) exit(1);
    double seconds = bench_wall() - start;
    yk_study_free(study);
    return seconds;
}

// On the clock of the wall, the best of three: both processors are needed.
static bool compare_threads(void)
{
    static const char *const names[] = {"a", "b", "c", "d"};
    static double angles[POSES];
    double *values[4], *rows = rows_of(4, DESIGNS), least[3] = {0, INFINITY, INFINITY};
    YkExtent *extents = malloc(2 * DESIGNS * sizeof *extents), *again = malloc(2 * DESIGNS * sizeof *extents);
    Machine m;
    if (!extents || !again || !machine_load(&m, YOKE_ROOT "/examples/four-bar.yaml")) exit(1);
    for (int p = 0; p < 4; p++) {
        double own = yk_model_parameter(m.model, names[p]);
        YkDistribution d = {YK_DISTRIBUTION_NORMAL, own * 0.99, own * 1.01, own, own * 0.003};
        values[p] = rows + (size_t)p * (DESIGNS + 24);
        for (size_t k = 0; k < DESIGNS; k++) values[p][k] = yk_distribution_draw(&d, 1, k, (uint64_t)p);
    }
    for (size_t k = 0; k < POSES; k++) angles[k] = 6.283185307179586 * (double)k / POSES;
    for (int r = 0; r < 3; r++)
        for (size_t threads = 1; threads <= 2; threads++)
            least[threads] =
                fmin(least[threads], run_study(&m, threads, values, angles, threads == 1 ? extents : again));
    double differs = memcmp(extents, again, 2 * DESIGNS * sizeof *extents) == 0 ? 0 : 1;
    bool keeps = least[2] <= 4;
    printf("row\tMonte Carlo of a four-bar's coupler point, 1e6 designs of 360 poses: two threads; against one\t"
           "%.3g s (one thread)\t%.3g s\t%.2f\t%s4 s, at most 0.56\t%.0e\n",
           least[1], least[2], least[2] / least[1], keeps && least[2] / least[1] <= 0.56 ? "" : "missed: ", differs);
    free(rows);
    free(extents);
    free(again);
    machine_end(&m);
    return keeps && differs == 0;
}

int main(void)
{
    bool keeps = compare_gallery();
    keeps &= compare_pendulum();
    keeps &= compare_threads();
    return keeps ? 0 : 2;
}

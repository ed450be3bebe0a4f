// The file that is written of a machine is that machine: of every kind, however it is built, the engine finds its
// traced point where the machine's own equations have it, at the pose that is written and at others.
#include "solve/machine.h"
#include "synthesis/paths/path_chain.h"

static YkBar random_bar(YkDesignKind kind, int variant, uint64_t *seed)
{
    YkBar bar = {.kind = kind, .variant = variant};
    for (int k = 0; k < YK_BAR_SIZE; k++) bar.v[k] = check_uniform(seed, -2, 2);
    for (int k = YK_BAR_GROUND; k < YK_BAR_SIZE; k++)
        if (yk_bar_is_length(kind, k)) bar.v[k] = check_uniform(seed, 0.5, 3);
    bar.branch = check_random(seed) % 2 ? 1 : -1;
    bar.bend = check_random(seed) % 2 ? 1 : -1;
    bar.hangs_at_end = yk_bar_has_loop(kind) && check_random(seed) % 2;
    return bar;
}

static void check_point(const Machine *m, const char *body, YkVec due)
{
    char name[2][20];
    for (int i = 0; i < 2; i++) snprintf(name[i], sizeof name[i], "%s.P.%c", body, i == 0 ? 'x' : 'y');
    CHECK_NEAR(machine_ask(m, name[0]), due.x, 1e-9);
    CHECK_NEAR(machine_ask(m, name[1]), due.y, 1e-9);
}

// Returns whether the machine closes at its pose and well around it.
static bool check_bar(const YkBar *bar, double input, const YkModel *sheet)
{
    YkDesign design;
    YkBarPoint point;
    YkText text = {0};
    const double step = 0.02;
    for (int k = -5; k <= 5; k++)
        if (!yk_bar_point(bar, input + 5 * step * k, &point)) return false;
    if (!yk_bar_design(bar, input, &design)) return false;
    YkJourney journey = {.sheet = sheet, .name = "written"};
    yk_design_write(&design, &journey, &text);
    Machine m = machine_parse(yk_text_get(&text), true);
    const char *body = yk_bar_size(bar->kind) == YK_BAR_PLAIN ? "coupler" : "link";
    for (int k = 0; k <= 5; k++) {
        assert_true(machine_solve(&m, input + step * k, 1, 0) >= 0);
        assert_true(yk_bar_point(bar, input + step * k, &point));
        check_point(&m, body, point.at);
    }
    machine_free(&m);
    yk_text_free(&text);
    return true;
}

static void written_machines_trace_the_curve(void **unused)
{
    (void)unused;
    Machine units =
        machine_parse("units: {length: mm}\nbodies: {ground: {points: {O: [0, 0]}}, a: {points: {O: [0, 0]}}}\n"
                      "joints: {O: {pin: [ground, a], angle: q}}\n",
                      false);
    uint64_t seed = 33;
    for (YkDesignKind kind = 0; kind < YK_DESIGN_KINDS; kind++) {
        int variants = (int)yk_chain_variants(kind);
        for (int variant = 0; variant < (variants > 0 ? variants : 1); variant++) {
            size_t closed = 0;
            for (int k = 0; k < 200 && closed < 6; k++) {
                YkBar bar = random_bar(kind, variant, &seed);
                closed += check_bar(&bar, check_uniform(&seed, -3, 3), units.model);
            }
            if (closed < 3) print_error("kind %d, variant %d: %zu\n", (int)kind, variant, closed);
            assert_true(closed >= 3);
        }
    }
    machine_free(&units);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(written_machines_trace_the_curve)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

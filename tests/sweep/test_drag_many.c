// Dragging with several free inputs where the answer is known: carriages on each other, each with a slide that has
// stops. The point reaches the sum of the slides' ways; the pose nearest to a target is that of least squares within a
// box, which has no minimum but the least.
#include "solve/machine.h"
#include <yoke/drag.h>

enum { MOST = 4 };

typedef struct Table {
    size_t count;
    double angle[MOST], low[MOST], high[MOST]; // of the slides
} Table;

static Table random_table(uint64_t *seed, size_t count, double size)
{
    Table t = {.count = count};
    double first = check_uniform(seed, -3, 3);
    for (size_t k = 0; k < count; k++) { // no two of them nearly parallel
        t.angle[k] = first + ((double)k + check_uniform(seed, -0.2, 0.2)) * YK_PI / (double)count;
        t.low[k] = size * check_uniform(seed, -1, -0.1);
        t.high[k] = size * check_uniform(seed, 0.1, 1);
    }
    return t;
}

static Machine table_machine(const Table *t, double size)
{
    char bodies[600], joints[900], stops[400], text[2000];
    int b = snprintf(bodies, sizeof bodies, "bodies:\n  ground: {points: {O: [0, 0], E: [%.17g, 0]}}\n", size);
    int j = snprintf(joints, sizeof joints, "joints:\n"), s = snprintf(stops, sizeof stops, "stops: {");
    for (size_t k = 0; k < t->count; k++) {
        char below[8];
        snprintf(below, sizeof below, k == 0 ? "ground" : "b%zu", k - 1);
        b += snprintf(bodies + b, sizeof bodies - (size_t)b, "  b%zu: {points: {O: [0, 0]}}\n", k);
        j += snprintf(joints + j, sizeof joints - (size_t)j,
                      "  J%zu: {slide: [%s, b%zu], along: %.17g, from: O, to: O, distance: d%zu}\n", k, below, k,
                      t->angle[k], k);
        s += snprintf(stops + s, sizeof stops - (size_t)s, "%sd%zu: [%.17g, %.17g]", k ? ", " : "", k, t->low[k],
                      t->high[k]);
    }
    snprintf(text, sizeof text, "%s%s%s}\n", bodies, joints, stops);
    return machine_parse(text, true);
}

// Returns the least distance by turning at one slide after the other, each as far as is best and its stops allow.
static double least_distance(const Table *t, const double target[2])
{
    double d[MOST] = {0}, x = -target[0], y = -target[1];
    for (int round = 0; round < 400; round++)
        for (size_t k = 0; k < t->count; k++) {
            double c = cos(t->angle[k]), s = sin(t->angle[k]);
            double to = fmin(fmax(d[k] - (x * c + y * s), t->low[k]), t->high[k]);
            x += (to - d[k]) * c;
            y += (to - d[k]) * s;
            d[k] = to;
        }
    return hypot(x, y);
}

static void check_table(size_t count, double size, uint64_t *seed, size_t *reached)
{
    Table t = random_table(seed, count, size);
    Machine m = table_machine(&t, size);
    double place[2] = {0, 0};
    YkDrag *drag = yk_drag_new(m.state, count, place, NULL);
    assert_non_null(drag);
    for (int k = 0; k < 6; k++) {
        double target[2] = {size * check_uniform(seed, -2, 2), size * check_uniform(seed, -2, 2)};
        double least = least_distance(&t, target), x = 0, y = 0;
        YkDragged end;
        assert_int_equal(yk_state_drag(drag, target, &end), YK_OK);
        for (size_t i = 0; i < count; i++) {
            double d = yk_state_input(m.state, i).position;
            assert_true(d >= t.low[i] - 1e-9 * size && d <= t.high[i] + 1e-9 * size);
            x += d * cos(t.angle[i]);
            y += d * sin(t.angle[i]);
        }
        CHECK_NEAR(hypot(x - target[0], y - target[1]), end.distance, 1e-12 * size);
        CHECK_NEAR(end.distance, least, 1e-7 * size);
        assert_int_equal(end.end, least > 1e-9 * size ? YK_DRAG_STOP : YK_DRAG_REACHED);
        *reached += end.end == YK_DRAG_REACHED;
        assert_int_equal(end.block, -1);
        assert_true((end.coordinate >= 0) == (end.end == YK_DRAG_STOP));
        if (end.end != YK_DRAG_STOP) continue;
        double d = yk_state_coordinate(m.state, (size_t)end.coordinate).position;
        const char *name = yk_coordinate_info(m.mech, (size_t)end.coordinate).name;
        size_t slide = (size_t)(name[1] - '0');
        assert_true(fmin(fabs(d - t.low[slide]), fabs(d - t.high[slide])) < 1e-3 * size);
    }
    yk_drag_free(drag);
    machine_free(&m);
}

static void carriages_come_as_near_as_their_stops_let_them(void **unused)
{
    (void)unused;
    uint64_t seed = 41;
    size_t reached = 0;
    for (uint64_t k = 0; k < check_cases(100); k++)
        for (size_t count = 2; count <= MOST; count++)
            check_table(count, pow(1e-6, (double)(k % 3) - 1), &seed, &reached);
    assert_true(reached > check_cases(100));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(carriages_come_as_near_as_their_stops_let_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

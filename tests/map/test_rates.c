// The derivatives that enclose steps along the mapped input, against differences of poses enclosed at two inputs.
#include "configurations/truss.h"
#include "map/map.h"

// Checks that a derivative's disc over an interval contains the difference quotient of two values at its ends: by the
// mean value theorem, both of its parts are derivatives somewhere in between.
static void check_rate(YkBall rate, YkVec from, YkVec to, double length, double *narrowest)
{
    YkVec quotient = yk_scale(1 / length, yk_sub(to, from));
    double off = yk_norm(yk_sub(rate.at, quotient)), slack = 1e-9 * (1 + yk_norm(quotient));
    if (!(off <= sqrt(2) * rate.radius + slack))
        print_error("%.9g %+.9g i, not %.9g %+.9g i\n", rate.at.x, rate.at.y, quotient.x, quotient.y);
    assert_true(off <= sqrt(2) * rate.radius + slack);
    if (yk_norm(quotient) > 1e-3) *narrowest = fmin(*narrowest, rate.radius / yk_norm(quotient));
}

// Returns a copy of the values of all slots, then distances, then nodes.
static YkVec *copy_values(const YkDiscs *d, size_t counts[3])
{
    const YkDual *of[] = {d->slots, d->distances, d->nodes};
    YkVec *values = calloc(counts[0] + counts[1] + counts[2] + 1, sizeof *values), *next = values;
    assert_non_null(values);
    for (int kind = 0; kind < 3; kind++)
        for (size_t k = 0; k < counts[kind]; k++) *next++ = of[kind][k].at.at;
    return values;
}

// Where no loop has to be closed, a state stands in the only pose of an input: its directions are those enclosed.
static void check_directions(YkTracer *t, YkState *state, double at)
{
    yk_state_set_input(state, 0, (YkMotion){at, 0, 0});
    assert_int_equal(yk_state_solve(state), YK_OK);
    for (size_t k = 1; k < t->mech->slot_count; k++) {
        YkTurn own = yk_space_turn(&state->space, (int32_t)k);
        YkBall disc = t->discs.slots[k].at;
        assert_true(yk_norm(yk_sub(disc.at, yk_vec(own.c[0], own.s[0]))) <= disc.radius + 1e-14);
        assert_true(disc.radius < 1e-12);
    }
}

static void check_strand(YkTracer *t, YkState *state, YkStrand *strand, size_t *checked, double *narrowest)
{
    size_t counts[] = {t->mech->slot_count, t->mech->distance_count, t->mech->node_count};
    for (size_t c = 0; c < strand->count; c += 1 + strand->count / 12) {
        double half, from = strand->cells[c].from, to = strand->cells[c].to;
        if (to - from < 1e-3 * t->scale) continue; // beside an event rounding hides differences
        to = fmin(to, from + 0.01 * t->scale);
        assert_true(yk_trace_place(t, strand, from));
        if (t->mech->block_count == 0) check_directions(t, state, from);
        YkVec *first = copy_values(&t->discs, counts);
        assert_true(yk_trace_place(t, strand, to));
        YkVec *last = copy_values(&t->discs, counts);
        assert_true(yk_trace_place_path(t, strand, from, to, &half));
        const YkDual *of[] = {t->over.slots, t->over.distances, t->over.nodes};
        size_t place = 0;
        for (int kind = 0; kind < 3; kind++)
            for (size_t k = 0; k < counts[kind]; k++, place++, (*checked)++)
                check_rate(of[kind][k].rate, first[place], last[place], to - from, narrowest);
        free(first);
        free(last);
    }
}

static void test_rates_are_those_of_differences(void **unused)
{
    (void)unused;
    static const char *const files[] = {
        "four-bar",       "reverted-train",     "slider-crank",  "inverted-slider-crank",     "klann",
        "planetary-gear", "stephenson-awkward", "doubled-guide", "three-crank-parallelogram", "whitworth-kg"};
    for (size_t f = 0; f < sizeof files / sizeof *files; f++) {
        Machine m = machine_load(files[f]);
        assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
        YkMap *map = yk_map_new(m.state, yk_input_coordinate(m.mech, 0), m.problems);
        size_t checked = 0;
        double narrowest = INFINITY;
        assert_non_null(map);
        for (size_t k = 0; k < map->leaves->count; k++)
            check_strand(&map->tracer, m.state, map->leaves->items[k], &checked, &narrowest);
        if (!(checked >= 4 && narrowest < 0.1)) print_error("%s: %zu checked, %g\n", files[f], checked, narrowest);
        assert_true(checked >= 4);
        assert_true(narrowest < 0.1); // discs that contain everything would prove nothing
        yk_map_free(map);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_rates_are_those_of_differences)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// The times at which a motion leaves the range of a law, against closed forms.
#include "run.h"

// A weight falls; a table of its way, which exerts nothing, ends after 0.1 m.
static Run falling(const char *law, const char *of)
{
    char text[800];
    snprintf(text, sizeof text,
             "gravity: [0, -9.81]\n"
             "bodies: {weight: {mass: 2 kg}}\n"
             "joints: {S: {slide: [ground, weight], along: -y, distance: s}}\n"
             "laws: {%s}\n"
             "efforts: {s: {law: rail, of: %s}}\n"
             "start: {s: 0, s.rate: 0}\n",
             law, of);
    return run_of_text(text, run_options(1e-10));
}

static void the_time_is_a_root(void **unused)
{
    (void)unused;
    Run way = falling("rail: {table: [[0 m, 0 N], [0.1 m, 0 N]]}", "s"),
        rate = falling("rail: {table: [[0 m/s, 0 N], [3 m/s, 0 N]]}", "s.rate"),
        time = falling("rail: {table: [[0 s, 0 N], [0.25 s, 0 N]]}", "t");
    const double expected[] = {sqrt(2 * 0.1 / 9.81), 3 / 9.81, 0.25}, ends[] = {0.1, 3, 0.25};
    Run *const runs[] = {&way, &rate, &time};
    for (size_t k = 0; k < 3; k++) {
        assert_int_equal(yk_simulation_advance(runs[k]->sim, 1), YK_OK);
        assert_int_equal(yk_simulation_happening_count(runs[k]->sim), 1);
        YkHappening left = yk_simulation_happening(runs[k]->sim, 0);
        assert_int_equal(left.kind, YK_HAPPENING_LAW_LEFT);
        assert_string_equal(left.name, "s");
        CHECK_NEAR(left.time, expected[k], 2e-9);
        CHECK_NEAR(left.value, ends[k], 1e-8);
        CHECK_NEAR(run_value(runs[k], "s"), 9.81 / 2, 1e-9); // looking changes nothing
        run_free(runs[k]);
    }
}

static void a_start_outside_is_told(void **unused)
{
    (void)unused;
    Run run = falling("rail: {table: [[0.1 m, 0 N], [0.2 m, 0 N]]}", "s");
    assert_int_equal(yk_simulation_advance(run.sim, 0), YK_OK);
    assert_int_equal(yk_simulation_happening_count(run.sim), 1);
    assert_true(yk_simulation_happening(run.sim, 0).time == 0);
    assert_int_equal(yk_simulation_advance(run.sim, 1), YK_OK);
    assert_int_equal(yk_simulation_happening_count(run.sim), 1); // once
    run_free(&run);
}

static void what_stays_inside_or_repeats_is_not_told(void **unused)
{
    (void)unused;
    Run inside = falling("rail: {table: [[0 m, 0 N], [6 m, 0 N]]}", "s"),
        period = falling("rail: {period: 0.1 m, table: [[0 m, 0 N], [0.1 m, 0 N]]}", "s");
    assert_int_equal(yk_simulation_advance(inside.sim, 1), YK_OK);
    assert_int_equal(yk_simulation_advance(period.sim, 1), YK_OK);
    assert_int_equal(yk_simulation_happening_count(inside.sim), 0);
    assert_int_equal(yk_simulation_happening_count(period.sim), 0);
    run_free(&inside);
    run_free(&period);
}

// The rows that are asked for do not matter, nor does saving in between.
static void rows_and_saving_change_nothing(void **unused)
{
    (void)unused;
    static char bytes[1 << 16];
    const char *law = "rail: {table: [[0 m, 0 N], [0.1 m, 0 N]]}";
    Run run = falling(law, "s"), rows = falling(law, "s"), saved = falling(law, "s");
    for (int k = 0; k <= 50; k++) assert_int_equal(yk_simulation_advance(rows.sim, 0.01 * k), YK_OK);
    assert_int_equal(yk_simulation_advance(run.sim, 0.3), YK_OK);
    size_t count = yk_simulation_save(run.sim, bytes, sizeof bytes);
    assert_true(count > 0 && count <= sizeof bytes);
    assert_int_equal(yk_simulation_restore(saved.sim, bytes, count), YK_OK);
    assert_int_equal(yk_simulation_advance(saved.sim, 0.5), YK_OK);
    assert_int_equal(yk_simulation_happening_count(saved.sim), 1);
    assert_int_equal(yk_simulation_happening_count(rows.sim), 1);
    CHECK_NEAR(yk_simulation_happening(rows.sim, 0).time, yk_simulation_happening(saved.sim, 0).time, 1e-11);
    run_free(&run);
    run_free(&rows);
    run_free(&saved);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_time_is_a_root),
        cmocka_unit_test(a_start_outside_is_told),
        cmocka_unit_test(what_stays_inside_or_repeats_is_not_told),
        cmocka_unit_test(rows_and_saving_change_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

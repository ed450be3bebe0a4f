// Examples in other units of length and mass (tests/similar.h): they move alike in time, with the same steps and events
// and similar work. Not so in other units of time: steps are chosen by errors of places and of rates, measured by a
// radian or by the machine's size and by these in a second.
#include "../similar.h"
#include "simulate/simulation.h"

static YkSimulation *start(const Similar *m)
{
    YkSimulationOptions options = yk_default_simulation_options();
    options.tolerance = 1e-6;
    YkSimulation *sim = yk_simulation_new(m->model, &options, m->problems);
    if (!sim) print_error("%s: %s", m->file, yk_problems_text(m->problems, 0));
    assert_non_null(sim);
    return sim;
}

static void check_events(const Similar *a, const YkSimulation *one, const YkSimulation *two)
{
    SIMILAR_EQUAL(a->file, yk_simulation_happening_count(one), yk_simulation_happening_count(two));
    for (size_t k = 0; k < yk_simulation_happening_count(one); k++) {
        YkHappening h = yk_simulation_happening(one, k), i = yk_simulation_happening(two, k);
        SIMILAR_EQUAL(a->file, h.kind, i.kind);
        assert_string_equal(h.name, i.name);
        similar_check(h.time, i.time, YK_QUANTITY_TIME, a->file, "time of an event");
    }
    YkSimulationSummary s = yk_simulation_summary(one), t = yk_simulation_summary(two);
    SIMILAR_EQUAL(a->file, s.steps, t.steps);
    SIMILAR_EQUAL(a->file, s.rejected, t.rejected);
    SIMILAR_EQUAL(a->file, s.evaluations, t.evaluations);
    SIMILAR_EQUAL(a->file, s.recoordinations, t.recoordinations);
    similar_check(s.energy_error, t.energy_error, YK_QUANTITY_NUMBER, a->file, "error of the energy");
    similar_check(s.worst_residual, t.worst_residual, YK_QUANTITY_NUMBER, a->file, "residual");
    similar_check(s.energy_end, t.energy_end, YK_QUANTITY_ENERGY, a->file, "energy");
    for (size_t k = 0; k < yk_simulation_work_count(one); k++)
        similar_check(yk_simulation_work(one, k), yk_simulation_work(two, k), YK_QUANTITY_ENERGY, a->file,
                      yk_simulation_work_name(one, k));
}

static void check_file(const char *file, double end, const int units[3])
{
    similar_set(0, 0, 0);
    Similar a = similar_load(file, NULL);
    YkSimulation *one = start(&a);
    similar_set(units[0], units[1], units[2]);
    Similar b = similar_load(file, NULL);
    YkSimulation *two = start(&b);
    for (int row = 1; row <= 4; row++) {
        YkStatus status = yk_simulation_advance(one, end * row / 4);
        SIMILAR_EQUAL(file, yk_simulation_advance(two, similar_to(end * row / 4, YK_QUANTITY_TIME)), status);
        Similar c = a, d = b;
        c.state = yk_simulation_state(one), c.mech = (YkMechanism *)yk_state_mechanism(c.state);
        d.state = yk_simulation_state(two), d.mech = (YkMechanism *)yk_state_mechanism(d.state);
        c.dynamics = yk_simulation_dynamics(one), d.dynamics = yk_simulation_dynamics(two);
        check_events(&a, one, two);
        similar_check_state(&c, &d);
    }
    yk_simulation_free(one);
    yk_simulation_free(two);
    similar_free(&a);
    similar_free(&b);
}

static void test_motions_in_other_units(void **unused)
{
    (void)unused;
    static const char *const files[] = {"examples/bouncing-block.yaml",
                                        "examples/toggle.yaml",
                                        "examples/crank-press.yaml",
                                        "examples/n-four-bar.yaml",
                                        "examples/double-pendulum-boxes.yaml",
                                        "examples/cart-pendulum.yaml",
                                        "examples/rough-block.yaml",
                                        "examples/swing-arm.yaml",
                                        "examples/andrews.yaml",
                                        "examples/five-bar-motors.yaml",
                                        "examples/spring-slider-crank.yaml",
                                        "examples/rocking-four-bar.yaml",
                                        "examples/watt-with-masses.yaml",
                                        "examples/gas-engine.yaml",
                                        "examples/double-pendulum.yaml",
                                        "examples/damped-pendulum.yaml",
                                        "examples/cubic-spring.yaml",
                                        "examples/torsion-spring.yaml",
                                        "examples/steam-engine.yaml",
                                        "examples/car-axis.yaml",
                                        "examples/flat-faced-cam.yaml",
                                        "examples/valve-cam.yaml",
                                        "examples/compound-pendulum.yaml",
                                        "examples/swing-cam.yaml"};
    static const int units[][3] = {{33, -26, 0}, {-35, 24, 0}};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++)
        for (size_t u = 0; u < sizeof units / sizeof *units; u++) check_file(files[k], 0.5, units[u]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_motions_in_other_units)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

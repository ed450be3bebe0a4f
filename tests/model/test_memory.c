// Loading survives the failure of any one allocation, and of all from any one on: it is refused, nothing leaks, nothing
// crashes.
#include "interposed.h"
#include "model/examples.h"
#include "model/fixture.h"

// Loads while allocation number k fails. True when k is beyond the last one, so that the load was undisturbed.
static int load_while_failing(const char *text, const YkLoadOptions *options, long k, int is_good)
{
    YkProblems *problems = yk_problems_new();
    assert_non_null(problems);
    has_failed = 0;
    countdown = k;
    YkModel *model = yk_model_parse(text, strlen(text), "test", options, problems);
    countdown = -1;
    int undisturbed = !has_failed;
    if (undisturbed) assert_int_equal(model != NULL, is_good);
    if (!undisturbed && !model) assert_true(yk_problems_count(problems) > 0); // it says why
    yk_model_free(model);
    yk_problems_free(problems);
    return undisturbed;
}

static void check_all(const char *text, const YkLoadOptions *options, int is_good)
{
    for (int for_good = 0; for_good < 2; for_good++) {
        fails_for_good = for_good;
        long k = 0, before = live;
        while (!load_while_failing(text, options, k, is_good)) {
            if (live != before) print_error("leak of %ld blocks when allocation %ld fails\n", live - before, k);
            assert_true(live == before);
            k++;
        }
        assert_true(k > 20); // there was something to fail
    }
    fails_for_good = false;
}

static void a_good_file_is_loaded_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    const YkOverride override = {"l1", "0.12 m"};
    check_all(quick_return, NULL, 1);
    check_all(toggle, &(YkLoadOptions){&override, 1}, 1);
    check_all(double_pendulum, NULL, 1);
    check_all("parameters: {h: 3 mm, b: 1/4}\nlaws:\n  lift:\n    period: 360 deg\n    segments:\n"
              "      - {polynomial: [{at: 0, s: 0, v: 0}, {at: 90 deg, s: 2*h, v: 0}]}\n"
              "      - {rise: {to: 2, by: h, law: spline, through: [{at: 1.8, s: 2*h}]}}\n"
              "      - {fall: {to: 360 deg, by: 3*h, law: scca, scca: {b: b, c: b, d: 2*b}}}\n"
              "  drag: {table: [[0, 1 N], [h, 2], [2*h, 3]], between: cubic}\n"
              "bodies: {k: {}}\njoints: {O: {pin: [ground, k]}}\n",
              NULL, 1);
}

static void loads_are_read_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_all("parameters: {k: 3, mu: 0.1}\nbodies: {a: {points: {P: [0, 1]}}, b: {}}\n"
              "joints: {O: {pin: [ground, a], angle: phi, friction: {coulomb: mu, radius: 2*k}},\n"
              "  S: {slide: [a, b], friction: {viscous: k*1 N*s/m^2}}}\n"
              "efforts: {phi: -2 N*m*s * phi.rate + 3 N*s * S.distance.rate}\n"
              "forces: {F: {body: a, at: P, value: [1 N * sin(phi), 0], axes: body, moment: 2 N*m * cos(O.angle)}}\n"
              "springs: {c: {along: S.distance, stiffness: 2 N/m^2 * k}}\n"
              "stops: {S.distance: {between: [-k, k], restitution: mu}}\n",
              NULL, 1);
}

static void trains_are_read_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_all(epicyclic, NULL, 1);
    check_all(cam, NULL, 1);
    check_all("bodies: {a: {}, b: {}, bar: {}, arm: {points: {B: [1, 0]}}}\n"
              "joints: {A: {pin: [arm, a]}, B: {pin: [arm, b]}, O: {pin: [ground, arm], angle: q},\n"
              "  S: {slide: [arm, bar], distance: d}}\n"
              "belts: {x: {between: [a, b], radii: [1/2, 0.3], crossed: true}}\n"
              "racks: {y: {pinion: b, rack: bar, radius: 2 mm * 3}}\n"
              "locks: {one: [a, q], two: {hold: [bar], join: [[a, b], [b, arm]]}}\n",
              NULL, 1);
}

static void a_bad_file_is_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    check_all("parameters: {a: b, b: a, c: 1/0, l1: 3 m}\nbodies: {k: {points: {A: [l2, 0]}, mass: -1}, m: {}}\n"
              "joints: {O: {pin: [ground, kk]}, A: {pin: [k, m], angle: q, at: B}}\n"
              "drives: {O.angle: 3, qq: 2, q: q}\nstart: {A.angle.rate: 1}\nspeed: 3\n",
              NULL, 0);
}

static void a_value_is_read_or_refused_whichever_allocation_fails(void **state)
{
    (void)state;
    skip_unless_interposed();
    YkModel *model = fixture_load(toggle);
    int undisturbed = 0;
    for (long k = 0; !undisturbed; k++) {
        long before = live;
        double value = 0;
        has_failed = 0;
        countdown = k;
        YkStatus status = yk_model_value(model, "l1/2 + 3 mm", YK_QUANTITY_LENGTH, &value, NULL);
        countdown = -1;
        undisturbed = !has_failed;
        if (status == YK_OK) CHECK_NEAR(value, 0.053, 1e-16);
        if (undisturbed) assert_int_equal(status, YK_OK);
        assert_true(live == before);
    }
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_good_file_is_loaded_or_refused_whichever_allocation_fails),
        cmocka_unit_test(loads_are_read_or_refused_whichever_allocation_fails),
        cmocka_unit_test(trains_are_read_or_refused_whichever_allocation_fails),
        cmocka_unit_test(a_bad_file_is_refused_whichever_allocation_fails),
        cmocka_unit_test(a_value_is_read_or_refused_whichever_allocation_fails),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Dragging, against fine sweeps of the same way: the first pose from which the distance grows, limits and stops where
// the sweep finds them; with several inputs, nothing nearer around.
#include "interposed.h"
#include "solve/four_bar.h"

static const char slider_crank[] =
    "bodies:\n  ground: {points: {O: [0, 0]}}\n  crank: {points: {O: [0, 0], A: [0.1, 0]}}\n"
    "  rod: {points: {A: [0, 0], B: [0.3, 0], C: [0.1, 0.1]}}\n  piston: {points: {B: [0, 0]}}\n"
    "joints:\n  O: {pin: [ground, crank], angle: q}\n  A: {pin: [crank, rod], angle: p}\n  B: {pin: [rod, piston]}\n"
    "  R: {slide: [ground, piston], along: x, distance: d}\n";
static const char five_bar[] =
    "bodies:\n  ground: {points: {O: [0, 0], Q: [1, 0]}}\n  left: {points: {O: [0, 0], A: [0.7, 0]}}\n"
    "  one: {points: {A: [0, 0], C: [0.9, 0]}}\n  two: {points: {B: [0, 0], C: [0.8, 0]}}\n"
    "  right: {points: {Q: [0, 0], B: [0.6, 0]}}\n"
    "joints:\n  O: {pin: [ground, left], angle: a}\n  Q: {pin: [ground, right], angle: b}\n"
    "  A: {pin: [left, one], angle: c}\n  B: {pin: [right, two]}\n  C: {pin: [one, two]}\n";

static YkVec point_of_state(const YkState *state, size_t body, const double place[2])
{
    const YkModel *model = yk_mechanism_model(yk_state_mechanism(state));
    YkPointMotion origin = {{0, 0}, {0, 0}, {0, 0}};
    double angle = yk_state_body(state, body).position;
    for (size_t k = 0; k < model->point_count; k++)
        if (model->points[k].body == (int32_t)body && model->points[k].at.x == 0 && model->points[k].at.y == 0)
            origin = yk_state_point(state, k);
    return yk_vec(origin.position[0] + cos(angle) * place[0] - sin(angle) * place[1],
                  origin.position[1] + sin(angle) * place[0] + cos(angle) * place[1]);
}

static double distance_of(const YkState *state, size_t body, const double place[2], const double target[2])
{
    return yk_norm(yk_sub(point_of_state(state, body, place), yk_vec(target[0], target[1])));
}

// The first pose from which the distance grows, by a sweep in 20,000 rows a turn from where the state stands, in the
// direction in which it falls. *limit: the motion ends first.
static double by_sweep(Machine *m, size_t body, const double place[2], const double target[2], double way, bool *limit)
{
    enum { FINE = 3000 };
    double from = yk_state_input(m->state, 0).position, step = 2 * YK_PI / 20000, best = from;
    double last = distance_of(m->state, body, place, target);
    YkState *s = yk_state_new(m->mech);
    assert_int_equal(yk_state_copy(s, m->state), YK_OK);
    *limit = false;
    YkMotion beside = {from + way * 1e-7, 0, 0}; // next to a limit points move as its root: no row would see it
    if (yk_state_move_to(s, &beside, NULL, NULL) >= 0 && distance_of(s, body, place, target) > last) {
        yk_state_free(s);
        return from;
    }
    yk_state_copy(s, m->state);
    for (int k = 1; k <= 7 * FINE; k++) {
        YkMotion goal = {from + way * step * k, 0, 0};
        if (yk_state_move_to(s, &goal, NULL, NULL) < 0) {
            *limit = true;
            break;
        }
        double now = distance_of(s, body, place, target);
        if (now >= last) break;
        last = now;
        best = goal.position;
    }
    yk_state_free(s);
    return best;
}

// A limit: one way is closed, and the other leads away. Otherwise both lead away, or one does not close - where the
// nearest pose lies all but at the limit.
static void check_end(Machine *m, size_t body, const double place[2], const double target[2], const YkDragged *end)
{
    size_t closed = 0;
    for (int way = -1; way <= 1; way += 2) {
        YkState *s = yk_state_new(m->mech);
        yk_state_copy(s, m->state);
        YkMotion goal = {yk_state_input(m->state, 0).position + way * 1e-6, 0, 0};
        if (yk_state_move_to(s, &goal, NULL, NULL) < 0)
            closed++;
        else
            assert_true(distance_of(s, body, place, target) > end->distance - 1e-10);
        yk_state_free(s);
    }
    assert_true(closed <= 1);
    if (end->end == YK_DRAG_LIMIT) assert_int_equal(closed, 1);
}

// The inputs keep the rates that they had, 0.7 and -0.3, and so everything moves as if it were solved there.
static void check_own_rates(Machine *m, size_t inputs)
{
    YkState *s = yk_state_new(m->mech);
    yk_state_copy(s, m->state);
    for (size_t i = 0; i < inputs; i++) {
        YkMotion q = yk_state_input(m->state, i);
        CHECK_NEAR(q.velocity, 0.7, 0);
        CHECK_NEAR(q.acceleration, -0.3, 0);
        yk_state_set_input(s, i, q);
    }
    bool is_there = yk_state_solve(s) == YK_OK && yk_state_has_rates(m->state);
    for (size_t c = 0; is_there && c < yk_coordinate_count(m->mech); c++) {
        double rate = yk_state_coordinate(s, c).velocity;
        CHECK_NEAR(yk_state_coordinate(m->state, c).velocity, rate, 1e-9 * (1 + fabs(rate)));
    }
    yk_state_free(s);
}

static void check_single(Machine *m, size_t body, uint64_t *seed, size_t *limits, size_t *inner)
{
    double place[2], target[2], step = 2 * YK_PI / 20000;
    for (int k = 0; k < 2; k++) {
        place[k] = check_uniform(seed, -0.5, 0.5);
        target[k] = check_uniform(seed, -2, 2);
    }
    double from = yk_state_input(m->state, 0).position, before = distance_of(m->state, body, place, target);
    bool ends_up, ends_down;
    double up = by_sweep(m, body, place, target, 1, &ends_up), down = by_sweep(m, body, place, target, -1, &ends_down);
    YkDrag *drag = yk_drag_new(m->state, body, place, NULL);
    YkDragged end;
    machine_solve(m, from, 0.7, -0.3);
    assert_int_equal(yk_state_drag(drag, target, &end), YK_OK);
    check_own_rates(m, 1);
    double here = yk_state_input(m->state, 0).position, now = distance_of(m->state, body, place, target);
    double want = up != from ? up : down;
    CHECK_NEAR(now, end.distance, 1e-12);
    assert_true(now <= before);
    if (up != from && down != from) fail_msg("a maximum");
    CHECK_NEAR(here, want, 2.1 * step);
    if (end.end != YK_DRAG_REACHED) check_end(m, body, place, target, &end);
    *limits += end.end == YK_DRAG_LIMIT;
    *inner += end.end == YK_DRAG_NEAREST;
    assert_int_equal(end.block, end.end == YK_DRAG_LIMIT ? 0 : -1);
    assert_int_equal(end.coordinate, -1);
    // On from there, again: it stays. Back to where it was: it goes, as far as there is no other minimum on the way.
    assert_int_equal(yk_state_drag(drag, target, NULL), YK_OK);
    CHECK_NEAR(distance_of(m->state, body, place, target), now, 1e-9);
    yk_drag_free(drag);
}

static void four_bars_follow_to_the_nearest_pose(void **unused)
{
    (void)unused;
    uint64_t seed = 915;
    size_t limits = 0, inner = 0;
    for (uint64_t k = 0; k < check_cases(15);) {
        FourBar f = {check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1), check_uniform(&seed, 0.1, 1),
                     check_uniform(&seed, 0.1, 1)};
        double theta = check_uniform(&seed, -YK_PI, YK_PI);
        int branch = check_random(&seed) % 2 ? 1 : -1;
        if (!four_bar_pose(f, theta, branch).closes || fabs(grashof_excess(f)) < 1e-2) continue;
        Machine m = four_bar_machine(f, theta, branch);
        for (size_t body = 1; body <= 3; body++) check_single(&m, body, &seed, &limits, &inner);
        machine_free(&m);
        k++;
    }
    assert_true(limits > check_cases(15) / 6 && inner > check_cases(15) * 5 / 6);
}

static void slider_cranks_follow_to_the_nearest_pose(void **unused)
{
    (void)unused;
    uint64_t seed = 4;
    size_t limits = 0, inner = 0;
    for (uint64_t k = 0; k < check_cases(8); k++) {
        char text[2000];
        snprintf(text, sizeof text, "%sstart: {q: %.17g, d: 0.3}\n", slider_crank, check_uniform(&seed, -3, 3));
        Machine m = machine_parse(text, true);
        for (size_t body = 1; body <= 3; body++) check_single(&m, body, &seed, &limits, &inner);
        machine_free(&m);
    }
    assert_true(limits == 0 && inner > check_cases(8));
}

// A crank's end on its circle: the direction of the target, whatever the way there.
static void a_point_on_a_circle_turns_towards_the_target(void **unused)
{
    (void)unused;
    uint64_t seed = 77;
    Machine m = machine_parse("bodies:\n  ground: {points: {O: [0, 0]}}\n  bar: {points: {O: [0, 0], A: [1, 0]}}\n"
                              "joints: {O: {pin: [ground, bar], angle: q}}\n",
                              true);
    double place[2] = {1, 0}, back[2] = {-2, 0}, on[2] = {0, 1};
    YkDrag *drag = yk_drag_new(m.state, 1, place, NULL);
    YkDragged end;
    assert_int_equal(yk_state_drag(drag, (double[]){2, 0}, &end), YK_OK); // it is as near as it comes
    assert_int_equal(end.end, YK_DRAG_NEAREST);
    CHECK_NEAR(yk_state_coordinate(m.state, 0).position, 0, 0);
    assert_int_equal(yk_state_drag(drag, back, &end), YK_OK); // exactly behind: either way will do
    CHECK_NEAR(end.distance, 1, 1e-12);
    assert_int_equal(yk_state_drag(drag, on, &end), YK_OK);
    assert_int_equal(end.end, YK_DRAG_REACHED);
    for (uint64_t k = 0; k < check_cases(200); k++) {
        double target[2] = {check_uniform(&seed, -3, 3), check_uniform(&seed, -3, 3)};
        assert_int_equal(yk_state_drag(drag, target, &end), YK_OK);
        double off = yk_state_coordinate(m.state, 0).position - atan2(target[1], target[0]);
        CHECK_NEAR(off - 2 * YK_PI * round(off / (2 * YK_PI)), 0, 1e-9);
    }
    const double bad[][2] = {{(double)NAN, 0}, {0, (double)NAN}, {(double)INFINITY, 0}, {0, -(double)INFINITY}};
    for (size_t k = 0; k < 4; k++) assert_int_equal(yk_state_drag(drag, bad[k], &end), YK_BAD_ARGUMENT);
    assert_null(yk_drag_new(m.state, 2, place, NULL));
    yk_drag_free(drag);
    machine_free(&m);
}

static void a_stop_ends_the_drag(void **unused)
{
    (void)unused;
    char text[2000];
    snprintf(text, sizeof text, "%sstart: {q: 0.5, d: 0.3}\nstops: {d: [0.28, 1]}\n", slider_crank);
    Machine m = machine_parse(text, true);
    double place[2] = {0.1, 0}, far[2] = {-0.3, 0.1}, near[2] = {0.3, 0.05};
    YkDrag *drag = yk_drag_new(m.state, 1, place, NULL);
    YkDragged end;
    for (int k = 0; k < 3; k++) {
        assert_int_equal(yk_state_drag(drag, far, &end), YK_OK);
        assert_int_equal(end.end, YK_DRAG_STOP);
        assert_int_equal(end.coordinate, yk_coordinate_find(m.mech, "d"));
        assert_int_equal(end.block, -1);
        CHECK_NEAR(machine_ask(&m, "d"), 0.28, 1e-10);
        if (k == 0) continue;
        assert_int_equal(yk_state_drag(drag, near, &end), YK_OK); // and back
        assert_int_equal(end.end, YK_DRAG_NEAREST);
        CHECK_NEAR(machine_ask(&m, "q"), atan2(0.05, 0.3), 1e-9);
    }
    yk_drag_free(drag);
    machine_free(&m);
}

// A parallelogram passes its change points as the motion does, so that it stays one.
static void change_points_are_passed(void **unused)
{
    (void)unused;
    Machine m = machine_load("parallelogram");
    double place[2] = {0.1, 0}, before = machine_ask(&m, "coupler.angle");
    YkDrag *drag = yk_drag_new(m.state, 1, place, NULL);
    YkDragged end;
    size_t passes = 0;
    for (int k = 0; k < 40; k++) {
        double angle = 0.3 * k, target[2] = {10 * cos(angle), 10 * sin(angle)};
        assert_int_equal(yk_state_drag(drag, target, &end), YK_OK);
        assert_int_equal(end.end, YK_DRAG_NEAREST);
        CHECK_NEAR(machine_ask(&m, "coupler.angle"), before, 1e-6);
        passes += end.pass_count;
    }
    assert_true(passes >= 3);
    yk_drag_free(drag);
    machine_free(&m);
}

// --- several inputs -------------------------------------------------------------------------------

// Never farther away; where it ends for good, nothing nearer on a ring of small motions; at a limit, near that one.
static void check_many(Machine *m, size_t body, const double place[2], const double target[2], size_t *ends)
{
    YkState *from = yk_state_new(m->mech), *probe = yk_state_new(m->mech);
    yk_state_copy(from, m->state);
    YkDrag *drag = yk_drag_new(m->state, body, place, NULL);
    YkDragged end;
    double before = distance_of(m->state, body, place, target);
    for (size_t i = 0; i < 2; i++)
        yk_state_set_input(m->state, i, (YkMotion){yk_state_input(m->state, i).position, 0.7, -0.3});
    yk_state_solve(m->state);
    for (int k = 0; k == 0 || (end.end == YK_DRAG_SPENT && k < 4); k++) {
        assert_int_equal(yk_state_drag(drag, target, &end), YK_OK);
        assert_true(end.distance <= before + 1e-3); // it stands a hair inside of a limit
        before = end.distance;
    }
    check_own_rates(m, 2);
    ends[end.end]++;
    CHECK_NEAR(distance_of(m->state, body, place, target), end.distance, 1e-9);
    if (end.end == YK_DRAG_LIMIT) assert_true(yk_state_transmission(m->state, (size_t)end.block) < 0.3);
    if (end.end == YK_DRAG_NEAREST)
        for (int k = 0; k < 64; k++) {
            double angle = 2 * YK_PI * k / 64, off = 1e-3;
            YkMotion goal[2] = {yk_state_input(m->state, 0), yk_state_input(m->state, 1)};
            goal[0].position += off * cos(angle);
            goal[1].position += off * sin(angle);
            yk_state_copy(probe, m->state);
            YkMoveOptions options = yk_default_move_options();
            options.detours = 0;
            if (yk_state_move_to(probe, goal, &options, NULL) < 0) continue;
            double there = distance_of(probe, body, place, target);
            if (!(there > end.distance - 1e-5)) print_error("end %d: %g, nearer %g\n", end.end, end.distance, there);
            assert_true(there > end.distance - 1e-5);
        }
    yk_drag_free(drag);
    yk_state_free(from);
    yk_state_free(probe);
}

static void five_bars_follow_with_two_inputs(void **unused)
{
    (void)unused;
    uint64_t seed = 12;
    char text[2000];
    size_t ends[5] = {0};
    snprintf(text, sizeof text, "%sstart: {a: 1.8, b: 1.2, c: -1}\n", five_bar);
    Machine m = machine_parse(text, true);
    for (int k = 0; k < 150; k++) {
        double place[2] = {0.9, 0}, target[2] = {check_uniform(&seed, -0.5, 1.5), check_uniform(&seed, 0, 1.6)};
        if (k % 3 == 0) place[0] = check_uniform(&seed, 0, 0.9);
        check_many(&m, 2, place, target, ends);
    }
    assert_true(ends[YK_DRAG_REACHED] > 20 && ends[YK_DRAG_NEAREST] > 10 && ends[YK_DRAG_LIMIT] > 10);
    machine_free(&m);
}

// Two arms reach every place within their reach, and point at the others.
static void an_arm_reaches_what_it_can(void **unused)
{
    (void)unused;
    uint64_t seed = 5;
    Machine m = machine_parse("bodies:\n  ground: {points: {O: [0, 0]}}\n  upper: {points: {O: [0, 0], A: [0.6, 0]}}\n"
                              "  lower: {points: {A: [0, 0], T: [0.5, 0]}}\n"
                              "joints:\n  O: {pin: [ground, upper], angle: a}\n  A: {pin: [upper, lower], angle: b}\n"
                              "start: {a: 0.3, b: 0.8}\n",
                              true);
    double place[2] = {0.5, 0};
    YkDrag *drag = yk_drag_new(m.state, 2, place, NULL);
    for (uint64_t k = 0; k < check_cases(300); k++) {
        double target[2] = {check_uniform(&seed, -1.5, 1.5), check_uniform(&seed, -1.5, 1.5)};
        double far = hypot(target[0], target[1]), want = fmax(0, fmax(far - 1.1, 0.1 - far));
        YkDragged end;
        assert_int_equal(yk_state_drag(drag, target, &end), YK_OK);
        CHECK_NEAR(end.distance, want, 1e-5);
    }
    yk_drag_free(drag);
    bool hold[2] = {true, false}; // then only the lower arm follows
    drag = yk_drag_new(m.state, 2, place, hold);
    double a = yk_state_input(m.state, 0).position, target[2] = {0.1, 0.2};
    assert_int_equal(yk_state_drag(drag, target, NULL), YK_OK);
    assert_true(yk_state_input(m.state, 0).position == a);
    double x = 0.6 * cos(a), y = 0.6 * sin(a), off = yk_state_body(m.state, 2).position - atan2(0.2 - y, 0.1 - x);
    CHECK_NEAR(off - 2 * YK_PI * round(off / (2 * YK_PI)), 0, 1e-9);
    yk_drag_free(drag);
    machine_free(&m);
}

// Taking hold allocates, and survives whatever fails; dragging does not.
static void dragging_allocates_nothing(void **unused)
{
    (void)unused;
    skip_unless_interposed();
    char text[2000];
    snprintf(text, sizeof text, "%sstart: {a: 1.8, b: 1.2, c: -1}\n", five_bar);
    Machine m = machine_parse(text, true);
    double place[2] = {0.9, 0};
    bool hold[2] = {false, true};
    for (int k = 0; k < 2; k++) {
        long before = live;
        YkDrag *drag = NULL;
        for (long at = 0; !drag; at++) {
            assert_int_equal(live, before);
            countdown = at;
            drag = yk_drag_new(m.state, 2, place, k ? hold : NULL);
            countdown = -1;
            assert_true(drag ? at > 3 : at < 100);
        }
        long asked = requests;
        for (int j = 0; j < 30; j++) {
            double target[2] = {2 * cos(0.7 * j), 2 * sin(0.7 * j)};
            assert_int_equal(yk_state_drag(drag, target, NULL), YK_OK);
        }
        assert_int_equal(requests, asked);
        yk_drag_free(drag);
        assert_int_equal(live, before);
    }
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(four_bars_follow_to_the_nearest_pose),
        cmocka_unit_test(slider_cranks_follow_to_the_nearest_pose),
        cmocka_unit_test(a_point_on_a_circle_turns_towards_the_target),
        cmocka_unit_test(a_stop_ends_the_drag),
        cmocka_unit_test(change_points_are_passed),
        cmocka_unit_test(five_bars_follow_with_two_inputs),
        cmocka_unit_test(an_arm_reaches_what_it_can),
        cmocka_unit_test(dragging_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

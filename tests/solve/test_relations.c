// Gears, belts, racks, cams and laws: closed forms, rates against differences, residuals that show a miss; poses
// adopted.
#include "machine.h"
#include "solve/state.h"

static const char *const wheels =
    "bodies:\n  ground: {points: {A: [0, 0], B: [1, 0], C: [1.5, 0], D: [3, 0], E: [4, 0], F: [9, 9], O: [0, 0], G: "
    "[0, -0.03]}}\n"
    "  a: {points: {A: [0, 0]}}\n  b: {points: {B: [0, 0]}}\n  c: {points: {C: [0, 0]}}\n  d: {points: {D: [0, 0]}}\n"
    "  e: {points: {E: [0, 0]}}\n  f: {points: {F: [0, 0]}}\n  arm: {points: {O: [0, 0], P: [2, 0]}}\n"
    "  planet: {points: {P: [0, 0]}}\n  bar: {}\n  other: {}\n  lift: {}\n"
    "joints:\n  A: {pin: [ground, a], angle: a}\n  B: {pin: [ground, b], angle: b}\n  C: {pin: [ground, c], angle: c}\n"
    "  D: {pin: [ground, d], angle: d}\n  E: {pin: [ground, e], angle: e}\n  F: {pin: [ground, f], angle: f}\n"
    "  O: {pin: [ground, arm], angle: arm}\n  P: {pin: [arm, planet], angle: p}\n"
    "  R: {slide: [ground, bar], along: x, from: G, distance: r}\n  S: {slide: [ground, other], along: y, distance: "
    "s}\n"
    "  T: {slide: [ground, lift], along: y, distance: h}\n"
    "laws:\n  rise: {period: 2*pi, segments: [{formula: {to: 2*pi, s: 5 mm*(1 - cos(x))}}]}\n"
    "  line: {table: [[-1000, -3000], [1000, 3000]], between: linear}\n"
    "gears:\n  ab: {mesh: [a, b], teeth: [20, 30]}\n  bc: {mesh: [b, c], teeth: [17, 51], internal: true}\n"
    "  ap: {mesh: [a, planet], teeth: [20, 15], carrier: arm}\n"
    "belts:\n  cd: {between: [c, d], radii: [40 mm, 100 mm]}\n"
    "  de: {between: [d, e], radii: [60 mm, 20 mm], crossed: true}\n"
    "racks: {ar: {pinion: a, rack: bar, radius: 30 mm}}\n"
    "drives: {a: 0.3 rad + 2 rad/s * t, arm: 0.1 rad + 0.5 rad/s * t, h: {law: rise, of: a}, s: {law: line, of: "
    "r}}\n";

static YkMotion value_of(const Machine *m, const char *name)
{
    return yk_state_coordinate(m->state, yk_coordinate_find(m->mech, name));
}

static void check_ratio(const Machine *m, const char *name, double ratio, YkMotion by, double start)
{
    YkMotion found = value_of(m, name);
    if (!(fabs(found.position - start - ratio * by.position) <= 1e-12 * (1 + fabs(by.position))))
        print_error("%s\n", name);
    CHECK_NEAR(found.position - start, ratio * by.position, 1e-12 * (1 + fabs(by.position)));
    CHECK_NEAR(found.velocity, ratio * by.velocity, 1e-13 * (1 + fabs(by.velocity)));
    CHECK_NEAR(found.acceleration, ratio * by.acceleration, 1e-13 * (1 + fabs(by.acceleration)));
}

static void wheels_turn_by_their_ratios(void **unused)
{
    (void)unused;
    static const char *const names[] = {"b", "c", "d", "e", "r"};
    static const double ratios[] = {-2.0 / 3, -2.0 / 9, -4.0 / 45, 4.0 / 15, 0};
    Machine m = machine_parse(wheels, true);
    YkMotion a0 = value_of(&m, "a"), arm0 = value_of(&m, "arm"), p0 = value_of(&m, "p"), r0 = value_of(&m, "r");
    double start[5];
    for (int k = 0; k < 5; k++) start[k] = value_of(&m, names[k]).position;
    for (int k = -30; k <= 30; k++) {
        assert_int_equal(yk_state_set_time(m.state, 0.7 * k, m.problems), YK_OK);
        for (size_t i = 0; i < yk_input_count(m.mech); i++) { // with an acceleration, too
            YkMotion in = yk_state_input(m.state, i);
            in.acceleration += 0.3 * (double)(i + 1);
            yk_state_set_input(m.state, i, in);
        }
        assert_true(yk_state_solve(m.state) >= 0);
        YkMotion a = value_of(&m, "a"), arm = value_of(&m, "arm"), p = value_of(&m, "p");
        YkMotion by = {a.position - a0.position, a.velocity, a.acceleration};
        for (int j = 0; j < 4; j++) check_ratio(&m, names[j], ratios[j], by, start[j]);
        double side = (value_of(&m, "r").velocity > 0) == (a.velocity > 0) ? 0.03 : -0.03;
        check_ratio(&m, "r", side, by, r0.position);
        // Willis: (a - arm) 20 = -(planet - arm) 15, and p is planet - arm.
        YkMotion about = {a.position - a0.position - arm.position + arm0.position, a.velocity - arm.velocity,
                          a.acceleration - arm.acceleration};
        check_ratio(&m, "p", -4.0 / 3, about, p0.position);
        assert_true(fabs(p.velocity) > 0.1);
        YkResiduals r = yk_state_residuals(m.state);
        CHECK_NEAR(r.position, 0, 1e-12);
        CHECK_NEAR(r.velocity, 0, 1e-12);
        CHECK_NEAR(r.acceleration, 0, 1e-12);
    }
    machine_free(&m);
}

// h = 5 mm (1 - cos a) and s = 3 r, as laws that follow.
static void laws_follow_what_they_are_of(void **unused)
{
    (void)unused;
    Machine m = machine_parse(wheels, true);
    for (int k = -10; k <= 10; k++) {
        assert_int_equal(yk_state_set_time(m.state, 0.7 * k, m.problems), YK_OK);
        for (size_t i = 0; i < yk_input_count(m.mech); i++) {
            YkMotion in = yk_state_input(m.state, i);
            in.acceleration += 0.4;
            yk_state_set_input(m.state, i, in);
        }
        assert_true(yk_state_solve(m.state) >= 0);
        YkMotion a = value_of(&m, "a"), r = value_of(&m, "r"), h = value_of(&m, "h"), s = value_of(&m, "s");
        CHECK_NEAR(h.position, 0.005 * (1 - cos(a.position)), 1e-15);
        CHECK_NEAR(h.velocity, 0.005 * sin(a.position) * a.velocity, 1e-14);
        CHECK_NEAR(h.acceleration,
                   0.005 * (cos(a.position) * a.velocity * a.velocity + sin(a.position) * a.acceleration), 1e-13);
        for (size_t j = 0; j < m.mech->relation_count; j++) { // the slopes that forces take
            double gain = m.state->space.gain[j * m.state->space.stride];
            if (strcmp(m.mech->relations[j].name, "h") == 0) CHECK_NEAR(gain, 0.005 * sin(a.position), 1e-14);
            if (strcmp(m.mech->relations[j].name, "s") == 0) CHECK_NEAR(gain, 3, 1e-13);
        }
        CHECK_NEAR(s.position, 3 * r.position, 1e-12);
        CHECK_NEAR(s.velocity, 3 * r.velocity, 1e-13);
        CHECK_NEAR(s.acceleration, 3 * r.acceleration, 1e-12);
    }
    machine_free(&m);
}

// Wheels whose start gives them phases miss nothing either, at any time.
static void phases_are_no_miss(void **unused)
{
    (void)unused;
    char text[4000];
    snprintf(text, sizeof text, "%sstart: {b: 1.1, c: -0.7, d: 0.4, e: 2.3, p: 0.9, r: 0.37}\n", wheels);
    Machine m = machine_parse(text, true);
    for (int k = -20; k <= 20; k++) {
        assert_int_equal(yk_state_set_time(m.state, 0.6 * k, m.problems), YK_OK);
        assert_true(yk_state_solve(m.state) >= 0);
        CHECK_NEAR(yk_state_residuals(m.state).position, 0, 1e-12);
        CHECK_NEAR(yk_state_residuals(m.state).velocity, 0, 1e-12);
    }
    machine_free(&m);
}

// What is moved away by hand misses its relation, in position, rate and acceleration.
static void residuals_tell_a_miss(void **unused)
{
    (void)unused;
    Machine m = machine_parse(wheels, true);
    YkSpace *space = &m.state->space;
    for (int32_t k = 1; k < (int32_t)m.mech->orientation_count; k++) {
        int32_t body = m.mech->orientation_body[k];
        if (strcmp(m.model->bodies[body].name, "f") == 0) continue; // on its own
        YkTurn t = yk_space_turn(space, k);
        double c = *t.c, s = *t.s, w = *t.w, a = *t.a;
        *t.c = c * cos(0.01) - s * sin(0.01), *t.s = s * cos(0.01) + c * sin(0.01);
        bool is_driven = strcmp(m.model->bodies[body].name, "a") == 0 || strcmp(m.model->bodies[body].name, "arm") == 0;
        assert_true(is_driven || yk_state_residuals(m.state).position > 1e-4); // a drive's angle is what is asked
        *t.c = c, *t.s = s, *t.w = w + 0.01;
        assert_true(yk_state_residuals(m.state).velocity > 1e-4);
        *t.w = w, *t.a = a + 0.01;
        assert_true(yk_state_residuals(m.state).acceleration > 1e-4);
        *t.a = a;
    }
    for (int32_t k = 0; k < (int32_t)m.mech->distance_count; k++) {
        YkSlide d = yk_space_slide(space, k);
        double at = *d.d, v = *d.v, a = *d.a;
        *d.d = at + 0.01;
        assert_true(yk_state_residuals(m.state).position > 1e-4);
        *d.d = at, *d.v = v + 0.01;
        assert_true(yk_state_residuals(m.state).velocity > 1e-4);
        *d.v = v, *d.a = a + 0.01;
        assert_true(yk_state_residuals(m.state).acceleration > 1e-4);
        *d.a = a;
    }
    CHECK_NEAR(yk_state_residuals(m.state).position, 0, 1e-12);
    machine_free(&m);
}

// What a wheel is off by counts the same however far it has turned.
static void a_miss_is_the_same_after_many_turns(void **unused)
{
    (void)unused;
    Machine m = machine_parse(wheels, true);
    double due[4];
    for (int k = 0; k < 3; k++) {
        assert_int_equal(yk_state_set_time(m.state, 40 * k, m.problems), YK_OK);
        assert_true(yk_state_solve(m.state) >= 0);
        for (int32_t wheel = 0; wheel < 4; wheel++) {
            YkTurn t = yk_space_turn(&m.state->space, m.mech->bodies[2 + wheel].orientation);
            YkVec kept = yk_vec(*t.c, *t.s), off = yk_mul(kept, yk_unit(0.01));
            *t.c = off.x, *t.s = off.y;
            double miss = yk_state_residuals(m.state).position;
            if (k == 0) due[wheel] = miss;
            CHECK_NEAR(miss, due[wheel], 1e-9);
            *t.c = kept.x, *t.s = kept.y;
        }
    }
    machine_free(&m);
}

// Loops determine angles only up to whole turns, and a whole turn does not enter a belt's equation as a whole number.
static void whole_turns_are_no_miss_and_their_parts_are(void **unused)
{
    (void)unused;
    Machine m = machine_parse(
        "bodies:\n  ground: {points: {A: [0, 0], D: [3, 0]}}\n  a: {points: {A: [0, 0], B: [1, 0]}}\n"
        "  b: {points: {B: [0, 0], C: [3, 0]}}\n  c: {points: {C: [0, 0], D: [2, 0]}}\n  w: {points: {B: [0, 0]}}\n"
        "joints:\n  A: {pin: [ground, a], angle: x}\n  B: {pin: [a, b], angle: y}\n  D: {pin: [ground, c], angle: z}\n"
        "  C: {pin: [b, c]}\n  W: {pin: [b, w], at: B, angle: p}\n"
        "belts: {g: {between: [c, w], radii: [0.11, 0.07], carrier: b}}\nstart: {y: -50 deg, z: 220 deg}\n"
        "drives: {x: 60 deg}\n",
        true);
    double *reference = &m.state->reference[yk_coordinate_find(m.mech, "p")];
    for (int turns = -5; turns <= 5; turns++) {
        *reference += turns * 2 * YK_PI;
        CHECK_NEAR(yk_state_residuals(m.state).position, 0, 1e-12);
        *reference -= turns * 2 * YK_PI;
    }
    YkTurn t = yk_space_turn(&m.state->space, m.mech->bodies[4].orientation);
    YkVec wheel = yk_vec(*t.c, *t.s);
    for (int part = 1; part < 64; part++) {
        YkVec off = yk_mul(wheel, yk_unit(part * 2 * YK_PI / 64));
        *t.c = off.x, *t.s = off.y;
        assert_true(yk_state_residuals(m.state).position > 1e-3);
    }
    machine_free(&m);
}

// A drag link whose rocker turns right round, and a wheel that meshes with the rocker: at 20 : 60 a whole turn of the
// rocker is a third of the wheel's, so that the wheel shows which turn the start means.
static void a_start_that_is_turns_away_counts_its_turns(void **unused)
{
    (void)unused;
    static const char text[] =
        "parameters: {turns: 0 rad}\nbodies:\n  ground: {points: {O: [0, 0], Q: [1, 0], W: [3, 3]}}\n"
        "  crank: {points: {O: [0, 0], A: [2, 0]}}\n  coupler: {points: {A: [0, 0], B: [1.8, 0]}}\n"
        "  rocker: {points: {Q: [0, 0], B: [2.2, 0]}}\n  wheel: {points: {W: [0, 0]}}\njoints:\n"
        "  O: {pin: [ground, crank], angle: th}\n  A: {pin: [crank, coupler], angle: u}\n"
        "  Q: {pin: [ground, rocker], angle: ps}\n  W: {pin: [ground, wheel], angle: w}\n  B: {pin: [coupler, "
        "rocker]}\n"
        "gears: {g: {mesh: [rocker, wheel], teeth: [20, 60]}}\ndrives: {th: 0.5}\nstart: {ps: 1.5 rad + turns}\n";
    for (int turn = -7; turn <= 7; turn++) {
        char value[40];
        snprintf(value, sizeof value, "%.17g rad", 2 * YK_PI * turn);
        YkOverride override = {.name = "turns", .value = value};
        Machine m = machine_parse_with(text, &override, 1);
        assert_true(yk_state_assemble(m.state) >= 0);
        YkMotion ps = value_of(&m, "ps");
        assert_true(fabs(ps.position - 2 * YK_PI * turn - 1.5) < YK_PI);
        CHECK_NEAR(remainder(value_of(&m, "w").position + ps.position / 3, 2 * YK_PI), 0, 1e-12);
        double turned = ps.position; // answers stay within half a turn of the start: counted here
        for (int k = 1; k <= 40; k++) {
            assert_true(machine_solve(&m, 0.5 + 0.4 * k, 1, 0) >= 0);
            turned += remainder(value_of(&m, "ps").position - turned, 2 * YK_PI);
            CHECK_NEAR(remainder(value_of(&m, "w").position + turned / 3, 2 * YK_PI), 0, 1e-12);
        }
        assert_true(turned - ps.position > 13);
        machine_free(&m);
    }
}

// d/dt along q + v t + a t^2 / 2 by central differences of the eighth order, of positions and of rates.
static void check_differences(Machine m, const char *example, uint64_t *seed)
{
    static const double weight[] = {4.0 / 5, -1.0 / 5, 4.0 / 105, -1.0 / 280}, h = 1e-3;
    size_t n = yk_input_count(m.mech), count = yk_coordinate_count(m.mech);
    YkMotion *base = calloc(n + 1, sizeof *base), *at = calloc(count + 1, sizeof *at);
    double *v = calloc(count + 1, sizeof *v), *a = calloc(count + 1, sizeof *a);
    assert_true(base && at && v && a);
    for (size_t i = 0; i < n; i++) {
        base[i] = yk_state_input(m.state, i);
        base[i].velocity = check_uniform(seed, -1, 1);
        base[i].acceleration = check_uniform(seed, -1, 1);
    }
    for (int k = -4; k <= 5; k++) {
        double t = k == 5 ? 0 : k * h;
        if (k == 0) continue;
        for (size_t i = 0; i < n; i++)
            yk_state_set_input(m.state, i,
                               (YkMotion){base[i].position + t * (base[i].velocity + t * base[i].acceleration / 2),
                                          base[i].velocity + t * base[i].acceleration, base[i].acceleration});
        assert_true(yk_state_solve(m.state) >= 0);
        for (size_t c = 0; c < count; c++) {
            YkMotion q = yk_state_coordinate(m.state, c);
            if (k == 5) at[c] = q;
            if (k == 5) continue;
            double w = (k > 0 ? 1 : -1) * weight[(k > 0 ? k : -k) - 1] / h;
            v[c] += w * q.position;
            a[c] += w * q.velocity;
        }
    }
    for (size_t c = 0; c < count; c++) {
        double size = 1 + fabs(at[c].position) + fabs(at[c].velocity) + fabs(at[c].acceleration);
        if (!(fabs(v[c] - at[c].velocity) <= 1e-8 * size && fabs(a[c] - at[c].acceleration) <= 1e-8 * size))
            print_error("%s: coordinate %zu\n", example, c);
        CHECK_NEAR(v[c], at[c].velocity, 1e-8 * size);
        CHECK_NEAR(a[c], at[c].acceleration, 1e-8 * size);
    }
    free(base), free(at), free(v), free(a);
    machine_free(&m);
}

static void rates_are_differences_of_positions(void **unused)
{
    (void)unused;
    static const char *const examples[] = {"geared-five-bar", "epicyclic-drive", "epicyclic",     "ferguson",
                                           "planetary-gear",  "reverted-train",  "gearbox-8hp70", "two-rings",
                                           "swing-arm",       "formula-cam"};
    uint64_t seed = 41;
    for (size_t k = 0; k < sizeof examples / sizeof *examples; k++)
        check_differences(machine_load(examples[k]), examples[k], &seed);
}

// A four-bar that a wheel on the crank's axis drives: a belt, a pair of gears or a law ties the wheel to the coupler or
// the rocker as the crank carries them, so that the loop and the relation are solved together.
static void rates_of_loops_that_wheels_drive_are_differences(void **unused)
{
    (void)unused;
    static const char *const ties[] = {
        "belts: {g: {between: [wheel, coupler], radii: [0.3, 0.2], carrier: crank}}\ndrives: {q: 0.4}\n",
        "belts: {g: {between: [wheel, coupler], radii: [0.1, 0.3], carrier: crank, crossed: true}}\n"
        "drives: {q: 0.4}\n",
        "gears: {g: {mesh: [wheel, coupler], teeth: [20, 50], carrier: crank}}\ndrives: {q: 0.4}\n",
        "laws: {swing: {table: [[-9, -13], [0, 0.5], [2, 3], [9, 13]], between: cubic}}\n"
        "drives: {q: {law: swing, of: v}}\ngears: {g: {mesh: [wheel, coupler], teeth: [20, 50], carrier: crank}}\n"};
    uint64_t seed = 7;
    for (size_t k = 0; k < sizeof ties / sizeof *ties; k++) {
        char text[2000];
        snprintf(text, sizeof text,
                 "bodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n  wheel: {points: {O: [0, 0]}}\n"
                 "  crank: {points: {O: [0, 0], A: [0.7, 0]}}\n  coupler: {points: {A: [0, 0], B: [2, 0]}}\n"
                 "  rocker: {points: {Q: [0, 0], B: [1.5, 0]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"
                 "  W: {pin: [ground, wheel], at: O, angle: q}\n  A: {pin: [crank, coupler], angle: u}\n"
                 "  Q: {pin: [ground, rocker], angle: v}\n  B: {pin: [coupler, rocker]}\n%s"
                 "start: {th: 1, u: -0.4, v: 1.7, q: 0.4}\n",
                 ties[k]);
        Machine m = machine_parse(text, true);
        assert_true(m.mech->has_groups);
        check_differences(m, ties[k], &seed);
    }
}

// --- poses adopted by a machine with another input

static void a_pose_is_adopted_where_it_closes(void **unused)
{
    (void)unused;
    Machine from = machine_load("four-bar");
    size_t count = yk_coordinate_count(from.mech);
    for (int k = 0; k < 12; k++) {
        assert_true(machine_solve(&from, 0.5 * k, 1, 0) >= 0);
        Machine to = machine_open("four-bar", NULL);
        assert_int_equal(yk_state_adopt(to.state, from.state), YK_OK);
        for (size_t c = 0; c < count; c++)
            CHECK_NEAR(yk_state_coordinate(to.state, c).position, yk_state_coordinate(from.state, c).position, 1e-12);
        from.state->time = 2.5;
        assert_int_equal(yk_state_adopt(to.state, from.state), YK_OK);
        assert_true(to.state->time == 2.5);
        from.state->time = 0;
        machine_free(&to);
    }
    Machine other = machine_load("slider-crank"), four = machine_open("four-bar", NULL);
    if (yk_coordinate_count(other.mech) != count)
        assert_int_equal(yk_state_adopt(four.state, other.state), YK_BAD_ARGUMENT);
    Machine empty = machine_open("four-bar", NULL);
    assert_int_equal(yk_state_adopt(four.state, empty.state), YK_BAD_ARGUMENT); // it has no pose
    machine_free(&empty);
    machine_free(&other);
    machine_free(&four);
    machine_free(&from);
}

// A machine of slightly other dimensions takes a pose that is almost its own, and no other.
static void a_pose_is_not_adopted_where_it_does_not_close(void **unused)
{
    (void)unused;
    static const char *const text =
        "parameters: {b: 2.5}\nbodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"
        "  crank: {points: {O: [0, 0], A: [0.7, 0]}}\n  coupler: {points: {A: [0, 0], B: [b, 0]}}\n"
        "  rocker: {points: {Q: [0, 0], B: [1.8, 0]}}\njoints:\n  O: {pin: [ground, crank], angle: q}\n"
        "  A: {pin: [crank, coupler], angle: u}\n  Q: {pin: [ground, rocker], angle: v}\n  B: {pin: [coupler, "
        "rocker]}\n"
        "drives: {q: 1 rad}\nstart: {u: -0.4, v: 1.3}\n";
    static const struct {
        const char *length;
        bool closes;
    } cases[] = {{"2.5 m", true},   {"2.5 m + 1e-7 m", true}, {"2.5 m - 1e-7 m", true},
                 {"2.55 m", false}, {"2.4 m", false},         {"9 m", false}};
    Machine from = machine_parse(text, true);
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkOverride other = {.name = "b", .value = cases[k].length};
        Machine to = machine_parse_with(text, &other, 1);
        YkStatus status = yk_state_adopt(to.state, from.state);
        assert_int_equal(status, cases[k].closes ? YK_OK : YK_NO_ASSEMBLY);
        machine_free(&to);
    }
    machine_free(&from);
}

// Belts that repeat one that closes a geared linkage leave the start what it is, whatever turns the wheel has made.
static void repeated_belts_leave_the_start_nearest(void **unused)
{
    (void)unused;
    static const char drag_link[] = "bodies:\n"
                                    "  ground: {points: {A: [0, 0], D: [1, 0], P: [4, 4]}}\n"
                                    "  crank: {points: {A: [0, 0], B: [3, 0]}}\n"
                                    "  coupler: {points: {B: [0, 0], C: [3.5, 0]}}\n"
                                    "  sun: {points: {D: [0, 0], C: [2.9, 0]}}\n"
                                    "  wheel: {points: {P: [0, 0]}}\n"
                                    "joints:\n"
                                    "  A: {pin: [ground, crank], angle: th}\n"
                                    "  D: {pin: [ground, sun], angle: phi}\n"
                                    "  B: {pin: [crank, coupler], angle: be}\n"
                                    "  C: {pin: [coupler, sun]}\n"
                                    "  P: {pin: [ground, wheel], angle: q}\n"
                                    "start: {th: -2.82, be: 2.27248, phi: -1.87109}\n"
                                    "belts:\n"
                                    "  m0: {between: [wheel, crank], radii: [0.03125, 0.03125], crossed: true}\n"
                                    "  m1: {between: [sun, wheel], radii: [0.09375, 0.140625]}\n";
    static const char *const repeated[] = {"", "  m2: {between: [sun, wheel], radii: [0.09375, 0.140625]}\n",
                                           "  m2: {between: [sun, wheel], radii: [0.1875, 0.28125]}\n"};
    for (size_t k = 0; k < 3; k++) {
        char text[2000];
        snprintf(text, sizeof text, "%s%s", drag_link, repeated[k]);
        Machine m = machine_parse(text, false);
        YkState *state = m.state;
        assert_int_equal(yk_state_assemble(state), k == 0 ? YK_OK : YK_REDUNDANT);
        double th = yk_state_coordinate(state, yk_coordinate_find(m.mech, "th")).position;
        double phi = yk_state_coordinate(state, yk_coordinate_find(m.mech, "phi")).position;
        double x = 1 + 2.9 * cos(phi) - 3 * cos(th), y = 2.9 * sin(phi) - 3 * sin(th);
        CHECK_NEAR(hypot(x, y), 3.5, 1e-9);                          // the loop
        CHECK_NEAR(remainder(2 * phi + 3 * th, 2 * YK_PI), 0, 1e-9); // the belts
        CHECK_NEAR(th, -2.82, 0.1);
        CHECK_NEAR(phi, -1.87109, 0.1);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(wheels_turn_by_their_ratios),
        cmocka_unit_test(laws_follow_what_they_are_of),
        cmocka_unit_test(phases_are_no_miss),
        cmocka_unit_test(residuals_tell_a_miss),
        cmocka_unit_test(a_miss_is_the_same_after_many_turns),
        cmocka_unit_test(whole_turns_are_no_miss_and_their_parts_are),
        cmocka_unit_test(a_start_that_is_turns_away_counts_its_turns),
        cmocka_unit_test(rates_are_differences_of_positions),
        cmocka_unit_test(rates_of_loops_that_wheels_drive_are_differences),
        cmocka_unit_test(a_pose_is_adopted_where_it_closes),
        cmocka_unit_test(a_pose_is_not_adopted_where_it_does_not_close),
        cmocka_unit_test(repeated_belts_leave_the_start_nearest),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

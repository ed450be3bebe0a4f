// Gear trains against the books, and the books' methods against each other.
#include "design/train_check.h"

#define OPTIONS(...) (&(YkTrainOptions){.efficiency = 1, __VA_ARGS__})

static void the_train_of_the_format_has_its_exact_ring_speed(void **state)
{
    (void)state;
    Train t = train_example("epicyclic", NULL);
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_OK);
    assert_int_equal(yk_train_freedom(t.train), 2);
    assert_string_equal(train_body(&t, "ring").exact, "460/29 rpm");
    CHECK_NEAR(train_body(&t, "ring").speed, 460.0 / 29 * RPM, 1e-15);
    assert_string_equal(train_body(&t, "planet").exact, "5 rpm");
    assert_string_equal(train_share(&t, "ring", 0).formula, "1 + N1*N3/(N2*N4)"); // of the arm
    assert_string_equal(train_share(&t, "ring", 1).formula, "-N1*N3/(N2*N4)");    // of the sun
    assert_string_equal(train_share(&t, "ring", 0).exact, "35/29");
    assert_string_equal(yk_train_mesh(t.train, 1).willis, "(planet - arm)*N3 = (ring - arm)*N4");
    CHECK_NEAR(yk_train_mesh(t.train, 1).distance, 0.063, 1e-15);
    CHECK_NEAR(yk_train_mesh(t.train, 0).radius[0], 0.027, 1e-15);
    train_done(&t);
}

static void a_gearbox_has_all_its_ratios_from_one_file(void **state)
{
    (void)state;
    static const char *const ratios[] = {"108/23", "72/23",   "162/77", "5/3",      "8826/6871",
                                         "1",      "120/143", "2/3",    "-1744/529"};
    Train t = train_example("gearbox-8hp70", OPTIONS(.in = "input", .out = "output"));
    assert_int_equal(yk_train_gear_count(t.train), 9);
    for (size_t i = 0; i < 9; i++) {
        YkTrainGear gear = yk_train_gear(t.train, i);
        assert_int_equal(gear.status, YK_TRAIN_STATUS_OK);
        assert_int_equal(gear.freedom, 1);
        assert_string_equal(gear.ratio.exact, ratios[i]);
        assert_non_null(gear.ratio.formula);
        Train one = train_example("gearbox-8hp70", OPTIONS(.lock = gear.lock));
        assert_int_equal(yk_train_status(one.train), YK_TRAIN_STATUS_OK);
        CHECK_NEAR(train_body(&one, "output").speed * gear.ratio.value, 1000 * RPM, 1e-11);
        train_done(&one);
    }
    assert_string_equal(yk_train_gear(t.train, 0).ratio.formula, "1 + R4/S4");
    assert_string_equal(yk_train_gear(t.train, 1).ratio.formula, "R2*(S4 + R4)/(S4*(S2 + R2))");
    train_done(&t);
}

static void the_simple_planetary_set_has_all_its_ratios(void **state)
{
    (void)state;
    const struct {
        const char *in, *out, *lock, *exact, *formula;
    } cases[] = {
        {"sun", "arm", "ring-held", "27/10", "1 + Zr/Zs"},    {"ring", "arm", "sun-held", "27/17", "1 + Zs/Zr"},
        {"arm", "ring", "sun-held", "17/27", "Zr/(Zs + Zr)"}, {"arm", "sun", "ring-held", "10/27", "Zs/(Zs + Zr)"},
        {"sun", "ring", "arm-held", "-17/10", "-Zr/Zs"},      {"sun", "ring", "direct", "1", "1"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Train t =
            train_example("simple-planetary", OPTIONS(.in = cases[i].in, .out = cases[i].out, .lock = cases[i].lock));
        YkTrainRatio ratio = yk_train_ratio(t.train);
        assert_true(ratio.is_known);
        assert_string_equal(ratio.exact, cases[i].exact);
        assert_string_equal(ratio.formula, cases[i].formula);
        train_done(&t);
    }
}

static void fergusons_wheels_creep_against_each_other(void **state)
{
    (void)state;
    Train t = train_example("ferguson", NULL);
    assert_string_equal(train_body(&t, "sun2").exact, "0 rpm");
    assert_string_equal(train_body(&t, "sun3").exact, "-100/99 rpm");
    assert_string_equal(train_body(&t, "sun4").exact, "100/101 rpm");
    assert_string_equal(train_share(&t, "sun3", 0).formula, "1 - N2/N3");
    train_done(&t);
}

// --- Khurmi and Gupta, Theory of Machines, chapter 13
// ---------------------------------------------------------------------

#define COAXIAL(name) #name ": {pin: [ground, " #name "], angle: q_" #name "}\n  "
#define ON_ARM(name) #name ": {pin: [arm, " #name "], at: P}\n  "
#define ARM "arm: {points: {P: [1, 0]}}"

static void textbook(const char *text, const YkTrainOptions *options, const char *body, const char *exact)
{
    Train t = train_of(text, options);
    YkTrainBody b = train_body(&t, body);
    if (!b.exact || strcmp(b.exact, exact) != 0) print_error("%s%s: %s, expected %s\n", text, body, b.exact, exact);
    assert_non_null(b.exact);
    assert_string_equal(b.exact, exact);
    train_done(&t);
}

static void the_compound_train_of_example_13_1(void **state)
{
    (void)state;
    textbook("bodies: {ground: {points: {b: [1, 0], d: [2, 0], f: [3, 0]}}, A: {}, BC: {}, DE: {}, F: {}}\n"
             "joints: {a: {pin: [ground, A], angle: q}, b: {pin: [ground, BC]}, d: {pin: [ground, DE]}, f: {pin: "
             "[ground, F]}}\n"
             "gears: {ab: {mesh: [A, BC], teeth: [20, 50]}, cd: {mesh: [BC, DE], teeth: [25, 75]}, ef: {mesh: [DE, F], "
             "teeth: [26, 65]}}\n"
             "drives: {q: 975 rpm * t}\n",
             NULL, "F", "-52 rpm");
}

static void an_arm_with_two_wheels_of_example_13_4(void **state)
{
    (void)state;
    static const char *const drives[] = {"drives: {q_arm: 150 rpm * t, q_A: 0 rpm * t}\n",
                                         "drives: {q_arm: 150 rpm * t, q_A: -300 rpm * t}\n"};
    static const char *const answers[] = {"270 rpm", "510 rpm"};
    for (int k = 0; k < 2; k++) {
        char text[800];
        snprintf(text, sizeof text,
                 "bodies: {A: {}, B: {}, " ARM "}\njoints:\n  " COAXIAL(A) COAXIAL(arm)
                     ON_ARM(B) "\ngears: {g: {mesh: [A, B], teeth: [36, 45]}}\n%s",
                 drives[k]);
        textbook(text, NULL, "B", answers[k]);
    }
}

static void the_reverted_train_of_example_13_5(void **state)
{
    (void)state;
    Train t = train_example("reverted-train", OPTIONS(.lock = "fixed", .out = "wheelC"));
    assert_string_equal(train_body(&t, "wheelC").exact, "400 rpm");
    assert_string_equal(train_share(&t, "wheelC", 0).formula, "1 - B*D/(E*C)");
    assert_string_equal(yk_train_ratio(t.train).exact, "-1/4");
    train_done(&t);
}

#define SUN_RING(sun, planet, ring, drives)                                                                            \
    "bodies: {S: {}, P: {}, R: {}, " ARM "}\njoints:\n  " COAXIAL(S) COAXIAL(R) COAXIAL(arm)                           \
        ON_ARM(P) "\ngears: {s: {mesh: [S, P], teeth: [" #sun ", " #planet "]}, r: {mesh: [P, R], teeth: [" #planet    \
                  ", " #ring "], internal: true}}\ndrives: {" drives "}\n"

static void planetary_sets_of_examples_13_6_13_7_and_13_20(void **state)
{
    (void)state;
    textbook(SUN_RING(32, 20, 72, "q_R: 0 rpm * t, q_arm: 18 rpm * t"), NULL, "S", "117/2 rpm");
    textbook(SUN_RING(32, 20, 72, "q_R: 0 rpm * t, q_arm: 18 rpm * t"), NULL, "P", "-234/5 rpm");
    textbook(SUN_RING(40, 25, 90, "q_S: -1 rpm * t, q_R: 1/2 rpm * t"), NULL, "arm", "1/26 rpm");
    textbook(SUN_RING(40, 25, 90, "q_S: -1 rpm * t, q_R: 0 rpm * t"), NULL, "arm", "-4/13 rpm");
    Train t = train_of(SUN_RING(16, 24, 64, "q_S: 100 rpm * t") "locks: {E: [R]}\nefforts: {q_S: 100 N*m}\n",
                       OPTIONS(.lock = "E", .out = "arm"));
    assert_string_equal(yk_train_ratio(t.train).exact, "5");
    CHECK_NEAR(train_torque(&t, "arm").torque, -500, 1e-11);
    CHECK_NEAR(train_torque(&t, "R").torque, 400, 1e-11); // the torque that holds the annulus
    CHECK_NEAR(train_torque(&t, "q_S").power, 100 * 100 * RPM, 1e-9);
    train_done(&t);
}

// A ring welded to the ground is held as a locked one is, and the balance of the whole train asks for the same moment.
static void a_weld_to_the_ground_holds_as_a_lock_does(void **state)
{
    (void)state;
    static const char *const welds[] = {"W: {weld: [ground, R]}", "W: {weld: [R, ground]}"};
    for (int k = 0; k < 2; k++) {
        char text[1200];
        snprintf(
            text, sizeof text,
            "bodies: {S: {}, P: {}, R: {}, " ARM "}\njoints:\n  " COAXIAL(S) COAXIAL(arm) ON_ARM(
                P) "\n  %s\n"
                   "gears: {s: {mesh: [S, P], teeth: [16, 24]}, r: {mesh: [P, R], teeth: [24, 64], internal: true}}\n"
                   "drives: {q_S: 100 rpm * t}\nefforts: {q_S: 100 N*m}\n",
            welds[k]);
        Train t = train_of(text, OPTIONS(.out = "arm"));
        CHECK_NEAR(train_torque(&t, "R").torque, 400, 1e-11);
        CHECK_NEAR(train_torque(&t, "R").power, 0, 0);
        assert_string_equal(train_torque(&t, "R").role, "hold");
        double sum = 0;
        for (size_t i = 0; i < yk_train_torque_count(t.train); i++) sum += yk_train_torque(t.train, i).torque;
        CHECK_NEAR(sum, 0, 1e-10);
        train_done(&t);
    }
}

static void two_rings_and_a_compound_sun_of_example_13_8(void **state)
{
    (void)state;
    static const char *const answers[] = {"-900/217 rpm", "1180/217 rpm"};
    for (int k = 0; k < 2; k++) {
        char text[1200];
        snprintf(
            text, sizeof text,
            "bodies: {A: {}, B: {}, CD: {}, E: {}, F: {}, arm: {points: {P: [1, 0], Q: [2, 0]}}}\njoints:\n  " COAXIAL(
                A) COAXIAL(B) COAXIAL(CD) COAXIAL(arm)
                ON_ARM(E) "F: {pin: [arm, F], at: Q}\n"
                          "gears:\n"
                          "  ae: {mesh: [E, A], teeth: [18, 64], internal: true}\n"
                          "  ec: {mesh: [E, CD], teeth: [18, 28]}\n"
                          "  df: {mesh: [CD, F], teeth: [26, 18]}\n"
                          "  fb: {mesh: [F, B], teeth: [18, 62], internal: true}\n"
                          "drives: {q_arm: -100 rpm * t, q_A: %s}\n",
            k ? "10 rpm * t" : "0 rpm * t");
        textbook(text, NULL, "B", answers[k]);
    }
}

static void compound_planets_of_examples_13_10_13_11_13_14(void **state)
{
    (void)state;
    textbook(
        "bodies: {C: {}, DE: {}, G: {}, " ARM "}\njoints:\n  " COAXIAL(C) COAXIAL(G) COAXIAL(arm) ON_ARM(
            DE) "\ngears: {c: {mesh: [C, DE], teeth: [50, 20]}, g: {mesh: [DE, G], teeth: [35, 105], internal: true}}\n"
                "drives: {q_C: 110 rpm * t, q_G: 0 rpm * t}\n",
        NULL, "arm", "50 rpm");
    Train t = train_of(
        "bodies: {A: {}, BC: {}, E: {}, D: {}, " ARM
        "}\njoints:\n  " COAXIAL(A) COAXIAL(E) COAXIAL(D) COAXIAL(arm) ON_ARM(
            BC) "\ngears: {ab: {mesh: [A, BC], teeth: [12, 30]}, be: {mesh: [BC, E], teeth: [30, 72], internal: true}, "
                "cd: {mesh: [BC, D], teeth: [14, 56], internal: true}}\n"
                "drives: {q_A: -60 rpm * t, q_D: 300 rpm * t}\n",
        NULL);
    CHECK_NEAR(train_body(&t, "arm").speed, 27.98873455, 1e-8);
    CHECK_NEAR(train_body(&t, "E").speed, 33.70072119, 1e-8);
    train_done(&t);
    textbook("bodies: {ground: {points: {G: [3, 0]}}, H: {}, KL: {}, C: {}, G: {}, " ARM "}\njoints:\n  " COAXIAL(H)
                 COAXIAL(C) COAXIAL(arm)
                     ON_ARM(KL) "G: {pin: [ground, G]}\n  W: {weld: [ground, C]}\n"
                                "gears: {hk: {mesh: [H, KL], teeth: [40, 20]}, lc: {mesh: [KL, C], teeth: [30, 90], "
                                "internal: true}, fg: {mesh: [arm, G], teeth: [50, 80], carrier: ground}}\n"
                                "drives: {q_H: -400 rpm * t}\n",
             NULL, "G", "100 rpm");
}

static void a_drive_under_power_of_example_13_22(void **state)
{
    (void)state;
    Train t = train_of(
        "bodies: {sun: {}, planets: {}, Y: {}, X: {points: {P: [1, 0]}}}\njoints:\n  " COAXIAL(sun) COAXIAL(Y)
            COAXIAL(X) "P: {pin: [X, planets]}\n"
                       "gears: {s: {mesh: [sun, planets], teeth: [15, 20]}, y: {mesh: [planets, Y], teeth: [25, "
                       "60], internal: true}}\nlocks: {held: [sun]}\n"
                       "drives: {q_Y: 740 rad/s * t}\nefforts: {q_Y: 130 kW / 740 rad/s}\n",
        OPTIONS(.lock = "held", .out = "X"));
    assert_string_equal(train_body(&t, "X").exact, "11840/21 rad/s");
    CHECK_NEAR(train_torque(&t, "sun").torque, 8125.0 / 148, 1e-11); // the fixing torque
    CHECK_NEAR(yk_train_power(t.train).out, 130e3, 1e-7);
    train_done(&t);
}

// --- What else turns
// --------------------------------------------------------------------------------------------------------

static void belts_turn_wheels_by_their_radii(void **state)
{
    (void)state;
    for (int crossed = 0; crossed < 2; crossed++) {
        char text[600];
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {B: [1, 0]}}, a: {}, b: {}}\n"
                 "joints: {A: {pin: [ground, a], angle: q}, B: {pin: [ground, b]}}\n"
                 "belts: {belt: {between: [a, b], radii: [0.3, 70 mm], crossed: %s}}\ndrives: {q: 7 rpm * t}\n",
                 crossed ? "true" : "false");
        textbook(text, NULL, "b", crossed ? "-30 rpm" : "30 rpm");
        Train t = train_of(text, OPTIONS(.out = "b"));
        assert_string_equal(yk_train_ratio(t.train).formula, crossed ? "-r_b/r_a" : "r_b/r_a");
        train_done(&t);
    }
}

static void a_rack_moves_by_the_pinions_radius(void **state)
{
    (void)state;
    Train t =
        train_of("bodies: {ground: {points: {Q: [0, -40 mm]}}, pinion: {}, bar: {}}\n"
                 "joints: {A: {pin: [ground, pinion], angle: q}, S: {slide: [ground, bar], from: Q, distance: d}}\n"
                 "racks: {r: {pinion: pinion, rack: bar, radius: 40 mm}}\ndrives: {d: 0.2 m/s * t}\n"
                 "efforts: {d: 10 N}\n",
                 OPTIONS(.out = "pinion"));
    CHECK_NEAR(train_body(&t, "pinion").speed, 5, 1e-14);
    assert_string_equal(train_body(&t, "pinion").exact, "5 rad/s");
    CHECK_NEAR(yk_train_rack_speed(t.train, 0), 0.2, 1e-16);
    CHECK_NEAR(train_torque(&t, "pinion").torque, -0.4, 1e-15);
    CHECK_NEAR(yk_train_power(t.train).out, 2, 1e-14);
    train_done(&t);
}

static void a_ring_may_be_the_ground_itself(void **state)
{
    (void)state;
    textbook("bodies: {S: {}, P: {}, " ARM "}\njoints:\n  " COAXIAL(S) COAXIAL(arm)
                 ON_ARM(P) "\ngears: {s: {mesh: [S, P], teeth: [20, 20]}, r: {mesh: [P, ground], teeth: [20, 60], "
                           "internal: true}}\n"
                           "drives: {q_S: 100 rpm * t}\n",
             NULL, "arm", "25 rpm");
}

// --- Locked and open
// ------------------------------------------------------------------------------------------------------

static void a_locked_train_names_what_contradicts(void **state)
{
    (void)state;
    Train t = train_of(SUN_RING(16, 24, 64, "q_S: 100 rpm * t, q_R: 3 rpm * t, q_arm: 20 rpm * t"), NULL);
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_LOCKED);
    static const char *const names[] = {"`q_S`", "`q_R`", "`q_arm`", "gears `s`", "gears `r`"};
    for (size_t i = 0; i < 5; i++) assert_non_null(strstr(yk_train_message(t.train), names[i]));
    assert_false(train_body(&t, "S").is_determined);
    train_done(&t);
    t = train_of(SUN_RING(16, 24, 64, "q_S: 100 rpm * t") "locks: {all: [S, R]}\n", OPTIONS(.lock = "all"));
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_LOCKED);
    assert_non_null(strstr(yk_train_message(t.train), "hold of `S`"));
    assert_null(strstr(yk_train_message(t.train), "gears"));
    train_done(&t);
}

static void an_open_train_names_what_stays_open(void **state)
{
    (void)state;
    Train t = train_of(SUN_RING(16, 24, 64, "q_S: 100 rpm * t"), NULL);
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_UNDETERMINED);
    assert_int_equal(yk_train_freedom(t.train), 2);
    assert_non_null(strstr(yk_train_message(t.train), "`P`, `R` and `arm` stay open"));
    assert_non_null(strstr(yk_train_message(t.train), "1 more condition"));
    assert_true(train_body(&t, "S").is_determined);
    assert_true(isnan(train_body(&t, "arm").speed));
    train_done(&t);
    t = train_of(SUN_RING(16, 24, 64, ""), NULL);
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_FREE);
    train_done(&t);
}

static void drives_that_agree_are_no_contradiction(void **state)
{
    (void)state;
    Train t = train_of(SUN_RING(16, 24, 64, "q_S: 50 rpm * t, q_R: 0 rpm * t, q_arm: 10 rpm * t"), NULL);
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_OK);
    assert_string_equal(train_body(&t, "arm").exact, "10 rpm");
    train_done(&t);
    t = train_of(SUN_RING(16, 24, 64, "q_S: 50 rpm * t, q_R: 0 rpm * t") "locks: {held: [R]}\n",
                 OPTIONS(.lock = "held"));
    assert_int_equal(yk_train_status(t.train), YK_TRAIN_STATUS_OK);
    assert_string_equal(train_body(&t, "arm").exact, "10 rpm");
    train_done(&t);
}

static void questions_that_make_no_sense_are_refused(void **state)
{
    (void)state;
    const struct {
        YkTrainOptions options;
        int code;
    } cases[] = {
        {{.efficiency = 1, .lock = "second"}, YK_CODE_UNKNOWN_LOCK},
        {{.efficiency = 1, .in = "moon"}, YK_CODE_NOT_OF_TRAIN},
        {{.efficiency = 1, .out = "ground"}, YK_CODE_NOT_OF_TRAIN},
        {{.efficiency = 1.5}, YK_CODE_BAD_EFFICIENCY},
        {{.efficiency = 0}, YK_CODE_BAD_EFFICIENCY},
        {{.efficiency = 1, .efforts = &(YkTrainEffort){"q_moon", 1}, .effort_count = 1}, YK_CODE_NOT_A_COORDINATE}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Train t = train_ask(train_parse(SUN_RING(16, 24, 64, "q_S: 1 rpm * t, q_R: 0 rpm * t")), &cases[i].options);
        assert_null(t.train);
        assert_int_equal(yk_problems_get(t.problems, 0)->code, cases[i].code);
        train_done(&t);
    }
    Train t = train_ask(train_parse("bodies: {a: {}}\njoints: {A: {pin: [ground, a]}}\n"), NULL);
    assert_null(t.train);
    assert_int_equal(yk_problems_get(t.problems, 0)->code, YK_CODE_NO_TRAIN);
    train_done(&t);
}

// --- Other ways to the same
// ------------------------------------------------------------------------------------------------

static void the_tabular_method_gives_the_same_speeds(void **state)
{
    (void)state;
    static const char *const names[] = {"epicyclic", "ferguson", "reverted-train"};
    for (size_t n = 0; n < 3; n++) {
        Train t = train_example(names[n], n == 2 ? OPTIONS(.lock = "fixed") : NULL);
        assert_int_equal(yk_train_table_count(t.train), 1);
        YkTrainTable table = yk_train_table(t.train, 0);
        assert_true(table.has_speeds && table.exact_x && table.exact_y);
        for (size_t k = 0; k < table.count; k++) {
            double speed = train_body(&t, yk_model_body_name(t.model, table.body[k])).speed;
            CHECK_NEAR(table.turns_value[k] * table.x + table.y, speed, 1e-12);
        }
        train_done(&t);
    }
}

static void planets_are_spaced_equally_only_where_teeth_fit(void **state)
{
    (void)state;
    const struct {
        int sun, planet, ring, planets;
        const char *text;
        bool is_fault;
    } cases[] = {{20, 7, 34, 3, "(20 + 34)/3 is whole", false},
                 {20, 7, 34, 4, "(20 + 34)/4 is not whole", true},
                 {20, 40, 100, 6, "touch each other", true},
                 {60, 20, 100, 8, "(60 + 100)/8 is whole", false}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[900];
        bool is_told = false;
        snprintf(text, sizeof text,
                 "bodies: {S: {}, P: {}, R: {}, " ARM "}\njoints:\n  " COAXIAL(S) COAXIAL(R) COAXIAL(arm)
                     ON_ARM(P) "\ngears: {s: {mesh: [S, P], teeth: [%d, %d], planets: %d}, r: {mesh: [P, R], teeth: "
                               "[%d, %d], internal: "
                               "true}}\n",
                 cases[i].sun, cases[i].planet, cases[i].planets, cases[i].planet, cases[i].ring);
        Train t = train_of(text, NULL);
        for (size_t k = 0; k < yk_train_remark_count(t.train); k++) {
            YkTrainRemark remark = yk_train_remark(t.train, k);
            if (!strstr(remark.text, cases[i].text)) continue;
            is_told = true;
            assert_int_equal(remark.is_fault, cases[i].is_fault);
        }
        assert_true(is_told);
        train_done(&t);
    }
}

// At 20 deg a rack undercuts a gear of fewer than 17.1 teeth; in practice 17 are cut. Ring gears are not cut by racks.
static void small_gears_that_a_rack_cuts_are_undercut(void **state)
{
    (void)state;
    const struct {
        int teeth[2];
        bool is_internal;
        size_t remarks;
    } cases[] = {
        {{16, 17}, false, 1}, {{17, 16}, false, 1}, {{17, 18}, false, 0}, {{9, 10}, false, 2}, {{9, 16}, true, 1}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char text[600];
        size_t remarks = 0;
        snprintf(text, sizeof text,
                 "bodies: {ground: {points: {B: [1, 0]}}, a: {}, b: {}}\n"
                 "joints: {A: {pin: [ground, a]}, B: {pin: [ground, b]}}\n"
                 "gears: {g: {mesh: [a, b], teeth: [%d, %d], internal: %s}}\n",
                 cases[i].teeth[0], cases[i].teeth[1], cases[i].is_internal ? "true" : "false");
        Train t = train_of(text, NULL);
        for (size_t k = 0; k < yk_train_remark_count(t.train); k++)
            remarks += strstr(yk_train_remark(t.train, k).text, "undercut") != NULL;
        assert_int_equal(remarks, cases[i].remarks);
        train_done(&t);
    }
}

// Losses: power in = power out + loss, and a single pair of gears on the ground loses exactly its share.
static void losses_take_their_share_of_the_power(void **state)
{
    (void)state;
    const char *pair = "bodies: {ground: {points: {B: [1, 0]}}, a: {}, b: {}}\n"
                       "joints: {A: {pin: [ground, a], angle: q}, B: {pin: [ground, b]}}\n"
                       "gears: {g: {mesh: [a, b], teeth: [20, 30]}}\ndrives: {q: 10 rad/s * t}\nefforts: {q: 6 N*m}\n";
    Train t = train_of(pair, &(YkTrainOptions){.efficiency = 0.98, .out = "b"});
    CHECK_NEAR(train_torque(&t, "b").torque, 6 * 1.5 * 0.98, 1e-13);
    CHECK_NEAR(yk_train_power(t.train).efficiency, 0.98, 1e-14);
    CHECK_NEAR(yk_train_power(t.train).loss, 1.2, 1e-13);
    assert_int_equal(yk_train_mesh(t.train, 0).driver, 0);
    train_done(&t);
    // simple planetary, ring held: eta = (1 + eta0 zr/zs) / (1 + zr/zs) with both meshes' eta0 (Merritt)
    t = train_of(SUN_RING(16, 24, 64, "q_S: 100 rpm * t") "locks: {E: [R]}\nefforts: {q_S: 100 N*m}\n",
                 &(YkTrainOptions){.efficiency = 0.98, .lock = "E", .out = "arm"});
    CHECK_NEAR(yk_train_power(t.train).efficiency, (1 + 4 * 0.98 * 0.98) / 5, 1e-13);
    CHECK_NEAR(yk_train_power(t.train).in, yk_train_power(t.train).out + yk_train_power(t.train).loss, 1e-9);
    train_done(&t);
}

static void power_that_circulates_is_named(void **state)
{
    (void)state;
    // Ferguson's arm drives wheel 3 at 1/99 of its speed: nearly all power goes round
    Train t =
        train_of("bodies: {A: {}, B: {}, P: {}, " ARM "}\njoints:\n  " COAXIAL(A) COAXIAL(B) COAXIAL(arm)
                     ON_ARM(P) "\ngears: {a: {mesh: [A, P], teeth: [100, 20]}, b: {mesh: [B, P], teeth: [99, 20]}}\n"
                               "locks: {held: [A]}\ndrives: {q_arm: 100 rpm * t}\nefforts: {q_arm: 1 N*m}\n",
                 OPTIONS(.lock = "held", .out = "B"));
    YkTrainPower power = yk_train_power(t.train);
    assert_true(power.is_known && power.mesh);
    CHECK_NEAR(power.in, 100 * RPM, 1e-12);
    assert_true(power.circulating > 10 * power.in);
    CHECK_NEAR(train_torque(&t, "B").torque, 99, 1e-9);
    train_done(&t);
    // with losses it locks itself, driven from the slow side
    t = train_of("bodies: {A: {}, B: {}, P: {}, " ARM "}\njoints:\n  " COAXIAL(A) COAXIAL(B) COAXIAL(arm)
                     ON_ARM(P) "\ngears: {a: {mesh: [A, P], teeth: [100, 20]}, b: {mesh: [B, P], teeth: [99, 20]}}\n"
                               "locks: {held: [A]}\ndrives: {q_B: -1 rpm * t}\nefforts: {q_B: -1 N*m}\n",
                 &(YkTrainOptions){.efficiency = 0.98, .lock = "held", .out = "arm"});
    assert_int_equal(yk_problems_get(t.problems, 0)->code, YK_CODE_SELF_LOCKING);
    assert_true(train_torque(&t, "arm").power > 0 && train_torque(&t, "q_B").power > 0);
    CHECK_NEAR(yk_train_power(t.train).in, yk_train_power(t.train).loss, 1e-12);
    train_done(&t);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_train_of_the_format_has_its_exact_ring_speed),
        cmocka_unit_test(a_gearbox_has_all_its_ratios_from_one_file),
        cmocka_unit_test(the_simple_planetary_set_has_all_its_ratios),
        cmocka_unit_test(fergusons_wheels_creep_against_each_other),
        cmocka_unit_test(the_compound_train_of_example_13_1),
        cmocka_unit_test(an_arm_with_two_wheels_of_example_13_4),
        cmocka_unit_test(the_reverted_train_of_example_13_5),
        cmocka_unit_test(planetary_sets_of_examples_13_6_13_7_and_13_20),
        cmocka_unit_test(a_weld_to_the_ground_holds_as_a_lock_does),
        cmocka_unit_test(two_rings_and_a_compound_sun_of_example_13_8),
        cmocka_unit_test(compound_planets_of_examples_13_10_13_11_13_14),
        cmocka_unit_test(a_drive_under_power_of_example_13_22),
        cmocka_unit_test(belts_turn_wheels_by_their_radii),
        cmocka_unit_test(a_rack_moves_by_the_pinions_radius),
        cmocka_unit_test(a_ring_may_be_the_ground_itself),
        cmocka_unit_test(a_locked_train_names_what_contradicts),
        cmocka_unit_test(an_open_train_names_what_stays_open),
        cmocka_unit_test(drives_that_agree_are_no_contradiction),
        cmocka_unit_test(questions_that_make_no_sense_are_refused),
        cmocka_unit_test(the_tabular_method_gives_the_same_speeds),
        cmocka_unit_test(planets_are_spaced_equally_only_where_teeth_fit),
        cmocka_unit_test(small_gears_that_a_rack_cuts_are_undercut),
        cmocka_unit_test(losses_take_their_share_of_the_power),
        cmocka_unit_test(power_that_circulates_is_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

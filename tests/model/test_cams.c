// `cams:` what is read, what follows from the joints, what is refused.
#include "model/examples.h"
#include "model/fixture.h"

#define DEG (YK_PI / 180)
#define LIFT                                                                                                           \
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: pi, by: 20 mm, law: 3-4-5}}, "                                 \
    "{fall: {to: 2*pi, by: 20 mm, law: 3-4-5}}]}}\n"
#define SWING                                                                                                          \
    "laws: {lift: {period: 2*pi, segments: [{rise: {to: pi, by: 20 deg, law: 3-4-5}}, "                                \
    "{fall: {to: 2*pi, by: 20 deg, law: 3-4-5}}]}}\n"
#define SLIDE                                                                                                          \
    "bodies: {shaft: {}, tappet: {points: {P: [0, 10 mm]}}}\n"                                                         \
    "joints: {K: {pin: [ground, shaft], angle: theta}, T: {slide: [ground, tappet], along: y, distance: s}}\n"
#define PIVOT                                                                                                          \
    "bodies: {ground: {points: {O: [0, 0], Q: [80 mm, 60 mm]}}, shaft: {}, "                                           \
    "rocker: {points: {Q: [10 mm, 0], P: [70 mm, 80 mm]}}}\n"                                                          \
    "joints: {O: {pin: [ground, shaft], angle: theta}, Q: {pin: [ground, rocker], angle: phi}}\n"

static void the_cam_of_the_format_loads(void **state)
{
    (void)state;
    YkModel *model = fixture_load(cam);
    assert_int_equal(model->cam_count, 1);
    const YkCam *c = &model->cams[0];
    assert_string_equal(c->name, "valve");
    assert_string_equal(model->bodies[c->cam].name, "shaft");
    assert_string_equal(model->bodies[c->follower].name, "tappet");
    assert_int_equal(c->carrier, 0);
    assert_string_equal(model->joints[c->cam_joint].name, "K");
    assert_string_equal(model->joints[c->follower_joint].name, "T");
    assert_int_equal(c->face, YK_CAM_FACE_ROLLER);
    assert_false(c->oscillates || c->is_groove || c->is_conjugate);
    CHECK_NEAR(c->base, 0.06, 0);
    CHECK_NEAR(c->roller, 0.01, 0);
    CHECK_NEAR(c->offset, 0, 0);
    CHECK_NEAR(c->along.x, 0, 0);
    CHECK_NEAR(c->along.y, 1, 0);
    CHECK_NEAR(c->turn, 1, 0);
    assert_non_null(c->base_expr);
    assert_null(c->arm_expr);
    yk_model_free(model);
}

static void arm_and_centres_follow_from_points_or_from_keys(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load(SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 60 mm, at: P}}\n" PIVOT);
    const YkCam *c = &model->cams[0];
    assert_true(c->oscillates);
    assert_int_equal(c->face, YK_CAM_FACE_KNIFE);
    CHECK_NEAR(c->arm, 0.1, 1e-16);
    CHECK_NEAR(c->centers, 0.1, 1e-16);
    CHECK_NEAR(c->pivot.x, 0.08, 0);
    CHECK_NEAR(c->swing, 1, 0);
    yk_model_free(model);
    model = fixture_load(SWING "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 60 mm, arm: 90 mm, centers: "
                               "120 mm}}\nbodies: {shaft: {}, rocker: {}}\n"
                               "joints: {O: {pin: [ground, shaft]}, Q: {pin: [rocker, ground]}}\n");
    c = &model->cams[0];
    CHECK_NEAR(c->arm, 0.09, 0);
    CHECK_NEAR(c->centers, 0.12, 0);
    CHECK_NEAR(c->pivot.x, 0.12, 0);
    CHECK_NEAR(c->swing, -1, 0);
    yk_model_free(model);
}

// The arm lies where turning clockwise leads away from the cam.
static void a_follower_leaves_its_cam_where_its_point_and_law_say(void **state)
{
    (void)state;
    static const struct {
        const char *first, *second, *arm, *pin;
        double away;
    } cases[] = {{"fall", "rise", "at: P", "[ground, rocker]", -1}, // the law goes below 0
                 {"rise", "fall", "at: P", "[ground, rocker]", 1},  // a point of the wrong side
                 {"fall", "rise", "arm: 100 mm", "[ground, rocker]", 1},
                 {"rise", "fall", "at: P", "[rocker, ground]", -1},
                 {"fall", "rise", "at: P", "[rocker, ground]", -1}}; // lift 0 is the cam's largest radius
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        char text[2000];
        snprintf(text, sizeof text,
                 "laws: {lift: {period: 2*pi, segments: [{%s: {to: pi, by: 20 deg, law: 3-4-5}}, "
                 "{%s: {to: 2*pi, by: 20 deg, law: 3-4-5}}]}}\n"
                 "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 60 mm, %s}}\n"
                 "bodies: {ground: {points: {O: [0, 0], Q: [80 mm, 60 mm]}}, shaft: {}, "
                 "rocker: {points: {Q: [10 mm, 0], P: [70 mm, 80 mm]}}}\n"
                 "joints: {O: {pin: [ground, shaft]}, Q: {pin: %s}}\n",
                 cases[k].first, cases[k].second, cases[k].arm, cases[k].pin);
        YkModel *model = fixture_load(text);
        CHECK_NEAR(model->cams[0].away, cases[k].away, 0);
        yk_model_free(model);
    }
}

// The guide's line passes the shaft at 30 mm on its right; a reversed guide moves the other way.
static void the_offset_follows_from_the_guide_where_it_is_not_given(void **state)
{
    (void)state;
    YkModel *model = fixture_load(
        LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 60 mm}}\n"
             "bodies: {ground: {points: {O: [10 mm, 5 mm], G: [40 mm, 0]}}, shaft: {points: {O: [0, 0]}}, tappet: {}}\n"
             "joints: {O: {pin: [ground, shaft]}, T: {slide: [ground, tappet], from: G, along: y}}\n");
    CHECK_NEAR(model->cams[0].offset, 0.03, 1e-17);
    yk_model_free(model);
    model = fixture_load(
        LIFT "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 60 mm, offset: -5 mm}}\n"
             "bodies: {shaft: {}, tappet: {}}\n"
             "joints: {O: {pin: [shaft, ground]}, T: {slide: [tappet, ground], along: y, turned: 90 deg}}\n");
    const YkCam *c = &model->cams[0];
    CHECK_NEAR(c->turn, -1, 0);
    CHECK_NEAR(c->along.x, -1, 1e-16); // the ground goes along y of a tappet that lies at -90 deg
    CHECK_NEAR(c->along.y, 0, 1e-16);
    CHECK_NEAR(c->offset, -0.005, 0);
    yk_model_free(model);
}

static void grooves_and_conjugate_cams_are_read(void **state)
{
    (void)state;
    YkModel *model =
        fixture_load(LIFT "cams:\n"
                          "  a: {cam: shaft, follower: tappet, law: lift, base: 60 mm, roller: 8 mm, groove: true}\n"
                          "  b: {cam: shaft, follower: tappet, law: lift, base: 60 mm, roller: 8 mm, "
                          "groove: false, conjugate: {span: 160 mm}}\n" SLIDE);
    assert_true(model->cams[0].is_groove && !model->cams[0].is_conjugate);
    assert_true(!model->cams[1].is_groove && model->cams[1].is_conjugate);
    CHECK_NEAR(model->cams[1].other_span, 0.16, 0);
    CHECK_NEAR(model->cams[1].other_roller, 0.008, 0);
    yk_model_free(model);
    model = fixture_load(SWING "cams: {a: {cam: shaft, follower: rocker, law: lift, base: 60 mm, roller: 8 mm, at: P, "
                               "conjugate: {roller: 7 mm, angle: 80 deg}}}\n" PIVOT);
    CHECK_NEAR(model->cams[0].other_roller, 0.007, 0);
    CHECK_NEAR(model->cams[0].other_arm, 0.1, 1e-16);
    CHECK_NEAR(model->cams[0].other_angle, 80 * DEG, 1e-16);
    yk_model_free(model);
}

// Without any unit in the law, the follower says whether it is a length or an angle.
static void a_law_without_units_takes_those_of_its_follower(void **state)
{
    (void)state;
    const char *law = "units: {length: mm, angle: deg}\nlaws: {lift: {period: 360, segments: "
                      "[{rise: {to: 180, by: 20, law: 3-4-5}}, {fall: {to: 360, by: 20, law: 3-4-5}}]}}\n";
    char text[1500];
    double d[5];
    snprintf(text, sizeof text, "%s%s", law, "cams: {c: {cam: shaft, follower: tappet, law: lift, base: 60}}\n" SLIDE);
    YkModel *model = fixture_load(text);
    yk_law_eval(model->laws[0].law, YK_PI, d);
    CHECK_NEAR(d[0], 0.02, 1e-16);
    yk_model_free(model);
    snprintf(text, sizeof text, "%s%s", law,
             "cams: {c: {cam: shaft, follower: rocker, law: lift, base: 60, at: P}}\n" PIVOT);
    model = fixture_load(text);
    yk_law_eval(model->laws[0].law, YK_PI, d);
    CHECK_NEAR(d[0], 20 * DEG, 1e-15);
    yk_model_free(model);
}

static void refused(const char *law, const char *keys, const char *machine, int code, const char *part)
{
    char text[2000];
    snprintf(text, sizeof text, "%scams: {c: {%s}}\n%s", law, keys, machine);
    YkProblems *problems = fixture_refuse(text);
    const YkProblem *problem = fixture_problem(problems, code);
    int is_right = problem && strstr(problem->message, part) && yk_problems_error_count(problems) == 1;
    if (!is_right) print_error("%s: expected E%04d (%s), found\n%s", keys, code, part, yk_problems_text(problems, 0));
    yk_problems_free(problems);
    assert_true(is_right);
}

static void sizes_that_cannot_be_are_refused(void **state)
{
    (void)state;
    const char *slide = "cam: shaft, follower: tappet, law: lift, ",
               *turn = "cam: shaft, follower: rocker, law: lift, ";
    const struct {
        const char *keys;
        bool turns;
        const char *part;
    } cases[] = {
        {"base: 0 mm", false, "`base`"},
        {"base: -5 mm", false, "`base`"},
        {"base: 60 mm, roller: 0 mm", false, "`roller`"},
        {"base: 60 mm, offset: 61 mm", false, "offset"},
        {"base: 60 mm", true, "`arm`"},
        {"base: 60 mm, arm: -1 mm", true, "`arm`"},
        {"base: 60 mm, arm: 20 mm", true, "cannot lie 0.06 m"},
        {"base: 60 mm, at: P, centers: 90 mm", true, "0.1 m apart"},
        {"base: 101 mm, face: flat", true, "too large"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char keys[300];
        snprintf(keys, sizeof keys, "%s%s", cases[i].turns ? turn : slide, cases[i].keys);
        refused(cases[i].turns ? SWING : LIFT, keys, cases[i].turns ? PIVOT : SLIDE, YK_CODE_CAM_SIZE, cases[i].part);
    }
    refused(SWING, "cam: shaft, follower: rocker, law: lift, base: 60 mm, arm: 60 mm",
            "bodies: {shaft: {}, rocker: {}}\njoints: {O: {pin: [ground, shaft]}, Q: {pin: [ground, rocker]}}\n",
            YK_CODE_CAM_SIZE, "same place");
    refused("laws: {lift: {period: 2*pi, segments: [{fall: {to: pi, by: 70 mm, law: 3-4-5}}, "
            "{rise: {to: 2*pi, by: 70 mm, law: 3-4-5}}]}}\n",
            "cam: shaft, follower: tappet, law: lift, base: 60 mm", SLIDE, YK_CODE_CAM_SIZE, "cam's centre");
}

static void keys_of_other_kinds_are_refused(void **state)
{
    (void)state;
    const char *slide = "cam: shaft, follower: tappet, law: lift, base: 60 mm, ";
    const char *turn = "cam: shaft, follower: rocker, law: lift, base: 60 mm, ";
    const struct {
        const char *keys;
        bool turns;
        int code;
        const char *part;
    } cases[] = {
        {"roller: 5 mm, face: flat", false, YK_CODE_CAM_KEY, "no roller"},
        {"roller: 5 mm, face: knife", false, YK_CODE_CAM_KEY, "no roller"},
        {"face: roller", false, YK_CODE_MISSING_KEY, "`roller`"},
        {"face: round", false, YK_CODE_WRONG_WORD, "`round`"},
        {"arm: 60 mm", false, YK_CODE_CAM_KEY, "`arm`"},
        {"at: P", false, YK_CODE_CAM_KEY, "`at`"},
        {"centers: 60 mm", false, YK_CODE_CAM_KEY, "`centers`"},
        {"groove: true", false, YK_CODE_CAM_KEY, "`groove`"},
        {"roller: 5 mm, groove: 3", false, YK_CODE_WRONG_WORD, "`groove`"},
        {"conjugate: {span: 160 mm}", false, YK_CODE_CAM_KEY, "`conjugate`"},
        {"roller: 5 mm, conjugate: {roller: 5 mm}", false, YK_CODE_MISSING_KEY, "`span`"},
        {"roller: 5 mm, conjugate: {span: 160 mm, angle: 3}", false, YK_CODE_UNKNOWN_KEY, "`angle`"},
        {"at: P, offset: 1 mm", true, YK_CODE_CAM_KEY, "`offset`"},
        {"at: P, arm: 100 mm", true, YK_CODE_CAM_KEY, "`at`"},
        {"face: flat, arm: 100 mm", true, YK_CODE_CAM_KEY, "`arm`"},
        {"at: P, bass: 3", true, YK_CODE_UNKNOWN_KEY, "`bass`"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char keys[300];
        snprintf(keys, sizeof keys, "%s%s", cases[i].turns ? turn : slide, cases[i].keys);
        refused(cases[i].turns ? SWING : LIFT, keys, cases[i].turns ? PIVOT : SLIDE, cases[i].code, cases[i].part);
    }
}

static void what_a_cam_needs_is_asked_for(void **state)
{
    (void)state;
    refused(LIFT, "follower: tappet, law: lift, base: 60 mm", SLIDE, YK_CODE_MISSING_KEY, "`cam`");
    refused(LIFT, "cam: shaft, law: lift, base: 60 mm", SLIDE, YK_CODE_MISSING_KEY, "`follower`");
    refused(LIFT, "cam: shaft, follower: tappet, base: 60 mm", SLIDE, YK_CODE_MISSING_KEY, "`law`");
    refused(LIFT, "cam: shaft, follower: tappet, law: lift", SLIDE, YK_CODE_MISSING_KEY, "`base`");
    refused(LIFT, "cam: shaft, follower: tappet, law: left, base: 60 mm", SLIDE, YK_CODE_UNKNOWN_LAW, "`left`");
    refused(LIFT, "cam: shift, follower: tappet, law: lift, base: 60 mm", SLIDE, YK_CODE_UNKNOWN_BODY, "`shift`");
}

static void cam_and_follower_need_one_carrier(void **state)
{
    (void)state;
    const char *keys = "cam: shaft, follower: tappet, law: lift, base: 60 mm";
    refused(LIFT, keys,
            "bodies: {shaft: {}, arm: {}, tappet: {}}\njoints: {O: {pin: [ground, arm]}, K: {pin: [arm, shaft]}, "
            "T: {slide: [ground, tappet], along: y}}\n",
            YK_CODE_CAM_CARRIER, "no body holds both");
    refused(LIFT, "cam: shaft, follower: shaft, law: lift, base: 60 mm", SLIDE, YK_CODE_CAM_CARRIER, "no body");
    const char *twice =
        "bodies: {shaft: {}, arm: {}, tappet: {}}\njoints: {O: {pin: [ground, arm]}, K: {pin: [arm, shaft]}, "
        "L: {pin: [ground, shaft]}, T: {slide: [ground, tappet], along: y}, "
        "U: {slide: [arm, tappet], along: y}}\n";
    refused(LIFT, keys, twice, YK_CODE_CAM_CARRIER, "more than one");
    char text[1500];
    snprintf(text, sizeof text, "%scams: {c: {%s, carrier: arm}}\n%s", LIFT, keys, twice);
    YkModel *model = fixture_load(text);
    assert_string_equal(model->bodies[model->cams[0].carrier].name, "arm");
    yk_model_free(model);
}

static void a_law_must_fit_the_follower_and_return_after_a_turn(void **state)
{
    (void)state;
    const char *keys = "cam: shaft, follower: tappet, law: lift, base: 60 mm";
    refused(SWING, keys, SLIDE, YK_CODE_CAM_LAW, "a length over an angle");
    refused("laws: {lift: {period: 3 s, segments: [{rise: {to: 1 s, by: 2 mm, law: 3-4-5}}, "
            "{fall: {to: 3 s, by: 2 mm, law: 3-4-5}}]}}\n",
            keys, SLIDE, YK_CODE_CAM_LAW, "over a time");
    refused("laws: {lift: {segments: [{rise: {to: pi, by: 2 mm, law: 3-4-5}}]}}\n", keys, SLIDE, YK_CODE_CAM_LAW,
            "does not return");
    refused("laws: {lift: {period: 3*pi, segments: [{rise: {to: pi, by: 2 mm, law: 3-4-5}}, "
            "{fall: {to: 3*pi, by: 2 mm, law: 3-4-5}}]}}\n",
            keys, SLIDE, YK_CODE_CAM_LAW, "not returned");
    refused("laws: {lift: {period: 2*pi, segments: [{rise: {to: pi, by: 2 mm, law: 3-4-5}}, {dwell: {to: 2*pi}}]}}\n",
            keys, SLIDE, YK_CODE_LAW_JUMP, "does not return");
}

static void all_problems_come_at_once(void **state)
{
    (void)state;
    YkProblems *problems =
        fixture_refuse(SWING "cams: {a: {cam: shaft, follower: tappet, law: lift, base: -1 mm, arm: 3 mm, fce: flat}, "
                             "b: {cam: shaft, follower: no, law: lift, base: 3 s}}\n" SLIDE);
    const int codes[] = {YK_CODE_CAM_SIZE,     YK_CODE_CAM_KEY, YK_CODE_UNKNOWN_KEY,
                         YK_CODE_UNKNOWN_BODY, YK_CODE_CAM_LAW, YK_CODE_WRONG_DIMENSION};
    for (size_t i = 0; i < sizeof codes / sizeof *codes; i++) assert_non_null(fixture_problem(problems, codes[i]));
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_cam_of_the_format_loads),
        cmocka_unit_test(arm_and_centres_follow_from_points_or_from_keys),
        cmocka_unit_test(a_follower_leaves_its_cam_where_its_point_and_law_say),
        cmocka_unit_test(the_offset_follows_from_the_guide_where_it_is_not_given),
        cmocka_unit_test(grooves_and_conjugate_cams_are_read),
        cmocka_unit_test(a_law_without_units_takes_those_of_its_follower),
        cmocka_unit_test(sizes_that_cannot_be_are_refused),
        cmocka_unit_test(keys_of_other_kinds_are_refused),
        cmocka_unit_test(what_a_cam_needs_is_asked_for),
        cmocka_unit_test(cam_and_follower_need_one_carrier),
        cmocka_unit_test(a_law_must_fit_the_follower_and_return_after_a_turn),
        cmocka_unit_test(all_problems_come_at_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Channels: a parsed name prints back as a name that parses to the same; an unknown one gets a hint.
#include "machine.h"
#include "table.h"

static YkChannel parse(const Machine *m, const char *name)
{
    YkChannel channel = {0};
    YkStatus status = yk_channel_parse(m->mech, name, &channel, m->problems);
    if (status != YK_OK) print_error("%s: %s", name, yk_problems_text(m->problems, 0));
    assert_int_equal(status, YK_OK);
    return channel;
}

static void check_same(YkChannel a, YkChannel b)
{
    assert_int_equal(a.kind, b.kind);
    assert_int_equal(a.index, b.index);
    assert_int_equal(a.order, b.order);
    assert_int_equal(a.quantity, b.quantity);
}

static void check_round_trip(const Machine *m, YkChannel channel)
{
    char name[300];
    size_t length = yk_channel_name(m->mech, channel, name, sizeof name);
    assert_int_equal(length, strlen(name));
    check_same(parse(m, name), channel);
}

static YkQuantity quantity(bool is_length, int order)
{
    if (order == 0) return is_length ? YK_QUANTITY_LENGTH : YK_QUANTITY_ANGLE;
    if (order == 1) return is_length ? YK_QUANTITY_SPEED : YK_QUANTITY_ANGLE_RATE;
    return is_length ? YK_QUANTITY_ACCELERATION : YK_QUANTITY_ANGLE_ACCELERATION;
}

// Everything that can be asked of every machine of the table.
static void names_and_channels_are_one_to_one(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        check_round_trip(&m, (YkChannel){YK_CHANNEL_TIME, 0, 0, YK_QUANTITY_TIME});
        for (int order = 0; order < 3; order++) {
            for (size_t c = 0; c < yk_coordinate_count(m.mech); c++)
                check_round_trip(&m, (YkChannel){YK_CHANNEL_COORDINATE, (int)c, order,
                                                 quantity(yk_coordinate_info(m.mech, c).is_distance, order)});
            for (size_t b = 0; b < yk_model_body_count(m.model); b++)
                if (yk_names_find(&m.model->joint_names, yk_model_body_name(m.model, b)) == YK_NONE)
                    check_round_trip(&m, (YkChannel){YK_CHANNEL_BODY, (int)b, order, quantity(false, order)});
            for (size_t p = 0; p < yk_model_point_count(m.model); p++) {
                check_round_trip(&m, (YkChannel){YK_CHANNEL_POINT_X, (int)p, order, quantity(true, order)});
                check_round_trip(&m, (YkChannel){YK_CHANNEL_POINT_Y, (int)p, order, quantity(true, order)});
                if (order == 0) check_round_trip(&m, (YkChannel){YK_CHANNEL_POINT_SPEED, (int)p, 0, YK_QUANTITY_SPEED});
            }
        }
        for (size_t b = 0; b < yk_block_count(m.mech); b++)
            check_round_trip(&m, (YkChannel){YK_CHANNEL_TRANSMISSION, (int)b, 0, YK_QUANTITY_ANGLE});
        machine_free(&m);
    }
}

// Forces of joints and of contacts, efforts, and what is asked of the whole machine.
static void names_of_forces_are_one_to_one(void **state)
{
    (void)state;
    static const char *const files[] = {"four-bar", "slider-crank", "epicyclic-drive", "flat-faced-cam",
                                        "geared-five-bar"};
    size_t contacts = 0;
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) {
        Machine m = machine(files[k]);
        for (size_t j = 0; j < m.model->joint_count + yk_contact_count(m.mech); j++) {
            bool is_contact = j >= m.model->joint_count;
            for (int kind = YK_CHANNEL_FORCE_X; kind <= YK_CHANNEL_FORCE; kind++)
                check_round_trip(&m, (YkChannel){(YkChannelKind)kind, (int)j, 0, YK_QUANTITY_FORCE});
            check_round_trip(&m, (YkChannel){YK_CHANNEL_MOMENT, (int)j, 0, YK_QUANTITY_TORQUE});
            contacts += is_contact;
        }
        for (size_t c = 0; c < yk_coordinate_count(m.mech); c++) {
            YkQuantity q = yk_coordinate_info(m.mech, c).is_distance ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE;
            check_round_trip(&m, (YkChannel){YK_CHANNEL_EFFORT, (int)c, 0, q});
            check_round_trip(&m, (YkChannel){YK_CHANNEL_EFFORT_FROM, (int)c, 0, q});
            check_round_trip(&m, (YkChannel){YK_CHANNEL_EFFORT_TO, (int)c, 0, q});
        }
        for (int kind = YK_CHANNEL_ENERGY; kind <= YK_CHANNEL_SHAKING_MOMENT; kind++) {
            YkQuantity q = kind <= YK_CHANNEL_POTENTIAL        ? YK_QUANTITY_ENERGY
                           : kind == YK_CHANNEL_SHAKING_MOMENT ? YK_QUANTITY_TORQUE
                                                               : YK_QUANTITY_FORCE;
            check_round_trip(&m, (YkChannel){(YkChannelKind)kind, 0, 0, q});
        }
        machine_free(&m);
    }
    assert_true(contacts >= 4);
}

static void joints_off_the_tree_can_be_asked_for_too(void **state)
{
    (void)state;
    Machine m = machine("quick-return");
    for (size_t j = 0; j < m.model->joint_count; j++) {
        const YkPart *part = yk_part(m.model->joints[j].kind);
        char name[100];
        for (int order = 0; order < 3; order++) {
            static const char *const ends[] = {"", ".rate", ".accel"};
            snprintf(name, sizeof name, "%s.%s%s", m.model->joints[j].name, part->turns ? "angle" : "distance",
                     ends[order]);
            YkChannel channel = parse(&m, name);
            assert_int_equal(channel.kind, part->turns ? YK_CHANNEL_JOINT_ANGLE : YK_CHANNEL_JOINT_DISTANCE);
            assert_int_equal(channel.index, j);
            assert_int_equal(channel.order, order);
            check_round_trip(&m, channel);
        }
    }
    machine_free(&m);
}

static void the_names_of_the_manual_parse_as_it_says(void **state)
{
    (void)state;
    Machine m = machine("quick-return");
    static const struct {
        const char *name;
        YkChannelKind kind;
        int order;
        YkQuantity quantity;
    } cases[] = {
        {"t", YK_CHANNEL_TIME, 0, YK_QUANTITY_TIME},
        {"theta2", YK_CHANNEL_COORDINATE, 0, YK_QUANTITY_ANGLE},
        {"theta2.rate", YK_CHANNEL_COORDINATE, 1, YK_QUANTITY_ANGLE_RATE},
        {"d3.accel", YK_CHANNEL_COORDINATE, 2, YK_QUANTITY_ACCELERATION},
        {"d5", YK_CHANNEL_COORDINATE, 0, YK_QUANTITY_LENGTH},
        {"lever.angle", YK_CHANNEL_BODY, 0, YK_QUANTITY_ANGLE},
        {"lever.angle.rate", YK_CHANNEL_BODY, 1, YK_QUANTITY_ANGLE_RATE},
        {"lever.rate", YK_CHANNEL_BODY, 1, YK_QUANTITY_ANGLE_RATE},
        {"lever.accel", YK_CHANNEL_BODY, 2, YK_QUANTITY_ANGLE_ACCELERATION},
        {"ram.C.x", YK_CHANNEL_POINT_X, 0, YK_QUANTITY_LENGTH},
        {"ram.C.y.rate", YK_CHANNEL_POINT_Y, 1, YK_QUANTITY_SPEED},
        {"ram.C.x.accel", YK_CHANNEL_POINT_X, 2, YK_QUANTITY_ACCELERATION},
        {"ram.C.speed", YK_CHANNEL_POINT_SPEED, 0, YK_QUANTITY_SPEED},
        {"C.transmission", YK_CHANNEL_TRANSMISSION, 0, YK_QUANTITY_ANGLE},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkChannel c = parse(&m, cases[k].name);
        assert_int_equal(c.kind, cases[k].kind);
        assert_int_equal(c.order, cases[k].order);
        assert_int_equal(c.quantity, cases[k].quantity);
    }
    machine_free(&m);
}

// It has two distances: none of them is "the" distance. Its coordinates have names of their own.
static void a_free_joint_has_no_distance(void **state)
{
    (void)state;
    Machine m = machine("bodies: {ground: {}, plate: {}}\n"
                        "joints: {J: {free: [ground, plate], at: [x, y, phi]}}\nstart: {x: 3, y: 4, phi: 1}\n");
    YkChannel channel;
    YkProblems *problems = yk_problems_new();
    assert_int_equal(yk_channel_parse(m.mech, "J.distance", &channel, problems), YK_BAD_ARGUMENT);
    assert_int_equal(yk_channel_parse(m.mech, "J.angle", &channel, problems), YK_OK);
    assert_int_equal(yk_channel_parse(m.mech, "y", &channel, problems), YK_OK);
    yk_problems_free(problems);
    machine_free(&m);
}

static void unknown_names_are_refused_with_a_hint(void **state)
{
    (void)state;
    static const struct {
        const char *name, *hint;
    } cases[] = {
        {"theta3", "did you mean `theta"},
        {"thetta4", "`theta4`"},
        {"theta2.rat", "ask for"},
        {"Theta4", "`theta4`"},
        {"levr.angle", "`lever.angle`"},
        {"ram.B.x", "`ram.C"},
        {"nothing.at.all", "ask for a coordinate"},
        {"", "ask for a coordinate"},
        {".rate", "ask for"},
        {"t.rate", ""},
        {"ram.C", ""},
        {"ram.C.z", ""},
        {"ram.C.speed.rate", ""},
        {"S.angle", ""},
        {"A.distance", ""},
        {"B.transmission", ""},
        {"lever", ""},
        {"C.transmission.rate", ""},
        {"theta2.rate.rate", ""},
        {"ground..x", ""},
        {"theta1.torque", "`theta1.effort`"},
        {"d5.force", "`d5.effort`"},
        {"theta1.velocity", "`theta1.rate`"},
        {"ram.C.velocity", "`ram.C.speed`"},
        {"B.reaction", "`B.force`"},
    };
    Machine m = machine("quick-return");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        YkChannel channel;
        YkProblems *problems = yk_problems_new();
        YkStatus status = yk_channel_parse(m.mech, cases[k].name, &channel, problems);
        bool is_right = status == YK_BAD_ARGUMENT && yk_problems_count(problems) == 1 &&
                        yk_problems_get(problems, 0)->code == YK_CODE_UNKNOWN_CHANNEL &&
                        yk_problems_get(problems, 0)->hint && strstr(yk_problems_get(problems, 0)->hint, cases[k].hint);
        if (!is_right)
            print_error("`%s` should have the hint %s:\n%s", cases[k].name, cases[k].hint,
                        yk_problems_text(problems, 0));
        assert_true(is_right);
        yk_problems_free(problems);
        assert_int_equal(yk_channel_parse(m.mech, cases[k].name, &channel, NULL),
                         YK_BAD_ARGUMENT); // nor is a list needed
    }
    machine_free(&m);
}

static void the_nearest_name_is_suggested_not_the_first_that_is_near(void **state)
{
    (void)state;
    Machine m = machine("stephenson-six-bar"); // theta2 .. theta6
    YkChannel channel;
    assert_int_equal(yk_channel_parse(m.mech, "thet6", &channel, m.problems), YK_BAD_ARGUMENT);
    assert_non_null(strstr(yk_problems_get(m.problems, 0)->hint, "`theta6`"));
    machine_free(&m);
}

static void endless_names_are_refused(void **state)
{
    (void)state;
    enum { LONG = 100000 };
    char *name = malloc(LONG + 1);
    YkChannel channel;
    Machine m = machine("four-bar");
    memset(name, 'a', LONG);
    name[LONG] = 0;
    assert_int_equal(yk_channel_parse(m.mech, name, &channel, m.problems), YK_BAD_ARGUMENT);
    machine_free(&m);
    free(name);
}

static void names_are_cut_to_the_room_there_is(void **state)
{
    (void)state;
    Machine m = machine("quick-return");
    YkChannel channel = parse(&m, "ram.C.x.rate");
    char text[] = "########";
    assert_int_equal(yk_channel_name(m.mech, channel, text, 5), 12); // the length needed
    assert_string_equal(text, "ram.");
    assert_int_equal(text[5], '#');
    assert_int_equal(yk_channel_name(m.mech, channel, NULL, 0), 12);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_and_channels_are_one_to_one),
        cmocka_unit_test(names_of_forces_are_one_to_one),
        cmocka_unit_test(joints_off_the_tree_can_be_asked_for_too),
        cmocka_unit_test(the_names_of_the_manual_parse_as_it_says),
        cmocka_unit_test(a_free_joint_has_no_distance),
        cmocka_unit_test(unknown_names_are_refused_with_a_hint),
        cmocka_unit_test(the_nearest_name_is_suggested_not_the_first_that_is_near),
        cmocka_unit_test(endless_names_are_refused),
        cmocka_unit_test(names_are_cut_to_the_room_there_is),
    };
    return cmocka_run_group_tests_name("compile/channel", tests, NULL, NULL);
}

// The format's examples load, field by field; and the loader's treatment of names, texts and failures.
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>
#include "model/examples.h"
#include "model/fixture.h"

#define DEG (YK_PI / 180)

static void the_quick_return_has_its_bodies_points_and_joints(void **state)
{
    (void)state;
    YkModel *model = fixture_load(quick_return);
    const char *bodies[] = {"ground", "crank", "lever", "block", "coupler", "ram"};
    assert_int_equal(model->body_count, 6);
    for (size_t i = 0; i < 6; i++) assert_string_equal(model->bodies[i].name, bodies[i]);
    assert_int_equal(model->point_count, 11);
    assert_int_equal(model->joint_count, 7);
    CHECK_NEAR(fixture_point(model, "ground.C0")->at.y, 2, 0);
    CHECK_NEAR(fixture_point(model, "crank.A")->at.x, 0.75, 0);
    CHECK_NEAR(fixture_point(model, "lever.B")->at.x, 1.75, 0);
    CHECK_NEAR(fixture_point(model, "coupler.C")->at.x, 2.0 / 3, 1e-16);
    const YkJoint *pin = fixture_joint(model, "B");
    assert_int_equal(pin->kind, YK_PIN);
    assert_string_equal(model->bodies[pin->body[0]].name, "lever");
    assert_string_equal(model->bodies[pin->body[1]].name, "coupler");
    assert_ptr_equal(&model->points[pin->point[0]], fixture_point(model, "lever.B"));
    assert_ptr_equal(&model->points[pin->point[1]], fixture_point(model, "coupler.B"));
    CHECK_NEAR(pin->at[0].x, 1.75, 0);
    CHECK_NEAR(pin->at[1].x, 0, 0);
    yk_model_free(model);
}

static void the_quick_return_slides_have_their_lines(void **state)
{
    (void)state;
    YkModel *model = fixture_load(quick_return);
    const YkJoint *slide = fixture_joint(model, "R"), *inner = fixture_joint(model, "S");
    assert_int_equal(slide->kind, YK_SLIDE);
    assert_ptr_equal(&model->points[slide->point[0]], fixture_point(model, "ground.C0"));
    assert_int_equal(slide->point[1], YK_NONE);
    CHECK_NEAR(slide->at[0].y, 2, 0);
    assert_true(slide->along.x == 1 && slide->along.y == 0 && slide->along_angle == 0);
    assert_null(slide->along_expr);
    assert_int_equal(inner->point[0], YK_NONE);
    assert_string_equal(model->coordinates[inner->distance].name, "d3");
    assert_int_equal(inner->angle, YK_NONE);
    yk_model_free(model);
}

static void the_quick_return_moves_as_its_drive_says(void **state)
{
    (void)state;
    YkModel *model = fixture_load(quick_return);
    const char *names[] = {"theta1", "theta2", "d3", "theta4", "d5"};
    assert_int_equal(model->coordinate_count, 5);
    for (size_t i = 0; i < 5; i++) assert_string_equal(model->coordinates[i].name, names[i]);
    assert_int_equal(model->drive_count, 1);
    assert_int_equal(model->drives[0].coordinate, 0);
    assert_int_equal(model->coordinates[0].drive, 0);
    assert_int_equal(model->coordinates[1].drive, YK_NONE);
    for (double t = 0; t < 10; t += 1.7) {
        YkJet jet;
        assert_int_equal(yk_model_eval(model, model->drives[0].expr, t, &jet, NULL), YK_OK);
        CHECK_NEAR(jet.d[0], 30 * DEG - 0.5 * t, 1e-15);
        CHECK_NEAR(jet.d[1], -0.5, 1e-15);
        CHECK_NEAR(jet.d[2], 0, 0);
    }
    const double start[] = {60 * DEG, 1.5, -20 * DEG, 1.2};
    assert_int_equal(model->start_count, 4);
    for (size_t i = 0; i < 4; i++) {
        CHECK_NEAR(model->starts[i].value, start[i], 1e-15);
        assert_int_equal(model->starts[i].coordinate, (int)i + 1);
    }
    CHECK_NEAR(model->size, 2, 0); // the ground, from O2 to C0
    yk_model_free(model);
}

static void the_toggle_has_uniform_rods_and_a_point_mass(void **state)
{
    (void)state;
    YkModel *model = fixture_load(toggle);
    const struct {
        const char *name;
        double mass, length;
    } rods[] = {{"link1", 0.4, 0.1}, {"link2", 0.9, 0.22}, {"link3", 0.8, 0.2}, {"link4", 1.0, 0.25}};
    for (size_t i = 0; i < 4; i++) {
        const YkBody *body = fixture_body(model, rods[i].name);
        assert_true(body->has_mass);
        CHECK_NEAR(body->mass, rods[i].mass, 0);
        CHECK_NEAR(body->center.x, rods[i].length / 2, 1e-17);
        CHECK_NEAR(body->center.y, 0, 0);
        CHECK_NEAR(body->inertia, rods[i].mass * rods[i].length * rods[i].length / 12, 1e-17);
    }
    const YkBody *slider = fixture_body(model, "slider");
    CHECK_NEAR(slider->mass, 2.5, 0);
    assert_true(slider->inertia == 0 && slider->center.x == 0 && slider->center.y == 0);
    assert_false(model->bodies[0].has_mass);
    yk_model_free(model);
}

static void the_toggle_has_gravity_an_effort_and_a_rate_at_the_start(void **state)
{
    (void)state;
    YkModel *model = fixture_load(toggle);
    assert_true(model->has_gravity);
    CHECK_NEAR(model->gravity.x, 0, 0);
    CHECK_NEAR(model->gravity.y, -9.81, 0);
    assert_int_equal(model->effort_count, 1);
    YkJet jet;
    assert_int_equal(yk_model_eval(model, model->efforts[0].strength.expr, 0, &jet, NULL), YK_OK);
    CHECK_NEAR(jet.d[0], 2, 0);
    const YkStart *last = &model->starts[model->start_count - 1];
    assert_true(last->is_rate);
    assert_string_equal(model->coordinates[last->coordinate].name, "theta1");
    CHECK_NEAR(last->value, 3, 0);
    const YkJoint *joint = fixture_joint(model, "J23"); // two joints on one point
    assert_ptr_equal(&model->points[joint->point[0]], fixture_point(model, "link2.J"));
    assert_ptr_equal(&model->points[joint->point[1]], fixture_point(model, "link3.J"));
    yk_model_free(model);
}

static void the_double_pendulum_takes_bare_numbers_by_their_use(void **state)
{
    (void)state;
    YkModel *model = fixture_load(double_pendulum);
    const YkBody *link = fixture_body(model, "link1");
    CHECK_NEAR(link->mass, 0.5, 0);
    CHECK_NEAR(link->inertia, 0.025, 0);
    CHECK_NEAR(link->center.y, -0.35, 0);
    CHECK_NEAR(fixture_point(model, "link2.tip")->at.y, -0.5, 0);
    CHECK_NEAR(model->starts[0].value, YK_PI / 3, 1e-16);
    assert_true(yk_dimension_equal(fixture_parameter(model, "lc1")->dimension, (YkDimension){.length = 1}));
    assert_true(yk_dimension_equal(fixture_parameter(model, "I2")->dimension, (YkDimension){.length = 2, .mass = 1}));
    assert_true(yk_dimension_equal(fixture_parameter(model, "tau2")->dimension,
                                   (YkDimension){.length = 2, .mass = 1, .time = -2}));
    yk_model_free(model);
}

static void gear_trains_and_cams_load(void **state)
{
    (void)state;
    YkModel *model = fixture_load(epicyclic);
    assert_int_equal(model->gear_count, 2);
    assert_string_equal(model->bodies[model->gears[1].carrier].name, "arm");
    yk_model_free(model);
    model = fixture_load(cam);
    assert_int_equal(model->cam_count, 1);
    yk_model_free(model);
}

static void a_machine_without_a_name_has_that_of_its_file(void **state)
{
    (void)state;
    const struct {
        const char *path, *name;
    } cases[] = {{"a/b/crank.yaml", "crank"}, {"crank", "crank"},    {"x/.hidden", ".hidden"}, {"-", "machine"},
                 {"a.b/c.d.yaml", "c.d"},     {"folder/", "machine"}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        YkModel *model = yk_model_parse(CRANK, strlen(CRANK), cases[i].path, NULL, NULL);
        assert_non_null(model);
        assert_string_equal(yk_model_name(model), cases[i].name);
        assert_string_equal(model->source_name, cases[i].path);
        yk_model_free(model);
    }
    YkModel *model = fixture_load("name: The crank\n" CRANK);
    assert_string_equal(yk_model_name(model), "The crank");
    yk_model_free(model);
}

static void every_mistake_of_a_file_is_told_in_one_run(void **state)
{
    (void)state;
    YkProblems *problems = fixture_refuse("colour: red\n"
                                          "parameters: {a: b, b: a, t: 3, c: 1/0}\n"
                                          "bodies:\n"
                                          "  ground: {points: {O: [0, 0, 0]}, mass: 1}\n"
                                          "  crank: {points: {O: [0, 0], A: [l1, 0]}, mass: -1}\n"
                                          "  wheel: {}\n"
                                          "joints: {O: {pin: [ground, cronk]}, P: {hinge: [ground, crank]}}\n"
                                          "drives: {theta: 3}\n");
    const int codes[] = {YK_CODE_UNKNOWN_KEY,  YK_CODE_PARAMETER_CYCLE, YK_CODE_RESERVED_NAME,     YK_CODE_EVALUATION,
                         YK_CODE_COMPONENTS,   YK_CODE_GROUND_KEY,      YK_CODE_UNKNOWN_NAME,      YK_CODE_BAD_MASS,
                         YK_CODE_UNKNOWN_BODY, YK_CODE_JOINT_KIND,      YK_CODE_UNKNOWN_COORDINATE};
    for (size_t i = 0; i < sizeof codes / sizeof *codes; i++) {
        if (!fixture_problem(problems, codes[i])) print_error("E%04d is missing\n", codes[i]);
        assert_non_null(fixture_problem(problems, codes[i]));
    }
    yk_problems_free(problems);
}

static void a_file_and_its_text_give_the_same_machine(void **state)
{
    (void)state;
    char path[] = "/tmp/yoke-test-XXXXXX";
    int handle = mkstemp(path);
    assert_true(handle >= 0);
    assert_int_equal(write(handle, toggle, strlen(toggle)), (int)strlen(toggle));
    close(handle);
    YkModel *file = yk_model_load(path, NULL, NULL), *text = fixture_load(toggle);
    remove(path);
    assert_non_null(file);
    assert_int_equal(file->point_count, text->point_count);
    for (size_t i = 0; i < file->point_count; i++) {
        assert_memory_equal(&file->points[i].at, &text->points[i].at, sizeof(YkVec));
    }
    yk_model_free(file);
    yk_model_free(text);
}

static void a_file_that_is_not_there_is_a_problem(void **state)
{
    (void)state;
    YkProblems *problems = yk_problems_new();
    assert_null(yk_model_load("/nowhere/at/all.yaml", NULL, problems));
    assert_int_equal(yk_problems_error_count(problems), 1);
    assert_null(yk_model_load("/nowhere/at/all.yaml", NULL, NULL));
    yk_problems_free(problems);
    yk_model_free(NULL);
}

static void errors_count_also_when_nobody_reads_them_or_the_list_is_full(void **state)
{
    (void)state;
    const char *bad = "bodies: {a: 3}\n";
    assert_null(yk_model_parse(bad, strlen(bad), "bad", NULL, NULL));
    YkProblems *problems = yk_problems_new();
    for (int i = 0; i < YK_PROBLEMS_MAX + 5; i++) {
        yk_problem(problems, YK_CODE_UNKNOWN_KEY, (YkPlace){0}, "full");
    }
    assert_null(yk_model_parse(bad, strlen(bad), "bad", NULL, problems));
    yk_problems_free(problems);
}

static void a_list_or_a_value_is_no_model(void **state)
{
    (void)state;
    fixture_refused("[a, b]\n", YK_CODE_MODEL_NOT_MAP, 1, 1, "list");
    fixture_refused("hello\n", YK_CODE_MODEL_NOT_MAP, 1, 1, "value");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_quick_return_has_its_bodies_points_and_joints),
        cmocka_unit_test(the_quick_return_slides_have_their_lines),
        cmocka_unit_test(the_quick_return_moves_as_its_drive_says),
        cmocka_unit_test(the_toggle_has_uniform_rods_and_a_point_mass),
        cmocka_unit_test(the_toggle_has_gravity_an_effort_and_a_rate_at_the_start),
        cmocka_unit_test(the_double_pendulum_takes_bare_numbers_by_their_use),
        cmocka_unit_test(gear_trains_and_cams_load),
        cmocka_unit_test(a_machine_without_a_name_has_that_of_its_file),
        cmocka_unit_test(every_mistake_of_a_file_is_told_in_one_run),
        cmocka_unit_test(a_file_and_its_text_give_the_same_machine),
        cmocka_unit_test(a_file_that_is_not_there_is_a_problem),
        cmocka_unit_test(errors_count_also_when_nobody_reads_them_or_the_list_is_full),
        cmocka_unit_test(a_list_or_a_value_is_no_model),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// The public door with an index past the last: each call answers as <yoke/yoke.h> says, and reads and writes nothing
// outside.
#include <yoke/yoke.h>
#include "../check.h"

typedef struct Door {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
} Door;

static Door open_door(const char *file)
{
    YkProblems *problems = yk_problems_new();
    char path[300];
    snprintf(path, sizeof path, YOKE_ROOT "/examples/%s", file);
    Door d = {.model = yk_model_load(path, NULL, problems)};
    assert_non_null(d.model);
    assert_non_null(d.mech = yk_mechanism_compile(d.model, NULL, problems));
    assert_non_null(d.state = yk_state_new(d.mech));
    assert_true(yk_state_set_time(d.state, 0, problems) >= 0 && yk_state_assemble(d.state) >= 0);
    yk_problems_free(problems);
    return d;
}

static void close_door(Door d)
{
    yk_state_free(d.state);
    yk_mechanism_free(d.mech);
    yk_model_free(d.model);
}

// The first index past the last, and that of a name that was not found.
static size_t past(size_t count, int which)
{
    return which ? YK_NOT_FOUND : count;
}

static void check_motion(YkMotion m)
{
    assert_true(isnan(m.position) && isnan(m.velocity) && isnan(m.acceleration));
}

static void models_and_mechanisms_answer(void **unused)
{
    (void)unused;
    Door d = open_door("quick-return.yaml");
    for (int which = 0; which < 2; which++) {
        size_t body = past(yk_model_body_count(d.model), which), point = past(yk_model_point_count(d.model), which),
               joint = past(yk_model_joint_count(d.model), which), block = past(yk_block_count(d.mech), which),
               coordinate = past(yk_coordinate_count(d.mech), which), input = past(yk_input_count(d.mech), which);
        double place[2];
        assert_null(yk_model_body_name(d.model, body));
        assert_null(yk_model_point_name(d.model, point));
        assert_null(yk_model_joint_name(d.model, joint));
        assert_null(yk_model_joint_kind(d.model, joint));
        assert_true(yk_model_joint_body(d.model, joint, 1) == YK_NOT_FOUND);
        assert_true(yk_model_point_body(d.model, point) == YK_NOT_FOUND);
        yk_model_point_place(d.model, point, place);
        assert_true(isnan(place[0]) && isnan(place[1]));
        YkCoordinateInfo info = yk_coordinate_info(d.mech, coordinate);
        assert_true(!info.name && info.joint == YK_NOT_FOUND && info.input == -1);
        assert_true(yk_input_coordinate(d.mech, input) == YK_NOT_FOUND);
        assert_true(yk_loop_joint(d.mech, past(yk_loop_count(d.mech), which)) == YK_NOT_FOUND);
        assert_int_equal(yk_loop_bodies(d.mech, past(yk_loop_count(d.mech), which), NULL, 0), 0);
        assert_true(yk_redundant_joint(d.mech, past(yk_redundant_count(d.mech), which)) == YK_NOT_FOUND);
        assert_null(yk_block_info(d.mech, block).label);
        assert_true(yk_block_joint(d.mech, block, 0) == YK_NOT_FOUND &&
                    yk_block_body(d.mech, block, 0) == YK_NOT_FOUND);
        assert_null(yk_block_relation(d.mech, block, 0));
        for (size_t b = 0; b < yk_block_count(d.mech); b++) {
            YkBlockInfo of = yk_block_info(d.mech, b);
            assert_true(yk_block_joint(d.mech, b, past(of.joint_count, which)) == YK_NOT_FOUND);
            assert_true(yk_block_body(d.mech, b, past(of.body_count, which)) == YK_NOT_FOUND);
            assert_null(yk_block_relation(d.mech, b, past(of.relation_count, which)));
        }
        check_motion(yk_state_coordinate(d.state, coordinate));
        check_motion(yk_state_body(d.state, body));
        check_motion(yk_state_input(d.state, input));
        YkPointMotion p = yk_state_point(d.state, point);
        assert_true(isnan(p.position[0]) && isnan(p.velocity[1]) && isnan(p.acceleration[1]));
        assert_int_equal(yk_state_branch(d.state, block), 0);
        assert_true(isnan(yk_state_transmission(d.state, block)));
        yk_state_set_input_to(d.state, input, 1, 2, 3);
        yk_state_hold_input(d.state, input, 0, 1);
        yk_state_hold_input(d.state, 0, 3, 1);
        yk_state_set_branch(d.state, block, -1);
        YkRange range;
        assert_int_equal(yk_closing_ranges(d.state, coordinate, &range, 1), 0);
    }
    assert_true(yk_model_find_joint(d.model, "nothing") == YK_NOT_FOUND);
    close_door(d);
}

static void blocks_of_carriages_answer(void **unused)
{
    (void)unused;
    Door d = open_door("floating-plate.yaml"); // its free joint has carriages, which no answer tells of
    for (size_t b = 0; b < yk_block_count(d.mech); b++) {
        YkBlockInfo of = yk_block_info(d.mech, b);
        for (size_t k = 0; k < of.joint_count; k++)
            assert_true(yk_block_joint(d.mech, b, k) < yk_model_joint_count(d.model));
        for (size_t k = 0; k < of.body_count; k++)
            assert_true(yk_block_body(d.mech, b, k) < yk_model_body_count(d.model));
        assert_true(yk_block_joint(d.mech, b, of.joint_count) == YK_NOT_FOUND);
        assert_true(yk_block_body(d.mech, b, of.body_count) == YK_NOT_FOUND);
    }
    size_t past_last = yk_model_joint_count(d.model); // where carriages have their joints
    assert_true(!yk_model_joint_name(d.model, past_last) && !yk_model_joint_kind(d.model, past_last));
    assert_true(yk_model_joint_body(d.model, past_last, 0) == YK_NOT_FOUND);
    YkDynamics *f = yk_dynamics_new(d.mech, NULL);
    assert_true(yk_dynamics_solve(f, d.state, YK_METHOD_REDUCED) >= 0);
    assert_true(yk_dynamics_reaction(f, past_last).on == YK_NOT_FOUND);
    assert_true(yk_dynamics_reaction(f, 0).on < yk_model_body_count(d.model));
    yk_dynamics_free(f);
    close_door(d);
}

static void points_and_joints_are_found_with_their_places(void **unused)
{
    (void)unused;
    Door d = open_door("four-bar.yaml");
    for (size_t p = 0; p < yk_model_point_count(d.model); p++) { // the place, moved with its body, is the point's
        double place[2];
        yk_model_point_place(d.model, p, place);
        YkDrag *drag = yk_drag_new(d.state, yk_model_point_body(d.model, p), place, NULL);
        YkPointMotion at = yk_state_point(d.state, p);
        YkDragged dragged;
        assert_int_equal(yk_state_drag(drag, at.position, &dragged), YK_OK);
        CHECK_NEAR(dragged.distance, 0, 1e-12);
        yk_drag_free(drag);
    }
    for (size_t j = 0; j < yk_model_joint_count(d.model); j++)
        assert_int_equal(yk_model_find_joint(d.model, yk_model_joint_name(d.model, j)), j);
    close_door(d);
}

static void check_reaction(YkReaction r)
{
    assert_true(r.by == YK_NOT_FOUND && r.on == YK_NOT_FOUND && isnan(r.force[0]) && isnan(r.moment) && isnan(r.at[1]));
}

static void forces_answer(void **unused)
{
    (void)unused;
    Door d = open_door("valve-cam.yaml");
    YkDynamics *f = yk_dynamics_new(d.mech, NULL);
    assert_true(yk_dynamics_solve(f, d.state, YK_METHOD_REDUCED) >= 0);
    for (int which = 0; which < 2; which++) {
        size_t coordinate = past(yk_coordinate_count(d.mech), which), input = past(yk_input_count(d.mech), which),
               contact = past(yk_dynamics_contact_count(f), which);
        check_reaction(yk_dynamics_reaction(f, past(yk_model_joint_count(d.model), which)));
        check_reaction(yk_dynamics_contact(f, contact));
        assert_null(yk_dynamics_contact_name(f, contact));
        assert_false(yk_dynamics_contact_pulls(f, contact));
        assert_true(isnan(yk_dynamics_effort(f, coordinate)));
        YkEffortRange range = yk_dynamics_effort_range(f, coordinate);
        assert_true(!range.is_single && !range.is_known && isinf(range.low) && isinf(range.high));
        assert_false(yk_dynamics_has_effort(f, coordinate));
        assert_false(yk_dynamics_is_prescribed(f, input));
        assert_true(isnan(yk_dynamics_balance(f, past(yk_model_body_count(d.model), which)).residual));
        yk_dynamics_prescribe(f, input, true);
        yk_dynamics_set_effort(f, coordinate, 1);
    }
    yk_dynamics_free(f);
    close_door(d);
}

static void sweeps_and_simulations_answer(void **unused)
{
    (void)unused;
    Door d = open_door("four-bar.yaml");
    YkSweepOptions options = yk_default_sweep_options();
    options.coordinate = (int)yk_input_coordinate(d.mech, 0);
    YkSweep *sweep = yk_sweep_run(d.state, &options, NULL, 0, NULL);
    assert_non_null(sweep);
    YkDerivation *derivation = yk_derivation_new(d.model, d.mech, NULL);
    YkProblems *problems = yk_problems_new();
    YkModel *pendulum = yk_model_load(YOKE_ROOT "/examples/pendulum.yaml", NULL, problems);
    YkSimulation *simulation = yk_simulation_new(pendulum, NULL, problems);
    YkRest *rest = yk_rest_find(pendulum, NULL, problems);
    YkSketch *sketch = yk_sketch_load(YOKE_ROOT "/examples/four-bar.yaml", NULL, problems);
    assert_true(derivation && simulation && rest && sketch);
    for (int which = 0; which < 2; which++) {
        size_t row = past(yk_sweep_row_count(sweep), which), event = past(yk_sweep_event_count(sweep), which),
               section = past(yk_derivation_section_count(), which), k = past(yk_rest_freedom(rest), which),
               index = past(yk_rest_count(rest), which);
        assert_true(isnan(yk_sweep_at(sweep, row)) && isnan(yk_sweep_value(sweep, 0, past(0, which))));
        assert_true(yk_sweep_row_status(sweep, row) == YK_BAD_ARGUMENT);
        assert_true(yk_sweep_event(sweep, event).channel == YK_NOT_FOUND);
        assert_true(isnan(yk_sweep_event(sweep, event).at) && isnan(yk_sweep_event_value(sweep, event, 0)));
        assert_null(yk_derivation_section_name(section));
        assert_null(yk_derivation_section_title(section));
        assert_false(yk_derivation_has_section(derivation, section));
        assert_true(
            isnan(yk_simulation_happening(simulation, past(yk_simulation_happening_count(simulation), which)).time));
        assert_true(isnan(yk_simulation_work(simulation, past(yk_simulation_work_count(simulation), which))));
        assert_null(yk_simulation_work_name(simulation, past(yk_simulation_work_count(simulation), which)));
        assert_null(yk_rest_state(rest, index));
        assert_int_equal(yk_rest_equilibrium(rest, index).stability, YK_STABILITY_NONE);
        assert_true(isnan(yk_rest_equilibrium(rest, index).potential) && yk_rest_input(rest, k) == YK_NOT_FOUND);
        assert_true(!yk_rest_mass(rest, index) && !yk_rest_damping(rest, index) && !yk_rest_stiffness(rest, index));
        assert_true(isnan(yk_rest_mode(rest, index, 0).frequency) && isnan(yk_rest_mode(rest, 0, k).frequency));
        double real, imaginary;
        yk_rest_root(rest, 0, past(2 * yk_rest_freedom(rest), which), &real, &imaginary);
        assert_true(isnan(real) && isnan(imaginary));
        YkLack lack = yk_sketch_lack(sketch, past(yk_sketch_lack_count(sketch), which));
        assert_true(lack.body == YK_NOT_FOUND && lack.coordinate == YK_NOT_FOUND);
    }
    yk_sketch_free(sketch);
    yk_rest_free(rest);
    yk_simulation_free(simulation);
    yk_model_free(pendulum);
    yk_problems_free(problems);
    yk_derivation_free(derivation);
    yk_sweep_free(sweep);
    close_door(d);
}

static void trains_and_cams_answer(void **unused)
{
    (void)unused;
    Door d = open_door("planetary-gear.yaml");
    YkProblems *problems = yk_problems_new();
    YkTrain *train = yk_train_new(d.model, NULL, problems);
    YkModel *cams = yk_model_load(YOKE_ROOT "/examples/valve-cam.yaml", NULL, problems);
    YkCamDesign *cam = yk_cam_design_new(cams, 0);
    assert_true(train && cam);
    for (int which = 0; which < 2; which++) {
        size_t member = past(yk_train_body_count(train), which), input = past(yk_train_input_count(train), which),
               mesh = past(yk_train_mesh_count(train), which), segment = past(yk_cam_segment_count(cam), which);
        assert_true(isnan(yk_train_input(train, input).speed) && isnan(yk_train_body(train, member).speed));
        assert_true(isnan(yk_train_share(train, member, 0).value) && isnan(yk_train_share(train, 0, input).value));
        assert_true(!yk_train_mesh(train, mesh).name && isnan(yk_train_rack_speed(train, mesh)));
        YkTrainMesh none = yk_train_mesh(train, mesh);
        assert_true(none.body[0] == YK_NOT_FOUND && none.body[1] == YK_NOT_FOUND && none.driver == -1);
        assert_true(isnan(none.torque[1]) && isnan(none.radius[0]) && isnan(none.loss));
        YkTrainGear gear = yk_train_gear(train, past(yk_train_gear_count(train), which));
        assert_true(!gear.lock && gear.ratio.in == YK_NOT_FOUND && isnan(gear.ratio.value));
        YkTrainTable table = yk_train_table(train, past(yk_train_table_count(train), which));
        assert_true(table.count == 0 && isnan(table.x) && isnan(table.y));
        YkTrainTorque torque = yk_train_torque(train, past(yk_train_torque_count(train), which));
        assert_true(torque.on == YK_NOT_FOUND && isnan(torque.torque) && isnan(torque.power));
        assert_null(yk_train_remark(train, past(yk_train_remark_count(train), which)).text);
        assert_true(isnan(yk_cam_segment(cam, segment).from) && isnan(yk_cam_condition(cam, segment, 0).at));
        assert_true(isnan(yk_cam_condition(cam, 0, past(yk_cam_segment(cam, 0).condition_count, which)).value));
        assert_null(yk_cam_design_new(cams, past(1, which)));
    }
    yk_cam_design_free(cam);
    yk_model_free(cams);
    yk_train_free(train);
    yk_problems_free(problems);
    close_door(d);
}

// What goes wrong goes wrong in the same way where nobody wants to hear why.
static void problems_may_be_null(void **unused)
{
    (void)unused;
    Door d = open_door("four-bar.yaml");
    YkChannel channel;
    double value;
    assert_null(yk_model_load("there/is/no.yaml", NULL, NULL));
    for (const char *const *text =
             (const char *const[]){"", "joints: {}", "bodies: {ground: {points: {O: [0, 0]}}}\nnonsense: 1",
                                   "bodies: {a: {points: {O: [0, x]}}}", NULL};
         *text; text++)
        assert_null(yk_model_parse(*text, strlen(*text), "text", NULL, NULL));
    YkCompileOptions both = yk_default_compile_options();
    both.inputs = (const char *const[]){"theta2", "nothing"};
    both.input_count = 2;
    assert_null(yk_mechanism_compile(d.model, &both, NULL));
    assert_int_equal(yk_channel_parse(d.mech, "nothing", &channel, NULL), YK_BAD_ARGUMENT);
    assert_int_equal(yk_model_value(d.model, "1 +", YK_QUANTITY_NUMBER, &value, NULL), YK_BAD_ARGUMENT);
    assert_null(yk_variant_new(d.mech, (const char *const[]){"nothing"}, 1, NULL));
    assert_null(yk_map_new(d.state, YK_NOT_FOUND, NULL));
    assert_null(yk_task_parse("kind: nothing", 13, "text", NULL));
    close_door(d);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(models_and_mechanisms_answer),
        cmocka_unit_test(blocks_of_carriages_answer),
        cmocka_unit_test(points_and_joints_are_found_with_their_places),
        cmocka_unit_test(forces_answer),
        cmocka_unit_test(sweeps_and_simulations_answer),
        cmocka_unit_test(trains_and_cams_answer),
        cmocka_unit_test(problems_may_be_null),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

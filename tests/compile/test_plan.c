// The order of solution: which blocks, with which labels, in which order, for every machine of the table; and the rules
// of any plan: each body is placed once, each block needs only earlier ones, each unknown is found exactly once.
#include "compile/plan.h"
#include "machine.h"
#include "table.h"

static void freedom_inputs_loops_and_blocks_are_as_known(void **state)
{
    (void)state;
    assert_true(MACHINES >= 50);
    for (size_t k = 0; k < MACHINES; k++) {
        const Known *known = &machines[k];
        Machine m = machine(known->source);
        YkFreedom f = yk_mechanism_freedom(m.mech);
        char inputs[200], blocks[400];
        describe_inputs(m.mech, inputs, sizeof inputs);
        describe_blocks(m.mech, blocks, sizeof blocks);
        if (f.gruebler != known->gruebler || f.by_rank != known->by_rank || strcmp(blocks, known->blocks))
            print_error("%s\n", known->source);
        assert_int_equal(f.gruebler, known->gruebler);
        assert_int_equal(f.by_rank, known->by_rank);
        assert_int_equal(f.redundant, known->by_rank - known->gruebler);
        assert_int_equal(f.driven, m.model->drive_count);
        assert_int_equal(yk_loop_count(m.mech), known->loops);
        assert_string_equal(inputs, known->inputs);
        assert_string_equal(blocks, known->blocks);
        machine_free(&m);
    }
}

// Gruebler's count from the kinds' names alone.
static void gruebler_counts_three_a_body_less_what_joints_take(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        int count = 3 * ((int)yk_model_body_count(m.model) - 1);
        for (size_t j = 0; j < yk_model_joint_count(m.model); j++) {
            const char *kind = yk_model_joint_kind(m.model, j);
            count -= strcmp(kind, "weld") == 0 ? 3 : strcmp(kind, "pin-slot") == 0 ? 1 : 2;
        }
        assert_int_equal(yk_mechanism_freedom(m.mech).gruebler, count);
        machine_free(&m);
    }
}

// --- laws of any plan
// ---------------------------------------------------------------------------------------------------

typedef struct Seen {
    bool *slot, *distance, *node;
} Seen;

static void check_sum(const YkMechanism *mech, const Seen *seen, const YkSum *sum)
{
    assert_true(sum->plus == YK_NONE || seen->node[sum->plus]);
    assert_true(sum->minus == YK_NONE || seen->node[sum->minus]);
    for (uint32_t k = 0; k < sum->count; k++) {
        YkTerm t = mech->terms[sum->first + k];
        assert_true(seen->slot[t.slot]);
        assert_true(t.distance == YK_NONE || seen->distance[t.distance]);
    }
}

// Group loops hold their unknowns: those count as known once the group's columns are.
static void check_block(const YkMechanism *mech, const Seen *seen, const YkBlock *b)
{
    if (b->kind == YK_BLOCK_GROUP) return;
    check_sum(mech, seen, &b->known);
    size_t angles = 0;
    for (size_t c = 0; c < b->column_count; c++) angles += !b->column[c].is_distance;
    for (size_t a = 0; a < angles; a++) {
        check_sum(mech, seen, &b->aside->arm[a]);
        assert_int_equal(b->arm_is_constant[a], b->aside->arm[a].count == 0);
    }
}

static void learn(const YkMechanism *mech, Seen *seen, YkColumn c)
{
    bool *known = c.is_distance ? &seen->distance[c.index] : &seen->slot[c.index];
    assert_false(*known); // found once
    *known = true;
    if (!c.is_distance) assert_int_equal(mech->group_root[c.index], c.index);
}

static void run_step(const YkMechanism *mech, Seen *seen, const YkStep *step)
{
    switch (step->kind) {
    case YK_STEP_TURN:
        assert_true(seen->slot[step->parent]);
        assert_false(seen->slot[step->target]);
        seen->slot[step->target] = true;
        break;
    case YK_STEP_COMPOSE:
        assert_true(seen->slot[step->parent] && seen->slot[step->other]);
        assert_false(seen->slot[step->target]);
        seen->slot[step->target] = true;
        break;
    case YK_STEP_DISTANCE:
        assert_false(seen->distance[step->target]);
        seen->distance[step->target] = true;
        break;
    case YK_STEP_NODE:
        check_sum(mech, seen, &mech->node_sums[step->target]);
        assert_false(seen->node[step->target]);
        seen->node[step->target] = true;
        break;
    case YK_STEP_BLOCK: {
        const YkBlock *b = &mech->blocks[step->target];
        check_block(mech, seen, b);
        for (size_t c = 0; c < b->column_count; c++)
            learn(mech, seen, b->kind == YK_BLOCK_GROUP ? mech->group_columns[b->first_column + c] : b->column[c]);
        for (size_t l = 0; b->kind == YK_BLOCK_GROUP && l < b->loop_count; l++)
            for (uint32_t k = 0; k < mech->group_loops[b->first_loop + l].count; k++) {
                int32_t slot = mech->terms[mech->group_loops[b->first_loop + l].first + k].slot;
                assert_true(seen->slot[slot] || seen->slot[mech->group_root[slot]]);
            }
        break;
    }
    }
}

static void check_plan(const YkMechanism *mech)
{
    Seen seen = {calloc(mech->slot_count + 1, sizeof(bool)), calloc(mech->distance_count + 1, sizeof(bool)),
                 calloc(mech->node_count + 1, sizeof(bool))};
    assert_true(seen.slot && seen.distance && seen.node);
    seen.slot[0] = true;
    for (size_t s = 0; s < mech->step_count; s++) run_step(mech, &seen, &mech->steps[s]);
    for (size_t o = 0; o < mech->orientation_count; o++) assert_true(seen.slot[o]); // all is found at the end
    for (size_t d = 0; d < mech->distance_count; d++) assert_true(seen.distance[d]);
    for (size_t n = 0; n < mech->node_count; n++) assert_true(seen.node[n]);
    for (size_t b = 0; b < mech->model->body_count; b++) check_sum(mech, &seen, &mech->bodies[b].origin);
    free(seen.slot);
    free(seen.distance);
    free(seen.node);
}

static void every_step_needs_only_what_stands_before_it(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        check_plan(m.mech);
        machine_free(&m);
    }
}

// Whatever coordinates are inputs: every choice of as many as there are freedoms either gives a plan or is refused.
static void every_choice_of_inputs_gives_a_valid_plan_or_is_refused(void **state)
{
    (void)state;
    size_t planned = 0, refused = 0;
    for (size_t k = 0; k < MACHINES; k++) {
        if (machines[k].by_rank != 1) continue;
        Machine first = machine(machines[k].source);
        size_t drives = first.model->drive_count;
        for (size_t c = 0; c < yk_coordinate_count(first.mech); c++) {
            const char *name = yk_coordinate_info(first.mech, c).name;
            Machine m = machine_try(machines[k].source, &(YkCompileOptions){&name, 1});
            if (m.mech) {
                assert_int_equal(yk_input_count(m.mech), 1); // and it stands in for the drive
                assert_string_equal(yk_coordinate_info(m.mech, yk_input_coordinate(m.mech, 0)).name, name);
                check_plan(m.mech);
                planned++;
            } else {
                assert_int_equal(yk_problems_get(m.problems, yk_problems_count(m.problems) - 1)->code,
                                 YK_CODE_OVERDRIVEN);
                refused++;
            }
            machine_free(&m);
        }
        assert_true(drives <= 1);
        machine_free(&first);
    }
    assert_true(planned > 100);
    assert_true(refused < 12); // only coordinates that cannot move, as the rod's angle of parallel cranks
}

static void blocks_list_the_bodies_and_joints_they_place_once(void **state)
{
    (void)state;
    for (size_t k = 0; k < MACHINES; k++) {
        Machine m = machine(machines[k].source);
        size_t placed[32] = {0}, used[32] = {0};
        bool has_group = false;
        for (size_t b = 0; b < yk_block_count(m.mech); b++) {
            YkBlockInfo info = yk_block_info(m.mech, b);
            has_group = has_group || info.kind == YK_BLOCK_GROUP;
            bool is_dyad = info.kind <= YK_BLOCK_PP;
            assert_int_equal(info.assur_class == 2, is_dyad);
            if (is_dyad) assert_true(info.unknowns == 2 && info.equations == 2 && info.body_count >= 1);
            if (info.kind == YK_BLOCK_LINK) assert_true(info.unknowns == 1 && info.equations == 2);
            if (info.kind == YK_BLOCK_GROUP) assert_true(info.equations >= info.unknowns && info.assur_class >= 3);
            for (size_t i = 0; i < info.body_count; i++) placed[yk_block_body(m.mech, b, i)]++;
            for (size_t i = 0; i < info.joint_count; i++) used[yk_block_joint(m.mech, b, i)]++;
            for (size_t other = 0; other < b; other++)
                assert_string_not_equal(info.label, yk_block_info(m.mech, other).label);
        }
        assert_int_equal(placed[0], 0);
        for (size_t b = 0; b < yk_model_body_count(m.model); b++) assert_true(placed[b] <= 1);
        for (size_t j = 0; j < yk_model_joint_count(m.model); j++) assert_true(used[j] <= 1);
        (void)has_group;
        machine_free(&m);
    }
}

static void redundant_joints_are_named(void **state)
{
    (void)state;
    static const struct {
        const char *source, *joint;
    } cases[] = {{"three-crank-parallelogram", "A3"},
                 {"doubled-guide", "lower"},
                 {tied_parallelogram, "N"},
                 {cardan, "V"},
                 {braced_square, "Cp"}};
    for (size_t k = 0; k < 5; k++) {
        Machine m = machine(cases[k].source);
        assert_int_equal(yk_redundant_count(m.mech), 1);
        const char *name = yk_model_joint_name(m.model, yk_redundant_joint(m.mech, 0));
        if (k == 4) // its two joints close together
            assert_true(*name == 'C' || *name == 'A');
        else if (k == 0)
            assert_true(strcmp(name, "A3") == 0 || strcmp(name, "O3") == 0);
        else
            assert_string_equal(name, cases[k].joint);
        machine_free(&m);
    }
}

// A drive that floats between two unknown bodies: they form one cluster, placed by one dyad.
static void driven_joints_make_clusters(void **state)
{
    (void)state;
    Machine m = machine(floating_drive);
    assert_int_equal(yk_block_count(m.mech), 1);
    YkBlockInfo info = yk_block_info(m.mech, 0);
    assert_int_equal(info.body_count, 3); // rocker, and crank with coupler as one
    size_t relative = m.mech->slot_count - m.mech->orientation_count;
    assert_int_equal(relative, 1); // the coupler turns with the crank
    machine_free(&m);
}

// Chains of bodies fixed to each other, inside a group, entered at either end.
static void clusters_inside_groups_are_walked_from_any_end(void **state)
{
    (void)state;
    enum { CHAIN = 20000 };
    for (int far_end = 0; far_end < 2; far_end++) {
        char *text = malloc(CHAIN * 100 + 4000);
        size_t n = 0, room = CHAIN * 100 + 4000;
        assert_non_null(text);
        // the awkward Stephenson, its coupler's point A held over a long chain of welds
        n += (size_t)snprintf(text + n, room - n,
                              "bodies:\n  ground: {points: {O2: [0, 0], O4: [4, 0], O6: [6, 2.5]}}\n" LINK(
                                  "crank", "O2", "A", "1") LINK("rocker", "O4", "B", "3") LINK("link", "C", "D", "4.5")
                                  LINK("output", "O6", "D", "2.5") "  w0: {points: {%s}}\n",
                              far_end ? "B: [3.5, 0], C: [2, 1.5]" : "A: [0, 0]");
        for (int k = 1; k < CHAIN; k++)
            n += (size_t)snprintf(text + n, room - n, "  w%d: {%s}\n", k,
                                  k < CHAIN - 1 ? ""
                                  : far_end     ? "points: {A: [0, 0]}"
                                                : "points: {B: [3.5, 0], C: [2, 1.5]}");
        n += (size_t)snprintf(text + n, room - n,
                              "joints:\n  O6: {pin: [ground, output], angle: t6}\n  D: {pin: [output, link], angle: "
                              "t5}\n  O2: {pin: [ground, crank], angle: t2}\n"
                              "  A: {pin: [crank, w%d], angle: t3}\n  O4: {pin: [ground, rocker], angle: t4}\n  B: "
                              "{pin: [w%d, rocker]}\n  C: {pin: [w%d, link]}\n",
                              far_end ? CHAIN - 1 : 0, far_end ? 0 : CHAIN - 1, far_end ? 0 : CHAIN - 1);
        for (int k = 1; k < CHAIN; k++)
            n += (size_t)snprintf(text + n, room - n, "  W%d: {weld: [w%d, w%d]}\n", k, k - 1, k);
        snprintf(text + n, room - n,
                 "drives: {t6: 120 deg}\nstart: {t2: 120 deg, t3: -90 deg, t4: 119 deg, t5: -101 deg}\n");
        Machine m = machine(text);
        assert_int_equal(yk_block_count(m.mech), 1);
        assert_int_equal(yk_block_info(m.mech, 0).kind, YK_BLOCK_GROUP);
        assert_int_equal(yk_block_info(m.mech, 0).unknowns, 4);
        check_plan(m.mech);
        machine_free(&m);
        free(text);
    }
}

// An arm that is short beside the machine is handled with care, whichever of the two it is.
static void a_short_arm_is_seen_on_either_side(void **state)
{
    (void)state;
    static const char *const lengths[][2] = {{"1", "1"},      {"1e-4", "2"}, {"2", "1e-4"}, {"0.9e-3", "2"},
                                             {"2", "0.9e-3"}, {"0.1", "2"},  {"2", "0.1"}};
    for (size_t k = 0; k < sizeof lengths / sizeof *lengths; k++) {
        YkOverride overrides[] = {{"b", lengths[k][0]}, {"c", lengths[k][1]}};
        Machine m = machine_try_with(
            "parameters: {b: 1, c: 1}\nbodies:\n  ground: {points: {O: [0, 0], Q: [2, 0]}}\n"
            "  crank: {points: {O: [0, 0], A: [1, 0]}}\n  coupler: {points: {A: [0, 0], B: [b, 0.1*b]}}\n"
            "  rocker: {points: {Q: [0, 0], B: [c, 0]}}\njoints:\n  O: {pin: [ground, crank], angle: th}\n"
            "  A: {pin: [crank, coupler], angle: u}\n  Q: {pin: [ground, rocker], angle: v}\n"
            "  B: {pin: [coupler, rocker]}\ndrives: {th: 1}\nstart: {u: 1, v: 2}\n",
            &(YkLoadOptions){overrides, 2, NULL}, NULL);
        assert_non_null(m.mech);
        double shorter = fmin(atof(lengths[k][0]), atof(lengths[k][1]));
        bool is_short = shorter < 1e-3 * yk_mechanism_size(m.mech) * 0.99;
        assert_int_equal(m.mech->blocks[0].form, is_short ? YK_FORM_RRR_SHORT : YK_FORM_RRR);
        machine_free(&m);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(freedom_inputs_loops_and_blocks_are_as_known),
        cmocka_unit_test(gruebler_counts_three_a_body_less_what_joints_take),
        cmocka_unit_test(every_step_needs_only_what_stands_before_it),
        cmocka_unit_test(every_choice_of_inputs_gives_a_valid_plan_or_is_refused),
        cmocka_unit_test(blocks_list_the_bodies_and_joints_they_place_once),
        cmocka_unit_test(redundant_joints_are_named),
        cmocka_unit_test(a_short_arm_is_seen_on_either_side),
        cmocka_unit_test(driven_joints_make_clusters),
        cmocka_unit_test(clusters_inside_groups_are_walked_from_any_end),
    };
    return cmocka_run_group_tests_name("compile/plan", tests, NULL, NULL);
}

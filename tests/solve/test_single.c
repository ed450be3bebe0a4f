// One pose by values has the bits of the lanes: every step of the gallery's machines and of those below, in every form
// of a block.
#include "machine.h"
#include "solve/state.h"

enum { LANES = 3, POSES = 60, FORMS = YK_FORM_RPR_AXIAL + 1 };
static size_t seen[FORMS], closed, sliding[2], hung[2]; // terms with a distance; sums from nodes, less nodes

// Arms, lines and slides that lie askew, or on what turns.
static const char *const others[] = {
    "bodies: {ground: {points: {O: [0, 0], Q: [4, 1]}}, crank: {points: {O: [0, 0], A: [1, 0.2]}}, arm: {points: {Q: "
    "[0, 0], P: [0.1, 0.3]}}, block: {points: {A: [0, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, Q: {pin: [ground, arm], angle: u}, S: {slide: [arm, block], "
    "along: 0.7, from: P, distance: v}, A: {pin: [crank, block]}}\n"
    "drives: {theta: 0.4 rad + 1.3 rad/s * t}\n",
    "bodies: {ground: {points: {O: [0, 0], G: [0, 0.3]}}, crank: {points: {O: [0, 0], A: [1, 0]}}, rod: {points: {A: "
    "[0, 0], B: [3, 0.4]}}, piston: {points: {B: [0, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, rod], angle: u}, B: {pin: [rod, piston]}, R: "
    "{slide: [ground, piston], along: 0.3, from: G, distance: v}}\n"
    "drives: {theta: 0.4 rad + 1.3 rad/s * t}\n",
    "bodies: {ground: {points: {O: [0, 0], G: [0.2, 0.3]}}, table: {points: {O: [0, 0], R: [0.1, 0.2]}}, crank: "
    "{points: {G: [0, 0], A: [0.5, 0.1]}}, rod: {points: {A: [0, 0], B: [2, 0.4]}}, piston: {points: {B: [0, 0]}}}\n"
    "joints: {O: {pin: [ground, table], angle: phi}, G: {pin: [ground, crank], angle: theta}, A: {pin: [crank, rod], "
    "angle: u}, B: {pin: [rod, piston]}, R: {slide: [table, piston], along: 0.3, from: R, distance: v}}\n"
    "drives: {theta: 0.4 rad + 1.3 rad/s * t, phi: 0.1 rad - 0.7 rad/s * t}\n",
    // distances as inputs: along what turns, along the ground
    "bodies: {ground: {points: {O: [0, 0], Q: [4, 0]}}, arm: {points: {O: [0, 0]}}, carriage: {points: {C: [0.1, "
    "0.2]}}, coupler: {points: {C: [0, 0], D: [3, 0]}}, rocker: {points: {Q: [0, 0], D: [2.5, 0]}}}\n"
    "joints: {O: {pin: [ground, arm], angle: theta}, S: {slide: [arm, carriage], along: 0.2, distance: s}, C: {pin: "
    "[carriage, coupler], angle: u}, Q: {pin: [ground, rocker], angle: v}, D: {pin: [coupler, rocker]}}\n"
    "drives: {theta: 0.4 rad + 1.3 rad/s * t, s: 1 m + 0.1 m/s * t}\n",
    "bodies: {ground: {points: {Q: [4, 0]}}, carriage: {points: {C: [0.1, 0.2]}}, coupler: {points: {C: [0, 0], D: [3, "
    "0]}}, rocker: {points: {Q: [0, 0], D: [2.5, 0]}}}\n"
    "joints: {S: {slide: [ground, carriage], along: 0.2, distance: s}, C: {pin: [carriage, coupler], angle: u}, Q: "
    "{pin: [ground, rocker], angle: v}, D: {pin: [coupler, rocker]}}\n"
    "drives: {s: 1 m + 0.1 m/s * t}\n",
    // arms that are short beside the machine: both, and the second alone
    "bodies: {ground: {points: {O: [0, 0], Q: [4, 0], F: [5000, 0]}}, crank: {points: {O: [0, 0], A: [1, 0.2]}}, "
    "coupler: {points: {A: [0, 0], B: [3.5, 0.3]}}, rocker: {points: {Q: [0, 0], B: [3, -0.1]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, coupler], angle: u}, Q: {pin: [ground, "
    "rocker], angle: v}, B: {pin: [coupler, rocker]}}\n"
    "drives: {theta: 0.4 rad + 1.3 rad/s * t}\n",
    "bodies: {ground: {points: {O: [0, 0], Q: [4, 0]}}, crank: {points: {O: [0, 0], A: [0.001, 0]}}, coupler: "
    "{points: {A: [0, 0], B: [3.999, 0.1]}}, rocker: {points: {Q: [0, 0], B: [0.0035, 0.0001]}}, far: {points: {Q: "
    "[0, 0], E: [9, 0]}}}\n"
    "joints: {O: {pin: [ground, crank], angle: theta}, A: {pin: [crank, coupler], angle: u}, Q: {pin: [ground, "
    "rocker], angle: v}, B: {pin: [coupler, rocker]}, E: {pin: [ground, far], at: Q, angle: w}}\n"
    "drives: {theta: 0.4 rad + 1.3 rad/s * t, w: 0}\n",
    // two arms of many links, and a dyad between their tips: sums from nodes
    "bodies: {ground: {points: {L0: [0, 0], R0: [1, 0]}}, l1: {points: {L0: [0, 0], L1: [0.9, 0]}}, l2: {points: {L1: "
    "[0, 0], L2: [0.7, 0]}}, l3: {points: {L2: [0, 0], L3: [0.8, 0]}}, l4: {points: {L3: [0, 0], L4: [0.6, 0]}}, l5: "
    "{points: {L4: [0, 0], L5: [0.5, 0]}}, l6: {points: {L5: [0, 0], L6: [0.4, 0]}}, r1: {points: {R0: [0, 0], R1: "
    "[0.9, 0]}}, r2: {points: {R1: [0, 0], R2: [0.7, 0]}}, r3: {points: {R2: [0, 0], R3: [0.8, 0]}}, r4: {points: {R3: "
    "[0, 0], R4: [0.6, 0]}}, r5: {points: {R4: [0, 0], R5: [0.5, 0]}}, r6: {points: {R5: [0, 0], R6: [0.4, 0]}}, u: "
    "{points: {L6: [0, 0], X: [4, 0.1]}}, v: {points: {R6: [0, 0], X: [4.2, 0]}}}\n"
    "joints: {L0: {pin: [ground, l1], angle: qL1}, L1: {pin: [l1, l2], angle: qL2}, L2: {pin: [l2, l3], angle: qL3}, "
    "L3: {pin: [l3, l4], angle: qL4}, L4: {pin: [l4, l5], angle: qL5}, L5: {pin: [l5, l6], angle: qL6}, R0: {pin: "
    "[ground, r1], angle: qR1}, R1: {pin: [r1, r2], angle: qR2}, R2: {pin: [r2, r3], angle: qR3}, R3: {pin: [r3, r4], "
    "angle: qR4}, R4: {pin: [r4, r5], angle: qR5}, R5: {pin: [r5, r6], angle: qR6}, L6: {pin: [l6, u], angle: a}, R6: "
    "{pin: [r6, v], angle: b}, X: {pin: [u, v]}}\n"
    "drives: {qL1: 0.9 rad + 0.5 rad/s * t, qL2: 0.3 rad, qL3: -0.2 rad, qL4: 0.4 rad, qL5: 0.1 rad, qL6: 0.2 rad, "
    "qR1: 0.9 rad + 0.5 rad/s * t, qR2: 0.3 rad, qR3: -0.2 rad, qR4: 0.4 rad, qR5: 0.1 rad, qR6: 0.2 rad}\n",
};

static void same_rows(const double *one, const double *many, size_t rows)
{
    for (size_t k = 0; k < rows; k++) {
        assert_memory_equal(&one[k], &many[k * LANES], sizeof *one);
    }
}

// Both spaces hold the same things in the same order. What does not close is garbage, and masked by its margin.
static void compare(const YkSpace *one, const YkSpace *many)
{
    same_rows(one->margin, many->margin, 1);
    if (!(one->margin[0] > YK_SINGULAR_MARGIN)) return;
    closed++;
    same_rows(one->data + 4, many->data + 4 * LANES, 4 * (one->slots - 1));
    same_rows(one->slides, many->slides, 3 * one->distances);
    same_rows(one->planes, many->planes, 6 * one->nodes);
    same_rows(one->gap, many->gap, 1);
}

static void run_both(const Machine *m, YkSpace *one, YkSpace *many)
{
    YkState *s = m->state;
    size_t inputs = 3 * m->mech->input_count;
    double *rows = calloc(inputs + 1, LANES * sizeof *rows);
    const double **lanes = calloc(inputs + 1, sizeof *lanes);
    assert_true(rows && lanes);
    for (size_t i = 0; i < inputs; i++) {
        lanes[i] = rows + i * LANES;
        for (size_t k = 0; k < LANES; k++) rows[i * LANES + k] = s->input[i];
    }
    YkRun single = yk_state_run(s, one), wide = {m->mech, many, lanes, s->branch, NULL, LANES, s->slot_reference};
    yk_run_begin(&single);
    yk_run_steps(&single, 0, m->mech->step_count);
    yk_run_begin(&wide);
    yk_run_steps(&wide, 0, m->mech->step_count);
    compare(one, many);
    free(rows);
    free((void *)lanes);
}

static void check(const Machine *m)
{
    YkSpace one, many;
    uint64_t seed = 7;
    if (m->mech->has_groups) return; // one at a time anyhow
    for (size_t b = 0; b < m->mech->block_count; b++) {
        const YkSum *known = &m->mech->blocks[b].known;
        seen[m->mech->blocks[b].form]++;
        hung[0] += known->plus != YK_NONE;
        hung[1] += known->minus != YK_NONE;
        for (uint32_t k = known->first; k < known->first + known->count; k++)
            if (m->mech->terms[k].distance != YK_NONE) sliding[m->mech->terms[k].slot != 0]++;
    }
    assert_true(yk_space_start(&one, m->mech, 1, true) && yk_space_start(&many, m->mech, LANES, true));
    for (int k = 0; k < POSES; k++) {
        for (size_t i = 0; i < m->mech->input_count; i++)
            yk_state_set_input_to(m->state, i, check_uniform(&seed, -3, 3), check_uniform(&seed, -2, 2),
                                  check_uniform(&seed, -2, 2));
        if (k == POSES - 1) yk_state_set_input_to(m->state, 0, 3e6, 1, 1); // beyond the quick reduction of angles
        run_both(m, &one, &many);
    }
    yk_space_end(&one);
    yk_space_end(&many);
}

static void one_pose_has_the_bits_of_lanes(void **unused)
{
    (void)unused;
    for (size_t k = 0; k < EXAMPLE_COUNT; k++) {
        Machine m = machine_load(all_examples[k]);
        check(&m);
        machine_free(&m);
    }
    for (size_t k = 0; k < sizeof others / sizeof *others; k++) {
        Machine m = machine_parse(others[k], true);
        check(&m);
        machine_free(&m);
    }
    assert_true(closed > 1000 && sliding[0] > 0 && sliding[1] > 0 && hung[0] > 0 && hung[1] > 0);
    for (size_t k = 0; k < FORMS; k++) assert_true(seen[k] > 0); // no form is left out
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(one_pose_has_the_bits_of_lanes)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

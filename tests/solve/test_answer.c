// Answers from a pose: bodies' angles one by one, all at once and in a batch, along trees deeper than one piece of a way.
#include "compile/ladder.h"
#include "machine.h"

enum { LINKS = 1300, EVERY = 50 };

static double expected[LINKS + 1];

// A chain whose every joint is an input: a body's angle is the sum of those before it.
static void turn_all(Machine *m)
{
    uint64_t seed = 99;
    for (size_t i = 0; i < LINKS; i++) {
        yk_state_set_input(m->state, i, (YkMotion){check_uniform(&seed, -9, 9), check_uniform(&seed, -1, 1), 0});
        expected[i + 1] = expected[i] + yk_state_input(m->state, i).position;
    }
    assert_true(yk_state_solve(m->state) >= 0);
}

static void check_batch(const Machine *m, size_t body)
{
    YkChannel channel = {.kind = YK_CHANNEL_BODY, .index = (int)body};
    YkBatch *batch = yk_batch_new(m->state, &channel, 1);
    double value = NAN, *outputs[] = {&value};
    assert_non_null(batch);
    const double *inputs[3 * LINKS] = {NULL};
    signed char status = 0;
    yk_batch_run(batch, inputs, outputs, &status, 1);
    assert_true(value == yk_state_body(m->state, body).position);
    yk_batch_free(batch);
}

static void angles_of_bodies_have_the_same_bits_however_they_are_asked_for(void **unused)
{
    (void)unused;
    static YkMotion all[LINKS + 1];
    Story story = chain(LINKS);
    Machine m = machine_parse(story.text, true);
    turn_all(&m);
    yk_state_bodies(m.state, all);
    for (size_t b = 0; b <= LINKS; b++) {
        YkMotion one = yk_state_body(m.state, b);
        assert_true(one.position == all[b].position);
        assert_true(one.velocity == all[b].velocity);
        CHECK_NEAR(all[b].position, expected[b], 1e-10);
    }
    for (size_t b = 0; b <= LINKS; b += EVERY) check_batch(&m, b);
    machine_free(&m);
    free(story.text);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(angles_of_bodies_have_the_same_bits_however_they_are_asked_for),
    };
    return cmocka_run_group_tests_name("solve/answer", tests, NULL, NULL);
}

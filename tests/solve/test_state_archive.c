// A state that is written as bytes and read into a new one goes on with the same bits, whatever it stood at; bytes that
// end too early or make no sense are refused.
#include "machine.h"
#include "base/archive.h"
#include "solve/state.h"

enum { ROOM = 1 << 20 };
static unsigned char bytes[ROOM], again[ROOM];

static size_t written(YkState *state, unsigned char *to)
{
    YkArchive counted = {0}, archive = {.bytes = to, .capacity = ROOM};
    yk_state_archive(state, &counted);
    yk_state_archive(state, &archive);
    assert_false(archive.failed);
    assert_int_equal(counted.at, archive.at);
    return archive.at;
}

static void check_same(const YkState *a, const YkState *b, size_t coordinates)
{
    assert_int_equal(yk_state_report(a)->status, yk_state_report(b)->status);
    assert_string_equal(yk_state_report(a)->message, yk_state_report(b)->message);
    assert_int_equal(yk_state_report(a)->joint, yk_state_report(b)->joint);
    assert_int_equal(yk_state_has_rates(a), yk_state_has_rates(b));
    for (size_t c = 0; c < coordinates; c++) {
        YkMotion x = yk_state_coordinate(a, c), y = yk_state_coordinate(b, c);
        assert_memory_equal(&x, &y, sizeof x);
    }
}

// Goes to a pose, some of them out of reach, saves, reads; then both go the same way.
static void check_example(const char *file, uint64_t *seed)
{
    Machine m = machine_load(file);
    size_t coordinates = yk_coordinate_count(m.mech), inputs = yk_input_count(m.mech);
    for (int trial = 0; trial < 4; trial++) {
        YkState *other = yk_state_new(m.mech);
        assert_non_null(other);
        for (int k = 0; k < 3; k++) {
            for (size_t i = 0; i < inputs; i++) {
                double way = yk_input_unit(m.mech, i) * check_uniform(seed, -0.4, 0.4);
                yk_state_set_input(m.state, i,
                                   (YkMotion){yk_state_input(m.state, i).position + way, check_uniform(seed, -1, 1),
                                              check_uniform(seed, -1, 1)});
            }
            yk_state_solve(m.state);
        }
        for (size_t i = 0; i < inputs; i++)
            m.state->phases[i].value = check_uniform(seed, 0, 1), m.state->phases[i].angle = check_uniform(seed, 0, 7);
        for (size_t i = 0; i < inputs; i++) yk_state_hold_input(m.state, i, trial % 3, check_uniform(seed, -1, 1));
        size_t size = written(m.state, bytes);
        YkArchive archive = {.bytes = bytes, .capacity = size, .is_reading = true};
        yk_state_archive(other, &archive);
        assert_true(!archive.failed && archive.at == size);
        assert_int_equal(written(other, again), size);
        assert_memory_equal(bytes, again, size);
        check_same(m.state, other, coordinates);
        for (size_t i = 0; i < inputs; i++) {
            CHECK_NEAR(other->phases[i].value, m.state->phases[i].value, 0);
            CHECK_NEAR(other->phases[i].angle, m.state->phases[i].angle, 0);
        }
        YkState *at_time = yk_state_new(m.mech), *like = yk_state_new(m.mech); // what is held stays so at every time
        assert_true(at_time && like);
        yk_state_copy(at_time, m.state);
        yk_state_copy(like, other);
        assert_int_equal(yk_state_set_time(at_time, 0.1, NULL), yk_state_set_time(like, 0.1, NULL));
        for (size_t i = 0; i < inputs; i++) {
            YkMotion x = yk_state_input(at_time, i), y = yk_state_input(like, i);
            assert_memory_equal(&x, &y, sizeof x);
        }
        yk_state_free(at_time);
        yk_state_free(like);
        for (size_t i = 0; i < inputs; i++) {
            double at = yk_state_input(m.state, i).position + yk_input_unit(m.mech, i) * check_uniform(seed, -7, 7);
            yk_state_set_input(m.state, i, (YkMotion){at, 1, 0.5});
            yk_state_set_input(other, i, (YkMotion){at, 1, 0.5});
        }
        assert_int_equal(yk_state_solve(m.state), yk_state_solve(other));
        check_same(m.state, other, coordinates);
        yk_state_free(other);
    }
    machine_free(&m);
}

static void a_state_that_is_read_goes_on_with_the_same_bits(void **unused)
{
    (void)unused;
    uint64_t seed = 23;
    static const char *const files[] = {
        "four-bar",  "jansen",        "double-butterfly", "change-point-four-bar", "epicyclic-drive",
        "excavator", "doubled-guide", "geared-five-bar",  "flat-faced-cam",        "double-pendulum"};
    for (size_t k = 0; k < sizeof files / sizeof *files; k++) check_example(files[k], &seed);
}

static void bytes_that_end_early_or_make_no_sense_are_refused(void **unused)
{
    (void)unused;
    Machine m = machine_load("geared-five-bar");
    size_t size = written(m.state, bytes);
    for (size_t less = 1; less < size; less += 1 + less / 8) {
        YkArchive archive = {.bytes = bytes, .capacity = size - less, .is_reading = true};
        yk_state_archive(m.state, &archive);
        assert_true(archive.failed);
    }
    size_t report = size - sizeof m.state->report.message - 5 * 8; // status, block, joint, gap, determinant
    static const size_t places[] = {0, 8, 16};
    for (size_t k = 0; k < 3; k++)
        for (int value = 100; value < 250; value += 50) {
            memcpy(again, bytes, size);
            memset(again + report + places[k], value, 8);
            YkArchive archive = {.bytes = again, .capacity = size, .is_reading = true};
            yk_state_archive(m.state, &archive);
            assert_true(archive.failed);
        }
    YkArchive archive = {.bytes = bytes, .capacity = size, .is_reading = true};
    yk_state_archive(m.state, &archive);
    assert_false(archive.failed);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_state_that_is_read_goes_on_with_the_same_bits),
        cmocka_unit_test(bytes_that_end_early_or_make_no_sense_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

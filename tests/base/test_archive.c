// Archives: what is written is read back, in the same bytes on every machine, and what was not written is refused.
#include "base/archive.h"
#include "check.h"

typedef struct Values {
    uint64_t whole[5];
    double numbers[8];
    size_t sizes[2];
    bool flags[3];
    signed char signs[3];
    int64_t choices[6];
    char bytes[5];
} Values;

static void pass(YkArchive *a, Values *v)
{
    size_t *sizes[] = {&v->sizes[0], &v->sizes[1]};
    for (int k = 0; k < 5; k++) yk_archive_whole(a, &v->whole[k]);
    yk_archive_numbers(a, v->numbers, 8);
    yk_archive_sizes(a, sizes, 2);
    yk_archive_flags(a, v->flags, 3);
    yk_archive_signs(a, v->signs, 3);
    for (int k = 0; k < 6; k++) yk_archive_choice(a, &v->choices[k], INT64_MIN, INT64_MAX);
    yk_archive_bytes(a, v->bytes, 5);
}

static void what_is_written_is_read_back(void **state)
{
    (void)state;
    Values values = {{0, 1, 0x0123456789abcdef, UINT64_MAX, 256},
                     {0, -0.0, 1.5, -1e-300, 4.9e-324, INFINITY, -INFINITY, NAN},
                     {7, SIZE_MAX},
                     {true, false, true},
                     {-1, 0, 1},
                     {0, 1, -1, -1000, INT64_MIN, INT64_MAX},
                     "yoke"};
    Values back;
    memset(&back, 0, sizeof back);
    unsigned char bytes[400];
    YkArchive counts = {0};
    pass(&counts, &values);
    assert_int_equal(counts.at, 8 * (5 + 8 + 2 + 3 + 3 + 6) + 5);
    YkArchive writes = {.bytes = bytes, .capacity = sizeof bytes};
    pass(&writes, &values);
    assert_int_equal(writes.at, counts.at);
    YkArchive reads = {.bytes = bytes, .capacity = writes.at, .is_reading = true};
    pass(&reads, &back);
    assert_false(counts.failed || writes.failed || reads.failed);
    assert_memory_equal(back.whole, values.whole, sizeof values.whole);
    assert_memory_equal(back.numbers, values.numbers, sizeof values.numbers);
    assert_memory_equal(back.sizes, values.sizes, sizeof values.sizes);
    assert_memory_equal(back.flags, values.flags, sizeof values.flags);
    assert_memory_equal(back.signs, values.signs, sizeof values.signs);
    assert_memory_equal(back.choices, values.choices, sizeof values.choices);
    assert_memory_equal(back.bytes, values.bytes, sizeof values.bytes);
    static const unsigned char third[] = {0xef, 0xcd, 0xab, 0x89, 0x67, 0x45, 0x23, 0x01}; // the lowest byte first
    assert_memory_equal(bytes + 16, third, 8);
}

// One byte short of what is needed, reading and writing fail, and touch nothing behind the end.
static void an_archive_that_ends_too_early_fails(void **state)
{
    (void)state;
    Values values = {0};
    YkArchive counts = {0};
    pass(&counts, &values);
    for (size_t capacity = 0; capacity < counts.at; capacity++)
        for (int reading = 0; reading < 2; reading++) {
            unsigned char bytes[400];
            memset(bytes, reading ? 0 : 0x55, sizeof bytes);
            YkArchive archive = {.bytes = bytes, .capacity = capacity, .is_reading = reading == 1};
            pass(&archive, &values);
            assert_true(archive.failed && archive.at <= capacity);
            for (size_t k = capacity; k < sizeof bytes && !reading; k++) assert_int_equal(bytes[k], 0x55);
        }
    YkArchive all = {.bytes = (unsigned char[400]){0}, .capacity = counts.at, .is_reading = true};
    pass(&all, &values);
    assert_false(all.failed);
}

static void choices_that_are_none_are_refused(void **state)
{
    (void)state;
    for (int64_t written = -5; written <= 9; written++) {
        unsigned char bytes[8];
        int64_t value = written;
        YkArchive writes = {.bytes = bytes, .capacity = 8};
        yk_archive_choice(&writes, &value, -5, 9);
        YkArchive reads = {.bytes = bytes, .capacity = 8, .is_reading = true};
        yk_archive_choice(&reads, &value, -2, 3);
        bool is_one = written >= -2 && written <= 3;
        assert_int_equal(reads.failed, !is_one);
        assert_int_equal(value, is_one ? written : -2);
    }
}

static void any_change_of_a_byte_changes_the_sum(void **state)
{
    (void)state;
    unsigned char bytes[40];
    uint64_t seed = 3;
    for (size_t k = 0; k < sizeof bytes; k++) bytes[k] = (unsigned char)check_random(&seed);
    uint64_t sum = yk_archive_sum(bytes, sizeof bytes);
    for (size_t k = 0; k < sizeof bytes; k++)
        for (int change = 1; change < 256; change++) {
            bytes[k] ^= (unsigned char)change;
            assert_true(yk_archive_sum(bytes, sizeof bytes) != sum);
            bytes[k] ^= (unsigned char)change;
        }
    assert_true(yk_archive_sum(bytes, sizeof bytes) == sum);
    assert_true(yk_archive_sum(bytes, sizeof bytes - 1) != sum);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_written_is_read_back),
        cmocka_unit_test(an_archive_that_ends_too_early_fails),
        cmocka_unit_test(choices_that_are_none_are_refused),
        cmocka_unit_test(any_change_of_a_byte_changes_the_sum),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

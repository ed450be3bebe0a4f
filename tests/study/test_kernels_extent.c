// The reduction of rows in parts, against one number after the other in long double.
#include "study/kernels_extent.h"
#include "check.h"

static void rows_of_any_length_are_reduced(void **unused)
{
    (void)unused;
    double row[100], state = 0.37;
    for (size_t k = 0; k < 100; k++) row[k] = (state = fmod(state * 57.31 + 0.11, 1)) - 0.6;
    for (size_t n = 0; n <= 100; n++) {
        double least = -0.1, largest = 0.1, sum = 5;
        long double exact = 5, low = -0.1, high = 0.1;
        yk_lanes_extent(&least, &largest, &sum, row, n);
        for (size_t k = 0; k < n; k++) {
            exact += row[k];
            low = row[k] < low ? row[k] : low;
            high = row[k] > high ? row[k] : high;
        }
        assert_true(least == (double)low && largest == (double)high);
        CHECK_NEAR(sum, (double)exact, 1e-14);
    }
}

// The parts, as the header describes them: number k goes to part k modulo 8, and the halves are added to each other.
static void the_order_of_the_sum_is_always_the_same(void **unused)
{
    (void)unused;
    double row[31], part[8] = {0}, least = INFINITY, largest = -INFINITY, sum = 0.3;
    for (size_t k = 0; k < 31; k++) {
        row[k] = 1.0 / (double)(3 * k + 1);
        part[k % 8] += row[k];
    }
    yk_lanes_extent(&least, &largest, &sum, row, 31);
    assert_true(sum ==
                0.3 + (((part[0] + part[4]) + (part[2] + part[6])) + ((part[1] + part[5]) + (part[3] + part[7]))));
    assert_true(least == row[30] && largest == 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_of_any_length_are_reduced),
        cmocka_unit_test(the_order_of_the_sum_is_always_the_same),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

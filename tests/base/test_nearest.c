// The nearest name to a misspelt one.
#include "check.h"
#include <stdlib.h>
#include "base/names.h"

static const char *const keys[] = {"bodies",  "joints", "parameters", "drives", "efforts",
                                   "gravity", "mass",   "inertia",    "center"};
enum { KEYS = sizeof keys / sizeof *keys };

static void check_nearest(const char *name, const char *expected)
{
    const char *found = yk_nearest(name, keys, KEYS);
    if (!expected) {
        assert_null(found);
        return;
    }
    if (!found) fail_msg("nothing near %s", name);
    assert_string_equal(found, expected);
}

static void one_slip_is_understood(void **state)
{
    (void)state;
    check_nearest("masss", "mass");
    check_nearest("mas", "mass");
    check_nearest("moss", "mass");
    check_nearest("msas", "mass");
    check_nearest("bodeis", "bodies");
    check_nearest("jionts", "joints");
    check_nearest("paramters", "parameters");
    check_nearest("parmaetesr", "parameters");
    check_nearest("centre", "center");
    check_nearest("mass", "mass");
}

static void case_alone_is_no_difference(void **state)
{
    (void)state;
    check_nearest("GRAVITY", "gravity");
    check_nearest("Mass", "mass");
}

static void strangers_are_not_suggested(void **state)
{
    (void)state;
    check_nearest("", NULL);
    check_nearest("colour", NULL);
    check_nearest("tyxs", NULL);
    check_nearest("grxxxty", NULL);
    const char *const single[] = {"x"};
    assert_null(yk_nearest("y", single, 1));
    assert_null(yk_nearest("y", NULL, 0));
}

static void the_nearest_wins_and_of_equals_the_first(void **state)
{
    (void)state;
    const char *const some[] = {"theta11", "theta2", NULL, "theta1", "theta3"};
    assert_string_equal(yk_nearest("theta1", some, 5), "theta1");
    assert_string_equal(yk_nearest("theta4", some, 5), "theta2");
    assert_string_equal(yk_nearest("tehta1", some, 5), "theta1");
}

static void long_names_are_no_danger(void **state)
{
    (void)state;
    char longest[65], longer[66], huge[5000];
    memset(longest, 'a', sizeof longest);
    memset(longer, 'a', sizeof longer);
    memset(huge, 'a', sizeof huge);
    longest[64] = longer[65] = huge[4999] = '\0';
    const char *const some[] = {huge, longer, longest};
    assert_ptr_equal(yk_nearest(longest, some, 3), longest);
    longest[30] = 'b';
    assert_null(yk_nearest(huge, some, 3));
    assert_null(yk_nearest(longer, some, 3));
    assert_null(yk_nearest(longest, some, 2)); // the candidate is too long to compare
}

// A second way: the shortest path of edits, by plain recursion over the definition.
static size_t slow_distance(const char *a, size_t i, const char *b, size_t j)
{
    if (i == 0 || j == 0) return i + j;
    size_t best = slow_distance(a, i - 1, b, j - 1) + (a[i - 1] != b[j - 1]);
    size_t other = 1 + slow_distance(a, i - 1, b, j);
    if (other < best) best = other;
    other = 1 + slow_distance(a, i, b, j - 1);
    if (other < best) best = other;
    if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        other = 1 + slow_distance(a, i - 2, b, j - 2);
        if (other < best) best = other;
    }
    return best;
}

static void a_name_is_near_exactly_within_the_limit(void **state)
{
    (void)state;
    uint64_t seed = 5;
    int near = 0;
    for (int i = 0; i < 3000; i++) {
        char a[7] = "", b[7] = "";
        size_t m = 1 + check_random(&seed) % 6, n = 1 + check_random(&seed) % 6;
        for (size_t k = 0; k < m; k++) a[k] = (char)('a' + check_random(&seed) % 3);
        for (size_t k = 0; k < n; k++) b[k] = (char)('a' + check_random(&seed) % 3);
        const char *candidates[] = {b};
        size_t distance = slow_distance(a, m, b, n);
        bool expected = distance <= 1 + m / 4 && distance < (m > n ? m : n);
        assert_int_equal(yk_nearest(a, candidates, 1) != NULL, expected);
        near += expected;
    }
    assert_true(near > 100 && near < 2900);
}

static void only_ten_thousand_candidates_are_looked_at(void **state)
{
    (void)state;
    size_t count = 10001;
    const char **candidates = malloc(count * sizeof *candidates);
    for (size_t i = 0; i < count; i++) candidates[i] = "nothing-like-it";
    candidates[10000] = "crank";
    assert_null(yk_nearest("crnak", candidates, count));
    candidates[9999] = "crank";
    assert_string_equal(yk_nearest("crnak", candidates, count), "crank");
    free((void *)candidates);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(one_slip_is_understood),
        cmocka_unit_test(case_alone_is_no_difference),
        cmocka_unit_test(strangers_are_not_suggested),
        cmocka_unit_test(the_nearest_wins_and_of_equals_the_first),
        cmocka_unit_test(long_names_are_no_danger),
        cmocka_unit_test(a_name_is_near_exactly_within_the_limit),
        cmocka_unit_test(only_ten_thousand_candidates_are_looked_at),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

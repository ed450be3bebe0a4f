// The pace of long work: when it asks, what it reports, and that a stop is final.
#include "check.h"
#include "base/pace.h"

typedef struct Asked {
    int count, refuse_at;
    double part;
} Asked;

static bool answer(void *context, double part)
{
    Asked *asked = context;
    asked->part = part;
    return ++asked->count != asked->refuse_at;
}

static void it_asks_at_the_beginning_and_after_every_slice(void **unused)
{
    (void)unused;
    Asked asked = {0};
    YkPace pace;
    assert_true(yk_pace_begin(&pace, (YkProgress){answer, &asked}));
    assert_int_equal(asked.count, 1);
    for (int k = 0; k < 100; k++) assert_true(yk_pace_spend(&pace, YK_PACE_SLICE / 10));
    assert_int_equal(asked.count, 11);
    assert_true(yk_pace_spend(&pace, UINT64_MAX / 2)); // work of any size is one question
    assert_int_equal(asked.count, 12);
}

static void a_stop_is_for_good_and_nobody_is_asked_again(void **unused)
{
    (void)unused;
    Asked asked = {.refuse_at = 2};
    YkPace pace;
    yk_pace_begin(&pace, (YkProgress){answer, &asked});
    assert_true(yk_pace_spend(&pace, 1));
    assert_false(yk_pace_spend(&pace, YK_PACE_SLICE));
    assert_false(yk_pace_spend(&pace, 0));
    assert_false(yk_pace_spend(&pace, 2 * YK_PACE_SLICE));
    assert_true(yk_pace_is_stopped(&pace));
    assert_int_equal(asked.count, 2);
}

static void parts_lie_in_their_stage_and_never_decrease(void **unused)
{
    (void)unused;
    Asked asked = {0};
    YkPace pace;
    yk_pace_begin(&pace, (YkProgress){answer, &asked});
    assert_true(asked.part == 0);
    yk_pace_stage(&pace, 0.25, 0.75);
    yk_pace_reach(&pace, 0.5);
    yk_pace_ask(&pace);
    assert_true(asked.part == 0.5);
    yk_pace_reach(&pace, 0.1);
    yk_pace_ask(&pace);
    assert_true(asked.part == 0.5);
    yk_pace_stage(&pace, 0.75, 1);
    YkProgress within = yk_pace_within(&pace);
    assert_true(within.goes_on(within.context, 0.5));
    assert_true(asked.part == 0.875);
    yk_pace_reach(&pace, 3);
    yk_pace_ask(&pace);
    assert_true(asked.part == 1);
}

static void without_anybody_to_ask_work_goes_on(void **unused)
{
    (void)unused;
    YkPace pace;
    assert_true(yk_pace_begin(&pace, (YkProgress){0}));
    assert_true(yk_pace_spend(&pace, 10 * (uint64_t)YK_PACE_SLICE));
    assert_true(yk_pace_spend(NULL, 10 * (uint64_t)YK_PACE_SLICE));
    assert_null(yk_pace_within(NULL).goes_on);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_asks_at_the_beginning_and_after_every_slice),
        cmocka_unit_test(a_stop_is_for_good_and_nobody_is_asked_again),
        cmocka_unit_test(parts_lie_in_their_stage_and_never_decrease),
        cmocka_unit_test(without_anybody_to_ask_work_goes_on),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

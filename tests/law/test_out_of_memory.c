// Every allocation fails once: the k-th, for every k. The sources are compiled in with our own allocator.
#include "allocations.h"
#include "check.h"

#define malloc try_malloc
#define calloc try_calloc
#define realloc try_realloc
#define free count_free
#include "../../src/base/memory.c"
#include "../../src/law/build.c"
#undef SAME
#include "../../src/law/conditions.c"
#undef SAME
#define solve solve_polynomial
#include "../../src/law/polynomial.c"
#undef solve
#include "../../src/law/solve.c"
#define solve solve_spline
#include "../../src/law/spline.c"
#undef solve
#define follow follow_function
#define by_size by_size_of_rough
#include "../../src/law/function.c"
#undef follow
#undef by_size
#define fill fill_table
#define rise rise_between
#include "../../src/law/table.c"
#undef malloc
#undef calloc
#undef realloc
#undef free

// One segment of every kind that allocates in its own way; true when all is well.
static bool make_segments(YkLawBuilder *builder)
{
    const YkLawCondition conditions[] = {{0, 0, 0}, {0, 1, 0}, {0, 2, 0}, {1, 0, 1}, {1, 1, 0}, {1, 2, 0}};
    YkLawCondition more[10];
    for (int i = 0; i < 10; i++) more[i] = (YkLawCondition){1 + i / 9.0, 0, 1};
    const YkLawFault faults[] = {yk_law_add_polynomial(builder, conditions, 6), yk_law_add_spline(builder, more, 10, 3),
                                 yk_law_add_dwell(builder, 3), yk_law_add_velocity(builder, 4, 1)};
    for (size_t i = 0; i < 4; i++) {
        // after a failure the segment is missing, and what follows does not fit
        if (faults[i] == YK_LAW_NO_MEMORY) return false;
        assert_int_equal(faults[i], YK_LAW_OK);
    }
    return true;
}

static bool rising(const void *context, double x, double d[YK_LAW_ORDER + 1])
{
    (void)context;
    for (int m = 0; m <= YK_LAW_ORDER; m++) d[m] = exp(x);
    return true;
}

static bool make_function(YkLawBuilder *builder)
{
    YkLawFault fault = yk_law_add_function(builder, 20, YK_LAW_FORMULA, rising, NULL);
    if (fault != YK_LAW_NO_MEMORY) assert_int_equal(fault, YK_LAW_OK);
    return fault == YK_LAW_OK;
}

static bool make_table(YkLawBuilder *builder)
{
    double x[20], y[20];
    for (int i = 0; i < 20; i++) y[i] = (x[i] = i) * 2;
    YkLawFault fault = yk_law_add_table(builder, x, y, 20, YK_TABLE_CUBIC, 0);
    if (fault != YK_LAW_NO_MEMORY) assert_int_equal(fault, YK_LAW_OK);
    return fault == YK_LAW_OK;
}

static void fail_each(bool (*make)(YkLawBuilder *))
{
    for (long k = 0;; k++) {
        countdown = k;
        YkArena *arena = yk_arena_new();
        YkLawBuilder *builder = yk_law_builder_new(0, 0);
        YkLaw *law = NULL;
        bool well = arena && builder && make(builder);
        if (well) well = yk_law_finish(builder, 0, arena, &law) == YK_LAW_OK;
        bool undisturbed = countdown >= 0;
        countdown = -1;
        assert_int_equal(well, undisturbed);
        assert_int_equal(law != NULL, well);
        yk_law_builder_free(builder);
        yk_arena_free(arena);
        assert_int_equal(live, 0);
        if (undisturbed) {
            assert_true(k > 5);
            return;
        }
    }
}

static void segments_survive_the_failure_of_any_allocation(void **state)
{
    (void)state;
    fail_each(make_segments);
}

static void tables_survive_the_failure_of_any_allocation(void **state)
{
    (void)state;
    fail_each(make_table);
}

static void functions_survive_the_failure_of_any_allocation(void **state)
{
    (void)state;
    fail_each(make_function);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(segments_survive_the_failure_of_any_allocation),
        cmocka_unit_test(tables_survive_the_failure_of_any_allocation),
        cmocka_unit_test(functions_survive_the_failure_of_any_allocation),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

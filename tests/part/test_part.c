// The catalogue of joints agrees with itself and with plane kinematics.
#include "check.h"
#include "part/part.h"

static int has_key(const YkPart *part, const char *key)
{
    for (size_t i = 0; part->keys[i]; i++) {
        if (strcmp(part->keys[i], key) == 0) return 1;
    }
    return 0;
}

static void every_kind_has_a_part_and_its_key_leads_back_to_it(void **state)
{
    (void)state;
    for (int kind = 0; kind < YK_PART_COUNT; kind++) {
        const YkPart *part = yk_part((YkPartKind)kind);
        assert_non_null(part);
        assert_int_equal(yk_part_find(part->key), kind);
    }
}

static void unknown_keys_and_kinds_lead_nowhere(void **state)
{
    (void)state;
    const char *unknown[] = {"", "Pin", "pins", "pin_slot", "hinge", "slide "};
    for (size_t i = 0; i < sizeof unknown / sizeof *unknown; i++) {
        assert_int_equal(yk_part_find(unknown[i]), YK_PART_COUNT);
    }
    assert_null(yk_part(YK_PART_COUNT));
}

static void constraints_and_freedoms_make_three(void **state)
{
    (void)state;
    for (int kind = 0; kind < YK_PART_COUNT; kind++) {
        const YkPart *part = yk_part((YkPartKind)kind);
        int slides = kind == YK_FREE ? 2 : part->slides; // in any direction
        assert_int_equal(part->constraints + part->turns + slides, 3);
    }
}

static void a_coordinate_may_be_named_exactly_where_there_is_a_freedom(void **state)
{
    (void)state;
    for (int kind = 0; kind < YK_PART_COUNT; kind++) {
        const YkPart *part = yk_part((YkPartKind)kind);
        if (kind == YK_FREE) continue; // `at` names all three
        assert_int_equal(has_key(part, "angle"), part->turns);
        assert_int_equal(has_key(part, "distance"), part->slides);
        assert_int_equal(has_key(part, "along"), part->slides);
        assert_int_equal(has_key(part, "turned"), !part->turns);
        assert_int_equal(has_key(part, "friction"), part->turns || part->slides);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_kind_has_a_part_and_its_key_leads_back_to_it),
        cmocka_unit_test(unknown_keys_and_kinds_lead_nowhere),
        cmocka_unit_test(constraints_and_freedoms_make_three),
        cmocka_unit_test(a_coordinate_may_be_named_exactly_where_there_is_a_freedom),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

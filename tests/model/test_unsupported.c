// Keys that would change the motion, and that this version cannot compute, are refused.
#include "model/fixture.h"

#define MACHINE                                                                                                        \
    "parameters: {F: 100, mu: 0.1}\n"                                                                                  \
    "bodies: {ground: {points: {P: [0, 0]}}, ram: {points: {C: [1, 0]}}}\n"                                            \
    "joints: {O: {pin: [ground, ram], angle: phi}}\n"

static void refused(const char *section, int code, unsigned column, const char *part)
{
    char text[600];
    snprintf(text, sizeof text, MACHINE "%s\n", section);
    fixture_refused(text, code, 4, column, part);
}

static void what_would_change_the_motion_is_refused_at_its_key(void **state)
{
    (void)state;
    const char *keys[] = {"gears", "racks", "belts", "cams", "locks"};
    for (size_t i = 0; i < 5; i++) {
        char section[60];
        snprintf(section, sizeof section, "%s: {a: {b: c}}", keys[i]);
        refused(section, YK_CODE_NOT_SUPPORTED, 1, keys[i]);
    }
}

static void a_gear_explains_a_point_that_is_on_one_body_only(void **state)
{
    (void)state;
    fixture_refused("bodies: {arm: {points: {P: [1, 0]}}, planet: {}}\n"
                    "joints: {O: {pin: [ground, arm]}, P: {pin: [arm, planet]}}\ngears: {g: {}}\n",
                    YK_CODE_NOT_SUPPORTED, 3, 1, "gears");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_would_change_the_motion_is_refused_at_its_key),
        cmocka_unit_test(a_gear_explains_a_point_that_is_on_one_body_only),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

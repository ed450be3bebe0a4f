// Machines of the gallery in which one value is replaced by something else.
#include "../mutilate.h"

static bool reads(const char *text, const char *path, YkProblems *problems)
{
    YkModel *model = yk_model_parse(text, strlen(text), path, NULL, problems);
    YkMechanism *mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    bool good = mech != NULL;
    yk_mechanism_free(mech);
    yk_model_free(model);
    return good;
}

static void a_machine_with_one_wrong_value_is_refused_with_words_or_compiles(void **state)
{
    (void)state;
    // Between them they have every section of a file.
    static const char *const files[] = {"arc-cam",        "cep-cam",        "epicyclic-drive",     "excavator",
                                        "flat-faced-cam", "formula-cam",    "gearbox-8hp70",       "planetary-gear",
                                        "reverted-train", "rough-block",    "spring-slider-crank", "shaking-table",
                                        "swing-cam",      "standing-frame", "two-rings",           "valve-cam"};
    assert_true(mutilate("", files, sizeof files / sizeof *files, 7, reads) > 1000);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_machine_with_one_wrong_value_is_refused_with_words_or_compiles),
    };
    start_counting();
    return cmocka_run_group_tests(tests, NULL, NULL);
}

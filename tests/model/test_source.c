// A model as a model file: comments and order as they were, the same machine to the last bit.
#include <dirent.h>
#include <stdlib.h>
#include <unistd.h>
#include "model/examples.h"
#include "model/fixture.h"
#include "doc/node.h"
#include "model/load.h"
#include <yoke/yoke.h>

static void check_text(const char *text, const char *name, const char *value, const char *expected)
{
    const YkOverride override = {name, value};
    const YkLoadOptions options = {.parameters = &override, .parameter_count = 1};
    YkModel *model = fixture_load_with(text, name ? &options : NULL);
    assert_string_equal(yk_model_text(model), expected);
    yk_model_free(model);
}

#define BODY "bodies: {a: {}}\njoints: {O: {pin: [ground, a]}}\n"

static void a_text_is_kept_byte_for_byte(void **state)
{
    (void)state;
    check_text(quick_return, NULL, NULL, quick_return);
    check_text("# head\r\nname:   x   # why\r\n" BODY, NULL, NULL, "# head\r\nname:   x   # why\r\n" BODY);
    check_text("\xef\xbb\xbf" BODY, NULL, NULL, BODY);
}

static void only_replaced_values_are_new(void **state)
{
    (void)state;
    check_text("parameters: {k: 1, l: 3 m, h: l} # of the gate\n" BODY, "l", "750 mm",
               "parameters: {k: 1, l: 750 mm, h: l} # of the gate\n" BODY);
    check_text("parameters:\n  # ähnlich\n  l: 'sqrt(2)' # old\n" BODY, "l", "atan2(1, 2)",
               "parameters:\n  # ähnlich\n  l: 'atan2(1, 2)' # old\n" BODY);
    check_text("parameters:\n  l: 1 +\n     2  # over two lines\n  h: 1\n" BODY, "l", "4",
               "parameters:\n  l: 4  # over two lines\n  h: 1\n" BODY);
    check_text("parameters: {'l': \"1 + \\\n  2\", h: 1}\n" BODY, "l", "4", "parameters: {'l': 4, h: 1}\n" BODY);
    check_text("parameters:\n  l: >-\n    3\n" BODY, "l", "4",
               "parameters:\n  l: 4\nbodies:\n  a: {}\njoints:\n  O: {pin: [ground, a]}\n");
}

static void a_section_of_values_is_replaced_in_place(void **state)
{
    (void)state;
    static const YkOverride values[] = {{"b", "0.5 rad"}, {"c", "3 m"}};
    YkText text = {0};
    assert_true(yk_source_replace("name: x # why\nstart:\n  a: 1\n  b: -20 deg # open\njoints: {}\n", "start", values,
                                  2, &text));
    assert_string_equal(yk_text_get(&text), "name: x # why\nstart:\n  a: 1\n  b: 0.5 rad # open\njoints: {}\n");
    yk_text_clear(&text);
    assert_false(yk_source_replace("name: x\n", "start", values, 2, &text));
    assert_false(yk_source_replace("start: {b: [1, 2]}\n", "start", values, 2, &text));
    assert_false(yk_source_replace("start: [1]\n", "start", values, 2, &text));
    assert_false(yk_source_replace("start:\n  b: >-\n    3\n", "start", values, 2, &text));
    assert_false(text.failed);
    yk_text_free(&text);
}

// Every coordinate at a few times: the bits of two models are the same.
static void compare_motion(const YkModel *one, const YkModel *other)
{
    const YkModel *models[2] = {one, other};
    YkState *states[2];
    YkMechanism *mechs[2];
    for (int k = 0; k < 2; k++) {
        mechs[k] = yk_mechanism_compile(models[k], NULL, NULL);
        assert_non_null(mechs[k]);
        states[k] = yk_state_new(mechs[k]);
    }
    for (int step = 0; step < 3; step++) {
        YkStatus status[2];
        for (int k = 0; k < 2; k++) {
            status[k] = yk_state_set_time(states[k], 0.01 * step, NULL);
            if (status[k] >= 0) status[k] = step ? yk_state_solve(states[k]) : yk_state_assemble(states[k]);
        }
        assert_int_equal(status[0], status[1]);
        if (status[0] < 0) break;
        for (size_t c = 0; c < yk_coordinate_count(mechs[0]); c++) {
            YkMotion a = yk_state_coordinate(states[0], c), b = yk_state_coordinate(states[1], c);
            assert_memory_equal(&a, &b, sizeof a);
        }
    }
    for (int k = 0; k < 2; k++) {
        yk_state_free(states[k]);
        yk_mechanism_free(mechs[k]);
    }
}

// The tree laid out anew, as a builder writes it.
static char *laid_out(const char *text)
{
    YkArena *arena = yk_arena_new();
    YkText out = {0};
    yk_doc_write(yk_doc_parse(text, strlen(text), "", arena, NULL), &out);
    yk_arena_free(arena);
    return out.data;
}

static void every_example_is_the_same_machine_when_written(void **state)
{
    (void)state;
    DIR *folder = opendir(YOKE_ROOT "/examples");
    assert_non_null(folder);
    size_t count = 0;
    for (struct dirent *entry; (entry = readdir(folder));) {
        char path[600], written[] = "/tmp/yoke-written-XXXXXX";
        if (!strstr(entry->d_name, ".yaml")) continue;
        snprintf(path, sizeof path, "%s/examples/%s", YOKE_ROOT, entry->d_name);
        YkProblems *problems = yk_problems_new();
        YkModel *model = yk_model_load(path, NULL, problems);
        assert_non_null(model);
        close(mkstemp(written));
        assert_int_equal(yk_model_write(model, written, problems), YK_OK);
        YkModel *again = yk_model_load(written, NULL, problems);
        assert_non_null(again);
        assert_string_equal(yk_model_text(model), yk_model_text(again));
        compare_motion(model, again);
        char *anew = laid_out(yk_model_text(model));
        YkModel *third = yk_model_parse(anew, strlen(anew), "anew", NULL, problems);
        if (!third) print_error("%s: %s", entry->d_name, yk_problems_text(problems, 0));
        assert_non_null(third);
        compare_motion(model, third);
        free(anew);
        unlink(written);
        yk_model_free(model);
        yk_model_free(again);
        yk_model_free(third);
        yk_problems_free(problems);
        count++;
    }
    closedir(folder);
    assert_true(count > 50);
}

static void a_file_that_cannot_be_written_is_told(void **state)
{
    (void)state;
    YkModel *model = fixture_load(quick_return);
    YkProblems *problems = yk_problems_new();
    assert_int_equal(yk_model_write(model, "/no/such/folder/x.yaml", problems), YK_IO);
    assert_int_equal(yk_problems_error_count(problems), 1);
    yk_problems_free(problems);
    yk_model_free(model);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_text_is_kept_byte_for_byte),
        cmocka_unit_test(only_replaced_values_are_new),
        cmocka_unit_test(a_section_of_values_is_replaced_in_place),
        cmocka_unit_test(every_example_is_the_same_machine_when_written),
        cmocka_unit_test(a_file_that_cannot_be_written_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

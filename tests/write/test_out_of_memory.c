// Every allocation of the writers fails once: the k-th, for every k. The sources are compiled in with our own
// allocator.
#include "allocations.h"
#include "check.h"
#include <yoke/yoke.h>

#define malloc try_malloc
#define calloc try_calloc
#define realloc try_realloc
#define free count_free
#include "../../src/base/memory.c"
#include "../../src/base/text.c"
#include "../../src/picture/drawing/drawing.c"
#include "../../src/picture/drawing/drawing_labels.c"
#include "../../src/picture/drawing/drawing_outline.c"
#include "../../src/picture/drawing/drawing_traces.c"
#include "../../src/write/table.c"
#undef malloc
#undef calloc
#undef realloc
#undef free
#include "picture/plot.h"
#include "write/csv.h"
#include "write/json.h"

// Runs `use` with the k-th allocation failing, for k = 0, 1, ... until none fails; returns how many there were.
static long fail_each(bool (*use)(void))
{
    long before = live;
    for (long k = 0;; k++) {
        countdown = k;
        bool well = use();
        bool is_reached = countdown < 0;
        countdown = -1;
        assert_int_equal(live, before); // nothing leaks
        if (!is_reached) {
            assert_true(well);
            return k;
        }
        assert_false(well); // no failure passes for an answer
    }
}

static YkMechanism *mech;
static YkState *pose;

static bool draw_a_machine(void)
{
    const size_t traced = yk_model_point_count(yk_mechanism_model(mech)) - 1;
    YkDrawOptions options = yk_default_draw_options();
    options.traced_points = &traced;
    options.traced_count = 1;
    YkDrawing *drawing = yk_drawing_new(mech, &options);
    bool good = drawing != NULL;
    for (int i = 0; good && i < 6; i++)
        good = yk_drawing_pose(drawing, pose) == YK_OK && yk_drawing_trace(drawing, pose) == YK_OK;
    good = good && yk_drawing_svg(drawing) != NULL;
    yk_drawing_free(drawing);
    return good;
}

static bool write_a_table(void)
{
    YkText text = {0};
    YkTable *table = yk_table_new(2);
    yk_table_head(table, "x", "mm");
    yk_table_head(table, "y", NULL);
    for (int i = 0; i < 100; i++) {
        yk_table_number(table, i, 6);
        yk_table_word(table, "a word of some length");
    }
    bool good = yk_table_write(table, 2, &text);
    yk_table_free(table);
    yk_text_free(&text);
    return good;
}

static bool write_json_and_csv(void)
{
    YkText text = {0};
    YkJson json = {.text = &text};
    YkCsv csv = {.text = &text};
    yk_json_list(&json, NULL, YK_JSON_LINES);
    for (int i = 0; i < 500; i++) yk_json_string(&json, NULL, "a string");
    yk_json_end(&json);
    for (int i = 0; i < 500; i++) yk_csv_number(&csv, i / 7.0);
    bool good = !text.failed;
    yk_text_free(&text);
    return good;
}

static bool write_a_plot(void)
{
    static const double x[] = {0, 1, 2};
    static const YkPlotColumn columns[] = {{"a", "m", x}, {"b", "rad", x}};
    YkPlot plot = {
        .title = "T", .x_name = "x", .x_unit = "m", .x = x, .rows = 3, .columns = columns, .column_count = 2};
    YkText script = {0};
    yk_plot_script(&plot, YK_FILE_SVG, &script);
    bool good = !script.failed;
    yk_text_free(&script);
    return good;
}

static void a_drawing_survives_every_failure(void **state)
{
    (void)state;
    assert_true(fail_each(draw_a_machine) > 20);
}

static void a_table_survives_every_failure(void **state)
{
    (void)state;
    assert_true(fail_each(write_a_table) > 5);
}

static void json_and_csv_survive_every_failure(void **state)
{
    (void)state;
    assert_true(fail_each(write_json_and_csv) > 3);
}

static void a_plot_survives_every_failure(void **state)
{
    (void)state;
    assert_true(fail_each(write_a_plot) > 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_drawing_survives_every_failure),
        cmocka_unit_test(a_table_survives_every_failure),
        cmocka_unit_test(json_and_csv_survive_every_failure),
        cmocka_unit_test(a_plot_survives_every_failure),
    };
    YkProblems *problems = yk_problems_new();
    YkModel *model = yk_model_load(YOKE_ROOT "/examples/quick-return.yaml", NULL, problems);
    mech = model ? yk_mechanism_compile(model, NULL, problems) : NULL;
    pose = mech ? yk_state_new(mech) : NULL;
    bool is_ready = pose && yk_state_set_time(pose, 0, problems) >= 0 && yk_state_assemble(pose) >= 0;
    int failed = is_ready ? cmocka_run_group_tests(tests, NULL, NULL) : 1;
    yk_state_free(pose);
    yk_mechanism_free(mech);
    yk_model_free(model);
    yk_problems_free(problems);
    return failed;
}

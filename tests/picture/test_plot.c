// Plots by gnuplot.
#include "check.h"
#include <stdlib.h>
#include "base/codes.h"
#include "picture/plot.h"

static const double x[] = {0, 1, 2}, angle[] = {0.5, NAN, 1.5}, other[] = {1, 2, 3}, length[] = {10, 20, 15};
static const YkPlotColumn columns[] = {{"theta2", "rad", angle}, {"d5", "m", length}, {"theta4's", "rad", other}};
static const YkPlotMark mark = {1.5, "limit"};

static YkPlot example(void)
{
    return (YkPlot){.title = "Machine",
                    .x_name = "theta1",
                    .x_unit = "rad",
                    .x = x,
                    .rows = 3,
                    .columns = columns,
                    .column_count = 3,
                    .marks = &mark,
                    .mark_count = 1};
}

static size_t occurrences(const char *text, const char *word)
{
    size_t count = 0;
    for (const char *at = strstr(text, word); at; at = strstr(at + 1, word)) count++;
    return count;
}

static void columns_of_one_unit_share_a_panel(void **state)
{
    (void)state;
    YkText script = {0};
    YkPlot plot = example();
    yk_plot_script(&plot, YK_FILE_SVG, &script);
    const char *text = yk_text_get(&script);
    assert_int_equal(occurrences(text, "\nplot "), 2);
    assert_non_null(strstr(text, "set multiplot layout 2,1 title 'Machine'"));
    assert_non_null(strstr(text, "plot $data using 1:2 with lines title 'theta2'"));
    assert_non_null(strstr(text, "$data using 1:4 with lines title 'theta4''s'")); // a quote within quotes
    assert_non_null(strstr(text, "plot $data using 1:3 with lines title 'd5'"));
    assert_non_null(strstr(text, "set xlabel 'theta1 [rad]'"));
    yk_text_free(&script);
}

// Every panel makes the page higher by as much, and the page has one shape in all formats.
static void pages_have_one_shape(void **state)
{
    (void)state;
    static const char *const sizes[] = {"font 'sans,13' size ", "size ", "font 'sans,20' size "};
    static const YkPlotColumn more[] = {{"a", "rad", angle}, {"b", "m", length}, {"c", "N", other}};
    double size[3][3][2]; // [panels - 1][format]
    for (size_t panels = 1; panels <= 3; panels++)
        for (YkFileKind kind = YK_FILE_SVG; kind <= YK_FILE_PNG; kind++) {
            YkText script = {0};
            YkPlot plot = example();
            plot.columns = more;
            plot.column_count = panels;
            yk_plot_script(&plot, kind, &script);
            char *at = strstr(yk_text_get(&script), sizes[kind]) + strlen(sizes[kind]);
            size[panels - 1][kind][0] = strtod(at, &at);
            size[panels - 1][kind][1] = strtod(strchr(at, ',') + 1, NULL);
            assert_int_equal(occurrences(yk_text_get(&script), "set ylabel"), panels);
            assert_non_null(strstr(yk_text_get(&script), "set xrange [0:2]"));
            yk_text_free(&script);
        }
    for (int kind = 0; kind < 3; kind++) {
        double panel = size[1][kind][1] - size[0][kind][1];
        CHECK_NEAR(size[2][kind][1] - size[1][kind][1], panel, 1e-3 * panel);
        assert_true(panel > 0 && panel < size[0][kind][0] && size[0][kind][1] > panel &&
                    size[0][kind][1] < 1.5 * panel);
        for (int k = 0; k < 3; k++)
            CHECK_NEAR(size[k][kind][1] / size[k][kind][0], size[k][0][1] / size[k][0][0], 1e-3);
    }
}

static void a_value_that_is_none_is_a_gap(void **state)
{
    (void)state;
    YkText script = {0};
    YkPlot plot = example();
    yk_plot_script(&plot, YK_FILE_SVG, &script);
    assert_non_null(strstr(yk_text_get(&script), "\n0 0.5 10 1\n1 ? 20 2\n2 1.5 15 3\nEOD\n"));
    assert_non_null(strstr(yk_text_get(&script), "set datafile missing '?'"));
    yk_text_free(&script);
}

static void marks_stand_at_their_place(void **state)
{
    (void)state;
    YkText script = {0};
    YkPlot plot = example();
    yk_plot_script(&plot, YK_FILE_PDF, &script);
    assert_non_null(strstr(yk_text_get(&script), "set arrow from first 1.5, graph 0"));
    assert_non_null(strstr(yk_text_get(&script), "set label 'limit'"));
    assert_non_null(strstr(yk_text_get(&script), "set terminal pdfcairo"));
    yk_text_free(&script);
}

static void the_same_plot_is_the_same_script(void **state)
{
    (void)state;
    YkText first = {0}, second = {0};
    YkPlot plot = example();
    yk_plot_script(&plot, YK_FILE_PNG, &first);
    yk_plot_script(&plot, YK_FILE_PNG, &second);
    assert_string_equal(yk_text_get(&first), yk_text_get(&second));
    yk_text_free(&first);
    yk_text_free(&second);
}

static void gnuplot_draws_every_kind(void **state)
{
    (void)state;
    static const char *const starts[] = {"<?xml", "%PDF-", "\x89PNG"};
    for (YkFileKind kind = YK_FILE_SVG; kind <= YK_FILE_PNG; kind++) {
        YkProblems *problems = yk_problems_new();
        YkText picture = {0};
        YkPlot plot = example();
        bool good = yk_plot_draw(&plot, kind, &picture, problems);
        if (good) {
            assert_memory_equal(yk_text_get(&picture), starts[kind], strlen(starts[kind]));
        } else {
            assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_PROGRAM_MISSING);
        }
        yk_text_free(&picture);
        yk_problems_free(problems);
    }
}

static void names_cannot_smuggle_commands_into_the_script(void **state)
{
    (void)state;
    YkText script = {0};
    YkPlot plot = example();
    plot.title = "'; system('false') #";
    yk_plot_script(&plot, YK_FILE_SVG, &script);
    assert_non_null(strstr(yk_text_get(&script), "title '''; system(''false'') #'\n"));
    yk_text_free(&script);
}

static void without_gnuplot_the_message_says_so(void **state)
{
    (void)state;
    char *path = getenv("PATH"), kept[4096];
    snprintf(kept, sizeof kept, "%s", path ? path : "");
    YkProblems *problems = yk_problems_new();
    YkText picture = {0};
    YkPlot plot = example();
    setenv("PATH", "/no/such/folder", 1);
    assert_false(yk_plot_draw(&plot, YK_FILE_SVG, &picture, problems));
    setenv("PATH", kept, 1);
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_PROGRAM_MISSING);
    assert_non_null(strstr(yk_problems_get(problems, 0)->message, "gnuplot"));
    yk_text_free(&picture);
    yk_problems_free(problems);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(columns_of_one_unit_share_a_panel),
        cmocka_unit_test(pages_have_one_shape),
        cmocka_unit_test(a_value_that_is_none_is_a_gap),
        cmocka_unit_test(marks_stand_at_their_place),
        cmocka_unit_test(the_same_plot_is_the_same_script),
        cmocka_unit_test(gnuplot_draws_every_kind),
        cmocka_unit_test(names_cannot_smuggle_commands_into_the_script),
        cmocka_unit_test(without_gnuplot_the_message_says_so),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Writes the structure: bodies as boxes with joints between them, as a picture; loops, order of solution and
// coordinates as tables.
#include "report/graph.h"
#include "report/html.h"
#include "report/report.h"

enum { ROWS_MAX = 200, LIST_MAX = 8 };

static void add_names(const YkReportPage *report, size_t block, bool of_joints, YkText *words)
{
    YkBlockInfo info = yk_block_info(report->mech, block);
    size_t count = of_joints ? info.joint_count : info.body_count, shown = count < LIST_MAX ? count : LIST_MAX;
    for (size_t i = 0; i < shown; i++) {
        size_t index = of_joints ? yk_block_joint(report->mech, block, i) : yk_block_body(report->mech, block, i);
        yk_text_format(words, "%s%s", i > 0 ? ", " : "",
                       of_joints ? report->model->joints[index].name : report->model->bodies[index].name);
    }
    if (count > shown) yk_text_puts(words, ", ...");
}

static void add_blocks(const YkReportPage *report, YkText *html)
{
    static const char *const heads[] = {"step", "group", "label", "joints", "places"};
    static const char *const classes[] = {"", "", " of class II", " of class III", " of class IV"};
    size_t all = yk_block_count(report->mech), count = all < ROWS_MAX ? all : ROWS_MAX;
    YkTable *table = yk_table_new(5);
    YkText words = {0};
    for (int i = 0; i < 5; i++) yk_table_head(table, heads[i], NULL);
    for (size_t b = 0; b < count; b++) {
        YkBlockInfo block = yk_block_info(report->mech, b);
        yk_text_clear(&words);
        yk_text_format(&words, "%z", b + 1);
        yk_table_word(table, yk_text_get(&words));
        yk_text_clear(&words);
        yk_text_format(&words, "%s%s", yk_block_kind_name(block.kind),
                       block.assur_class >= 0 && block.assur_class < 5 ? classes[block.assur_class] : "");
        yk_table_word(table, yk_text_get(&words));
        yk_table_word(table, block.label ? block.label : "");
        yk_text_clear(&words);
        add_names(report, b, true, &words);
        yk_table_word(table, yk_text_get(&words));
        yk_text_clear(&words);
        add_names(report, b, false, &words);
        yk_table_word(table, yk_text_get(&words));
    }
    yk_text_free(&words);
    yk_html_table(html, table, "Order of solution: each step needs only the ones before");
}

static void add_coordinates(const YkReportPage *report, YkText *html)
{
    static const char *const heads[] = {"coordinate", "is", "at joint", "it"};
    size_t all = yk_coordinate_count(report->mech), count = all < ROWS_MAX ? all : ROWS_MAX;
    YkTable *table = yk_table_new(4);
    for (int i = 0; i < 4; i++) yk_table_head(table, heads[i], NULL);
    for (size_t c = 0; c < count; c++) {
        YkCoordinateInfo info = yk_coordinate_info(report->mech, c);
        yk_table_word(table, info.name);
        yk_table_word(table, info.is_distance ? "a distance" : "an angle");
        yk_table_word(table, report->model->joints[info.joint].name);
        yk_table_word(table, info.input < 0 ? "follows" : info.has_drive ? "is driven" : "is free");
    }
    yk_html_table(html, table, "Coordinates: second body relative to first");
}

static void add_loops(YkReportPage *report, YkText *html)
{
    size_t loops = yk_loop_count(report->mech), bodies = yk_model_body_count(report->model);
    size_t *round = YK_NEW(report->arena, size_t, bodies + 1);
    if (!round) html->failed = true;
    if (!round || loops == 0) return;
    yk_text_puts(html, "<h3>Loops</h3>\n<ol>\n");
    for (size_t l = 0; l < loops && l < ROWS_MAX; l++) {
        size_t count = yk_loop_bodies(report->mech, l, round, bodies), shown = count < bodies ? count : bodies;
        yk_text_puts(html, "<li>");
        for (size_t i = 0; i < shown; i++) {
            yk_html_words(html, report->model->bodies[round[i]].name);
            yk_text_puts(html, " – ");
        }
        if (shown > 0) yk_html_words(html, report->model->bodies[round[0]].name);
        yk_text_puts(html, ", closed at ");
        yk_html_words(html, report->model->joints[yk_loop_joint(report->mech, l)].name);
        yk_text_puts(html, "</li>\n");
    }
    yk_text_puts(html, "</ol>\n");
}

void yk_section_topology(YkReportPage *report, YkText *html, YkProblems *problems)
{
    YkText svg = {0}, told = {0};
    (void)problems;
    if (yk_structure_write(report->mech, &svg)) {
        yk_text_format(&told, "Bodies as boxes and joints as lines between them: %z bodies, %z joints, %z loops",
                       yk_model_body_count(report->model), yk_model_joint_count(report->model),
                       yk_loop_count(report->mech));
        yk_html_picture(
            html, yk_text_get(&svg), yk_text_get(&told),
            "Bodies and joints. Dashed: joints that close a loop. The number beside a body is the step of the "
            "order of solution that places it.");
    }
    if (svg.failed) yk_text_fail(html);
    yk_text_free(&svg);
    yk_text_free(&told);
    add_loops(report, html);
    add_blocks(report, html);
    add_coordinates(report, html);
}

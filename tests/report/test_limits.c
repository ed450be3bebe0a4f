// A machine of many parts: its page takes the first of them, to the limits that keep pages readable, and all of a
// smaller one.
#include "report/page.h"
#include "base/text.h"

// A star: arms round the ground, each with a point and a parameter of its own; heavy ones have masses, and
// those of them that turn have drives.
static YkText star(size_t arms, bool is_heavy, bool turns)
{
    YkText text = {0};
    yk_text_puts(&text, "parameters: {u0: 1");
    for (size_t k = 1; k < arms; k++) yk_text_format(&text, ", u%z: 1", k);
    yk_text_puts(&text, "}\nbodies:\n  ground: {points: {O: [0, 0]}}\n");
    for (size_t k = 0; k < arms; k++)
        yk_text_format(&text, "  b%z: {points: {T: [%z, 1]}%s}\n", k, k + 1, is_heavy ? ", mass: 1, inertia: 1" : "");
    yk_text_puts(&text, "joints:\n");
    for (size_t k = 0; k < arms && turns; k++)
        yk_text_format(&text, "  J%z: {pin: [ground, b%z], angle: p%z}\n", k, k, k);
    for (size_t k = 0; k < arms && !turns; k++) yk_text_format(&text, "  J%z: {weld: [ground, b%z]}\n", k, k);
    if (turns && is_heavy) yk_text_puts(&text, "drives:\n");
    for (size_t k = 0; k < arms && turns && is_heavy; k++) yk_text_format(&text, "  p%z: 1 rad/s * t\n", k);
    return text;
}

// Rows below the head of the table whose caption begins with these words; 0 if there is none.
static size_t rows_of(const char *html, const char *caption)
{
    char words[100];
    size_t rows = 0;
    snprintf(words, sizeof words, "<caption>%s", caption);
    const char *at = strstr(html, words), *end = at ? strstr(at, "</table>") : NULL;
    for (; at && (at = strstr(at + 1, "<tr")) && at < end;) rows++;
    return rows > 0 ? rows - 1 : 0;
}

static size_t least(size_t a, size_t b)
{
    return a < b ? a : b;
}

static size_t columns_of(const YkReportPage *report, YkReportRole role)
{
    size_t count = 0;
    for (size_t c = 0; c < report->column_count; c++) count += report->columns[c].role == role;
    return count;
}

static void check_tables(const char *html, size_t arms, bool is_heavy, bool turns)
{
    assert_int_equal(rows_of(html, "Parameters"), least(arms, 300));
    assert_int_equal(rows_of(html, "Points, in the axes"), least(arms + 1, 300));
    assert_int_equal(rows_of(html, "Masses; "),
                     is_heavy ? least(arms, 299) : 0); // the ground is the first of 300 bodies
    assert_int_equal(rows_of(html, "Reactions at the start"), is_heavy ? least(arms, 200) : 0);
    assert_int_equal(rows_of(html, "Free bodies at the start"), is_heavy ? least(arms, 199) : 0);
    assert_int_equal(rows_of(html, "Torques along coordinates"), is_heavy && turns ? arms : 0);
    assert_int_equal(rows_of(html, "Forces along coordinates"), 0);
    assert_int_equal(rows_of(html, "Coordinates: second"), turns ? least(arms, 200) : 0);
    assert_int_equal(strstr(html, "too large for its equations") != NULL, arms + 1 > 32);
    assert_int_equal(strstr(html, "Bodies as boxes and joints as lines") != NULL, arms + 1 <= 40);
    char words[80];
    snprintf(words, sizeof words, "<p>%zu moving bod%s, %zu joint%s, 0 loops</p>", arms, arms == 1 ? "y" : "ies", arms,
             arms == 1 ? "" : "s");
    assert_non_null(strstr(html, words));
}

static void check_columns(const YkReportPage *report, size_t arms, bool is_heavy)
{
    assert_int_equal(columns_of(report, YK_ROLE_COORDINATE), 3 * least(arms, 16));
    assert_int_equal(columns_of(report, YK_ROLE_EFFORT), is_heavy ? least(arms, 8) : 0);
    assert_int_equal(columns_of(report, YK_ROLE_REACTION), is_heavy ? least(arms, 16) : 0);
    assert_int_equal(columns_of(report, YK_ROLE_FORCE), is_heavy ? 2 * least(arms, 16) : 0);
    assert_int_equal(columns_of(report, YK_ROLE_VELOCITY), 2 * least(arms, 12));
    for (size_t c = 0; c < report->column_count; c++) // the first ones, in order
        if (report->columns[c].role == YK_ROLE_COORDINATE) assert_int_equal(report->columns[c].of, c / 3);
}

static void check_star(size_t arms, bool is_heavy, bool turns)
{
    YkText text = star(arms, is_heavy, turns);
    YkReportOptions options = yk_default_report_options();
    options.steps = 2;
    Page page = open_text(yk_text_get(&text), &options);
    const char *html = yk_report_html(page.report, page.problems);
    assert_non_null(html);
    check_tables(html, arms, is_heavy, turns);
    if (turns) check_columns(page.report, arms, is_heavy);
    assert_int_equal(page.report->traced_count, least(arms, 12));
    close_page(&page);
    yk_text_free(&text);
}

static void a_page_takes_the_first_of_many(void **state)
{
    (void)state;
    check_star(1, true, true);
    check_star(9, true, true);
    check_star(17, true, true);
    check_star(32, false, true);
    check_star(39, false, true);
    check_star(201, false, true);
    check_star(301, true, false);
}

// More steps than a page can hold of a large machine are not chosen; what is asked for is done.
static void large_machines_have_fewer_rows(void **state)
{
    (void)state;
    static const size_t arms[] = {10, 90, 120};
    size_t most = 0;
    for (size_t k = 0; k < 3; k++) {
        YkText text = star(arms[k], false, true);
        Page page = open_text(yk_text_get(&text), NULL);
        size_t steps = page.report->motion.steps;
        if (k == 0) most = steps;
        assert_true(steps >= 24 && steps * (arms[k] + 1) <= 12000);
        assert_true(steps == most || (steps < most && (steps + 1) * (arms[k] + 1) > 12000));
        assert_int_equal(page.report->row_count, steps + 1);
        close_page(&page);
        yk_text_free(&text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_page_takes_the_first_of_many),
        cmocka_unit_test(large_machines_have_fewer_rows),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

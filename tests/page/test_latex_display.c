// Formulas on pages of limited width: what their lines, small matrices and numbered parts say is the formula, and they
// break where they have to, at signs of sums.
#include "check.h"
#include <stdbool.h>
#include <stdlib.h>
#include "base/memory.h"
#include "page/latex_display.h"

static double width(const char *formula)
{
    return yk_latex_width(formula, strlen(formula));
}

static void commands_are_as_wide_as_what_they_print(void **state)
{
    (void)state;
    CHECK_NEAR(width("\\left( x \\right)"), width("(x)"), 1e-12);
    CHECK_NEAR(width("\\mathrm{x}"), width("x"), 1e-12);
    CHECK_NEAR(width("\\ddot{x}_{1}"), width("x1"), 1e-12);
    CHECK_NEAR(width("\\frac{a}{b}") + width("\\tfrac{c}{d}"), width("abcd"), 1e-12);
    CHECK_NEAR(width("\\boldsymbol{\\omega}"), width("\\alpha"), 1e-12); // whatever the length of its name
    CHECK_NEAR(width("\\cos") - width("\\sin"), 0, 1e-12);
    assert_true(width("\\cos") > 2 * width("\\theta") && width("\\theta") >= width("x"));
    assert_true(width("\\,x") > width("x") && width("\\,x") < width("yx"));
    assert_true(width("x1") < width("xy") && width("x1") > 1.5 * width("x"));
    CHECK_NEAR(width("a - b"), width("a + b"), 1e-12);
    assert_true(width("a - b") > width("a-b") + 1); // a sign of a sum has room on both sides
    CHECK_NEAR(width("a -b"), width("a - b"), 1e-12);
    CHECK_NEAR(width("(-b"), width("(xb"), 1e-12);
}

// --- Random formulas

static void add_term(YkText *text, uint64_t *seed, int depth)
{
    static const char *const atoms[] = {"l_{1}",
                                        "\\cos(\\theta_{2} + \\phi)",
                                        "m_{3}",
                                        "\\ddot{\\theta}_{4}",
                                        "x^{2}",
                                        "\\tfrac{1}{2} k",
                                        "\\sin(\\theta_{1} - \\theta_{3})",
                                        "\\frac{a + b}{c - d}"};
    int count = 1 + (int)check_uniform(seed, 0, 4);
    for (int k = 0; k < count; k++) {
        if (k > 0) yk_text_puts(text, " ");
        yk_text_puts(text, atoms[(int)check_uniform(seed, 0, 8)]);
    }
    if (depth == 0 || check_uniform(seed, 0, 1) < 0.6) return;
    yk_text_puts(text, " (");
    int terms = 2 + (int)check_uniform(seed, 0, depth > 1 ? 6 : 12);
    for (int k = 0; k < terms; k++) {
        if (k > 0) yk_text_puts(text, check_uniform(seed, 0, 1) < 0.5 ? " + " : " - ");
        add_term(text, seed, depth - 1);
    }
    yk_text_puts(text, ")");
}

// How many brackets of sums each place is in; -1 within braces or a function's argument, and where no sign stands
// behind a blank.
static signed char *depths_of(const char *formula)
{
    size_t length = strlen(formula);
    signed char *found = malloc(length + 1);
    int depth = 0, braces = 0, functions = 0;
    char open[64];
    for (size_t k = 0; k <= length; k++) {
        const char *c = formula + k;
        bool is_sign = c[0] == ' ' && c[1] != '\0' && strchr("+-=", c[1]) && c[2] == ' ';
        found[k] = (signed char)(is_sign && braces == 0 && functions == 0 ? depth : -1);
        braces += (*c == '{') - (*c == '}');
        if (*c == '(') functions += (open[depth++] = k >= 3 && (c[-1] == 's' || c[-1] == 'n') ? 'f' : '(') == 'f';
        if (*c == ')') functions -= open[--depth] == 'f';
    }
    return found;
}

// The next place behind `at` at which a line may break, in the brackets of so many sums at most; NULL at the end.
static const char *next_break(const char *formula, const signed char *depths, const char *at, int deepest)
{
    for (const char *c = at + 1; *c; c++)
        if (depths[c - formula] >= 0 && depths[c - formula] <= deepest) return c;
    return NULL;
}

// Every line begins with a sign of a sum, outside of functions and quotients, and holds as many terms as fit.
static size_t check_lines(const char *formula, const char *shown)
{
    static const char head[] = "\\begin{multline*}\n", tail[] = "\n\\end{multline*}\n";
    signed char *depths = depths_of(formula);
    size_t lines = 0;
    if (width(formula) <= YK_LATEX_LINE) {
        assert_true(strncmp(shown, "\\[\n", 3) == 0 && strncmp(shown + 3, formula, strlen(formula)) == 0);
        assert_string_equal(shown + 3 + strlen(formula), "\n\\]\n");
        free(depths);
        return 0;
    }
    assert_memory_equal(shown, head, sizeof head - 1);
    const char *at = formula, *line = shown + sizeof head - 1, *stop = shown + strlen(shown) - (sizeof tail - 1);
    assert_string_equal(stop, tail);
    for (;;) {
        const char *end = strstr(line, " \\\\\n");
        size_t length = (size_t)((end && end < stop ? end : stop) - line);
        assert_memory_equal(line, at, length); // nothing is lost
        lines++;
        const char *cut = at + length;
        if (*cut == '\0') break;
        const char *further = next_break(formula, depths, cut, 1),
                   *last = further ? further : formula + strlen(formula);
        int depth = depths[cut - formula];
        assert_true(next_break(formula, depths, cut - 1, 99) == cut && depth >= 0);
        const char *shallow = next_break(formula, depths, at, 1);
        bool could = shallow && yk_latex_width(at, (size_t)(shallow - at)) <= YK_LATEX_LINE;
        if (depth <= 1) assert_true(yk_latex_width(at, (size_t)(last - at)) > YK_LATEX_LINE); // no more would fit
        if (could) assert_true(depth <= 1 && yk_latex_width(at, length) <= YK_LATEX_LINE);
        at = cut + 1;
        line += length + strlen(" \\\\\n");
    }
    free(depths);
    return lines;
}

static void long_sums_fill_their_lines(void **state)
{
    (void)state;
    uint64_t seed = 1907;
    size_t broken = 0;
    for (size_t trial = 0; trial < check_cases(100); trial++) {
        YkText formula = {0}, shown = {0};
        yk_text_puts(&formula, trial % 2 ? "\\tau = -" : "\\tau = ");
        for (size_t k = 0; trial % 5 == 1 && k < 40 + trial; k++) yk_text_puts(&formula, "l_{1} "); // no place to break
        int terms = 1 + (int)(trial % 17);
        for (int k = 0; k < terms; k++) {
            if (k > 0) yk_text_puts(&formula, k % 3 ? " + " : " - ");
            add_term(&formula, &seed, 2);
        }
        yk_latex_display(&shown, yk_text_get(&formula));
        broken += check_lines(yk_text_get(&formula), yk_text_get(&shown)) > 1;
        yk_text_free(&formula);
        yk_text_free(&shown);
    }
    assert_true(broken > check_cases(100) / 4);
}

// --- Matrices

typedef struct Matrix {
    size_t rows, columns;
    YkText text;         // A = ..., or A = ... with more behind it
    double widths, rest; // of its columns, measured here, and of what stands behind it
} Matrix;

static Matrix random_matrix(uint64_t *seed, size_t most)
{
    Matrix m = {.rows = 1 + (size_t)check_uniform(seed, 0, 7),
                .columns = 1 + (size_t)check_uniform(seed, 0, (double)most)};
    double widest[32] = {0};
    yk_text_puts(&m.text, "A = \\left[\\begin{array}{c");
    for (size_t k = 1; k < m.columns; k++) yk_text_puts(&m.text, k == 2 ? "|c" : "c");
    yk_text_puts(&m.text, "}");
    for (size_t i = 0; i < m.rows; i++) {
        if (i > 0) yk_text_puts(&m.text, i == 2 ? " \\\\ \\hline" : " \\\\");
        for (size_t k = 0; k < m.columns; k++) {
            YkText entry = {0};
            if (check_uniform(seed, 0, 1) < 0.4)
                yk_text_puts(&entry, "0");
            else
                for (int t = 0; t < 1 + (int)check_uniform(seed, 0, 3); t++) {
                    if (t > 0) yk_text_puts(&entry, " + ");
                    add_term(&entry, seed, 0);
                }
            widest[k] = fmax(widest[k], width(yk_text_get(&entry)) + 2);
            yk_text_format(&m.text, k > 0 ? " & %s" : " %s", yk_text_get(&entry));
            yk_text_free(&entry);
        }
    }
    for (size_t k = 0; k < m.columns; k++) m.widths += widest[k];
    yk_text_puts(&m.text, " \\end{array}\\right]");
    if (check_uniform(seed, 0, 1) < 0.5) return m;
    size_t own = m.text.length;
    for (int t = 0; t < 1 + (int)check_uniform(seed, 0, 9); t++) {
        yk_text_puts(&m.text, " + ");
        add_term(&m.text, seed, 0);
    }
    m.rest = width(yk_text_get(&m.text) + own);
    return m;
}

// Puts the meaning of numbered boxes back into what is shown, and takes away what only sets it smaller.
static YkText put_back(const char *shown)
{
    YkText all = {0};
    const char *end = strstr(shown, "\n\\]");
    const char *end_lines = strstr(shown, "\n\\end{multline*}");
    if (!end || (end_lines && end_lines < end)) end = end_lines;
    const char *begin = strstr(shown, "\\["), *lines = strstr(shown, "\\begin{multline*}");
    begin = lines && (!begin || lines < begin) ? lines + strlen("\\begin{multline*}\n") : begin + 3;
    for (const char *c = begin; c < end;) {
        if (strncmp(c, " \\\\\n", 4) == 0) {
            c += 4;
            continue;
        }
        if (strncmp(c, "\\boxed{", 7) != 0) {
            yk_text_add(&all, c++, 1);
            continue;
        }
        char key[40];
        snprintf(key, sizeof key, "\\boxed{%d} = ", atoi(c + 7));
        const char *meaning = strstr(end, key);
        assert_non_null(meaning);
        assert_null(strstr(meaning + 1, key)); // it is said once
        meaning += strlen(key);
        const char *stop = strstr(meaning, "\n\\"), *next = strstr(meaning, " ,\\quad ");
        if (next && next < stop) stop = next;
        for (const char *d = meaning; d < stop; d++)
            if (strncmp(d, " \\\\\n", 4) == 0)
                d += 3, yk_text_puts(&all, " "); // long parts are broken, too, before a blank
            else
                yk_text_add(&all, d, 1);
        c = strchr(c, '}') + 1;
    }
    return all;
}

static void squeeze(YkText *text) // blanks do not matter
{
    size_t kept = 0;
    for (size_t k = 0; k < text->length; k++)
        if (text->data[k] != ' ') text->data[kept++] = text->data[k];
    text->length = kept;
    text->data[kept] = '\0';
}

static void matrices_say_the_same_in_any_size(void **state)
{
    (void)state;
    uint64_t seed = 2026;
    size_t boxed = 0, small = 0, plain = 0;
    for (size_t trial = 0; trial < check_cases(100); trial++) {
        Matrix m = random_matrix(&seed, 1 + trial % 14);
        const char *formula = yk_text_get(&m.text), *head = strstr(strstr(formula, "{array}{") + 8, "}") + 1;
        const char *end = strstr(formula, "\\end{array}");
        CHECK_NEAR(yk_latex_width_of_array(head, end), m.widths, 1e-9);
        double whole = yk_latex_width_with_arrays(formula, m.text.length);
        CHECK_NEAR(whole, width("A = [") + 2 + m.widths + width("]") + m.rest, 1e-9);
        bool breaks = m.rest > 0 && whole > 1.2 * YK_LATEX_LINE; // behind the matrix
        if (breaks) whole = fmax(whole - m.rest, m.rest);
        YkText shown = {0};
        yk_latex_display(&shown, formula);
        const char *all = yk_text_get(&shown);
        YkText back = put_back(all);
        squeeze(&back);
        squeeze(&m.text);
        assert_string_equal(yk_text_get(&back), yk_text_get(&m.text));
        bool has_boxes = strstr(all, "\\boxed") != NULL, is_small = *all == '{';
        // Type gets smaller as little as it must; numbers stand for what does not fit in small type.
        assert_int_equal(has_boxes, whole > 1.4 * YK_LATEX_LINE);
        if (!has_boxes) {
            assert_int_equal(strstr(all, "multline") != NULL, breaks);
            assert_int_equal(is_small, whole > YK_LATEX_LINE);
            assert_int_equal(strncmp(all, "{\\scriptsize", 12) == 0, whole > 1.2 * YK_LATEX_LINE);
            assert_int_equal(strstr(all, "arraycolsep") != NULL, whole > 1.2 * YK_LATEX_LINE);
        }
        if (is_small) assert_true(all[strlen(all) - 2] == '}' || has_boxes);
        boxed += has_boxes;
        small += is_small;
        plain += !has_boxes && !is_small;
        yk_text_free(&back);
        yk_text_free(&shown);
        yk_text_free(&m.text);
    }
    size_t least = check_cases(100) / 20;
    assert_true(boxed >= least && small >= least && plain >= least);
}

// Equal entries share a number; what stays in the matrix is narrower than what is numbered.
static void the_widest_entries_are_numbered(void **state)
{
    (void)state;
    uint64_t seed = 77;
    for (size_t trial = 0; trial < check_cases(100); trial++) {
        Matrix m = random_matrix(&seed, 12);
        YkLatexBoxes boxes = {0};
        double widest = check_uniform(&seed, 5, 40);
        assert_true(yk_latex_box(&boxes, yk_text_get(&m.text), widest));
        for (size_t k = 0; k < boxes.count; k++) {
            assert_true(yk_latex_width(boxes.items[k].text, boxes.items[k].length) > widest);
            assert_true(*boxes.items[k].text != ' ' && boxes.items[k].text[boxes.items[k].length - 1] != ' ');
            for (size_t i = 0; i < k; i++)
                assert_false(boxes.items[i].length == boxes.items[k].length &&
                             strncmp(boxes.items[i].text, boxes.items[k].text, boxes.items[k].length) == 0);
        }
        if (m.widths < 0.6 * YK_LATEX_LINE) assert_int_equal(boxes.count, 0); // it needs no help
        const char *at = strstr(strstr(yk_text_get(&boxes.formula), "{array}{") + 8, "}") + 1,
                   *end = strstr(at, "\\end");
        while (at < end && m.widths >= 0.6 * YK_LATEX_LINE) {
            const char *stop = at;
            while (stop < end && *stop != '&' && strncmp(stop, "\\\\", 2) != 0) stop++;
            assert_true(yk_latex_width(at, (size_t)(stop - at)) <= fmax(widest, 4));
            at = *stop == '&' ? stop + 1 : strncmp(stop + 2, " \\hline", 7) == 0 ? stop + 9 : stop + 2;
        }
        yk_latex_boxes_free(&boxes);
        yk_text_free(&m.text);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(commands_are_as_wide_as_what_they_print),
        cmocka_unit_test(long_sums_fill_their_lines),
        cmocka_unit_test(matrices_say_the_same_in_any_size),
        cmocka_unit_test(the_widest_entries_are_numbered),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

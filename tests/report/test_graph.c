// The structure as a picture: every body and joint is there, boxes do not overlap, it is the same every time.
#include "report/graph.h"
#include "report/page.h"

typedef struct Box {
    double x, y, width, height;
} Box;

static double attribute(const char *element, const char *name)
{
    char pattern[32];
    snprintf(pattern, sizeof pattern, " %s=\"", name);
    const char *at = strstr(element, pattern);
    return at ? atof(at + strlen(pattern)) : (double)NAN;
}

static void check_boxes(const char *name)
{
    Page page = open_page(name, NULL);
    YkText svg = {0}, again = {0};
    Box boxes[64];
    size_t count = 0;
    assert_true(yk_structure_write(page.mech, &svg));
    for (const char *at = strstr(svg.data, "<rect x="); at; at = strstr(at + 1, "<rect x="))
        boxes[count++] = (Box){attribute(at, "x"), attribute(at, "y"), attribute(at, "width"), attribute(at, "height")};
    assert_int_equal(count, page.model->body_count);
    for (size_t i = 0; i < count; i++)
        for (size_t k = 0; k < i; k++) {
            bool apart = fabs(boxes[i].x + boxes[i].width / 2 - boxes[k].x - boxes[k].width / 2) >
                             (boxes[i].width + boxes[k].width) / 2 ||
                         fabs(boxes[i].y - boxes[k].y) > boxes[i].height;
            if (!apart) fail_msg("%s: boxes %zu and %zu lie on each other", name, k, i);
        }
    for (size_t j = 0; j < page.model->joint_count; j++) {
        char word[300];
        snprintf(word, sizeof word, ">%s</text>", page.model->joints[j].name);
        assert_non_null(strstr(svg.data, word));
    }
    assert_true(yk_structure_write(page.mech, &again));
    assert_string_equal(svg.data, again.data);
    yk_text_free(&svg);
    yk_text_free(&again);
    close_page(&page);
}

static void pictures_are_readable(void **state)
{
    (void)state;
    static const char *const names[] = {"four-bar", "quick-return", "jansen",   "andrews",
                                        "pendulum", "epicyclic",    "excavator"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) check_boxes(names[i]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(pictures_are_readable)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

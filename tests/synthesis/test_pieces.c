// Pieces of a search: each depends on its number alone, and a search that gets them from elsewhere gives the same
// answer.
#include "synthesis/answer.h"
#include <string.h>

static const char path_task[] = "synthesis: path\nbest: 3\nunits: {length: mm}\nbounds: {lengths: [5, "
                                "200]}\nmechanisms: [four-bar, slider-crank]\npoints:\n"
                                "- [0, 0]\n- [10, 6]\n- [22, 9]\n- [35, 8]\n- [47, 3]\n";
static const char motion_task[] =
    "synthesis: motion\npositions:\n- {at: [0, 0], angle: 0}\n- {at: [1, 0.2], angle: 0.3}\n";

static YkTask *task_of(const char *text)
{
    YkProblems *problems = yk_problems_new();
    YkTask *task = yk_task_parse(text, strlen(text), "task.yaml", problems);
    if (!task) print_error("%s\n", yk_problems_get(problems, 0)->message);
    assert_non_null(task);
    yk_problems_free(problems);
    return task;
}

typedef struct Elsewhere {
    YkPieces *pieces;
    size_t asked, last, ends_after;
    YkStatus end;
} Elsewhere;

static YkStatus get(void *context, size_t piece, double *numbers)
{
    Elsewhere *e = context;
    assert_true(e->asked == 0 || piece > e->last);
    e->last = piece;
    if (e->asked++ == e->ends_after) return e->end;
    return yk_pieces_compute(e->pieces, piece, numbers);
}

static void a_piece_depends_on_its_number_alone(void **state)
{
    (void)state;
    enum { LAST = 700, MOST = 64 }; // past the first slider-crank
    YkTask *task = task_of(path_task);
    YkPieces *forth = yk_pieces_new(task, NULL, NULL), *back = yk_pieces_new(task, NULL, NULL);
    size_t width = yk_pieces_width(forth), found = 0;
    double first[MOST], again[MOST];
    assert_true(width > 0 && width <= MOST && yk_pieces_count(forth) > LAST);
    const size_t pieces[] = {0, 1, 2, 9, 600, 601, LAST};
    for (size_t k = 0; k < sizeof pieces / sizeof *pieces; k++) {
        assert_int_equal(yk_pieces_compute(back, LAST - pieces[k], again), YK_OK); // other work before
        assert_int_equal(yk_pieces_compute(forth, pieces[k], first), YK_OK);
        assert_int_equal(yk_pieces_compute(back, pieces[k], again), YK_OK);
        assert_memory_equal(first, again, width * sizeof *first);
        found += first[0] == 1;
    }
    assert_true(found > 0);
    yk_pieces_free(forth);
    yk_pieces_free(back);
    yk_task_free(task);
}

static void expect_same(const YkSynthesis *a, const YkSynthesis *b)
{
    assert_int_equal(yk_synthesis_count(a), yk_synthesis_count(b));
    for (size_t k = 0; k < yk_synthesis_count(a); k++)
        assert_string_equal(yk_synthesis_candidate(a, k).model, yk_synthesis_candidate(b, k).model);
    for (int k = 0; k < YK_DEFECT_COUNT; k++)
        assert_int_equal(yk_synthesis_left_out(a, (YkDefect)k), yk_synthesis_left_out(b, (YkDefect)k));
}

static void a_search_with_pieces_from_elsewhere_finds_the_same(void **state)
{
    (void)state;
    YkTask *task = task_of(path_task);
    YkSynthesisOptions options = yk_default_synthesis_options();
    YkSynthesis *alone = yk_synthesis_run(task, &options, NULL);
    Elsewhere e = {.pieces = yk_pieces_new(task, &options, NULL), .ends_after = SIZE_MAX};
    options.pieces = (YkPieceSource){get, &e};
    YkSynthesis *shared = yk_synthesis_run(task, &options, NULL);
    assert_true(alone && shared && e.asked > 0);
    expect_same(alone, shared);
    yk_synthesis_free(alone);
    yk_synthesis_free(shared);
    yk_pieces_free(e.pieces);
    yk_task_free(task);
}

static void a_source_ends_the_search(void **state)
{
    (void)state;
    YkTask *task = task_of(path_task);
    YkSynthesisOptions options = yk_default_synthesis_options();
    Elsewhere e = {.pieces = yk_pieces_new(task, &options, NULL), .ends_after = 3, .end = YK_STOPPED};
    options.pieces = (YkPieceSource){get, &e};
    YkSynthesis *stopped = yk_synthesis_run(task, &options, NULL);
    assert_non_null(stopped);
    assert_true(yk_synthesis_was_stopped(stopped));
    assert_int_equal(e.asked, 4);
    yk_synthesis_free(stopped);
    e.asked = 0;
    e.end = YK_NO_MEMORY;
    YkProblems *problems = yk_problems_new();
    assert_null(yk_synthesis_run(task, &options, problems));
    assert_int_equal(yk_problems_error_count(problems), 1);
    yk_problems_free(problems);
    yk_pieces_free(e.pieces);
    yk_task_free(task);
}

static void signatures_tell_tasks_and_seeds_apart(void **state)
{
    (void)state;
    YkTask *path = task_of(path_task), *motion = task_of(motion_task);
    YkSynthesisOptions options = yk_default_synthesis_options();
    YkPieces *one = yk_pieces_new(path, &options, NULL), *same = yk_pieces_new(path, NULL, NULL);
    YkPieces *other = yk_pieces_new(motion, &options, NULL);
    options.seed = 2;
    YkPieces *seed = yk_pieces_new(path, &options, NULL);
    double number;
    assert_true(yk_pieces_signature(one) == yk_pieces_signature(same));
    assert_true(yk_pieces_signature(one) != yk_pieces_signature(seed));
    assert_true(yk_pieces_signature(one) != yk_pieces_signature(other));
    assert_int_equal(yk_pieces_width(other), 0); // sought whole
    assert_int_equal(yk_pieces_compute(other, 0, &number), YK_BAD_ARGUMENT);
    assert_int_equal(yk_pieces_compute(NULL, 0, &number), YK_BAD_ARGUMENT);
    assert_int_equal(yk_pieces_compute(one, yk_pieces_count(one), &number), YK_BAD_ARGUMENT);
    yk_pieces_free(one);
    yk_pieces_free(same);
    yk_pieces_free(seed);
    yk_pieces_free(other);
    yk_task_free(path);
    yk_task_free(motion);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_piece_depends_on_its_number_alone),
        cmocka_unit_test(a_search_with_pieces_from_elsewhere_finds_the_same),
        cmocka_unit_test(a_source_ends_the_search),
        cmocka_unit_test(signatures_tell_tasks_and_seeds_apart),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Movies: their names, and as SVG; those that need other programs are tested in tests/cli/test_reports.py.
#include "check.h"
#include <stdlib.h>
#include <unistd.h>
#include <yoke/yoke.h>
#include "base/codes.h"
#include "picture/movie.h"

static void the_ending_says_the_kind(void **state)
{
    (void)state;
    assert_int_equal(yk_movie_kind("a.svg"), YK_MOVIE_SVG);
    assert_int_equal(yk_movie_kind("/tmp/a.b.gif"), YK_MOVIE_GIF);
    assert_int_equal(yk_movie_kind("a.mp4"), YK_MOVIE_MP4);
    assert_int_equal(yk_movie_kind("a.webm"), YK_MOVIE_WEBM);
    assert_int_equal(yk_movie_kind(".gif"), YK_MOVIE_OTHER);
    assert_int_equal(yk_movie_kind("gif"), YK_MOVIE_OTHER);
    assert_int_equal(yk_movie_kind("a.avi"), YK_MOVIE_OTHER);
    for (int kind = 0; kind < YK_MOVIE_OTHER; kind++) assert_true(yk_movie_rate((YkMovieKind)kind) > 0);
}

typedef struct Machine {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDrawing *drawing;
    YkProblems *problems;
} Machine;

static Machine open_machine(void)
{
    Machine m = {.problems = yk_problems_new()};
    YkDrawOptions options = yk_default_draw_options();
    options.moving = true;
    m.model = yk_model_load(YOKE_ROOT "/examples/four-bar.yaml", NULL, m.problems);
    m.mech = yk_mechanism_compile(m.model, NULL, m.problems);
    m.state = yk_state_new(m.mech);
    m.drawing = yk_drawing_new(m.mech, &options);
    assert_true(yk_state_set_time(m.state, 0, m.problems) >= 0 && yk_state_assemble(m.state) >= 0);
    for (int k = 0; k < 3; k++) {
        YkMotion motion = yk_state_input(m.state, 0);
        motion.position += 0.1;
        yk_state_set_input(m.state, 0, motion);
        assert_true(yk_state_solve(m.state) >= 0);
        assert_int_equal(yk_drawing_pose(m.drawing, m.state), YK_OK);
    }
    return m;
}

static void close_machine(Machine *m)
{
    yk_drawing_free(m->drawing);
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

static void svg_needs_no_other_program(void **state)
{
    (void)state;
    Machine m = open_machine();
    YkText movie = {0};
    assert_true(yk_movie_write(m.drawing, YK_MOVIE_SVG, 2, false, &movie, m.problems));
    assert_string_equal(yk_text_get(&movie), yk_drawing_animation(m.drawing, 2, false));
    yk_text_free(&movie);
    close_machine(&m);
}

static void a_missing_program_is_told_once(void **state)
{
    (void)state;
    Machine m = open_machine();
    YkText movie = {0};
    char *path = strdup(getenv("PATH"));
    setenv("PATH", "/nowhere", 1);
    assert_false(yk_movie_write(m.drawing, YK_MOVIE_GIF, 2, false, &movie, m.problems));
    setenv("PATH", path, 1);
    assert_int_equal(movie.length, 0);
    assert_int_equal(yk_problems_count(m.problems), 1);
    assert_int_equal(yk_problems_get(m.problems, 0)->code, YK_CODE_PROGRAM_MISSING);
    assert_non_null(yk_problems_get(m.problems, 0)->hint);
    free(path);
    close_machine(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ending_says_the_kind),
        cmocka_unit_test(svg_needs_no_other_program),
        cmocka_unit_test(a_missing_program_is_told_once),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Task files that are wrong: each gets its code, its place, and all problems at once.
#include "synthesis/answer.h"
#include "base/codes.h"
#include "synthesis/design.h"
#include "synthesis/tasks/task.h"

#define PATH "points: [[0, 0], [1, 1]]\n"
#define THREE "points: [[0, 0], [1, 1], [2, 0]]\n"
#define TWO "positions: [{at: [0, 0], angle: 0}, {at: [1, 0], angle: 1}]\n"

static void refuse(const char *text, int code, unsigned line)
{
    YkProblems *problems = yk_problems_new();
    YkTask *task = yk_task_parse(text, strlen(text), "bad.yaml", problems);
    bool has = false;
    for (size_t k = 0; k < yk_problems_count(problems); k++) {
        const YkProblem *p = yk_problems_get(problems, k);
        has |= p->code == code && p->place.line == line && p->message[strlen(p->message) - 1] != '.';
    }
    if (task || !has) print_error("%s\nwants E%04d in line %u:\n%s", text, code, line, yk_problems_text(problems, 0));
    assert_null(task);
    assert_true(has);
    yk_problems_free(problems);
}

static void machines_that_a_task_cannot_have_are_passed_over_where_others_are_left(void **state)
{
    (void)state;
    static const char text[] = "synthesis: function\nof: log10(x)\nx: [1, 2]\ninput: 60 deg\noutput: 90 deg\n"
                               "mechanisms: [four-bar, watt]\n";
    YkProblems *problems = yk_problems_new();
    YkTask *task = yk_task_parse(text, strlen(text), "task.yaml", problems);
    assert_non_null(task);
    assert_int_equal(yk_problems_count(problems), 1);
    assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_TASK_MECHANISM);
    assert_int_equal(task->kinds, 1u << YK_DESIGN_FOUR_BAR);
    yk_task_free(task);
    yk_problems_free(problems);
}

static void nine_points_with_something_given_are_told_to_be_met_nearly(void **state)
{
    (void)state;
    static const char *const fix[] = {"", "fix: {input_pivot: [0, 0]}\n",
                                      "fix: {input_pivot: [0, 0], output_pivot: [1, 0]}\n", "fix: {ground_angle: 0}\n"};
    static const char *const left[] = {NULL, "leaves 7:", "leaves 5:", "leaves 8:"};
    for (size_t k = 0; k < 4; k++) {
        char text[400];
        snprintf(text, sizeof text,
                 "synthesis: path\npoints: [[.25, 0], [.52, .1], [.8, .7], [1.2, 1], [1.4, 1.3], [1.1, 1.48],\n"
                 "         [.7, 1.4], [.2, 1], [.02, .4]]\n%s",
                 fix[k]);
        YkProblems *problems = yk_problems_new();
        YkTask *task = yk_task_parse(text, strlen(text), "task.yaml", problems);
        assert_non_null(task);
        assert_int_equal(yk_problems_count(problems), k > 0);
        if (k > 0) {
            assert_int_equal(yk_problems_get(problems, 0)->code, YK_CODE_TASK_NEARLY);
            assert_int_equal(yk_problems_get(problems, 0)->place.line, 4);
            assert_non_null(strstr(yk_problems_text(problems, 0), left[k]));
        }
        yk_task_free(task);
        yk_problems_free(problems);
    }
}

static void every_mistake_has_its_code_and_place(void **state)
{
    (void)state;
    refuse("[1, 2]\n", YK_CODE_MODEL_NOT_MAP, 1);
    refuse("name: x\n", YK_CODE_MISSING_KEY, 1);
    refuse("synthesis: dance\n", YK_CODE_TASK_KIND, 1);
    refuse("synthesis: path\n", YK_CODE_MISSING_KEY, 1);
    refuse("name: x\nsynthesis: path\npoints: [[0, 0]]\n", YK_CODE_TASK_POSITIONS, 3);
    refuse("synthesis: path\npoints: [[0, 0], [0, 0], [1, 1]]\n", YK_CODE_TASK_POSITIONS, 2);
    refuse("synthesis: path\npoints: [[0, 0], [1]]\n", YK_CODE_COMPONENTS, 2);
    refuse("synthesis: path\npoints: [[0, 0], [1, 3 kg]]\n", YK_CODE_WRONG_DIMENSION, 2);
    refuse("synthesis: path\n" PATH "angles: [0, 1, 2]\n", YK_CODE_COMPONENTS, 3);
    refuse("synthesis: path\n" THREE "angles: [0, 1, .5]\n", YK_CODE_TASK_FUNCTION, 3);
    refuse("synthesis: path\n" PATH "angles: {from: free}\n", YK_CODE_MISSING_KEY, 3);
    refuse("synthesis: path\n" PATH "angles: {from: 3, step: 1}\n", YK_CODE_WRONG_WORD, 3);
    refuse("synthesis: path\n" PATH "angles: {from: free, step: 0}\n", YK_CODE_TASK_FUNCTION, 3);
    refuse("synthesis: path\n" PATH "closed: perhaps\n", YK_CODE_WRONG_WORD, 3);
    refuse("synthesis: path\n" PATH "mechanisms: [klann]\n", YK_CODE_WRONG_WORD, 3);
    refuse("synthesis: path\n" PATH "mechanisms: []\n", YK_CODE_WRONG_WORD, 3);
    refuse("synthesis: path\n" PATH "mechanisms: [slider-crank]\nfix: {output_pivot: [1, 1]}\n", YK_CODE_TASK_BOUNDS,
           4);
    refuse("synthesis: path\n" PATH "fix: {input_pivot: [1, 1], output_pivot: [1, 1]}\n", YK_CODE_TASK_BOUNDS, 3);
    refuse("synthesis: path\n" PATH "fix: {input_pivot: [0, 1], output_pivot: [1, 1], ground_angle: 1}\n",
           YK_CODE_RIVAL_KEYS, 3);
    refuse("synthesis: motion\n", YK_CODE_MISSING_KEY, 1);
    refuse("synthesis: motion\n" TWO "colour: red\n", YK_CODE_UNKNOWN_KEY, 3);
    refuse("synthesis: motion\n" TWO "swing: 3\n", YK_CODE_UNKNOWN_KEY, 3);
    refuse("synthesis: motion\npositions: []\n", YK_CODE_TASK_POSITIONS, 2);
    refuse("synthesis: motion\npositions: [{at: [0, 0], angle: 0}]\n", YK_CODE_TASK_POSITIONS, 2);
    refuse("synthesis: motion\npositions: [{at: [0, 0]}, {at: [1, 1], angle: 1}]\n", YK_CODE_MISSING_KEY, 2);
    refuse("synthesis: motion\npositions:\n- {at: [0, 0, 0], angle: 0}\n- {at: [1, 1], angle: 1}\n", YK_CODE_COMPONENTS,
           3);
    refuse("synthesis: motion\npositions:\n- {at: [0, 0], angle: 0}\n- {at: [0, 0], angle: 0}\n",
           YK_CODE_TASK_POSITIONS, 4);
    refuse("synthesis: motion\npositions:\n- {at: [0, 0], angle: 1}\n- {at: [1, 0], angle: 1}\n", YK_CODE_TASK_SPECIAL,
           3);
    refuse("synthesis: motion\npositions:\n- {at: [3, 1], angle: 0}\n- {at: [1, 3], angle: 90 deg}\n"
           "- {at: [-1, 1], angle: 180 deg}\n",
           YK_CODE_TASK_SPECIAL, 3); // about (1, 1)
    refuse("synthesis: motion\n" TWO "mechanisms: [slider-crank]\nfix: {output_pivot: [1, 1]}\n", YK_CODE_TASK_BOUNDS,
           3);
    refuse("synthesis: motion\nmechanisms: [slider-crank]\npositions:\n- {at: [0, 0], angle: 0}\n- {at: [1, 0], angle: "
           "1}\n"
           "- {at: [1, 1], angle: 2}\n- {at: [3, 0], angle: 3}\n- {at: [2, 5], angle: 4}\n",
           YK_CODE_TASK_POSITIONS, 2);
    refuse("synthesis: function\nof: x\nx: [1, 2]\ninput: 1\noutput: 1\nsamples: 4\nevened: true\n",
           YK_CODE_TASK_EVENED, 7);
    refuse("synthesis: function\nof: x\nx: [1, 2]\ninput: 1\noutput: 1\nmechanisms: [watt]\n", YK_CODE_WRONG_WORD, 6);
    refuse("synthesis: function\nof: x\nx: [1, 2]\ninput: 1\noutput: 30 deg\nmechanisms: [slider-crank]\n",
           YK_CODE_WRONG_DIMENSION, 5);
    refuse("synthesis: function\nof: x\nx: [1, 2]\ninput: 1\noutput: 1\nfix: {travel: 1}\n", YK_CODE_TASK_BOUNDS, 6);
    refuse("synthesis: function\nof: x\nx: [1, 2]\ninput: 1\noutput: 1\nmechanisms: [slider-crank]\nfix: {ground: 1}\n",
           YK_CODE_TASK_BOUNDS, 7);
    refuse("synthesis: motion\npositions:\n- {at: [0, 0], angle: 3 mm}\n- {at: [1, 0], angle: 1}\n",
           YK_CODE_WRONG_DIMENSION, 3);
    refuse("synthesis: motion\npositions:\n- {at: [0, 0], angle: q}\n- {at: [1, 0], angle: 1}\n", YK_CODE_UNKNOWN_NAME,
           3);
    refuse("synthesis: motion\n" TWO "require: {input: spins}\n", YK_CODE_WRONG_WORD, 3);
    refuse("synthesis: motion\n" TWO "mechanisms: [watt]\n", YK_CODE_WRONG_WORD, 3);
    refuse("synthesis: motion\n" TWO "rates: [{position: 3, velocity: [1, 0], rate: 1}]\n", YK_CODE_TASK_POSITIONS, 3);
    refuse("synthesis: motion\n" TWO "rates: [{position: 1, velocity: [0, 0], rate: 0}]\n", YK_CODE_TASK_POSITIONS, 3);
    refuse("synthesis: motion\n" TWO "rates: [{position: 1, velocity: [1, 0]}]\n", YK_CODE_MISSING_KEY, 3);
    refuse("synthesis: motion\n" TWO
           "rates:\n- {position: 2, velocity: [1, 0], rate: 1}\n- {position: 2, velocity: [0, 1], rate: 1}\n",
           YK_CODE_TASK_POSITIONS, 5);
    refuse("synthesis: motion\n" TWO "rates: [1, 2, 3, 4]\n", YK_CODE_TASK_POSITIONS, 3);
    refuse("synthesis: motion\n" TWO "best: 0\n", YK_CODE_TASK_BOUNDS, 3);
    refuse("synthesis: motion\n" TWO "bounds: {lengths: [3, 2]}\n", YK_CODE_TASK_BOUNDS, 3);
    refuse("synthesis: motion\n" TWO "bounds: {lengths: [3]}\n", YK_CODE_COMPONENTS, 3);
    refuse("synthesis: motion\n" TWO "bounds: {pivots: [[0, 0], [1]]}\n", YK_CODE_COMPONENTS, 3);
    refuse("synthesis: function\n", YK_CODE_MISSING_KEY, 1);
    refuse("synthesis: function\nof: x\nx: [1, 2]\ninput: 1\noutput: 1\npairs: [[0, 0]]\n", YK_CODE_RIVAL_KEYS, 6);
    refuse("synthesis: function\nof: log(x)\nx: [0, 2]\ninput: 1\noutput: 1\n", YK_CODE_TASK_FUNCTION, 2);
    refuse("synthesis: function\nof: x^2\nx: [-1, 1]\ninput: 1\noutput: 1\n", YK_CODE_TASK_FUNCTION, 2);
    refuse("synthesis: function\nof: x^2\nx: [1, 2]\ninput: 400 deg\noutput: 1\n", YK_CODE_TASK_FUNCTION, 4);
    refuse("synthesis: function\nof: x^2\nx: [1, 2]\ninput: 1\noutput: 1\nsamples: 7\n", YK_CODE_TASK_POSITIONS, 6);
    refuse("synthesis: function\nof: y^2\nx: [1, 2]\ninput: 1\noutput: 1\n", YK_CODE_UNKNOWN_NAME, 2);
    refuse("synthesis: function\nof: x*1 m\nx: [1, 2]\ninput: 1\noutput: 1\n", YK_CODE_WRONG_DIMENSION, 2);
    refuse("synthesis: function\npairs: [[0, 0], [1, 1]]\n", YK_CODE_TASK_POSITIONS, 2);
    refuse("synthesis: function\npairs: [[0, 0], [1, 1], [.5, 2]]\n", YK_CODE_TASK_FUNCTION, 2);
    refuse("synthesis: path\npoints: [[0, 0], [1, 1]]\nangles_from: ground\n", YK_CODE_MISSING_KEY, 3);
    refuse("synthesis: path\npoints: [[0, 0], [1, 1]]\nangles: {from: free, step: 1}\nangles_from: ground\n",
           YK_CODE_RIVAL_KEYS, 4);
    refuse("synthesis: path\npoints: [[0, 0], [1, 1]]\nangles: [0, 1]\nangles_from: y\n", YK_CODE_WRONG_WORD, 4);
    refuse("synthesis: stroke\n", YK_CODE_MISSING_KEY, 1);
    refuse("synthesis: stroke\nswing: 1\nstroke: 1\n", YK_CODE_RIVAL_KEYS, 3);
    refuse("synthesis: stroke\nswing: 200 deg\n", YK_CODE_TASK_FUNCTION, 2);
    refuse("synthesis: stroke\nswing: 1\ntime_ratio: .5\n", YK_CODE_TASK_FUNCTION, 3);
    refuse("synthesis: stroke\nswing: 1\nfix: {output: 1, input: 1}\n", YK_CODE_TASK_BOUNDS, 3);
    refuse("synthesis: stroke\nstroke: 1\nfix: {output: 1}\n", YK_CODE_TASK_BOUNDS, 3);
}

static void all_mistakes_are_told_at_once(void **state)
{
    (void)state;
    static const char text[] =
        "synthesis: motion\ncolour: red\npositions: [{at: [0, 0], angle: 3 mm}, {at: [1], angle: 1}]\n"
        "best: -1\nbounds: {lengths: [2, 1]}\nrequire: {input: spins}\n";
    YkProblems *problems = yk_problems_new();
    assert_null(yk_task_parse(text, strlen(text), "bad.yaml", problems));
    assert_true(yk_problems_error_count(problems) >= 6);
    yk_problems_free(problems);
}

static void values_have_units_and_parameters(void **state)
{
    (void)state;
    static const char text[] =
        "name: lid\nsynthesis: motion\nunits: {length: mm, angle: deg}\nparameters: {w: 50, turn: 30}\n"
        "positions: [{at: [0, 0], angle: 0}, {at: [w/2, 3 cm], angle: 2*turn}]\n"
        "bounds: {lengths: [10, w]}\nrequire: {transmission: 40}\n";
    YkProblems *problems = yk_problems_new();
    YkTask *task = yk_task_parse(text, strlen(text), "lid.yaml", problems);
    if (!task) print_error("%s", yk_problems_text(problems, 0));
    assert_non_null(task);
    CHECK_NEAR(task->motion.pose[1].at.x, .025, 1e-16);
    CHECK_NEAR(task->motion.pose[1].at.y, .03, 1e-16);
    CHECK_NEAR(task->motion.pose[1].angle, YK_PI / 3, 1e-15);
    CHECK_NEAR(task->lengths.high, .05, 1e-16);
    CHECK_NEAR(task->transmission.value, 2 * YK_PI / 9, 1e-15);
    assert_string_equal(yk_task_name(task), "lid");
    assert_string_equal(yk_task_kind(task), "motion");
    double size;
    assert_string_equal(yk_task_unit(task, YK_QUANTITY_LENGTH, &size), "mm");
    CHECK_NEAR(size, 1e-3, 0);
    yk_task_free(task);
    yk_problems_free(problems);
}

static void cut_anywhere_a_task_loads_or_is_refused(void **state)
{
    (void)state;
    static const char text[] =
        "name: y\nsynthesis: function\nof: log10(x) + sin(x/2)\nx: [1, 2]\ninput: 60 deg\noutput: -90 deg\n"
        "samples: 4\nrequire: {transmission: 30 deg, order: false}\nbounds: {pivots: [[0, 0], [1, 1]]}\n";
    for (size_t cut = 0; cut < sizeof text; cut++) {
        YkProblems *problems = yk_problems_new();
        YkTask *task = yk_task_parse(text, cut, "cut", problems);
        assert_int_equal(task == NULL, yk_problems_error_count(problems) > 0);
        yk_task_free(task);
        yk_problems_free(problems);
    }
}

static void nothing_is_asked_of_nothing(void **state)
{
    (void)state;
    YkSynthesisOptions options = yk_default_synthesis_options();
    assert_null(yk_task_load(NULL, NULL));
    assert_null(yk_task_parse(NULL, 0, NULL, NULL));
    assert_null(yk_task_name(NULL));
    assert_null(yk_task_kind(NULL));
    assert_null(yk_synthesis_run(NULL, &options, NULL));
    assert_int_equal(yk_synthesis_count(NULL), 0);
    assert_int_equal(yk_synthesis_dyad_count(NULL), 0);
    assert_int_equal(yk_synthesis_left_out(NULL, YK_DEFECT_BRANCH), 0);
    assert_null(yk_synthesis_picture(NULL));
    assert_null(yk_synthesis_parameter(NULL, 0, 0, NULL));
    yk_task_free(NULL);
    yk_synthesis_free(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(machines_that_a_task_cannot_have_are_passed_over_where_others_are_left),
        cmocka_unit_test(nine_points_with_something_given_are_told_to_be_met_nearly),
        cmocka_unit_test(every_mistake_has_its_code_and_place),
        cmocka_unit_test(all_mistakes_are_told_at_once),
        cmocka_unit_test(values_have_units_and_parameters),
        cmocka_unit_test(cut_anywhere_a_task_loads_or_is_refused),
        cmocka_unit_test(nothing_is_asked_of_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

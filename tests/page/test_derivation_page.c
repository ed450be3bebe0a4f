// The door of derivations: pages and verdicts.
#include <stdlib.h>
#include "check.h"
#include "base/text.h"
#include <yoke/yoke.h>

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    YkDerivation *derivation;
} Machine;

static Machine load(const char *name)
{
    char path[600];
    snprintf(path, sizeof path, "%s/examples/%s.yaml", YOKE_ROOT, name);
    Machine m = {.problems = yk_problems_new()};
    m.model = yk_model_load(path, NULL, m.problems);
    m.mech = yk_mechanism_compile(m.model, NULL, m.problems);
    m.state = yk_state_new(m.mech);
    assert_int_equal(yk_state_set_time(m.state, 0, m.problems), YK_OK);
    assert_int_equal(yk_state_assemble(m.state), YK_OK);
    m.derivation = yk_derivation_new(m.model, m.mech, m.problems);
    assert_non_null(m.derivation);
    return m;
}

static void release(Machine *m)
{
    yk_derivation_free(m->derivation);
    yk_state_free(m->state);
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
}

static bool gather(void *context, const char *text, size_t length)
{
    yk_text_add(context, text, length);
    return true;
}
static bool refuse(void *context, const char *text, size_t length)
{
    (void)text;
    *(size_t *)context += length;
    return false;
}

static void a_page_is_kept_or_handed_over_alike(void **state)
{
    (void)state;
    for (int format = 0; format < YK_PAGE_FORMATS; format++) {
        Machine m = load("quick-return");
        YkPageOptions options = yk_default_page_options();
        options.format = (YkPageFormat)format;
        assert_int_equal(yk_derivation_page(m.derivation, &options, m.problems), YK_OK);
        YkText kept = {0}, taken = {0};
        yk_text_puts(&kept, yk_derivation_text(m.derivation));
        assert_true(kept.length > 1000);
        release(&m);
        m = load("quick-return");
        options.write = gather;
        options.context = &taken;
        assert_int_equal(yk_derivation_page(m.derivation, &options, m.problems), YK_OK);
        assert_string_equal(yk_text_get(&taken), yk_text_get(&kept));
        assert_string_equal(yk_derivation_text(m.derivation), "");
        size_t seen = 0;
        options.write = refuse;
        options.context = &seen;
        assert_int_equal(yk_derivation_page(m.derivation, &options, m.problems), YK_STOPPED);
        assert_true(seen > 0);
        assert_int_equal(yk_problems_error_count(m.problems), 0);
        yk_text_free(&taken);
        yk_text_free(&kept);
        release(&m);
    }
}

static void sections_are_chosen_and_values_stand_beside(void **state)
{
    (void)state;
    Machine m = load("quick-return");
    bool wanted[32] = {false};
    assert_true(yk_derivation_section_count() <= 32);
    assert_true(yk_derivation_section_find("nothing") == YK_NOT_FOUND);
    size_t loops = yk_derivation_section_find("loops");
    assert_string_equal(yk_derivation_section_name(loops), "loops");
    assert_false(yk_derivation_has_section(m.derivation, yk_derivation_section_find("gears")));
    wanted[loops] = true;
    YkPageOptions options = yk_default_page_options();
    options.sections = wanted;
    assert_int_equal(yk_derivation_page(m.derivation, &options, m.problems), YK_OK);
    assert_non_null(strstr(yk_derivation_text(m.derivation), yk_derivation_section_title(loops)));
    assert_null(strstr(yk_derivation_text(m.derivation), "Jacobian"));
    size_t plain = strlen(yk_derivation_text(m.derivation));
    options.state = m.state;
    assert_int_equal(yk_derivation_page(m.derivation, &options, m.problems), YK_OK);
    assert_true(strlen(yk_derivation_text(m.derivation)) > plain);
    options.format = YK_PAGE_FORMATS;
    assert_int_equal(yk_derivation_page(m.derivation, &options, m.problems), YK_BAD_ARGUMENT);
    release(&m);
}

static void equations_get_their_verdict(void **state)
{
    (void)state;
    Machine m = load("quick-return");
    YkCheckVerdict verdict =
        yk_derivation_check(m.derivation, m.state, NULL, "l1*cos(theta1) = d3*cos(theta2)", m.problems);
    assert_int_equal(verdict.kind, YK_CHECK_TRUE);
    assert_false(verdict.is_identity);
    verdict = yk_derivation_check(m.derivation, m.state, NULL, "l1*cos(theta1) + d3*cos(theta2) = 0", m.problems);
    assert_int_equal(verdict.kind, YK_CHECK_FALSE);
    assert_non_null(verdict.slip);
    const YkMotion *at = verdict.shown.positions;
    YkMotion d3 = at[yk_coordinate_find(m.mech, "d3")], theta1 = at[yk_coordinate_find(m.mech, "theta1")],
             theta2 = at[yk_coordinate_find(m.mech, "theta2")];
    CHECK_NEAR(verdict.shown.left - verdict.shown.right,
               yk_model_parameter(m.model, "l1") * cos(theta1.position) + d3.position * cos(theta2.position), 1e-12);
    assert_int_equal(yk_problems_count(m.problems), 0);
    verdict = yk_derivation_check(m.derivation, m.state, NULL, "l1*cos(theta1) = 2*nobody", m.problems);
    assert_int_equal(verdict.kind, YK_CHECK_UNREADABLE);
    assert_string_equal(yk_check_kind_name(verdict.kind), "unreadable");
    assert_non_null(strstr(yk_problems_get(m.problems, 0)->message, "`l1*cos(theta1) = 2*nobody`: "));
    release(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_page_is_kept_or_handed_over_alike),
        cmocka_unit_test(sections_are_chosen_and_values_stand_beside),
        cmocka_unit_test(equations_get_their_verdict),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

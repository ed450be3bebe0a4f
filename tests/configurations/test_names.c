// Names of configurations: no two at a pose are alike, and a configuration keeps its name while the machine moves.
#include <yoke/move.h>
#include "solve/machine.h"
#include <yoke/configurations.h>

enum { COUNT_MAX = 32, NAME_SIZE = 32 };

typedef struct Names {
    YkConfigurations *all;
    const YkMechanism *mech;
    char name[COUNT_MAX][NAME_SIZE];
    YkState *state[COUNT_MAX];
    size_t count;
} Names;

static bool gather(void *context, YkState *state)
{
    Names *n = context;
    const char *name;
    assert_true(n->count < COUNT_MAX);
    assert_int_equal(yk_configurations_name(n->all, state, NULL, &name), YK_OK);
    snprintf(n->name[n->count], NAME_SIZE, "%s", name);
    n->state[n->count] = yk_state_new(n->mech);
    assert_non_null(n->state[n->count]);
    assert_int_equal(yk_state_copy(n->state[n->count++], state), YK_OK);
    return true;
}

static bool ask_unprepared(void *context, YkState *state)
{
    Names *n = context;
    const char *name;
    assert_int_equal(yk_configurations_name(n->all, state, NULL, &name), YK_BAD_ARGUMENT);
    assert_string_equal(name, "");
    n->count++;
    return false;
}

static Names names_of(const Machine *m)
{
    Names n = {.all = yk_configurations_new(m->mech), .mech = m->mech};
    YkConfigurationsOptions options = yk_default_configurations_options();
    assert_non_null(n.all);
    options.in_search_order = options.with_names = true;
    assert_true(yk_configurations_each(n.all, m->state, &options, gather, &n, NULL) >= 0);
    return n;
}

static void forget(Names *n)
{
    for (size_t k = 0; k < n->count; k++) yk_state_free(n->state[k]);
    yk_configurations_free(n->all);
}

static void names_differ_at_a_pose(void **state)
{
    (void)state;
    Machine m = machine_load("double-butterfly");
    Names n = names_of(&m);
    assert_int_equal(n.count, 8);
    for (size_t k = 0; k < n.count; k++) {
        char label[NAME_SIZE];
        size_t length = yk_state_label(n.state[k], label, sizeof label);
        assert_true(strncmp(n.name[k], label, length) == 0 && n.name[k][length] == '.');
        for (size_t j = 0; j < k; j++) assert_string_not_equal(n.name[k], n.name[j]);
    }
    forget(&n);
    machine_free(&m);
}

static void a_name_stays_while_the_machine_moves(void **state)
{
    (void)state;
    Machine m = machine_load("double-butterfly");
    Names n = names_of(&m);
    for (size_t k = 0; k < n.count; k++) {
        YkMotion goal = yk_state_input(n.state[k], 0);
        const char *name;
        goal.position += 0.02;
        assert_true(yk_state_move_to(n.state[k], &goal, NULL, NULL) >= 0);
        assert_int_equal(yk_configurations_name(n.all, n.state[k], NULL, &name), YK_OK);
        assert_string_equal(name, n.name[k]);
    }
    forget(&n);
    machine_free(&m);
}

static void dyads_have_their_labels(void **state)
{
    (void)state;
    Machine m = machine_load("watt-six-bar");
    Names n = names_of(&m);
    assert_true(n.count > 1);
    for (size_t k = 0; k < n.count; k++) {
        char label[NAME_SIZE];
        yk_state_label(n.state[k], label, sizeof label);
        assert_string_equal(n.name[k], label);
    }
    forget(&n);
    machine_free(&m);
}

static void what_cannot_be_named_is_refused(void **state)
{
    (void)state;
    Machine m = machine_load("double-butterfly"), other = machine_load("four-bar");
    Names n = {.all = yk_configurations_new(m.mech), .mech = m.mech};
    const char *name = "?";
    YkState *fresh = yk_state_new(m.mech);
    assert_int_equal(yk_configurations_name(n.all, fresh, NULL, &name), YK_BAD_ARGUMENT); // no pose
    assert_string_equal(name, "");
    assert_int_equal(yk_configurations_name(n.all, other.state, NULL, &name), YK_BAD_ARGUMENT);
    assert_int_equal(yk_configurations_name(NULL, m.state, NULL, &name), YK_BAD_ARGUMENT);
    assert_int_equal(yk_configurations_name(n.all, m.state, NULL, NULL), YK_BAD_ARGUMENT);
    yk_configurations_each(n.all, m.state, NULL, ask_unprepared, &n, NULL);
    assert_int_equal(n.count, 1);
    yk_state_free(fresh);
    yk_configurations_free(n.all);
    machine_free(&other);
    machine_free(&m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_differ_at_a_pose),
        cmocka_unit_test(a_name_stays_while_the_machine_moves),
        cmocka_unit_test(dyads_have_their_labels),
        cmocka_unit_test(what_cannot_be_named_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

// Random machines in symbols: every section can be written, every equation holds at poses of the numeric engine, and
// the print reads back as the same. YOKE_TEST_RANDOM=3000 runs more of them; a failure prints its number.
#include <stdlib.h>
#include "dynamics/random_machine.h"
#include "forces_check.h"
#include "solve/state.h"

enum { MACHINES = 60, POSES = 3 };
static RandomMachine text; // large
static size_t too_large;   // machines

static uint64_t machine_count(void)
{
    const char *wish = getenv("YOKE_TEST_RANDOM");
    return wish ? strtoull(wish, NULL, 10) : MACHINES;
}

// False where the machine is refused (a parallelogram that is none any more), or dry friction decides on its motion.
static bool make_machine(Machine *m, uint64_t number)
{
    random_numbers = number % 2 ? RANDOM_NAMED : RANDOM_SHORT;
    random_machine(&text, 7919 * number + 1);
    *m = (Machine){.problems = yk_problems_new(), .seed = number};
    m->model = text.dry ? NULL : yk_model_parse(text.text, strlen(text.text), "random.yaml", NULL, m->problems);
    if (m->model && machine_finish(m)) return true;
    machine_end(m);
    return false;
}

// With its page; false too where that is refused, which is counted.
static bool make(Machine *m, uint64_t number)
{
    if (!make_machine(m, number)) return false;
    if (write_all_sections(m, number)) return true;
    too_large++;
    machine_end(m);
    return false;
}

// Away from dead points, where the engine's own numbers carry large rounding.
static bool pose(Machine *m, YkDynamics *dynamics, int k)
{
    yk_state_set_time(m->state, 0, NULL);
    if (yk_state_assemble(m->state) < 0) return false;
    for (size_t i = 0; i < yk_input_count(m->mech); i++) {
        YkMotion motion = yk_state_input(m->state, i);
        motion.position += check_uniform(&m->seed, -0.05, 0.05);
        motion.velocity = check_uniform(&m->seed, -1, 1);
        motion.acceleration = check_uniform(&m->seed, -1, 1);
        yk_state_set_input(m->state, i, motion);
    }
    if (yk_state_solve(m->state) < 0 || !yk_state_has_rates(m->state)) return false;
    if (!(m->state->space.margin[0] > 0.05)) return false;
    return take_forces(m, dynamics, k % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED);
}

static void check_equation(Machine *m, const YkLine *line, uint64_t number)
{
    const YkPoisson *zero = line_vanishes(m->d->ring, line);
    YkVec value = yk_ring_value(m->d->ring, zero, m->values);
    double size = hypot(value.x, value.y), allowed = 1e-11 * (off_machine(m, zero) + magnitude(m, zero));
    if (size <= allowed) return;
    YkText text = {0};
    yk_ring_write(m->d->ring, zero, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
    print_error("machine %d, %s: %.600s = %g, allowed %g\n", (int)number, line->section, yk_text_get(&text), size,
                allowed);
    yk_text_free(&text);
    fail();
}

static size_t check_equations(Machine *m, uint64_t number)
{
    size_t count = 0;
    for (const YkLine *line = m->page.first; line; line = line->next) {
        if (!line->left || (line->text && strcmp(line->text, "angle") == 0)) continue; // whole turns
        check_equation(m, line, number);
        count++;
    }
    return count;
}

static void every_equation_of_random_machines_holds(void **state)
{
    (void)state;
    size_t machines = 0, poses = 0, equations = 0, count = machine_count();
    for (uint64_t number = 0; number < count; number++) {
        Machine m;
        if (!make(&m, number)) continue;
        machines++;
        YkDynamics *dynamics = dynamics_of(&m);
        for (int k = 0; k < POSES; k++) {
            if (!pose(&m, dynamics, k)) continue;
            poses++;
            equations += check_equations(&m, number);
        }
        yk_dynamics_free(dynamics);
        machine_end(&m);
    }
    print_message("%d machines, %d poses, %d equations\n", (int)machines, (int)poses, (int)equations);
    assert_true(too_large <= count / 10);
    assert_true(machines > count / 2 && poses > count / 2 && equations > 50 * poses);
}

static void what_is_printed_of_random_machines_reads_back(void **state)
{
    (void)state;
    size_t elements = 0, count = machine_count() / 4;
    for (uint64_t number = 0; number < count; number++) {
        Machine m;
        if (!make(&m, number)) continue;
        elements += check_page_reads_back(&m);
        machine_end(&m);
    }
    assert_true(elements > 50 * count);
}

static bool is_lump(const Machine *m, const YkLine *line)
{
    const char *name = line->solved >= 0 ? yk_ring_symbol_name(m->d->ring, line->solved) : "";
    return name[0] == 'p' && name[1] >= '0' && name[1] <= '9';
}

// The lumped constants, a line each; freed by the caller.
static YkText lumps_of(Machine *m)
{
    YkText text = {0};
    YkPrinting printing = {.ring = m->d->ring, .text = &text};
    for (const YkLine *line = m->page.first; line; line = line->next) {
        if (line->kind != YK_LINE_FORMULA || !line->over || !is_lump(m, line)) continue;
        yk_print_formula_text(&printing, line, &text);
        yk_text_puts(&text, "\n");
    }
    assert_false(text.failed || printing.failed);
    return text;
}

static void lumps_have_the_same_names_whatever_is_asked_for(void **state)
{
    (void)state;
    size_t seen = 0, count = machine_count() / 4;
    for (uint64_t number = 0; number < count; number++) {
        Machine all, alone;
        if (!make(&all, number)) continue;
        assert_true(make_machine(&alone, number));
        write_section(&alone, "lagrange");
        YkText first = lumps_of(&all), second = lumps_of(&alone);
        assert_string_equal(yk_text_get(&first), yk_text_get(&second));
        seen += first.length > 0;
        yk_text_free(&first);
        yk_text_free(&second);
        machine_end(&all);
        machine_end(&alone);
    }
    assert_true(seen > count / 4);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_equation_of_random_machines_holds),
        cmocka_unit_test(what_is_printed_of_random_machines_reads_back),
        cmocka_unit_test(lumps_have_the_same_names_whatever_is_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}

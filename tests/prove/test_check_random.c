// Random machines: every equation on a page is read and found true, except those between vectors and those that need
// the words around them.
#include <ctype.h>
#include "dynamics/random_machine.h"
#include "derive/forces_check.h"

enum { MACHINES = 10 };
static RandomMachine text; // large

typedef struct Fed {
    Machine printed, checked; // the same machine, each with a derivation of its own
    YkDynamics *dynamics;
    YkState *start;
    uint64_t number;
    size_t kinds[YK_CHECK_UNREADABLE + 1];
} Fed;

static bool make(Machine *m)
{
    *m = (Machine){.problems = yk_problems_new(), .seed = 1};
    m->model = yk_model_parse(text.text, strlen(text.text), "random.yaml", NULL, m->problems);
    return m->model && machine_finish(m) && yk_state_assemble(m->state) >= 0;
}

// p^{A/B}, F_s1 = [...], v_rel, the work of the constraints, tan(alpha) of a cam: names that pages alone have.
static bool needs_context(const char *equation)
{
    static const char *const words[] = {"^{", "work of the", "tan(alpha)", "rho = ", "x = lift_v"};
    for (size_t k = 0; k < sizeof words / sizeof *words; k++)
        if (strstr(equation, words[k])) return true;
    for (const char *c = equation; *c; c++)
        if (c[1] == '_' && strchr("FMNTWSDRQev", *c) &&
            (c == equation || !(isalnum((unsigned char)c[-1]) || c[-1] == '_')))
            return true;
    return false;
}

static void feed(Fed *fed, const char *equation)
{
    Machine *m = &fed->checked;
    YkProblems *problems = yk_problems_new();
    yk_state_copy(m->state, fed->start);
    YkCheckVerdict verdict =
        yk_derive_check(m->d, m->state, fed->dynamics, equation, strlen(equation), (YkPlace){1, 1, 0}, problems);
    bool is_good =
        verdict.kind <= YK_CHECK_TRUE_DRIVEN || (verdict.kind == YK_CHECK_UNREADABLE && needs_context(equation));
    if (!is_good) {
        print_error("machine %d: verdict %d: %.400s\n", (int)fed->number, (int)verdict.kind, equation);
        fail();
    }
    fed->kinds[verdict.kind]++;
    yk_problems_free(problems);
}

static char *trimmed(char *text_of, char *end)
{
    while (*text_of == ' ') text_of++;
    while (end > text_of && end[-1] == ' ') end--;
    *end = '\0';
    return text_of;
}

// a = b = c: every two neighbours.
static void feed_line(Fed *fed, const YkLine *line)
{
    YkPrinting printing = {.ring = fed->printed.d->ring};
    YkText formula = {0};
    yk_print_formula_text(&printing, line, &formula);
    size_t length = formula.length;
    char *copy = calloc(length + 2, 1), *left = NULL;
    assert_non_null(copy);
    memcpy(copy, yk_text_get(&formula), length);
    for (char *side = copy; side;) {
        char *equals = strchr(side, '='), *next = equals ? equals + 1 : NULL;
        char *right = trimmed(side, equals ? equals : side + strlen(side));
        YkText equation = {0};
        yk_text_format(&equation, "%s = %s", left ? left : "", right);
        if (left) feed(fed, yk_text_get(&equation));
        yk_text_free(&equation);
        left = right, side = next;
    }
    free(copy);
    yk_text_free(&formula);
}

static bool has_matrix(const YkLine *line)
{
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next)
        if (piece->matrix) return true;
    return false;
}

static bool feed_all(Fed *fed)
{
    Machine *m = &fed->printed;
    if (!write_all_sections(m, fed->number)) return false;
    for (const YkLine *line = m->page.first; line; line = line->next)
        if (line->kind == YK_LINE_FORMULA && !has_matrix(line)) feed_line(fed, line);
    return true;
}

static void what_is_printed_of_random_machines_is_true(void **state)
{
    (void)state;
    size_t machines = 0, kinds[YK_CHECK_UNREADABLE + 1] = {0};
    for (uint64_t n = 0; machines < MACHINES; n++) {
        assert_true(n < 5 * MACHINES);
        Fed fed = {.number = n};
        random_numbers = n % 2 ? RANDOM_NAMED : RANDOM_SHORT;
        random_machine(&text, 7919 * n + 1);
        if (text.dry) continue; // friction that sticks decides on the motion
        if (make(&fed.printed) && make(&fed.checked)) {
            fed.dynamics = dynamics_of(&fed.checked);
            fed.start = yk_state_new(fed.checked.mech);
            yk_state_copy(fed.start, fed.checked.state);
            machines += feed_all(&fed);
        }
        for (size_t k = 0; k <= YK_CHECK_UNREADABLE; k++) kinds[k] += fed.kinds[k];
        yk_dynamics_free(fed.dynamics);
        yk_state_free(fed.start);
        machine_end(&fed.printed);
        machine_end(&fed.checked);
    }
    assert_true(kinds[YK_CHECK_TRUE] > 400);
    assert_true(kinds[YK_CHECK_UNREADABLE] < kinds[YK_CHECK_TRUE]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(what_is_printed_of_random_machines_is_true)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}

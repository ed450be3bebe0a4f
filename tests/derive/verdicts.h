// What the tests of --check share: the verdict on an equation at the machine's start, with forces, and lists of
// equations with the verdicts that they must get.
#ifndef TESTS_DERIVE_VERDICTS_H
#define TESTS_DERIVE_VERDICTS_H
#include "derive_check.h"

typedef struct Expected {
    const char *equation;
    YkCheckKind kind;
} Expected;

static inline YkCheckVerdict forces_verdict(Machine *m, YkDynamics *dynamics, const char *equation)
{
    yk_state_set_time(m->state, 0, NULL);
    assert_true(yk_state_assemble(m->state) >= 0);
    return yk_derive_check(m->d, m->state, dynamics, equation, strlen(equation), (YkPlace){1, 1, 0}, m->problems);
}

static inline void check_kind(Machine *m, YkDynamics *dynamics, const char *equation, YkCheckKind expected)
{
    YkCheckVerdict verdict = forces_verdict(m, dynamics, equation);
    if (verdict.kind == expected) return;
    print_error("%s: verdict %d, expected %d\n%s", equation, (int)verdict.kind, (int)expected,
                yk_problems_text(m->problems, 0));
    fail();
}

static inline void check_kinds(Machine *m, const Expected *expected, size_t count)
{
    YkDynamics *dynamics = yk_dynamics_new(m->mech, m->problems);
    assert_non_null(dynamics);
    YkDynamics *asked = yk_dynamics_has_loads(dynamics) ? dynamics : NULL;
    for (size_t k = 0; k < count; k++) check_kind(m, asked, expected[k].equation, expected[k].kind);
    yk_dynamics_free(dynamics);
}
// CHECK_KINDS(&machine, IS("..."), IS_NOT("..."), ...)
#define CHECK_KINDS(m, ...)                                                                                            \
    check_kinds(m, (const Expected[]){__VA_ARGS__}, sizeof((const Expected[]){__VA_ARGS__}) / sizeof(Expected))
#define IS(equation)                                                                                                   \
    {                                                                                                                  \
        equation, YK_CHECK_TRUE                                                                                        \
    }
#define IS_HERE(equation)                                                                                              \
    {                                                                                                                  \
        equation, YK_CHECK_TRUE_HERE                                                                                   \
    }
#define IS_DRIVEN(equation)                                                                                            \
    {                                                                                                                  \
        equation, YK_CHECK_TRUE_DRIVEN                                                                                 \
    }
#define IS_NOT(equation)                                                                                               \
    {                                                                                                                  \
        equation, YK_CHECK_FALSE                                                                                       \
    }
#define CANNOT(equation)                                                                                               \
    {                                                                                                                  \
        equation, YK_CHECK_UNREADABLE                                                                                  \
    }

#endif

// Shared by the tests of --check: the verdict on an equation at the machine's start, with forces, and lists of
// equations with the verdicts that they must get.
#ifndef TESTS_DERIVE_VERDICTS_H
#define TESTS_DERIVE_VERDICTS_H
#include "derive/derive_check.h"

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

// A tappet with a roller beside the cam's axis: a cycloidal rise, a dwell, back by a polynomial.
#define ROLLER_CAM                                                                                                     \
    "laws:\n"                                                                                                          \
    "  lift:\n"                                                                                                        \
    "    period: 2*pi\n"                                                                                               \
    "    segments:\n"                                                                                                  \
    "      - {rise: {to: 120 deg, by: 20 mm, law: cycloidal}}\n"                                                       \
    "      - {dwell: {to: 180 deg}}\n"                                                                                 \
    "      - {polynomial: [{at: pi, s: 20 mm, v: 0, a: 0}, {at: 2*pi, s: 0, v: 0, a: 0}]}\n"                           \
    "cams:\n"                                                                                                          \
    "  cc: {cam: shaft, follower: tappet, law: lift, roller: 10 mm, base: 60 mm, offset: 5 mm}\n"                      \
    "bodies: {shaft: {inertia: 0.01}, tappet: {mass: 0.2 kg}}\n"                                                       \
    "gravity: [0, -9.81]\n"                                                                                            \
    "joints:\n"                                                                                                        \
    "  K: {pin: [ground, shaft], angle: theta}\n"                                                                      \
    "  T: {slide: [ground, tappet], along: y, distance: s}\n"                                                          \
    "springs: {sp: {along: s, stiffness: 800 N/m, length: -10 mm}}\n"                                                  \
    "drives: {theta: 10 rad/s * t}\n"

#endif

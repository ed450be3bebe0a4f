// Long machines as text, for cost: a ladder of four-bars, each driving the next, and an open chain with a drive at
// every joint.
#ifndef TESTS_COMPILE_LADDER_H
#define TESTS_COMPILE_LADDER_H
#include <stdarg.h>
#include <stdlib.h>
#include "check.h"

typedef struct Story {
    char *text;
    size_t length, room;
} Story;

static inline Story story_new(size_t room)
{
    Story s = {malloc(room), 0, room};
    assert_non_null(s.text);
    return s;
}
static inline void tell(Story *s, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(s->text + s->length, s->room - s->length, format, arguments);
    va_end(arguments);
    assert_true(n >= 0 && s->length + (size_t)n < s->room);
    s->length += (size_t)n;
}

// Parallelograms in a row: the right crank of one is the left crank of the next. 2 count + 1 bodies move.
static inline Story ladder(size_t count)
{
    Story s = story_new(count * 420 + 1000);
    tell(&s, "bodies:\n  ground: {points: {O0: [0, 0]");
    for (size_t k = 1; k <= count; k++) tell(&s, ", O%zu: [%zu, 0]", k, 2 * k);
    tell(&s, "}}\n");
    for (size_t k = 0; k <= count; k++)
        tell(&s, "  c%zu: {points: {O%zu: [0, 0], A%zu: [1, 0], B%zu: [1, 0]}}\n", k, k, k, k + 1);
    for (size_t k = 1; k <= count; k++) tell(&s, "  r%zu: {points: {B%zu: [0, 0], A%zu: [2, 0]}}\n", k, k, k);
    tell(&s, "joints:\n  O0: {pin: [ground, c0], angle: t0}\n");
    for (size_t k = 1; k <= count; k++)
        tell(&s,
             "  O%zu: {pin: [ground, c%zu], angle: t%zu}\n  B%zu: {pin: [c%zu, r%zu], angle: p%zu}\n  A%zu: {pin: "
             "[r%zu, c%zu]}\n",
             k, k, k, k, k - 1, k, k, k, k, k);
    tell(&s, "drives: {t0: 60 deg}\n");
    return s;
}

static inline Story chain(size_t count)
{
    Story s = story_new(count * 160 + 1000);
    tell(&s, "bodies:\n  ground: {points: {J0: [0, 0]}}\n");
    for (size_t k = 0; k < count; k++) tell(&s, "  b%zu: {points: {J%zu: [0, 0], J%zu: [1, 0]}}\n", k, k, k + 1);
    tell(&s, "joints:\n  J0: {pin: [ground, b0], angle: a0}\n");
    for (size_t k = 1; k < count; k++) tell(&s, "  J%zu: {pin: [b%zu, b%zu], angle: a%zu}\n", k, k - 1, k, k);
    tell(&s, "drives: {");
    for (size_t k = 0; k < count; k++) tell(&s, "%sa%zu: 0.1", k ? ", " : "", k);
    tell(&s, "}\n");
    return s;
}

#endif

// Runs one lane of a tape: one jump for each group of operations of a kind.
#include <math.h>
#include "graph/tape_one.h"

// One group of operations.
#define EACH(expression)                                                                                               \
    do {                                                                                                               \
        *s->out = (expression);                                                                                        \
    } while (++s < end);                                                                                               \
    break

static const YkTapeStep *run_rare(const YkTape *t, const YkTapeStep *rare, size_t count)
{
    for (size_t k = 0; k < count; k++) yk_tape_run_rare(t, t->one->calls, t->one->at, rare + k, 0);
    return rare + count;
}

static void run_groups(const YkTape *t)
{
    const YkTapeOne *one = t->one;
    const YkTapeOperation *s = one->operations;
    const YkTapeStep *rare = one->rare;
    for (const YkTapeGroup *g = one->groups, *last = g + one->group_count; g < last; g++) {
        const YkTapeOperation *end = g->end;
        switch (g->op) {
        case YK_TAPE_ADD:
            EACH(*s->a + *s->b);
        case YK_TAPE_SUBTRACT:
            EACH(*s->a - *s->b);
        case YK_TAPE_MULTIPLY:
            EACH(*s->a * *s->b);
        case YK_TAPE_DIVIDE:
            EACH(*s->a / *s->b);
        case YK_TAPE_MINUS:
            EACH(-*s->a);
        case YK_TAPE_PRODUCT_PLUS:
            EACH(*s->a * *s->b + *s->c);
        case YK_TAPE_PRODUCT_LESS:
            EACH(*s->a * *s->b - *s->c);
        case YK_TAPE_LESS_PRODUCT:
            EACH(*s->c - *s->a * *s->b);
        case YK_TAPE_DOT:
            EACH(*s->a * *s->b + *s->c * *s->d);
        case YK_TAPE_CROSS:
            EACH(*s->a * *s->b - *s->c * *s->d);
        case YK_TAPE_PLUS_DOT:
            EACH(*s->e + (*s->a * *s->b + *s->c * *s->d));
        case YK_TAPE_LESS_DOT:
            EACH(*s->e - (*s->a * *s->b + *s->c * *s->d));
        case YK_TAPE_DOT_LESS:
            EACH((*s->a * *s->b + *s->c * *s->d) - *s->e);
        case YK_TAPE_PLUS_CROSS:
            EACH(*s->e + (*s->a * *s->b - *s->c * *s->d));
        case YK_TAPE_LESS_CROSS:
            EACH(*s->e - (*s->a * *s->b - *s->c * *s->d));
        case YK_TAPE_CROSS_LESS:
            EACH((*s->a * *s->b - *s->c * *s->d) - *s->e);
        case YK_TAPE_PLUS_PLUS:
            EACH((*s->e + *s->a * *s->b) + *s->c * *s->d);
        case YK_TAPE_PLUS_LESS:
            EACH((*s->e + *s->a * *s->b) - *s->c * *s->d);
        case YK_TAPE_LESS_PLUS:
            EACH((*s->e - *s->a * *s->b) + *s->c * *s->d);
        case YK_TAPE_LESS_LESS:
            EACH((*s->e - *s->a * *s->b) - *s->c * *s->d);
        case YK_TAPE_ROOT:
            EACH(sqrt(*s->a));
        case YK_TAPE_SIZE:
            EACH(fabs(*s->a));
        case YK_TAPE_NONZERO:
            EACH(fabs(*s->a) + 1e-200);
        case YK_TAPE_CHOOSE:
            EACH(*s->a < 0 ? *s->b : *s->c);
        case YK_TAPE_COPY:
            EACH(*s->a);
        case YK_TAPE_RARE:
            rare = run_rare(t, rare, (size_t)(end - s));
            s = end;
            break;
        }
    }
}

const double *const *yk_tape_run_one(YkTape *t, const double *pose)
{
    if (pose != t->one->pose) yk_tape_read_pose(t, pose);
    run_groups(t);
    return t->one->result;
}

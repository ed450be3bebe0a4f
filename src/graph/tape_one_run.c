// Runs one lane of a tape: one jump for all operations of a kind that follow each other.
#include <math.h>
#include "graph/tape_one.h"

// Operations of one kind that follow each other.
#define EACH(kind, expression)                                                                                         \
    case YK_TAPE_##kind:                                                                                               \
        do {                                                                                                           \
            s->out = (expression);                                                                                     \
        } while ((s++)->has_like);                                                                                     \
        break;

static void run_operations(const YkTape *t)
{
    YkTapeOperation *s = t->one->operations;
    const YkTapeStep *rare = t->one->rare;
    for (;;) {
        switch (s->op) {
            EACH(ADD, *s->a + *s->b)
            EACH(SUBTRACT, *s->a - *s->b)
            EACH(MULTIPLY, *s->a * *s->b)
            EACH(DIVIDE, *s->a / *s->b)
            EACH(MINUS, -*s->a)
            EACH(PRODUCT_PLUS, *s->a * *s->b + *s->c)
            EACH(PRODUCT_LESS, *s->a * *s->b - *s->c)
            EACH(LESS_PRODUCT, *s->c - *s->a * *s->b)
            EACH(DOT, *s->a * *s->b + *s->c * *s->d)
            EACH(CROSS, *s->a * *s->b - *s->c * *s->d)
            EACH(PLUS_DOT, *s->e + (*s->a * *s->b + *s->c * *s->d))
            EACH(LESS_DOT, *s->e - (*s->a * *s->b + *s->c * *s->d))
            EACH(DOT_LESS, (*s->a * *s->b + *s->c * *s->d) - *s->e)
            EACH(PLUS_CROSS, *s->e + (*s->a * *s->b - *s->c * *s->d))
            EACH(LESS_CROSS, *s->e - (*s->a * *s->b - *s->c * *s->d))
            EACH(CROSS_LESS, (*s->a * *s->b - *s->c * *s->d) - *s->e)
            EACH(PLUS_PLUS, (*s->e + *s->a * *s->b) + *s->c * *s->d)
            EACH(PLUS_LESS, (*s->e + *s->a * *s->b) - *s->c * *s->d)
            EACH(LESS_PLUS, (*s->e - *s->a * *s->b) + *s->c * *s->d)
            EACH(LESS_LESS, (*s->e - *s->a * *s->b) - *s->c * *s->d)
            EACH(ROOT, sqrt(*s->a))
            EACH(SIZE, fabs(*s->a))
            EACH(NONZERO, fabs(*s->a) + 1e-200)
            EACH(CHOOSE, *s->a < 0 ? *s->b : *s->c)
        case YK_TAPE_RARE:
            yk_tape_run_rare(t, t->one->calls, t->one->at, rare++, 0);
            s++;
            break;
        case YK_TAPE_SPIN: // see place_step
        case YK_TAPE_COPY:
        case YK_TAPE_END:
            return;
        }
    }
}

const double *const *yk_tape_run_one(YkTape *t, const double *pose)
{
    if (pose != t->one->pose) yk_tape_read_pose(t, pose);
    run_operations(t);
    return t->one->result;
}

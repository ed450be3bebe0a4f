// Runs a tape: each operation over all lanes before the next one.
#include <float.h>
#include <math.h>
#include "base/vec.h"
#include "elementary/elementary.h"
#include "elementary/kernel.h"
#include "graph/tape_steps.h"

enum { ROUND = 4 * 8 }; // lanes in one turn of an unrolled loop, in the widest registers

// One operation over lanes. The row of the result is none of the operands'.
#define EACH(expression)                                                                                               \
    {                                                                                                                  \
        YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++) out[i] = (expression);                                   \
        break;                                                                                                         \
    }

// The same with operands x, y that are lanes or, where `scalars` has their bit, one number.
#define KERNEL(op, scalars) 4 * YK_TAPE_##op + (scalars)
#define OF_ONE(op, x)                                                                                                  \
    case KERNEL(op, 0):                                                                                                \
        EACH(op(x[i]))                                                                                                 \
    case KERNEL(op, 1): {                                                                                              \
        const double one = *x;                                                                                         \
        EACH(op(one))                                                                                                  \
    }
#define OF_TWO(op, x, y)                                                                                               \
    OF_ONE_OF_TWO(op, x, y)                                                                                            \
    case KERNEL(op, 3): {                                                                                              \
        const double one = *x, other = *y;                                                                             \
        EACH(op(one, other))                                                                                           \
    }
#define OF_ONE_OF_TWO(op, x, y)                                                                                        \
    case KERNEL(op, 0):                                                                                                \
        EACH(op(x[i], y[i]))                                                                                           \
    case KERNEL(op, 1): {                                                                                              \
        const double one = *x;                                                                                         \
        EACH(op(one, y[i]))                                                                                            \
    }                                                                                                                  \
    case KERNEL(op, 2): {                                                                                              \
        const double other = *y;                                                                                       \
        EACH(op(x[i], other))                                                                                          \
    }

#define ADD(a, b) (a) + (b)
#define SUBTRACT(a, b) (a) - (b)
#define DIVIDE(a, b) (a) / (b)
#define PRODUCT_PLUS(b, c) a[i] * (b) + (c)
#define PRODUCT_LESS(b, c) a[i] * (b) - (c)
#define LESS_PRODUCT(b, c) (c) - a[i] * (b)
#define DOT(b, d) a[i] * (b) + c[i] * (d)
#define CROSS(b, d) a[i] * (b)-c[i] * (d)
#define PLUS_DOT(b, d) e[i] + (a[i] * (b) + c[i] * (d))
#define LESS_DOT(b, d) e[i] - (a[i] * (b) + c[i] * (d))
#define DOT_LESS(b, d) (a[i] * (b) + c[i] * (d)) - e[i]
#define PLUS_CROSS(b, d) e[i] + (a[i] * (b)-c[i] * (d))
#define LESS_CROSS(b, d) e[i] - (a[i] * (b)-c[i] * (d))
#define CROSS_LESS(b, d) (a[i] * (b)-c[i] * (d)) - e[i]
#define PLUS_PLUS(b, d) (e[i] + a[i] * (b)) + c[i] * (d)
#define PLUS_LESS(b, d) (e[i] + a[i] * (b)) - c[i] * (d)
#define LESS_PLUS(b, d) (e[i] - a[i] * (b)) + c[i] * (d)
#define LESS_LESS(b, d) (e[i] - a[i] * (b)) - c[i] * (d)
#define MULTIPLY(b) a[i] * (b)
#define COPY(a) (a)

YK_INLINE void run_over(const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n)
{
    double *const *row = tape->row;
    for (const YkTapeStep *s = steps; s < steps + count; s++) {
        double *out = row[s->out];
        const double *a = row[s->in[0]], *b = row[s->in[1]], *c = row[s->in[2]], *d = row[s->in[3]], *e = row[s->in[4]];
        switch (4 * (int)s->op + s->scalars) {
            OF_ONE(MULTIPLY, b)
            OF_ONE(COPY, a)
            OF_ONE_OF_TWO(ADD, a, b)
            OF_ONE_OF_TWO(SUBTRACT, a, b)
            OF_ONE_OF_TWO(DIVIDE, a, b)
            OF_TWO(PRODUCT_PLUS, b, c)
            OF_TWO(PRODUCT_LESS, b, c)
            OF_TWO(LESS_PRODUCT, b, c)
            OF_TWO(DOT, b, d)
            OF_TWO(CROSS, b, d)
            OF_TWO(PLUS_DOT, b, d)
            OF_TWO(LESS_DOT, b, d)
            OF_TWO(DOT_LESS, b, d)
            OF_TWO(PLUS_CROSS, b, d)
            OF_TWO(LESS_CROSS, b, d)
            OF_TWO(CROSS_LESS, b, d)
            OF_TWO(PLUS_PLUS, b, d)
            OF_TWO(PLUS_LESS, b, d)
            OF_TWO(LESS_PLUS, b, d)
            OF_TWO(LESS_LESS, b, d)
        case KERNEL(SPIN, 0):
            if (YK_KNOWS_BLOCKS) { // otherwise there is none
                double *across = row[s->second];
                YK_EACH_LANE YK_UNROLL for (size_t i = 0; i < n; i++)
                {
                    double x = a[i], y = b[i], square = c[i] * c[i], change = d[i];
                    out[i] = x * square + y * change;
                    across[i] = x * change - y * square;
                }
            }
            break;
        case KERNEL(MINUS, 0):
            EACH(-a[i])
        case KERNEL(ROOT, 0):
            EACH(sqrt(a[i]))
        case KERNEL(SIZE, 0):
            EACH(fabs(a[i]))
        case KERNEL(NONZERO, 0):
            EACH(fabs(a[i]) + 1e-200)
        case KERNEL(CHOOSE, 0):
            EACH(a[i] < 0 ? b[i] : c[i])
        case KERNEL(RARE, 0):
            for (size_t i = 0; i < n; i++) yk_tape_run_rare(tape, tape->calls, row, s, i);
            break;
        }
    }
}

// The compiler sees that whole turns leave no rest.
YK_INLINE void yk_tape_run_steps_body(const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n)
{
    if (YK_KNOWS_BLOCKS && n % ROUND == 0)
        run_over(tape, steps, count, n / ROUND * ROUND);
    else
        run_over(tape, steps, count, n);
}

YK_KERNEL(yk_tape_run_steps, (const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n),
          (tape, steps, count))

// --- what is rare

static double value_of(const YkTapeStep *s, double a, double b)
{
    switch (s->kind) {
    case YK_VALUE_POWER:
        return yk_pow(a, b);
    case YK_VALUE_SINE:
        return yk_sin(a);
    case YK_VALUE_COSINE:
        return yk_cos(a);
    case YK_VALUE_ANGLE:
        return yk_atan2(a, b);
    case YK_VALUE_NEAREST:
        return yk_nearest_turn(a, b);
    case YK_VALUE_ROOT:
        return sqrt(a > 0 ? a : 0);
    case YK_VALUE_PER_ROOT:
        return 1 / sqrt(a < 1e-36 ? 1e-36 : a);
    case YK_VALUE_LEAST:
        return a < b ? a : b;
    case YK_VALUE_LARGEST:
        return b < a ? a : b;
    case YK_VALUE_WITNESS:
        return 0 * a;
    default:
        return yk_function_value(s->function, a, b);
    }
}

static void swap_rows(double *a, size_t width, size_t i, size_t k)
{
    for (size_t j = 0; i != k && j < width; j++) {
        double one = a[i * width + j];
        a[i * width + j] = a[k * width + j];
        a[k * width + j] = one;
    }
}

// Divides a row by about its largest coefficient, by a power of two so that nothing is rounded.
static void scale_row(double *row, size_t n, size_t width)
{
    double most = 0;
    int exponent;
    for (size_t k = 0; k < n; k++) most = fmax(most, fabs(row[k]));
    if (!(most > 0 && most <= DBL_MAX)) return;
    frexp(most, &exponent);
    for (size_t k = 0; k < width; k++) row[k] = ldexp(row[k], -exponent);
}

// Solves a[n][n + m] in place by elimination with partial pivoting on scaled rows: the right sides become the
// solutions. They are not finite if the matrix is singular.
static void solve(double *a, size_t n, size_t m)
{
    size_t width = n + m;
    for (size_t i = 0; i < n; i++) scale_row(a + i * width, n, width);
    for (size_t j = 0; j < n; j++) {
        size_t pivot = j;
        for (size_t i = j + 1; i < n; i++)
            if (fabs(a[i * width + j]) > fabs(a[pivot * width + j])) pivot = i;
        swap_rows(a, width, j, pivot);
        for (size_t i = 0; i < n; i++) {
            double factor = a[i * width + j] / a[j * width + j];
            for (size_t k = j + 1; i != j && k < width; k++) a[i * width + k] -= factor * a[j * width + k];
        }
    }
    for (size_t i = 0; i < n; i++)
        for (size_t k = n; k < width; k++) a[i * width + k] /= a[i * width + i];
}

static void run_call(const YkTape *tape, const YkTapeCall *call, double *const *row, size_t lane)
{
    double *value = tape->scratch;
    for (size_t k = 0; k < call->argument_count; k++) value[k] = row[call->arguments[k]][lane];
    if (call->kind == YK_CALL_SOLVE)
        solve(value, (size_t)call->n, (size_t)call->m);
    else
        tape->laws.evaluate(tape->laws.context, call->index, value[0], value);
    for (size_t k = 0; k < call->result_count; k++)
        if (call->results[k] != YK_NONE) row[call->results[k]][lane] = value[k];
}

void yk_tape_run_rare(const YkTape *tape, const YkTapeCall *calls, double *const *row, const YkTapeStep *s, size_t lane)
{
    if (s->call != YK_NONE)
        run_call(tape, &calls[s->call], row, lane);
    else
        row[s->out][lane] = value_of(s, row[s->in[0]][lane], row[s->in[1]][lane]);
}

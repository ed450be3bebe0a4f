// Runs a tape: each operation over all lanes before the next one.
#include <float.h>
#include <math.h>
#include "base/vec.h"
#include "elementary/elementary.h"
#include "elementary/kernel.h"
#include "graph/tape_steps.h"

// One operation over lanes. The row of the result is none of the operands'.
#define EACH(expression)                                                                                               \
    YK_EACH_LANE                                                                                                       \
    for (size_t i = 0; i < n; i++) out[i] = (expression);                                                              \
    break

YK_INLINE void run_over(const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n)
{
    double *const *row = tape->row;
    for (const YkTapeStep *s = steps; s < steps + count; s++) {
        double *out = row[s->out];
        const double *a = row[s->in[0]], *b = row[s->in[1]], *c = row[s->in[2]], *d = row[s->in[3]], *e = row[s->in[4]];
        switch (s->op) {
        case YK_TAPE_ADD:
            EACH(a[i] + b[i]);
        case YK_TAPE_SUBTRACT:
            EACH(a[i] - b[i]);
        case YK_TAPE_MULTIPLY:
            EACH(a[i] * b[i]);
        case YK_TAPE_DIVIDE:
            EACH(a[i] / b[i]);
        case YK_TAPE_MINUS:
            EACH(-a[i]);
        case YK_TAPE_PRODUCT_PLUS:
            EACH(a[i] * b[i] + c[i]);
        case YK_TAPE_PRODUCT_LESS:
            EACH(a[i] * b[i] - c[i]);
        case YK_TAPE_LESS_PRODUCT:
            EACH(c[i] - a[i] * b[i]);
        case YK_TAPE_DOT:
            EACH(a[i] * b[i] + c[i] * d[i]);
        case YK_TAPE_CROSS:
            EACH(a[i] * b[i] - c[i] * d[i]);
        case YK_TAPE_PLUS_DOT:
            EACH(e[i] + (a[i] * b[i] + c[i] * d[i]));
        case YK_TAPE_LESS_DOT:
            EACH(e[i] - (a[i] * b[i] + c[i] * d[i]));
        case YK_TAPE_DOT_LESS:
            EACH((a[i] * b[i] + c[i] * d[i]) - e[i]);
        case YK_TAPE_PLUS_CROSS:
            EACH(e[i] + (a[i] * b[i] - c[i] * d[i]));
        case YK_TAPE_LESS_CROSS:
            EACH(e[i] - (a[i] * b[i] - c[i] * d[i]));
        case YK_TAPE_CROSS_LESS:
            EACH((a[i] * b[i] - c[i] * d[i]) - e[i]);
        case YK_TAPE_PLUS_PLUS:
            EACH((e[i] + a[i] * b[i]) + c[i] * d[i]);
        case YK_TAPE_PLUS_LESS:
            EACH((e[i] + a[i] * b[i]) - c[i] * d[i]);
        case YK_TAPE_LESS_PLUS:
            EACH((e[i] - a[i] * b[i]) + c[i] * d[i]);
        case YK_TAPE_LESS_LESS:
            EACH((e[i] - a[i] * b[i]) - c[i] * d[i]);
        case YK_TAPE_ROOT:
            EACH(sqrt(a[i]));
        case YK_TAPE_SIZE:
            EACH(fabs(a[i]));
        case YK_TAPE_NONZERO:
            EACH(fabs(a[i]) + 1e-200);
        case YK_TAPE_CHOOSE:
            EACH(a[i] < 0 ? b[i] : c[i]);
        case YK_TAPE_COPY:
            EACH(a[i]);
        case YK_TAPE_RARE:
            for (size_t i = 0; i < n; i++) yk_tape_run_rare(tape, tape->calls, row, s, i);
            break;
        }
    }
}

// Whole blocks have loops of a length that the compiler knows.
YK_INLINE void yk_tape_run_steps_body(const YkTape *tape, const YkTapeStep *steps, size_t count, size_t n)
{
    if (n == YK_TAPE_BLOCK)
        run_over(tape, steps, count, YK_TAPE_BLOCK);
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

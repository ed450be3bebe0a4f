// Eigenvalues of general matrices: balancing, reduction to Hessenberg form, Francis' double-shift QR iteration.
#include <float.h>
#include <math.h>
#include "num/eigen.h"

enum { MOST_ITERATIONS = 60 }; // for one eigenvalue

// ---- balancing: rows and columns of similar length, by powers of two, which round nothing ----

static bool balance_one(size_t n, double *A, size_t i)
{
    double row = 0, column = 0, factor = 1;
    for (size_t j = 0; j < n; j++)
        if (j != i) {
            row += fabs(A[i * n + j]);
            column += fabs(A[j * n + i]);
        }
    if (row == 0 || column == 0) return false;
    double before = row + column;
    for (; column < row / 2 && factor < 0x1p400; column *= 2, row /= 2) factor *= 2;
    for (; column >= row * 2 && factor > 0x1p-400; column /= 2, row *= 2) factor /= 2;
    if (row + column >= 0.95 * before) return false;
    for (size_t j = 0; j < n; j++) A[i * n + j] /= factor;
    for (size_t j = 0; j < n; j++) A[j * n + i] *= factor;
    return true;
}

static void balance(size_t n, double *A)
{
    bool changed = true;
    for (int round = 0; changed && round < 100; round++) {
        changed = false;
        for (size_t i = 0; i < n; i++) changed |= balance_one(n, A, i);
    }
}

// ---- reflections H = I - beta v v^T with v[0] = 1 ----

// Finds the reflection that takes x[count] to a multiple of the first axis. x becomes v; returns beta, and the multiple
// in *length.
static double reflection(size_t count, double *x, size_t stride, double *length)
{
    double sum = 0, scale = 0, first = x[0];
    for (size_t i = 0; i < count; i++) scale = fmax(scale, fabs(x[i * stride]));
    *length = first;
    if (scale == 0) return 0;
    for (size_t i = 0; i < count; i++) sum += x[i * stride] / scale * (x[i * stride] / scale);
    double norm = scale * sqrt(sum);
    *length = first > 0 ? -norm : norm;
    double head = first - *length;
    for (size_t i = 1; i < count; i++) x[i * stride] /= head;
    x[0] = 1;
    return -head / *length;
}

// Reflects rows `row` .. + count of the columns from .. to.
static void reflect_rows(size_t n, double *A, size_t row, size_t count, const double *v, size_t stride, double beta,
                         size_t from, size_t to)
{
    for (size_t j = from; j < to; j++) {
        double sum = 0;
        for (size_t i = 0; i < count; i++) sum += v[i * stride] * A[(row + i) * n + j];
        sum *= beta;
        for (size_t i = 0; i < count; i++) A[(row + i) * n + j] -= sum * v[i * stride];
    }
}

static void reflect_columns(size_t n, double *A, size_t column, size_t count, const double *v, size_t stride,
                            double beta, size_t from, size_t to)
{
    for (size_t i = from; i < to; i++) {
        double sum = 0, *row = A + i * n + column;
        for (size_t j = 0; j < count; j++) sum += v[j * stride] * row[j];
        sum *= beta;
        for (size_t j = 0; j < count; j++) row[j] -= sum * v[j * stride];
    }
}

// Reduces to Hessenberg form: zeros below the first subdiagonal. Meanwhile the reflection of column k is stored below
// its subdiagonal.
static void reduce(size_t n, double *A)
{
    for (size_t k = 0; k + 2 < n; k++) {
        double *v = A + (k + 1) * n + k, length;
        double beta = reflection(n - k - 1, v, n, &length);
        if (beta != 0) {
            reflect_rows(n, A, k + 1, n - k - 1, v, n, beta, k + 1, n);
            reflect_columns(n, A, k + 1, n - k - 1, v, n, beta, 0, n);
        }
        v[0] = length;
        for (size_t i = k + 2; i < n; i++) A[i * n + k] = 0;
    }
}

// ---- Francis' iteration on the active block low .. high ----

typedef struct Shifts {
    double sum, product;
} Shifts;

// Returns the eigenvalues of the last 2 x 2 block; now and then other shifts, in case the iteration cycles.
static Shifts choose_shifts(size_t n, const double *H, size_t high, int iteration)
{
    const double *a = H + (high - 1) * n + high - 1, *b = a + n;
    if (iteration % 10 == 9) {
        double size = fabs(b[0]) + (high >= 2 ? fabs(a[-1]) : 0);
        return (Shifts){1.5 * size, size * size};
    }
    return (Shifts){a[0] + b[1], a[0] * b[1] - a[1] * b[0]};
}

static void chase(size_t n, double *H, size_t low, size_t high, Shifts shifts)
{
    const double *a = H + low * n + low, *b = a + n;
    double x[3] = {a[0] * (a[0] - shifts.sum) + a[1] * b[0] + shifts.product, b[0] * (a[0] + b[1] - shifts.sum), 0};
    if (low + 2 <= high) x[2] = b[0] * b[n + 1];
    for (size_t k = low; k < high; k++) {
        size_t count = k + 2 <= high ? 3 : 2;
        if (k > low)
            for (size_t i = 0; i < count; i++) x[i] = H[(k + i) * n + k - 1];
        double length, beta = reflection(count, x, 1, &length);
        if (k > low) {
            H[k * n + k - 1] = length;
            for (size_t i = 1; i < count; i++) H[(k + i) * n + k - 1] = 0;
        }
        if (beta == 0) continue;
        reflect_rows(n, H, k, count, x, 1, beta, k, high + 1);
        reflect_columns(n, H, k, count, x, 1, beta, low, k + 4 <= high ? k + 4 : high + 1);
    }
}

// Returns where the active block that ends at `high` begins: below the last subdiagonal entry that is negligible next
// to its neighbours.
static size_t find_low(size_t n, double *H, size_t high, double norm)
{
    size_t low = high;
    for (; low > 0; low--) {
        double *under = H + low * n + low - 1, size = fabs(under[1]) + fabs(under[-(ptrdiff_t)n]);
        if (fabs(*under) <= DBL_EPSILON * (size > 0 ? size : norm)) {
            *under = 0;
            break;
        }
    }
    return low;
}

static void solve_two(const double *a, const double *b, double *real, double *imaginary)
{
    double p = (a[0] - b[1]) / 2, scale = fmax(fabs(p), fmax(fabs(a[1]), fabs(b[0])));
    double inside = scale > 0 ? (p / scale) * (p / scale) + (a[1] / scale) * (b[0] / scale) : 0;
    double root = scale * sqrt(fabs(inside));
    if (inside >= 0) { // the larger one by addition, the other by the product
        double z = p + (p >= 0 ? root : -root);
        real[0] = b[1] + z;
        real[1] = z != 0 ? b[1] - a[1] / z * b[0] : b[1];
        imaginary[0] = imaginary[1] = 0;
    } else {
        real[0] = real[1] = b[1] + p;
        imaginary[0] = root;
        imaginary[1] = -root;
    }
}

static bool comes_before(const double *real, const double *imaginary, size_t a, size_t b)
{
    if (real[a] != real[b]) return real[a] < real[b];
    if (fabs(imaginary[a]) != fabs(imaginary[b])) return fabs(imaginary[a]) < fabs(imaginary[b]);
    return imaginary[a] > imaginary[b];
}

static void sort_values(size_t n, double *real, double *imaginary)
{
    for (size_t k = 1; k < n; k++)
        for (size_t i = k; i > 0 && comes_before(real, imaginary, i, i - 1); i--) {
            double x = real[i], y = imaginary[i];
            real[i] = real[i - 1];
            imaginary[i] = imaginary[i - 1];
            real[i - 1] = x;
            imaginary[i - 1] = y;
        }
}

static bool iterate(size_t n, double *H, double norm, double *real, double *imaginary)
{
    size_t left = n; // rows still to do
    for (int iteration = 0; left > 0;) {
        size_t high = left - 1, low = find_low(n, H, high, norm);
        if (low == high) {
            real[high] = H[high * n + high];
            imaginary[high] = 0;
        } else if (low + 1 == high) {
            solve_two(H + low * n + low, H + high * n + low, real + low, imaginary + low);
        } else {
            if (iteration == MOST_ITERATIONS) return false;
            chase(n, H, low, high, choose_shifts(n, H, high, iteration++));
            continue;
        }
        left = low;
        iteration = 0;
    }
    return true;
}

bool yk_eigen_general(size_t n, double *A, double *real, double *imaginary)
{
    double norm = 0;
    for (size_t k = 0; k < n * n; k++) {
        if (!(fabs(A[k]) <= DBL_MAX)) return false;
        norm = fmax(norm, fabs(A[k]));
    }
    int exponent = 0;
    frexp(norm, &exponent);
    for (size_t k = 0; k < n * n; k++) A[k] = ldexp(A[k], -exponent);
    balance(n, A);
    reduce(n, A);
    if (!iterate(n, A, 1, real, imaginary)) return false;
    for (size_t k = 0; k < n; k++) {
        real[k] = ldexp(real[k], exponent);
        imaginary[k] = ldexp(imaginary[k], exponent);
    }
    sort_values(n, real, imaginary);
    return true;
}

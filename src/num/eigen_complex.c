// Eigenvalues and eigenvectors of complex matrices: reduction to Schur form by rotations.
#include <float.h>
#include "num/complex.h"
#include "num/eigen.h"

enum { MOST_ITERATIONS = 60 }; // for one eigenvalue

// A rotation of two rows, (a, b) -> (c a + s b, -conj(s) a + c b), and of two columns by its inverse.
typedef struct Rotation {
    double c;
    YkVec s;
} Rotation;

// Finds the rotation that takes (a, b) to (*length, 0).
static Rotation rotation(YkVec a, YkVec b, YkVec *length)
{
    double size_a = yk_norm(a), size_b = yk_norm(b), size = yk_hypot(size_a, size_b);
    *length = a;
    if (size_b == 0) return (Rotation){1, {0, 0}};
    YkVec way = size_a > 0 ? yk_scale(1 / size_a, a) : yk_vec(1, 0);
    *length = yk_scale(size, way);
    return (Rotation){size_a / size, yk_scale(1 / size, yk_mul(way, yk_conj(b)))};
}

static void rotate_rows(size_t n, YkVec *A, size_t i, size_t k, Rotation r, size_t from)
{
    YkVec *a = A + i * n, *b = A + k * n, minus = yk_scale(-1, yk_conj(r.s));
    for (size_t j = from; j < n; j++) {
        YkVec x = a[j], y = b[j];
        a[j] = yk_add_product(yk_scale(r.c, x), r.s, y);
        b[j] = yk_add_product(yk_scale(r.c, y), minus, x);
    }
}

static void rotate_columns(size_t n, YkVec *A, size_t i, size_t k, Rotation r, size_t to)
{
    YkVec back = yk_conj(r.s), minus = yk_scale(-1, r.s);
    for (size_t row = 0; row < to; row++) {
        YkVec *a = A + row * n, x = a[i], y = a[k];
        a[i] = yk_add_product(yk_scale(r.c, x), back, y);
        a[k] = yk_add_product(yk_scale(r.c, y), minus, x);
    }
}

// Reduces A to Hessenberg form, zeros below the first subdiagonal, and collects the rotations in Q.
static void reduce(size_t n, YkVec *A, YkVec *Q)
{
    for (size_t k = 0; k + 2 < n; k++)
        for (size_t i = k + 2; i < n; i++) {
            YkVec length;
            Rotation r = rotation(A[(k + 1) * n + k], A[i * n + k], &length);
            rotate_rows(n, A, k + 1, i, r, k);
            A[i * n + k] = yk_vec(0, 0);
            rotate_columns(n, A, k + 1, i, r, n);
            rotate_columns(n, Q, k + 1, i, r, n);
        }
}

static YkVec root_of(YkVec a)
{
    double size = yk_norm(a), x = sqrt((size + fabs(a.x)) / 2), y = x > 0 ? a.y / (2 * x) : 0;
    if (a.x >= 0) return yk_vec(x, y);
    return a.y >= 0 ? yk_vec(y, x) : yk_vec(-y, -x);
}

// Returns the eigenvalue of the last 2 x 2 block that is nearer to its last entry (Wilkinson's shift); now and then
// another shift, in case the iteration cycles.
static YkVec choose_shift(size_t n, const YkVec *H, size_t high, int iteration)
{
    const YkVec *a = H + (high - 1) * n + high - 1, *b = a + n;
    if (iteration % 10 == 9) return yk_add(b[1], yk_vec(yk_norm(b[0]), 0));
    YkVec half = yk_scale(0.5, yk_sub(a[0], b[1])), product = yk_mul(a[1], b[0]);
    YkVec root = root_of(yk_add(yk_mul(half, half), product));
    YkVec far = yk_dot(half, root) >= 0 ? yk_add(half, root) : yk_sub(half, root);
    return yk_sum_norm(far) > 0 ? yk_sub(b[1], yk_mul(product, yk_inverse(far))) : b[1];
}

// Takes one step of the QR iteration on the active block low .. high.
static void chase(size_t n, YkVec *H, YkVec *Q, size_t low, size_t high, YkVec shift)
{
    YkVec x = yk_sub(H[low * n + low], shift), y = H[(low + 1) * n + low];
    for (size_t k = low; k < high; k++) {
        YkVec length;
        if (k > low) x = H[k * n + k - 1];
        if (k > low) y = H[(k + 1) * n + k - 1];
        Rotation r = rotation(x, y, &length);
        rotate_rows(n, H, k, k + 1, r, k > low ? k - 1 : low);
        if (k > low) H[(k + 1) * n + k - 1] = yk_vec(0, 0);
        rotate_columns(n, H, k, k + 1, r, k + 2 < high ? k + 3 : high + 1);
        rotate_columns(n, Q, k, k + 1, r, n);
    }
}

// Returns where the active block that ends at `high` begins: below the last subdiagonal entry that is negligible next
// to its neighbours.
static size_t find_low(size_t n, YkVec *H, size_t high)
{
    size_t low = high;
    for (; low > 0; low--) {
        YkVec *under = H + low * n + low - 1;
        double size = yk_sum_norm(under[1]) + yk_sum_norm(under[-(ptrdiff_t)n]);
        if (yk_sum_norm(*under) <= DBL_EPSILON * (size > 0 ? size : 1)) {
            *under = yk_vec(0, 0);
            break;
        }
    }
    return low;
}

static bool iterate(size_t n, YkVec *H, YkVec *Q)
{
    int iteration = 0;
    for (size_t left = n; left > 0;) {
        size_t high = left - 1, low = find_low(n, H, high);
        if (low == high) {
            left = low;
            iteration = 0;
            continue;
        }
        if (iteration == MOST_ITERATIONS) return false;
        chase(n, H, Q, low, high, choose_shift(n, H, high, iteration++));
    }
    return true;
}

// Finds the eigenvectors of the triangular T, row k below the diagonal for the k-th, and takes them back by Q in place.
static void find_vectors(size_t n, YkVec *T, YkVec *Q)
{
    const double LARGE = 1e150; // where more than twenty eigenvalues are equal, and their vectors nearly so
    for (size_t k = n; k-- > 0;) {
        YkVec *x = T + k * n;
        double head = 1; // x[k]
        for (size_t i = k; i-- > 0;) {
            YkVec sum = yk_scale(head, T[i * n + k]), off = yk_sub(T[k * n + k], T[i * n + i]);
            for (size_t j = i + 1; j < k; j++) sum = yk_add_product(sum, T[i * n + j], x[j]);
            // For equal eigenvalues this is nearly a vector of one of them. The largest entry of T is about 1.
            if (!(yk_sum_norm(off) > DBL_EPSILON)) off = yk_vec(DBL_EPSILON, 0);
            x[i] = yk_mul(sum, yk_inverse(off));
            if (!(yk_sum_norm(x[i]) > LARGE)) continue;
            for (size_t j = i; j < k; j++) x[j] = yk_scale(1 / LARGE, x[j]);
            head /= LARGE;
        }
        for (size_t i = 0; i < n; i++) {
            YkVec sum = yk_scale(head, Q[i * n + k]);
            for (size_t j = 0; j < k; j++) sum = yk_add_product(sum, Q[i * n + j], x[j]);
            Q[i * n + k] = sum;
        }
    }
}

bool yk_eigen_complex(size_t n, YkVec *A, YkVec *values, YkVec *vectors)
{
    double norm = 0;
    for (size_t k = 0; k < n * n; k++) {
        double size = yk_sum_norm(A[k]);
        if (!(size <= DBL_MAX)) return false;
        norm = fmax(norm, size);
        vectors[k] = yk_vec(k % (n + 1) == 0, 0);
    }
    int exponent = 0;
    frexp(norm, &exponent);
    for (size_t k = 0; k < n * n; k++) A[k] = yk_vec(ldexp(A[k].x, -exponent), ldexp(A[k].y, -exponent));
    reduce(n, A, vectors);
    if (!iterate(n, A, vectors)) return false;
    for (size_t k = 0; k < n; k++) values[k] = yk_vec(ldexp(A[k * n + k].x, exponent), ldexp(A[k * n + k].y, exponent));
    find_vectors(n, A, vectors);
    return true;
}

// Dyads through five positions: the points where two conics meet.
//
// Four rows leave a pencil of three vectors of monomials. A vector belongs to pivots if p_0 p_5 = z . F and
// p_0 p_6 = z x F hold among its entries: two conics in the three coefficients, which meet in four points. Two of them
// may be complex, or all; p_0 = 0 stands for a slide, which only special positions have.
#include <math.h>
#include <string.h>
#include "num/dense.h"
#include "synthesis/motions/poses.h"
#include "synthesis/polynomial.h"
#include "synthesis/motions/slides.h"

enum { N = YK_MONOMIALS, ROWS = YK_POSES_MAX - 1, FREE = N - ROWS };

// Completes base[0..count) to N orthonormal vectors: each time by the unit vector that is farthest from them.
static void complete(double base[N][N], size_t count)
{
    for (; count < N; count++) {
        double best = 0;
        for (size_t i = 0; i < N; i++) {
            double trial[N] = {0};
            trial[i] = 1;
            double length = yk_monomials_orthogonalise(trial, base, count);
            if (length <= best + 1e-3) continue;
            best = length;
            memcpy(base[count], trial, sizeof trial);
        }
    }
}

// Finds an orthonormal basis of what the rows leave. Returns false if the rows depend on each other.
static bool find_space(const YkPoseRows *rows, double base[N][N])
{
    static const double dependent = 1e-11;
    for (size_t k = 0; k < rows->count; k++) {
        memcpy(base[k], rows->row[k], sizeof base[k]);
        double unit[N], before;
        memcpy(unit, base[k], sizeof unit);
        before = yk_monomials_orthogonalise(unit, base, 0);
        if (!(yk_monomials_orthogonalise(base[k], base, k) > dependent * (before + 1))) return false;
    }
    complete(base, rows->count);
    return true;
}

// The conic p_a p_b + sum of sign p_c p_d, on the pencil.
static void add_product(YkConic *conic, double base[FREE][N], size_t a, size_t b, double sign)
{
    for (size_t i = 0; i < FREE; i++)
        for (size_t k = 0; k < FREE; k++) conic->q[i < k ? i : k][i < k ? k : i] += sign * base[i][a] * base[k][b];
}

// Improves a real solution on the four rows themselves. Returns whether it converged.
static bool polish(const YkPoseRows *rows, YkVec *z, YkVec *F)
{
    double last = INFINITY;
    for (int step = 0; step < 30; step++) {
        double J[16], b[4], scale[4], size = 0;
        int pivot[4];
        for (size_t k = 0; k < 4; k++) {
            const double *r = rows->row[k];
            b[k] = -yk_pose_row(rows, k, *z, *F);
            J[4 * k] = r[1] + r[5] * F->x + r[6] * F->y;
            J[4 * k + 1] = r[2] + r[5] * F->y - r[6] * F->x;
            J[4 * k + 2] = r[3] + r[5] * z->x - r[6] * z->y;
            J[4 * k + 3] = r[4] + r[5] * z->y + r[6] * z->x;
        }
        if (yk_lu_factor(4, J, pivot, scale) == 0) return last < 1e-7;
        yk_lu_solve(4, J, pivot, b);
        for (size_t i = 0; i < 4; i++) size = fmax(size, fabs(b[i]));
        if (!(size < last)) return last < 1e-7 * (1 + yk_norm(*z) + yk_norm(*F));
        last = size;
        *z = yk_add(*z, yk_vec(b[0], b[1]));
        *F = yk_add(*F, yk_vec(b[2], b[3]));
    }
    return last < 1e-7 * (1 + yk_norm(*z) + yk_norm(*F));
}

static bool is_new(const YkFivePoses *found, const YkDyad *dyad, double scale)
{
    for (size_t k = 0; k < found->count; k++) {
        const YkDyad *old = &found->dyad[k];
        double apart = fabs(old->fixed[0] - dyad->fixed[0]) + fabs(old->fixed[1] - dyad->fixed[1]) +
                       fabs(old->moving[0] - dyad->moving[0]) + fabs(old->moving[1] - dyad->moving[1]);
        double size = scale + fabs(old->fixed[0]) + fabs(old->fixed[1]) + fabs(old->moving[0]) + fabs(old->moving[1]);
        if (old->kind == dyad->kind && apart < 1e-9 * size) return false;
    }
    return true;
}

static void take_point(const YkPose *pose, const YkPoseRows *rows, double base[FREE][N], const YkVec c[3],
                       YkFivePoses *found)
{
    YkVec p[N];
    double largest = 0, real[N], imaginary = 0;
    for (size_t i = 0; i < N; i++) {
        p[i] = yk_vec(0, 0);
        for (size_t k = 0; k < FREE; k++) p[i] = yk_add(p[i], yk_scale(base[k][i], c[k]));
        largest = fmax(largest, yk_norm(p[i]));
    }
    bool is_finite = yk_norm(p[0]) > 1e-9 * largest;
    found->complex_count += is_finite;
    // A real point up to a complex factor: make its largest entry real.
    size_t top = 0;
    for (size_t i = 1; i < N; i++)
        if (yk_norm(p[i]) > yk_norm(p[top])) top = i;
    YkVec factor = yk_scale(1 / yk_dot(p[top], p[top]), yk_conj(p[top]));
    for (size_t i = 0; i < N; i++) {
        YkVec own = yk_mul(p[i], factor);
        real[i] = own.x;
        imaginary = fmax(imaginary, fabs(own.y));
    }
    YkDyad dyad = {0};
    if (imaginary > 1e-5) return;
    if (is_finite) {
        YkVec z = yk_vec(real[1] / real[0], real[2] / real[0]), F = yk_vec(real[3] / real[0], real[4] / real[0]);
        if (!polish(rows, &z, &F)) return;
        dyad = yk_pose_dyad(rows, pose, z, F);
    } else {
        if (!yk_slide_dyad(real, rows, pose, &dyad)) return;
    }
    if (is_new(found, &dyad, rows->scale)) found->dyad[found->count++] = dyad;
}

void yk_five_poses(const YkPose pose[5], YkFivePoses *found)
{
    YkPoseRows rows;
    double base[N][N];
    YkVec point[4][3];
    YkConic dot = {{{0}}}, cross = {{{0}}};
    *found = (YkFivePoses){.count = 0};
    yk_pose_rows(pose, 5, &rows);
    found->is_special = !find_space(&rows, base);
    if (found->is_special) return;
    double(*pencil)[N] = base + ROWS;
    add_product(&dot, pencil, 0, 5, 1);
    add_product(&dot, pencil, 1, 3, -1);
    add_product(&dot, pencil, 2, 4, -1);
    add_product(&cross, pencil, 0, 6, 1);
    add_product(&cross, pencil, 1, 4, -1);
    add_product(&cross, pencil, 2, 3, 1);
    size_t count = yk_conics_meet(&dot, &cross, point);
    found->is_special = count > 4;
    for (size_t k = 0; k < count && count <= 4; k++) take_point(pose, &rows, pencil, point[k], found);
}

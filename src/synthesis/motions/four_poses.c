// Dyads through four positions: rays from a pole meet the circle-point curve.
//
// Three rows are linear in F once z is given, so they have a solution where the determinant of (F_x, F_y, 1) vanishes:
// a cubic in z. The pole of two positions, the point of the body that they leave in place, lies on it. Along a ray from
// there the cubic has the root 0, and a quadratic is left. Source: Burmester 1888; Freudenstein & Sandor 1961.
#include <math.h>
#include "synthesis/motions/poses.h"
#include "synthesis/polynomial.h"

// A row as three linear functions of the ray's parameter t: value + slope t for F_x, F_y and 1.
typedef struct Line {
    double c[3][2];
} Line;

static Line along_ray(const double *r, YkVec z, YkVec u)
{
    return (Line){{{r[3] + r[5] * z.x - r[6] * z.y, r[5] * u.x - r[6] * u.y},
                   {r[4] + r[5] * z.y + r[6] * z.x, r[5] * u.y + r[6] * u.x},
                   {r[0] + r[1] * z.x + r[2] * z.y, r[1] * u.x + r[2] * u.y}}};
}

// Adds sign a b c to the cubic.
static void add_product(double sum[4], const double a[2], const double b[2], const double c[2], double sign)
{
    double ab[3] = {a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[1] * b[1]};
    for (size_t i = 0; i < 3; i++)
        for (size_t k = 0; k < 2; k++) sum[i + k] += sign * ab[i] * c[k];
}

void yk_four_poses(const YkPose pose[4], YkFourPoses *four)
{
    size_t a = 0, b = 0;
    double most = 1e-6; // of a turn between positions, as the sine of its half
    four->first = pose[0];
    yk_pose_rows(pose, 4, &four->rows);
    for (size_t i = 0; i < 4; i++)
        for (size_t k = i + 1; k < 4; k++) {
            double turn = fabs(yk_sin((pose[k].angle - pose[i].angle) / 2));
            if (turn <= most * (1 + 1e-9)) continue;
            most = turn;
            a = i;
            b = k;
        }
    four->is_special = a == b;
    if (four->is_special) return;
    // (R_b - R_a) z = d_a - d_b
    YkVec turn = yk_sub(yk_unit(pose[b].angle), yk_unit(pose[a].angle)), d = yk_sub(pose[a].at, pose[b].at);
    four->pole = yk_scale(1 / (yk_dot(turn, turn) * four->rows.scale), yk_mul(d, yk_conj(turn)));
}

// Finds F from the two rows in which it is determined best. Returns false if it lies at infinity.
static bool fixed_pivot(const YkPoseRows *rows, YkVec z, YkVec *F)
{
    double best = 1e-9;
    Line row[3];
    bool found = false;
    for (size_t k = 0; k < 3; k++) row[k] = along_ray(rows->row[k], z, yk_vec(0, 0));
    for (size_t i = 0; i < 3; i++)
        for (size_t k = i + 1; k < 3; k++) {
            double(*p)[2] = row[i].c, (*q)[2] = row[k].c;
            double determinant = p[0][0] * q[1][0] - p[1][0] * q[0][0];
            if (fabs(determinant) <= best) continue;
            best = fabs(determinant);
            *F = yk_vec((p[1][0] * q[2][0] - q[1][0] * p[2][0]) / determinant,
                        (q[0][0] * p[2][0] - p[0][0] * q[2][0]) / determinant);
            found = true;
        }
    return found;
}

size_t yk_four_poses_ray(const YkFourPoses *four, double angle, YkDyad dyad[2])
{
    double cubic[4] = {0};
    Line row[3];
    YkVec root[YK_DEGREE_MAX], u = yk_unit(angle), F;
    size_t found = 0;
    if (four->is_special) return 0;
    for (size_t k = 0; k < 3; k++) row[k] = along_ray(four->rows.row[k], four->pole, u);
    for (size_t i = 0; i < 3; i++) { // the six terms of a determinant
        size_t k = (i + 1) % 3, m = (i + 2) % 3;
        add_product(cubic, row[0].c[i], row[1].c[k], row[2].c[m], 1);
        add_product(cubic, row[0].c[m], row[1].c[k], row[2].c[i], -1);
    }
    size_t count = yk_roots(cubic + 1, 2, root);
    for (size_t k = 0; k < count; k++) {
        YkVec z = yk_add(four->pole, yk_scale(root[k].x, u));
        if (root[k].y != 0 || fabs(root[k].x) < 1e-6 || !fixed_pivot(&four->rows, z, &F)) continue;
        YkDyad own = yk_pose_dyad(&four->rows, &four->first, z, F);
        double limit = 50 * four->rows.scale; // far away it is a slide rather than a link
        if (own.length < 1e-6 * four->rows.scale || own.length > limit || fabs(own.fixed[0]) > 2 * limit) continue;
        dyad[found++] = own;
    }
    return found;
}

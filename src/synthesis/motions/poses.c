// The rows of conditions that positions put on a dyad's pivots.
#include "synthesis/motions/poses.h"
#include <math.h>

static void fill_row(YkPose pose, double row[YK_MONOMIALS])
{
    YkVec u = yk_unit(pose.angle), d = pose.at, own = yk_mul(yk_conj(u), d); // the origin's place in turned axes
    row[0] = yk_dot(d, d) / 2;
    row[1] = own.x;
    row[2] = own.y;
    row[3] = -d.x;
    row[4] = -d.y;
    row[5] = -u.x;
    row[6] = -u.y;
}

// The limit of the difference of two rows, over the time between them, made of the size of a row.
static void fill_rate(YkPose pose, double row[YK_MONOMIALS])
{
    YkVec u = yk_unit(pose.angle), d = pose.at, v = pose.velocity, turned = yk_scale(pose.rate, yk_quarter(u));
    YkVec own = yk_add(yk_mul(yk_conj(turned), d), yk_mul(yk_conj(u), v));
    const double rate[YK_MONOMIALS] = {yk_dot(d, v), own.x, own.y, -v.x, -v.y, -turned.x, -turned.y};
    double size = yk_norm(v) + fabs(pose.rate);
    for (size_t i = 0; i < YK_MONOMIALS; i++) row[i] = size > 0 ? rate[i] / size : 0;
}

static void find_scale(const YkPose *pose, size_t count, YkPoseRows *rows)
{
    rows->middle = yk_vec(0, 0);
    for (size_t k = 0; k < count; k++) rows->middle = yk_add(rows->middle, yk_scale(1 / (double)count, pose[k].at));
    rows->scale = 0;
    for (size_t k = 0; k < count; k++) rows->scale = fmax(rows->scale, yk_norm(yk_sub(pose[k].at, rows->middle)));
    if (!(rows->scale > 0)) rows->scale = 1;
}

void yk_pose_rows(const YkPose *pose, size_t count, YkPoseRows *rows)
{
    double first[YK_MONOMIALS];
    find_scale(pose, count, rows);
    rows->count = count - 1;
    for (size_t k = 0; k < count; k++) {
        YkPose own = pose[k];
        own.at = yk_scale(1 / rows->scale, yk_sub(pose[k].at, rows->middle));
        own.velocity = yk_scale(1 / rows->scale, pose[k].velocity);
        if (own.is_rate)
            fill_rate(own, rows->row[k - 1]);
        else
            fill_row(own, k == 0 ? first : rows->row[k - 1]);
    }
    for (size_t k = 0; k < rows->count; k++)
        for (size_t i = 0; i < YK_MONOMIALS && !pose[k + 1].is_rate; i++) rows->row[k][i] -= first[i];
}

double yk_pose_row(const YkPoseRows *rows, size_t k, YkVec z, YkVec F)
{
    const double *r = rows->row[k];
    return r[0] + r[1] * z.x + r[2] * z.y + r[3] * F.x + r[4] * F.y + r[5] * yk_dot(z, F) + r[6] * yk_cross(z, F);
}

YkDyad yk_pose_dyad(const YkPoseRows *rows, const YkPose *first, YkVec z, YkVec F)
{
    YkVec moving = yk_scale(rows->scale, z), fixed = yk_add(rows->middle, yk_scale(rows->scale, F));
    double length = yk_norm(yk_sub(yk_pose_apply(*first, moving), fixed));
    return (YkDyad){YK_DYAD_RR, {fixed.x, fixed.y}, {moving.x, moving.y}, length, 0};
}

// The conditions are linear in z once F is given: rows (a, b | c) with a z_x + b z_y + c = 0.
static void row_in_moving(const double *r, YkVec F, double out[3])
{
    out[0] = r[1] + r[5] * F.x + r[6] * F.y;
    out[1] = r[2] + r[5] * F.y - r[6] * F.x;
    out[2] = r[0] + r[3] * F.x + r[4] * F.y;
}

static const double flat = 1e-10;

// Solves the rows of a moving pivot. One row leaves a line of them: the one that is `along` from its foot.
static bool solve_moving(double (*row)[3], size_t count, double along, YkVec *z)
{
    YkVec a = yk_vec(row[0][0], row[0][1]);
    if (count == 1) {
        double length2 = yk_dot(a, a);
        if (!(length2 > flat * flat)) return false; // the fixed pivot is the pole
        YkVec foot = yk_scale(-row[0][2] / length2, a);
        *z = yk_add(foot, yk_scale(along / sqrt(length2), yk_quarter(a)));
        return true;
    }
    const double *p = row[0], *q = row[1];
    YkVec b = yk_vec(q[0], q[1]);
    double determinant = yk_cross(a, b);
    if (!(fabs(determinant) > flat * yk_norm(a) * yk_norm(b))) return false; // the moving pivot is at infinity
    *z = yk_vec((p[1] * q[2] - q[1] * p[2]) / determinant, (q[0] * p[2] - p[0] * q[2]) / determinant);
    return true;
}

bool yk_pose_pivot(const YkPose *pose, size_t count, YkVec fixed, double along, YkDyad *dyad)
{
    YkPoseRows rows;
    double row[2][3] = {{0}};
    yk_pose_rows(pose, count, &rows);
    YkVec F = yk_scale(1 / rows.scale, yk_sub(fixed, rows.middle)), z;
    for (size_t k = 0; k < rows.count && k < 2; k++) row_in_moving(rows.row[k], F, row[k]);
    if (!solve_moving(row, rows.count, along, &z)) return false;
    *dyad = yk_pose_dyad(&rows, &pose[0], z, F);
    return dyad->length > flat * rows.scale;
}

bool yk_pose_slide(const YkPose *pose, size_t count, double direction, double along, YkDyad *dyad)
{
    static const double far_away = 50;
    YkPoseRows rows;
    double row[2][3] = {{0}};
    yk_pose_rows(pose, count, &rows);
    YkVec F = yk_quarter(yk_unit(direction)), z; // at infinity, across the line
    for (size_t k = 0; k < rows.count && k < 2; k++) {
        const double *r = rows.row[k], constant_free[YK_MONOMIALS] = {0, 0, 0, r[3], r[4], r[5], r[6]};
        row_in_moving(constant_free, F, row[k]);
    }
    if (!solve_moving(row, rows.count, along, &z) || yk_norm(z) > far_away) return false;
    z = yk_scale(rows.scale, z);
    YkVec at = yk_pose_apply(pose[0], z),
          foot = yk_sub(at, yk_scale(yk_dot(at, yk_unit(direction)), yk_unit(direction)));
    *dyad = (YkDyad){.kind = YK_DYAD_PR, .fixed = {foot.x, foot.y}, .moving = {z.x, z.y}, .direction = direction};
    return true;
}

bool yk_pose_block(const YkPose *pose, size_t count, double direction, double along, YkDyad *dyad)
{
    YkPose seen[YK_POSES_MAX]; // the ground, from the body
    for (size_t k = 0; k < count; k++) {
        YkVec back = yk_conj(yk_unit(pose[k].angle)), at = yk_mul(back, pose[k].at);
        seen[k] = pose[k];
        seen[k].at = yk_scale(-1, at);
        seen[k].angle = -pose[k].angle;
        seen[k].velocity = yk_sub(yk_scale(pose[k].rate, yk_quarter(at)), yk_mul(back, pose[k].velocity));
        seen[k].rate = -pose[k].rate;
    }
    YkDyad slide;
    if (!yk_pose_slide(seen, count, direction, along, &slide)) return false;
    *dyad = (YkDyad){.kind = YK_DYAD_RP, .direction = direction};
    for (size_t i = 0; i < 2; i++) {
        dyad->fixed[i] = slide.moving[i];
        dyad->moving[i] = slide.fixed[i];
    }
    return true;
}

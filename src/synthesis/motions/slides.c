// Dyads with a slide: one of their pivots lies at infinity, where p_0 = 0 among the monomials.
#include "synthesis/motions/slides.h"
#include <math.h>

enum { N = YK_MONOMIALS };

static double product(const double *a, const double *b)
{
    double sum = 0;
    for (size_t i = 0; i < N; i++) sum += a[i] * b[i];
    return sum;
}

double yk_monomials_orthogonalise(double v[N], double base[][N], size_t count)
{
    for (int twice = 0; twice < 2; twice++)
        for (size_t k = 0; k < count; k++) {
            double part = product(v, base[k]);
            for (size_t i = 0; i < N; i++) v[i] -= part * base[k][i];
        }
    double length = sqrt(product(v, v));
    for (size_t i = 0; i < N && length > 0; i++) v[i] /= length;
    return length;
}

// Gives a dyad with a slide its line: PR: through the moving pivot; RP: through the fixed one, in the body.
static void place_line(const YkPose *first, YkDyad *dyad)
{
    YkVec along = yk_unit(dyad->direction);
    bool is_pr = dyad->kind == YK_DYAD_PR;
    YkVec through =
        is_pr ? yk_pose_apply(*first, yk_vec(dyad->moving[0], dyad->moving[1]))
              : yk_mul(yk_conj(yk_unit(first->angle)), yk_sub(yk_vec(dyad->fixed[0], dyad->fixed[1]), first->at));
    YkVec foot = yk_sub(through, yk_scale(yk_dot(through, along), along));
    double *out = is_pr ? dyad->fixed : dyad->moving;
    out[0] = foot.x;
    out[1] = foot.y;
}

bool yk_slide_dyad(const double p[N], const YkPoseRows *rows, const YkPose *first, YkDyad *dyad)
{
    YkVec z = yk_vec(p[1], p[2]), F = yk_vec(p[3], p[4]), w = yk_vec(p[5], p[6]);
    double moving = yk_norm(z), fixed = yk_norm(F);
    bool is_pr = fixed > 1e5 * moving, is_rp = moving > 1e5 * fixed;
    if (!is_pr && !is_rp) return false;
    // With F at infinity p_5 + i p_6 = conj(z) F; with z there it is conj(z) F, too.
    YkVec far_point = is_pr ? F : z, near_point;
    double square = yk_dot(far_point, far_point);
    near_point = is_pr ? yk_conj(yk_scale(1 / square, yk_mul(w, yk_conj(F)))) : yk_scale(1 / square, yk_mul(w, z));
    *dyad = (YkDyad){.kind = is_pr ? YK_DYAD_PR : YK_DYAD_RP};
    dyad->direction = yk_atan2(far_point.x, -far_point.y); // across the direction in which the pivot has gone
    YkVec at = yk_scale(rows->scale, near_point);
    if (is_pr) {
        dyad->moving[0] = at.x;
        dyad->moving[1] = at.y;
    } else {
        at = yk_add(rows->middle, at);
        dyad->fixed[0] = at.x;
        dyad->fixed[1] = at.y;
    }
    place_line(first, dyad);
    return true;
}

size_t yk_four_poses_slides(const YkPose pose[4], YkDyad dyad[2])
{
    YkPoseRows rows;
    size_t count = 0;
    yk_pose_rows(pose, 4, &rows);
    for (int is_rp = 0; is_rp < 2; is_rp++) { // with p_0 = 0 and one pivot's entries 0 four monomials are left
        static const size_t kept[2][4] = {{3, 4, 5, 6}, {1, 2, 5, 6}};
        double base[N][N] = {{0}}, p[N] = {0};
        bool good = true;
        for (size_t k = 0; k < 3 && good; k++) {
            for (size_t i = 0; i < 4; i++) base[k][i] = rows.row[k][kept[is_rp][i]];
            good = yk_monomials_orthogonalise(base[k], base, k) > 1e-9;
        }
        double best = 0;
        for (size_t i = 0; i < 4 && good; i++) {
            double trial[N] = {0};
            trial[i] = 1;
            double length = yk_monomials_orthogonalise(trial, base, 3);
            if (length <= best) continue;
            best = length;
            for (size_t k = 0; k < 4; k++) p[kept[is_rp][k]] = trial[k];
        }
        if (good && yk_slide_dyad(p, &rows, pose, &dyad[count])) count++;
    }
    return count;
}

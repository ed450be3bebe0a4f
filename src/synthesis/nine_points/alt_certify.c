// Krawczyk's operator for the equations of Alt's problem.
#include "synthesis/nine_points/alt_certify.h"
#include "synthesis/nine_points/alt_disc.h"

enum { N = YK_ALT_SIZE };

typedef struct Proof {
    YkDisc place[YK_ALT_PLACES];
    YkDisc x[N];    // with radius 0
    double size[N]; // of x_k
    YkVec Y[N * N]; // an approximate inverse of the Jacobian at x
    double miss[N]; // upper bounds of |Y F(x)|
} Proof;

static bool invert_jacobian(Proof *p)
{
    YkDisc row[N];
    YkVec J[N * N], column[N];
    int pivot[N];
    for (size_t j = 0; j < N; j++) {
        yk_alt_enclose(p->place[j], p->place[N + j], p->x, row);
        for (size_t k = 0; k < N; k++) J[j * N + k] = row[k].at;
    }
    if (!yk_complex_factor(N, J, pivot)) return false;
    for (size_t j = 0; j < N; j++) {
        for (size_t k = 0; k < N; k++) column[k] = yk_vec(k == j, 0);
        yk_complex_solve(N, J, pivot, column);
        for (size_t k = 0; k < N; k++) p->Y[k * N + j] = column[k];
    }
    return true;
}

static YkDisc widened(const Proof *p, size_t k, double radius)
{
    YkDisc x = p->x[k];
    x.radius = YK_BALL_OUT(radius * p->size[k]);
    return x;
}

static YkBall multiply_row(const Proof *p, size_t k, const YkBall *column, size_t stride, YkBall sum)
{
    for (size_t j = 0; j < N; j++) sum = yk_ball_add(sum, yk_ball_mul(yk_ball(p->Y[k * N + j], 0), column[j * stride]));
    return sum;
}

// Encloses the Newton step at x itself.
static void enclose_step(const Proof *p, YkBall *step)
{
    YkBall F[N];
    for (size_t j = 0; j < N; j++) F[j] = yk_disc_round(yk_alt_enclose(p->place[j], p->place[N + j], p->x, NULL));
    for (size_t k = 0; k < N; k++) step[k] = multiply_row(p, k, F, 1, yk_ball(yk_vec(0, 0), 0));
}

// Returns how far Krawczyk's operator maps the polydisc from x, relative to the sizes; infinity for not a number.
static double image_of(const Proof *p, double radius)
{
    YkDisc x[N], row[N];
    YkBall J[N * N];
    double most = 0;
    for (size_t k = 0; k < N; k++) x[k] = widened(p, k, radius);
    for (size_t j = 0; j < N; j++) {
        yk_alt_enclose(p->place[j], p->place[N + j], x, row);
        for (size_t k = 0; k < N; k++) J[j * N + k] = yk_disc_round(row[k]);
    }
    for (size_t k = 0; k < N; k++) {
        double sum = p->miss[k];
        for (size_t j = 0; j < N; j++) {
            YkBall entry = multiply_row(p, k, J + j, N, yk_ball(yk_vec(k == j ? -1 : 0, 0), 0));
            sum = YK_BALL_OUT(sum + yk_ball_most(entry) * YK_BALL_OUT(radius * p->size[j]));
        }
        double part = YK_BALL_OUT(sum / p->size[k]);
        if (!(part <= most)) most = part < INFINITY ? part : INFINITY;
    }
    return most;
}

// --- reality

static bool are_real(const YkVec *places)
{
    for (size_t k = 0; k < N; k++)
        if (places[k].x != places[N + k].x || places[k].y != -places[N + k].y) return false;
    return true;
}

static bool is_plain(size_t k) // not one of z^
{
    return k % YK_ALT_DYAD < YK_ALT_X_HAT;
}

static YkDisc conjugate(YkDisc a)
{
    return (YkDisc){yk_conj(a.at), yk_conj(a.rest), a.radius};
}

// Encloses the difference of z and the conjugate of z^.
static YkDisc apart(const Proof *p, size_t k, double radius)
{
    return yk_disc_sub(widened(p, k, radius), conjugate(widened(p, k + YK_ALT_X_HAT, radius)));
}

static bool seems_real(const Proof *p)
{
    const double near = 1e-10;
    for (size_t k = 0; k < N; k++)
        if (is_plain(k) && !(yk_sum_norm(apart(p, k, 0).at) < near * p->size[k])) return false;
    return true;
}

// Moves x to the nearest point that is its own conjugate.
static void make_real(Proof *p)
{
    for (size_t k = 0; k < N; k++) {
        if (!is_plain(k)) continue;
        YkDisc sum = yk_disc_add(p->x[k], conjugate(p->x[k + YK_ALT_X_HAT]));
        p->x[k] = (YkDisc){yk_scale(0.5, sum.at), yk_scale(0.5, sum.rest), 0};
        p->x[k + YK_ALT_X_HAT] = conjugate(p->x[k]);
    }
}

// Returns whether the polydisc holds no real point.
static bool avoids_reals(const Proof *p, double within)
{
    for (size_t k = 0; k < N; k++) {
        if (!is_plain(k)) continue;
        YkBall off = yk_disc_round(apart(p, k, within));
        if (fmax(fabs(off.at.x), fabs(off.at.y)) > off.radius) return true;
    }
    return false;
}

// --- the door

// Encloses the sums of the triple's pivots, a + b + c with c = (a y - b x) / (y - x).
static void enclose_key(const Proof *p, double within, YkBall key[2])
{
    for (size_t hat = 0; hat < 2; hat++) {
        YkDisc own[2][2]; // x and a of a dyad
        for (size_t k = 0; k < 4; k++) {
            size_t at = k / 2 * YK_ALT_DYAD + hat * YK_ALT_X_HAT + k % 2;
            own[k / 2][k % 2] = widened(p, at, within);
        }
        YkDisc turned = yk_disc_determinant(own[0][YK_ALT_A], own[1][YK_ALT_A], own[0][YK_ALT_X], own[1][YK_ALT_X]);
        YkBall inverse = yk_ball_inverse(yk_disc_round(yk_disc_sub(own[1][YK_ALT_X], own[0][YK_ALT_X])));
        YkBall third = yk_ball_mul(yk_disc_round(turned), inverse);
        key[hat] = yk_ball_add(yk_disc_round(yk_disc_add(own[0][YK_ALT_A], own[1][YK_ALT_A])), third);
    }
}

static void measure(Proof *p)
{
    for (size_t k = 0; k < N; k++) p->size[k] = yk_sum_norm(p->x[k].at);
}

// Bounds the Newton step. Returns the largest bound relative to the sizes.
static double bound_step(Proof *p, const YkBall *step)
{
    double most = 0;
    for (size_t k = 0; k < N; k++) {
        p->miss[k] = yk_ball_most(step[k]);
        most = fmax(most, p->miss[k] / p->size[k]);
    }
    return most;
}

// Brings x to where the precision ends, by Newton's method with one and the same inverse, and bounds what is left.
static bool refine(Proof *p, bool is_real)
{
    enum { STEPS = 12 };
    const double enough = 1e-26;
    YkBall step[N];
    measure(p);
    if (!invert_jacobian(p)) return false;
    for (int i = 0; i < STEPS; i++) {
        enclose_step(p, step);
        if (bound_step(p, step) < enough) return true;
        for (size_t k = 0; k < N; k++) {
            p->x[k] = yk_disc_sub(p->x[k], yk_disc(step[k].at, 0));
            p->x[k].radius = 0; // wherever it is now, it is taken as it is
        }
        if (is_real) make_real(p);
        measure(p);
    }
    enclose_step(p, step);
    bound_step(p, step);
    return true;
}

// Tries radii, from large to small. Returns false if none succeeds.
static bool prove(const Proof *p, double *radius, double *image)
{
    static const double radii[] = {1e-6, 1e-8, 1e-10, 1e-12, 1e-14, 1e-16, 1e-18, 1e-20, 1e-22, 1e-24};
    for (size_t r = 0; r < sizeof radii / sizeof *radii; r++) {
        *radius = radii[r];
        *image = image_of(p, *radius);
        if (*image < *radius) return true;
    }
    return false;
}

bool yk_alt_certify(const YkVec *places, YkVec *x, YkAltProof *proof)
{
    Proof p = {.size = {0}};
    double image;
    for (size_t k = 0; k < YK_ALT_PLACES; k++) p.place[k] = yk_disc(places[k], 0);
    for (size_t k = 0; k < N; k++) p.x[k] = yk_disc(x[k], 0);
    bool has_reals = are_real(places);
    if (!refine(&p, false)) return false;
    bool is_real = has_reals && seems_real(&p);
    if (is_real) make_real(&p);
    *proof = (YkAltProof){.reality = YK_ALT_UNKNOWN};
    if (!refine(&p, is_real) || !prove(&p, &proof->radius, &image)) return false;
    for (size_t k = 0; k < N; k++) x[k] = p.x[k].at;
    if (has_reals && !is_real && avoids_reals(&p, image)) proof->reality = YK_ALT_NOT_REAL;
    if (is_real) proof->reality = YK_ALT_REAL; // the polydisc is its own conjugate, and so is what is alone in it
    enclose_key(&p, image, proof->key);
    return true;
}

bool yk_alt_are_different(const YkAltProof *one, const YkAltProof *other)
{
    for (size_t k = 0; k < 2; k++) {
        const YkBall *a = &one->key[k], *b = &other->key[k];
        double apart_by =
            yk_sum_norm(yk_sub(a->at, b->at)) * (1 - 0x1p-48) / 1.5; // below the distance, as sqrt(2) < 1.5
        if (apart_by > YK_BALL_OUT(a->radius + b->radius)) return true;
    }
    return false;
}

// Krawczyk's operator for the equations of Alt's problem.
#include "synthesis/alt_certify.h"
#include "synthesis/alt_disc.h"

enum { N = YK_ALT_SIZE };

typedef struct Line {
    YkDisc u, v, w;
} Line;

static YkDisc sub(YkDisc a, YkDisc b)
{
    return yk_disc_add(a, yk_disc_negate(b));
}

static YkDisc add_product(YkDisc sum, YkDisc a, YkDisc b)
{
    return yk_disc_add(sum, yk_disc_mul(a, b));
}

static YkDisc determinant(YkDisc a, YkDisc b, YkDisc c, YkDisc d)
{
    return sub(yk_disc_mul(a, d), yk_disc_mul(b, c));
}

static Line line_of(YkDisc d, YkDisc hat, const YkDisc *x)
{
    YkDisc off = sub(x[YK_ALT_X], x[YK_ALT_A]), off_hat = sub(x[YK_ALT_X_HAT], x[YK_ALT_A_HAT]);
    Line line;
    line.u = yk_disc_mul(sub(hat, x[YK_ALT_A_HAT]), x[YK_ALT_X]);
    line.v = yk_disc_mul(sub(d, x[YK_ALT_A]), x[YK_ALT_X_HAT]);
    line.w = add_product(add_product(yk_disc_mul(d, off_hat), hat, off), d, hat);
    return line;
}

// As in alt_system.c.
static Line gradient(const Line *other, YkDisc by_D, YkDisc by_G, YkDisc by_H)
{
    Line g;
    g.u = determinant(by_D, by_H, other->w, other->v);
    g.v = determinant(by_G, by_D, other->u, other->w);
    g.w = determinant(by_H, by_G, other->v, other->u);
    return g;
}

static void fill_row(YkDisc d, YkDisc hat, const YkDisc *x, const Line *by, bool is_second, YkDisc *row)
{
    YkDisc along = yk_disc_mul(by->w, hat), along_hat = yk_disc_mul(by->w, d);
    row[YK_ALT_X] = add_product(along, by->u, sub(hat, x[YK_ALT_A_HAT]));
    row[YK_ALT_X_HAT] = add_product(along_hat, by->v, sub(d, x[YK_ALT_A]));
    row[YK_ALT_A] = yk_disc_negate(add_product(along, by->v, x[YK_ALT_X_HAT]));
    row[YK_ALT_A_HAT] = yk_disc_negate(add_product(along_hat, by->u, x[YK_ALT_X]));
    for (size_t k = 0; k < YK_ALT_DYAD && is_second; k++) row[k] = yk_disc_negate(row[k]);
}

// Evaluates an equation at discs; row may be NULL.
static YkDisc equation_at(YkDisc d, YkDisc hat, const YkDisc *x, YkDisc *row)
{
    Line one = line_of(d, hat, x), two = line_of(d, hat, x + YK_ALT_DYAD);
    YkDisc D = determinant(one.u, one.v, two.u, two.v), G = determinant(one.v, one.w, two.v, two.w);
    YkDisc H = determinant(one.w, one.u, two.w, two.u), by_D = yk_disc_add(G, H);
    YkDisc value = add_product(yk_disc_mul(D, by_D), G, H);
    if (!row) return value;
    YkDisc by_G = yk_disc_add(D, H), by_H = yk_disc_add(D, G);
    Line by_one = gradient(&two, by_D, by_G, by_H), by_two = gradient(&one, by_D, by_G, by_H);
    fill_row(d, hat, x, &by_one, false, row);
    fill_row(d, hat, x + YK_ALT_DYAD, &by_two, true, row + YK_ALT_DYAD);
    return value;
}

typedef struct Proof {
    YkDisc place[YK_ALT_PLACES];
    YkVec *x;
    double size[N]; // of x_k
    YkVec Y[N * N]; // an approximate inverse of the Jacobian at x
    double miss[N]; // upper bounds of |Y F(x)|
} Proof;

static bool invert_jacobian(const YkVec *places, Proof *p)
{
    YkVec F[N], J[N * N], column[N];
    int pivot[N];
    yk_alt_evaluate(places, p->x, F, J, NULL, NULL);
    if (!yk_complex_factor(N, J, pivot)) return false;
    for (size_t j = 0; j < N; j++) {
        for (size_t k = 0; k < N; k++) column[k] = yk_vec(k == j, 0);
        yk_complex_solve(N, J, pivot, column);
        for (size_t k = 0; k < N; k++) p->Y[k * N + j] = column[k];
    }
    return true;
}

static double radius_of(const Proof *p, size_t k, double radius)
{
    return YK_BALL_OUT(radius * p->size[k]);
}

static YkBall multiply_row(const Proof *p, size_t k, const YkBall *column, size_t stride, YkBall sum)
{
    for (size_t j = 0; j < N; j++) sum = yk_ball_add(sum, yk_ball_mul(yk_ball(p->Y[k * N + j], 0), column[j * stride]));
    return sum;
}

// Encloses the Newton step at x itself.
static void enclose_step(const Proof *p, YkBall *step)
{
    YkDisc x[N];
    YkBall F[N];
    for (size_t k = 0; k < N; k++) x[k] = yk_disc(p->x[k], 0);
    for (size_t j = 0; j < N; j++) F[j] = yk_disc_round(equation_at(p->place[j], p->place[N + j], x, NULL));
    for (size_t k = 0; k < N; k++) step[k] = multiply_row(p, k, F, 1, yk_ball(yk_vec(0, 0), 0));
}

// Returns how far Krawczyk's operator maps the polydisc from x, relative to the sizes; infinity for not a number.
static double image_of(const Proof *p, double radius)
{
    YkDisc x[N], row[N];
    YkBall J[N * N];
    double most = 0;
    for (size_t k = 0; k < N; k++) x[k] = yk_disc(p->x[k], radius_of(p, k, radius));
    for (size_t j = 0; j < N; j++) {
        equation_at(p->place[j], p->place[N + j], x, row);
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

// How far z and the conjugate of z^ are apart.
static double apart(const YkVec *x, size_t k)
{
    return yk_sum_norm(yk_sub(x[k], yk_conj(x[k + YK_ALT_X_HAT])));
}

static bool is_plain(size_t k) // not one of z^
{
    return k % YK_ALT_DYAD < YK_ALT_X_HAT;
}

// Returns whether x is near its own conjugate; moves it there if so.
static bool make_real(YkVec *x)
{
    const double near = 1e-7;
    for (size_t k = 0; k < N; k++)
        if (is_plain(k) && !(apart(x, k) < near * yk_sum_norm(x[k]))) return false;
    for (size_t k = 0; k < N; k++) {
        if (!is_plain(k)) continue;
        x[k] = yk_scale(0.5, yk_add(x[k], yk_conj(x[k + YK_ALT_X_HAT])));
        x[k + YK_ALT_X_HAT] = yk_conj(x[k]);
    }
    return true;
}

// Returns whether the polydisc holds no real point.
static bool avoids_reals(const Proof *p, double within)
{
    for (size_t k = 0; k < N; k++)
        if (is_plain(k) &&
            apart(p->x, k) > YK_BALL_OUT(2 * within * (p->size[k] + p->size[k + YK_ALT_X_HAT])) + 1e-14 * p->size[k])
            return true;
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
            own[k / 2][k % 2] = yk_disc(p->x[at], radius_of(p, at, within));
        }
        YkDisc turned = determinant(own[0][YK_ALT_A], own[1][YK_ALT_A], own[0][YK_ALT_X], own[1][YK_ALT_X]);
        YkBall inverse = yk_ball_inverse(yk_disc_round(sub(own[1][YK_ALT_X], own[0][YK_ALT_X])));
        YkBall third = yk_ball_mul(yk_disc_round(turned), inverse);
        key[hat] = yk_ball_add(yk_disc_round(yk_disc_add(own[0][YK_ALT_A], own[1][YK_ALT_A])), third);
    }
}

// Brings x to where rounding alone keeps it from the solution.
static void refine(Proof *p, bool is_real)
{
    enum { STEPS = 3 };
    YkBall step[N];
    for (int i = 0; i < STEPS; i++) {
        enclose_step(p, step);
        for (size_t k = 0; k < N; k++) p->x[k] = yk_sub(p->x[k], step[k].at);
        if (is_real) make_real(p->x);
    }
    enclose_step(p, step);
    for (size_t k = 0; k < N; k++) {
        p->miss[k] = yk_ball_most(step[k]);
        p->size[k] = yk_sum_norm(p->x[k]);
    }
}

bool yk_alt_certify(const YkVec *places, YkVec *x, YkAltProof *proof)
{
    static const double radii[] = {1e-6, 1e-8, 1e-10, 1e-11, 1e-12, 1e-13, 1e-14, 2e-15};
    Proof p = {.x = x};
    bool has_reals = are_real(places), looks_real = has_reals && make_real(x);
    for (size_t k = 0; k < YK_ALT_PLACES; k++) p.place[k] = yk_disc(places[k], 0);
    if (!invert_jacobian(places, &p)) return false;
    refine(&p, looks_real);
    for (size_t r = 0; r < sizeof radii / sizeof *radii; r++) {
        double image = image_of(&p, radii[r]);
        if (!(image < radii[r])) continue;
        *proof = (YkAltProof){.radius = radii[r], .reality = YK_ALT_UNKNOWN};
        if (has_reals && !looks_real && avoids_reals(&p, image)) proof->reality = YK_ALT_NOT_REAL;
        if (looks_real)
            proof->reality = YK_ALT_REAL; // the polydisc is its own conjugate, and so is what is alone in it
        enclose_key(&p, image, proof->key);
        return true;
    }
    return false;
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

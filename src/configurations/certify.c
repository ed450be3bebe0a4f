// Krawczyk's operator in complex discs.
#include "configurations/certify.h"
#include "configurations/ball.h"

enum { N_MAX = 2 * YK_SYSTEM_LOOPS_MAX };

typedef struct Proof {
    const YkShape *shape;
    const YkVec *coefficients;
    const double *radii; // of the coefficients' discs, 0 where one is absent; NULL: all as those of a pose
    const YkVec *x;
    double size[N_MAX];     // of x_k
    double spread[N_MAX];   // by which x_k itself moves; 0 except over an interval
    YkVec Y[N_MAX * N_MAX]; // an approximate inverse of the Jacobian at x
    double miss[N_MAX];     // upper bounds of |Y F(x)|
    bool is_rate;           // the coefficients are derivatives of some, in which the unknowns of relations stand still
} Proof;

static YkBall coefficient(const Proof *p, size_t row, size_t k)
{
    YkVec a = p->coefficients[row * (p->shape->unknowns + 1) + k];
    if (p->radii) return yk_ball(a, p->radii[row * (p->shape->unknowns + 1) + k]);
    bool is_absent = k < p->shape->unknowns && a.x == 0 && a.y == 0;
    return yk_ball(a, is_absent ? 0 : YK_COEFFICIENT_ERROR);
}

// Returns a part of a disc, x or y, as an interval.
static YkBall part_of(YkBall a, size_t part)
{
    return yk_ball(yk_vec(part == 0 ? a.at.x : a.at.y, 0), a.radius);
}

// Evaluates a row of a system in real unknowns as below, where every disc is an interval and w is e^(i Phi).
static YkBall real_row_at(const Proof *p, size_t row, const YkBall *x, const YkBall *w, YkBall *J)
{
    const YkShape *shape = p->shape;
    const YkBall i = {{0, 1}, 0}, zero = {{0, 0}, 0};
    size_t n = shape->unknowns, part = row % 2;
    bool is_loop = row < 2 * shape->loops;
    YkBall sum = coefficient(p, is_loop ? row / 2 : row, n);
    for (size_t k = 0; J && k < n; k++) J[k] = zero;
    for (size_t k = 0; k < n; k++) {
        YkBall a = coefficient(p, is_loop ? row / 2 : row, k);
        int turning = shape->turning[k];
        bool is_turn = is_loop && k < shape->angles, turns = is_loop && turning >= 0;
        if (a.radius == 0) continue;
        if (turns) a = yk_ball_mul(a, w[turning]);
        YkBall term = yk_ball_mul(a, is_turn ? w[k] : x[k]);
        sum = yk_ball_add(sum, term);
        if (!J) continue;
        YkBall slope = is_turn ? yk_ball_mul(i, term) : a;
        J[k] = yk_ball_add(J[k], is_loop ? part_of(slope, part) : slope);
        if (turns) J[turning] = yk_ball_add(J[turning], part_of(yk_ball_mul(i, term), part));
    }
    if (is_loop) return part_of(sum, part);
    sum.radius = YK_BALL_OUT(sum.radius + 1e-15 + 4e-16 * fabs(sum.at.x)); // what whole turns are rounded by
    if (row < 2 * shape->loops + shape->whole && !p->is_rate) sum.at.x = yk_nearest_turn(sum.at.x, 0);
    return sum;
}

// Evaluates a row at discs: its value, and its derivatives (J may be NULL).
static YkBall row_at(const Proof *p, size_t row, const YkBall *x, const YkBall *w, YkBall *J)
{
    const YkShape *shape = p->shape;
    if (shape->relations > 0) return real_row_at(p, row, x, w, J);
    bool inverse = row >= shape->loops;
    const YkBall *z = inverse ? w : x, zero = {{0, 0}, 0};
    size_t n = shape->unknowns;
    YkBall sum = coefficient(p, row, n);
    for (size_t k = 0; J && k < n; k++) J[k] = zero;
    for (size_t k = 0; k < n; k++) {
        YkBall a = coefficient(p, row, k);
        int turning = shape->turning[k];
        bool turns = k >= shape->angles && turning >= 0;
        if (a.radius == 0) continue;
        YkBall direction = turns ? yk_ball_mul(a, z[turning]) : a;
        sum = yk_ball_add(sum, yk_ball_mul(direction, k < shape->angles ? z[k] : x[k]));
        if (!J) continue;
        J[k] = yk_ball_add(J[k], direction);
        if (turns) J[turning] = yk_ball_add(J[turning], yk_ball_mul(a, x[k]));
    }
    for (size_t k = 0; J && inverse && k < shape->angles; k++)
        J[k] = yk_ball_negate(yk_ball_mul(J[k], yk_ball_mul(w[k], w[k])));
    return sum;
}

// Makes discs about x of a relative radius, and their inverses.
static void discs_about(const Proof *p, double radius, YkBall *x, YkBall *w)
{
    for (size_t k = 0; k < p->shape->unknowns; k++)
        x[k] = yk_ball(p->x[k], YK_BALL_OUT(radius * p->size[k] + p->spread[k]));
    for (size_t k = 0; k < p->shape->angles; k++)
        w[k] = p->shape->relations == 0
                   ? yk_ball_inverse(x[k])
                   : yk_ball(yk_unit(x[k].at.x), YK_BALL_OUT(x[k].radius + 1e-15 + 4e-16 * fabs(x[k].at.x)));
}

static bool invert_jacobian(Proof *p)
{
    YkVec F[N_MAX], J[N_MAX * N_MAX], column[N_MAX];
    int pivot[N_MAX];
    size_t n = p->shape->unknowns;
    yk_system_evaluate(p->shape, p->coefficients, p->x, F, J);
    if (!yk_complex_factor(n, J, pivot)) return false;
    for (size_t j = 0; j < n; j++) {
        for (size_t k = 0; k < n; k++) column[k] = yk_vec(k == j, 0);
        yk_complex_solve(n, J, pivot, column);
        for (size_t k = 0; k < n; k++) p->Y[k * n + j] = column[k];
    }
    return true;
}

// Bounds the Newton step at x itself.
static void bound_miss(Proof *p)
{
    YkBall x[N_MAX], w[N_MAX], F[N_MAX];
    size_t n = p->shape->unknowns;
    discs_about(p, 0, x, w);
    for (size_t row = 0; row < n; row++) F[row] = row_at(p, row, x, w, NULL);
    for (size_t k = 0; k < n; k++) {
        YkBall sum = {{0, 0}, 0};
        for (size_t j = 0; j < n; j++) sum = yk_ball_add(sum, yk_ball_mul(yk_ball(p->Y[k * n + j], 0), F[j]));
        p->miss[k] = yk_ball_most(sum);
    }
}

// Returns how far Krawczyk's operator maps the polydisc from x, relative to the sizes; infinity for not a number.
static double image_of(const Proof *p, double radius)
{
    YkBall x[N_MAX], w[N_MAX], J[N_MAX * N_MAX];
    size_t n = p->shape->unknowns;
    double most = 0;
    discs_about(p, radius, x, w);
    for (size_t row = 0; row < n; row++) row_at(p, row, x, w, J + row * n);
    for (size_t k = 0; k < n; k++) {
        double sum = p->miss[k];
        for (size_t j = 0; j < n; j++) {
            YkBall entry = {{k == j ? -1 : 0, 0}, 0};
            for (size_t i = 0; i < n; i++)
                entry = yk_ball_add(entry, yk_ball_mul(yk_ball(p->Y[k * n + i], 0), J[i * n + j]));
            sum = YK_BALL_OUT(sum + yk_ball_most(entry) * YK_BALL_OUT(radius * p->size[j]));
        }
        double part = YK_BALL_OUT(sum / p->size[k]);
        if (!(part <= most)) most = part < INFINITY ? part : INFINITY;
    }
    return most;
}

// Returns whether x is near its own conjugate; moves it there if so.
static bool make_real(const YkShape *shape, YkVec *x)
{
    const double near = 1e-7;
    for (size_t k = 0; k < shape->unknowns; k++) {
        double off = k < shape->angles ? fabs(yk_norm(x[k]) - 1) : fabs(x[k].y) / fmax(1, fabs(x[k].x));
        if (!(off < near)) return false;
    }
    for (size_t k = 0; k < shape->unknowns; k++)
        x[k] = k < shape->angles ? yk_scale(1 / yk_norm(x[k]), x[k]) : yk_vec(x[k].x, 0);
    return true;
}

// Returns whether the polydisc holds no real point: some |z| is not 1, or some distance is not real.
static bool avoids_reals(const Proof *p, double within)
{
    for (size_t k = 0; k < p->shape->unknowns; k++) {
        double off = k < p->shape->angles ? fabs(yk_norm(p->x[k]) - 1) : fabs(p->x[k].y);
        if (off > YK_BALL_OUT(within * p->size[k]) + 1e-14) return true;
    }
    return false;
}

bool yk_certify(const YkShape *shape, const YkVec *coefficients, YkVec *x, YkCertificate *certificate)
{
    static const double radii[] = {1e-6, 1e-8, 1e-10, 3e-12, 2e-13};
    Proof p = {.shape = shape, .coefficients = coefficients, .x = x};
    bool looks_real = make_real(shape, x), is_proved = false;
    for (size_t k = 0; k < shape->unknowns; k++) p.size[k] = yk_unknown_size(shape, x, k);
    if (!invert_jacobian(&p)) return false;
    bound_miss(&p);
    for (size_t r = 0; r < sizeof radii / sizeof *radii; r++) {
        double image = image_of(&p, radii[r]);
        if (!(image < radii[r])) continue;
        // Conjugation moves a point of the image by twice its distance from x, and by the rounding of |z| = 1, at most.
        bool is_real = looks_real && 3 * image + 1e-14 < radii[r];
        if (is_proved && !is_real) continue;
        *certificate = (YkCertificate){radii[r], image, YK_REALITY_UNKNOWN};
        certificate->reality = is_real ? YK_REAL : avoids_reals(&p, image) ? YK_NOT_REAL : YK_REALITY_UNKNOWN;
        is_proved = true;
        if (certificate->reality != YK_REALITY_UNKNOWN) break; // otherwise a smaller polydisc may decide
    }
    return is_proved;
}

bool yk_enclose(const YkShape *shape, const YkVec *coefficients, const double *radii, const YkVec *x,
                YkCertificate *certificate)
{
    static const double times[] = {1.3, 2, 4};
    double miss = 1e-15;
    Proof p = {.shape = shape, .coefficients = coefficients, .radii = radii, .x = x};
    for (size_t k = 0; k < shape->unknowns; k++) p.size[k] = yk_unknown_size(shape, x, k);
    if (!invert_jacobian(&p)) return false;
    bound_miss(&p);
    for (size_t k = 0; k < shape->unknowns; k++) miss = fmax(miss, p.miss[k] / p.size[k]);
    for (size_t r = 0; r < sizeof times / sizeof *times; r++) {
        double radius = times[r] * miss, image = radius < 0.5 ? image_of(&p, radius) : INFINITY;
        if (!(image < radius)) continue;
        *certificate = (YkCertificate){radius, image, YK_REALITY_UNKNOWN};
        return true;
    }
    return false;
}

// Bounds Y (F_u + J c): how fast the path leaves the line x + c t, for all points within `radius` of it.
static void bound_drift(const Proof *p, const Proof *rates, const YkVec *c, double radius, double *drift)
{
    YkBall x[N_MAX], w[N_MAX], row[N_MAX], J[N_MAX];
    size_t n = p->shape->unknowns;
    discs_about(p, radius, x, w);
    for (size_t i = 0; i < n; i++) {
        row[i] = row_at(rates, i, x, w, NULL);
        row_at(p, i, x, w, J);
        for (size_t k = 0; k < n; k++) row[i] = yk_ball_add(row[i], yk_ball_mul(J[k], yk_ball(c[k], 0)));
    }
    for (size_t k = 0; k < n; k++) {
        YkBall sum = {{0, 0}, 0};
        for (size_t i = 0; i < n; i++) sum = yk_ball_add(sum, yk_ball_mul(yk_ball(p->Y[k * n + i], 0), row[i]));
        drift[k] = yk_ball_most(sum);
    }
}

// Computes c = -Y F_u at x.
static void read_rate(const Proof *p, const Proof *rates, YkVec *c)
{
    YkVec F[N_MAX];
    size_t n = p->shape->unknowns;
    yk_system_evaluate(p->shape, rates->coefficients, p->x, F, NULL);
    for (size_t k = 0; k < n; k++) {
        c[k] = yk_vec(0, 0);
        for (size_t i = 0; i < n; i++) c[k] = yk_sub(c[k], yk_mul(p->Y[k * n + i], F[i]));
    }
}

bool yk_enclose_path(const YkShape *shape, const YkPathDiscs *path, const YkVec *x, YkPathCertificate *certificate)
{
    static const double times[] = {1.3, 2, 4};
    double drift[N_MAX], least = 1e-15;
    size_t n = shape->unknowns;
    Proof p = {.shape = shape, .coefficients = path->middle, .radii = path->middle_radius, .x = x};
    Proof rates = {.shape = shape, .coefficients = path->rate, .radii = path->rate_radius, .x = x, .is_rate = true};
    for (size_t k = 0; k < n; k++) p.size[k] = yk_unknown_size(shape, x, k);
    if (!invert_jacobian(&p)) return false;
    bound_miss(&p);
    read_rate(&p, &rates, certificate->rate);
    p.coefficients = path->whole;
    p.radii = path->whole_radius;
    for (size_t k = 0; k < n; k++) p.spread[k] = YK_BALL_OUT(yk_sum_norm(certificate->rate[k]) * path->half);
    bound_drift(&p, &rates, certificate->rate, 0, drift);
    for (size_t k = 0; k < n; k++) {
        p.miss[k] = YK_BALL_OUT(p.miss[k] + YK_BALL_OUT(drift[k] * path->half));
        least = fmax(least, p.miss[k] / p.size[k]);
    }
    for (size_t r = 0; r < sizeof times / sizeof *times; r++) {
        double radius = times[r] * least, image = radius < 0.5 ? image_of(&p, radius) : INFINITY, most = 0;
        if (!(image < 0.95 * radius)) continue;
        bound_drift(&p, &rates, certificate->rate, radius, drift);
        for (size_t k = 0; k < n; k++) most = fmax(most, drift[k] / p.size[k]);
        certificate->at = (YkCertificate){radius, image, YK_REALITY_UNKNOWN};
        certificate->rate_within = YK_BALL_OUT(most / (1 - image / radius) * (1 + 0x1p-40));
        return true;
    }
    return false;
}

bool yk_are_distinct(const YkShape *shape, const YkVec *x, const YkCertificate *of_x, const YkVec *y,
                     const YkCertificate *of_y)
{
    for (size_t k = 0; k < shape->unknowns; k++) {
        double off = fmax(fabs(x[k].x - y[k].x), fabs(x[k].y - y[k].y)) * (1 - 0x1p-48);
        if (off >
            YK_BALL_OUT(of_x->within * yk_unknown_size(shape, x, k) + of_y->within * yk_unknown_size(shape, y, k)))
            return true;
    }
    return false;
}

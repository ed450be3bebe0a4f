// Proves real solutions over intervals.
#include "map/tube.h"
#include <string.h>
#include "configurations/certify.h"
#include "num/dense.h"

enum { N = YK_PIECE_UNKNOWNS, LOOPS = YK_SYSTEM_LOOPS_MAX, NEWTON_MAX = 6 };
static const double ROUNDING = 1e-14; // relative: more than products and sums of this size lose
static const double STILL = 1e-8;     // after such a step the next one would be below rounding

// The factor beside a coefficient: a unit vector, a distance along one, or 1. Over the interval it is at + t rate, no
// farther off than `rest` on the line, and than `reach` more for each unit of the tube's radius.
typedef struct Factor {
    YkVec at, rate;
    double rest, reach;
} Factor;

// A sum of coefficients times factors, in the same terms; and by how much its derivative by t alone varies.
typedef struct Sum {
    YkVec at, rate;
    double rest, reach, drift, drift_reach;
    double along; // how far `rate` leads over the interval
} Sum;

typedef struct Proof {
    const YkPiece *piece;
    const YkDiscCoefficients *middle, *over;
    double half;
    size_t n, loops;
    double size[N], Y[N * N];
    double weight[N][LOOPS]; // [k][l]: |(Y[k][2 l], Y[k][2 l + 1])|
    Sum F[LOOPS], J[LOOPS][N];
} Proof;

// Returns an upper bound of a length; squares that underflow are below what is added.
static double length_of(YkVec a)
{
    return sqrt(yk_dot(a, a)) * (1 + 0x1p-48) + 0x1p-500;
}

static double size_of(const YkPiece *piece, const YkTube *tube, size_t k)
{
    double d = fabs(tube->x[k].x);
    return k < piece->shape.angles || d < 1 ? 1 : d;
}

// --- the system

static Factor mono_of(const YkShape *shape, const YkTube *tube, double h, size_t k, const double *size)
{
    double rate = tube->rate[k], bend = 0.5 * h * h * rate * rate;
    if (k < shape->angles) return (Factor){tube->x[k], yk_scale(rate, yk_quarter(tube->x[k])), bend, 1};
    double d = tube->x[k].x, most = fabs(d) + h * fabs(rate);
    int turning = shape->turning[k];
    if (turning < 0) return (Factor){yk_vec(d, 0), yk_vec(rate, 0), 0, size[k]};
    YkVec z = tube->x[turning];
    double w = tube->rate[turning];
    return (Factor){yk_scale(d, z), yk_add(yk_scale(rate, z), yk_scale(d * w, yk_quarter(z))),
                    h * h * fabs(rate * w) + most * 0.5 * h * h * w * w, most + size[k]};
}

// Adds coefficient k of a loop times a factor.
static void add_product(const Proof *p, size_t loop, size_t k, Factor f, Sum *sum)
{
    size_t at = loop * (p->n + 1) + k;
    double h = p->half, off = p->middle->radius[at], slack = p->over ? p->over->rate_radius[at] : 0;
    YkVec a = p->middle->at[at], b = p->over ? p->over->rate[at] : yk_vec(0, 0);
    if (off == 0 && slack == 0) return; // absent
    double A = length_of(a), B = length_of(b), P = length_of(f.at), Q = length_of(f.rate), all = P + h * Q + f.rest;
    sum->at = yk_add_product(sum->at, a, f.at);
    sum->rate = yk_add_product(yk_add_product(sum->rate, b, f.at), a, f.rate);
    sum->rest +=
        (off + h * slack) * all + (A + h * B) * f.rest + h * h * B * Q + ROUNDING * (A * P + h * (B * P + A * Q));
    sum->reach += (A + h * B + off + h * slack) * f.reach;
    sum->drift += slack * all + B * (h * Q + f.rest) + ROUNDING * (B * P);
    sum->drift_reach += (B + slack) * f.reach;
}

// Ends a sum: with what its use in products loses.
static void finish(const Proof *p, Sum *sum)
{
    double rate = length_of(sum->rate);
    sum->along = p->half * rate;
    sum->rest += ROUNDING * (length_of(sum->at) + sum->along);
    sum->drift += ROUNDING * rate;
}

static void turn_sum(Sum *sum) // by a quarter: the derivative of e^(i angle) is i times it
{
    sum->at = yk_quarter(sum->at);
    sum->rate = yk_quarter(sum->rate);
}

// Sums the loops and their derivatives by the unknowns, over the interval of the proof.
static void evaluate(Proof *p, const YkTube *tube)
{
    const YkShape *shape = &p->piece->shape;
    const Factor one = {{1, 0}, {0, 0}, 0, 0};
    Factor mono[N];
    for (size_t k = 0; k < p->n; k++) mono[k] = mono_of(shape, tube, p->half, k, p->size);
    for (size_t l = 0; l < p->loops; l++) {
        memset(&p->F[l], 0, sizeof p->F[l]);
        memset(p->J[l], 0, p->n * sizeof *p->J[l]);
        add_product(p, l, p->n, one, &p->F[l]);
        for (size_t k = 0; k < p->n; k++) {
            int turning = shape->turning[k];
            add_product(p, l, k, mono[k], &p->F[l]);
            if (k < shape->angles) add_product(p, l, k, mono[k], &p->J[l][k]);
            if (k >= shape->angles) add_product(p, l, k, turning < 0 ? one : mono[turning], &p->J[l][k]);
            if (turning >= 0) add_product(p, l, k, mono[k], &p->J[l][turning]);
        }
        for (size_t k = 0; k < shape->angles; k++) turn_sum(&p->J[l][k]);
        for (size_t k = 0; k < p->n; k++) finish(p, &p->J[l][k]);
        finish(p, &p->F[l]);
    }
}

static void fill_matrix(const Proof *p, double *matrix)
{
    for (size_t l = 0; l < p->loops; l++)
        for (size_t k = 0; k < p->n; k++) {
            matrix[2 * l * p->n + k] = p->J[l][k].at.x;
            matrix[(2 * l + 1) * p->n + k] = p->J[l][k].at.y;
        }
}

// Applies Y to a vector for each loop, row k.
static double times(const Proof *p, size_t k, size_t l, YkVec v)
{
    return p->Y[k * p->n + 2 * l] * v.x + p->Y[k * p->n + 2 * l + 1] * v.y;
}

// --- the solution in the middle

static void change(const YkShape *shape, YkTube *tube, const double *step)
{
    for (size_t k = 0; k < shape->angles; k++) {
        YkVec z = yk_mul(tube->x[k], yk_unit(step[k]));
        tube->x[k] = yk_scale(1 / yk_norm(z), z);
    }
    for (size_t k = shape->angles; k < shape->unknowns; k++) tube->x[k] = yk_vec(tube->x[k].x + step[k], 0);
}

// Sums the loops in the middle alone, without bounds; J may be NULL.
static void evaluate_middle(const Proof *p, const YkTube *tube, double *F, double *J)
{
    const YkShape *shape = &p->piece->shape;
    size_t n = p->n;
    for (size_t l = 0; l < p->loops; l++) {
        const YkVec *a = p->middle->at + l * (n + 1);
        YkVec sum = a[n], slope[N] = {{0, 0}};
        for (size_t k = 0; k < n; k++) {
            int turning = shape->turning[k];
            YkVec direction = k < shape->angles || turning < 0 ? a[k] : yk_mul(a[k], tube->x[turning]);
            YkVec product = yk_mul(direction, tube->x[k]);
            sum = yk_add(sum, product);
            slope[k] = yk_add(slope[k], k < shape->angles ? yk_quarter(product) : direction);
            if (turning >= 0) slope[turning] = yk_add(slope[turning], yk_quarter(product));
        }
        F[2 * l] = -sum.x;
        F[2 * l + 1] = -sum.y;
        for (size_t k = 0; k < n; k++) {
            J[2 * l * n + k] = slope[k].x;
            J[(2 * l + 1) * n + k] = slope[k].y;
        }
    }
}

static bool find_solution(const Proof *p, YkTube *tube)
{
    const YkShape *shape = &p->piece->shape;
    double J[N * N], step[N], scale[N];
    int pivot[N];
    for (size_t k = 0; k < p->n; k++) {
        double length = yk_norm(tube->x[k]);
        if (!(length > 0.1 && length < 1e6) && k < shape->angles) return false;
        tube->x[k] = k < shape->angles ? yk_scale(1 / length, tube->x[k]) : yk_vec(tube->x[k].x, 0);
    }
    for (int trial = 0; trial < NEWTON_MAX; trial++) {
        double most = 0;
        evaluate_middle(p, tube, step, J);
        if (yk_lu_factor(p->n, J, pivot, scale) == 0) return false;
        yk_lu_solve(p->n, J, pivot, step);
        for (size_t k = 0; k < p->n; k++)
            if (!(fabs(step[k]) <= most) && !isnan(most)) most = fabs(step[k]); // NaN stays
        if (!(most < 1)) return false;
        change(shape, tube, step);
        if (most < STILL) break;
    }
    return true;
}

// --- the proof

static bool invert(Proof *p)
{
    double J[N * N], column[N], scale[N];
    int pivot[N];
    fill_matrix(p, J);
    if (yk_lu_factor(p->n, J, pivot, scale) == 0) return false;
    for (size_t j = 0; j < p->n; j++) {
        memset(column, 0, sizeof column);
        column[j] = 1;
        yk_lu_solve(p->n, J, pivot, column);
        for (size_t k = 0; k < p->n; k++) p->Y[k * p->n + j] = column[k];
    }
    for (size_t k = 0; k < p->n; k++)
        for (size_t l = 0; l < p->loops; l++)
            p->weight[k][l] = length_of(yk_vec(p->Y[k * p->n + 2 * l], p->Y[k * p->n + 2 * l + 1]));
    return true;
}

// The operator's image of a tube of radius r: |x - line| <= miss + (a + b r) r, in row k.
typedef struct Bounds {
    double miss[N], a[N], b[N];
    double drift[N], drift_reach[N]; // of Y (F_t + J rate)
} Bounds;

static void bound_row(const Proof *p, const YkTube *tube, size_t k, Bounds *out)
{
    double h = p->half, value = 0, slope = 0, rest = 0, a = 0, b = 0, drift = 0, drift_reach = 0;
    for (size_t l = 0; l < p->loops; l++) {
        const Sum *F = &p->F[l];
        double w = p->weight[k][l];
        value += times(p, k, l, F->at);
        slope += times(p, k, l, F->rate);
        rest += w * F->rest;
        drift += w * F->drift;
        drift_reach += w * F->drift_reach;
    }
    for (size_t j = 0; j < p->n; j++) {
        double entry = k == j ? -1 : 0, turn = 0, off = 0, reach = 0, speed = fabs(tube->rate[j]);
        for (size_t l = 0; l < p->loops; l++) {
            const Sum *J = &p->J[l][j];
            double w = p->weight[k][l];
            entry += times(p, k, l, J->at);
            turn += times(p, k, l, J->rate);
            off += w * J->rest;
            reach += w * J->reach;
            drift += w * (J->along + J->rest) * speed;
            drift_reach += w * J->reach * speed;
        }
        a += (fabs(entry) + h * fabs(turn) + off) * p->size[j];
        b += reach * p->size[j];
    }
    out->miss[k] = (fabs(value) + h * fabs(slope) + rest) * (1 + 1e-12);
    out->a[k] = a * (1 + 1e-12);
    out->b[k] = b * (1 + 1e-12);
    out->drift[k] = (fabs(slope) + drift) * (1 + 1e-12);
    out->drift_reach[k] = drift_reach * (1 + 1e-12);
}

// Returns how far the image of a tube of radius r is from the line, over the sizes.
static double image_of(const Proof *p, const Bounds *bounds, double r)
{
    double most = 0;
    for (size_t k = 0; k < p->n; k++) {
        double part = YK_BALL_OUT(bounds->miss[k] + (bounds->a[k] + bounds->b[k] * r) * r) / p->size[k];
        if (!(part <= most) && !isnan(most)) most = part; // NaN stays
    }
    return YK_BALL_OUT(most);
}

static bool find_radii(const Proof *p, const Bounds *bounds, YkTube *tube)
{
    double least = 1e-15;
    for (size_t k = 0; k < p->n; k++) least = fmax(least, bounds->miss[k] / p->size[k]);
    tube->radius = 0;
    bool is_point = p->half == 0; // alone in as large a ball as it takes to compare poses
    for (double r = 1.25 * least; r < 0.25 && (r < 1e4 * least || is_point);
         r *= is_point && tube->radius > 0 ? 16 : 1.6) {
        double image = image_of(p, bounds, r);
        if (!(image < 0.95 * r)) {
            if (tube->radius > 0) break;
            continue;
        }
        if (tube->radius == 0) tube->within = image;
        tube->radius = r;
    }
    return tube->radius > 0;
}

static void bound_rate(const Proof *p, const Bounds *bounds, YkTube *tube)
{
    double most = 0, contraction = 0, r = tube->within;
    for (size_t k = 0; k < p->n; k++) {
        most = fmax(most, (bounds->drift[k] + bounds->drift_reach[k] * r) / p->size[k]);
        contraction = fmax(contraction, (bounds->a[k] + bounds->b[k] * r) / p->size[k]);
    }
    tube->rate_within = contraction < 1 ? YK_BALL_OUT(most / (1 - contraction)) * (1 + 1e-12) : INFINITY;
}

bool yk_tube_make(const YkPiece *piece, const YkDiscCoefficients *middle, const YkDiscCoefficients *over, double half,
                  YkTube *tube)
{
    Proof p = {.piece = piece, .middle = middle, .half = 0};
    Bounds bounds;
    p.n = piece->shape.unknowns;
    p.loops = piece->shape.loops;
    memset(tube->rate, 0, sizeof tube->rate);
    tube->half = half;
    if (!find_solution(&p, tube)) return false;
    for (size_t k = 0; k < p.n; k++) p.size[k] = size_of(piece, tube, k);
    p.over = over;
    p.half = over ? half : 0;
    evaluate(&p, tube); // at rate 0: the values, and F by t
    if (!invert(&p)) return false;
    for (size_t k = 0; over && k < p.n; k++)
        for (size_t l = 0; l < p.loops; l++) tube->rate[k] -= times(&p, k, l, p.F[l].rate);
    if (over) evaluate(&p, tube);
    for (size_t k = 0; k < p.n; k++) bound_row(&p, tube, k, &bounds);
    if (!find_radii(&p, &bounds, tube)) return false;
    bound_rate(&p, &bounds, tube);
    return true;
}

// --- what is in it

void yk_tube_at(const YkPiece *piece, const YkTube *tube, double at, YkVec *x)
{
    double t = at - tube->middle;
    for (size_t k = 0; k < piece->shape.unknowns; k++)
        x[k] = k < piece->shape.angles ? yk_mul(tube->x[k], yk_unit(t * tube->rate[k]))
                                       : yk_vec(tube->x[k].x + t * tube->rate[k], 0);
}

// Returns how far unknown k of a pose is from the line: bounds from below and above.
static double off_line(const YkPiece *piece, const YkVec *line, const YkVec *x, size_t k, double *most)
{
    if (k >= piece->shape.angles) {
        *most = fabs(x[k].x - line[k].x) + 1e-14 * (1 + fabs(line[k].x));
        return fabs(x[k].x - line[k].x) - 1e-14 * (1 + fabs(line[k].x));
    }
    YkVec turn = yk_mul(yk_conj(line[k]), x[k]);
    double sine = fabs(turn.y);
    *most = turn.x > 0.7 ? 1.12 * sine + 1e-14 : INFINITY; // arc sine x < 1.12 x below 0.72
    return turn.x < 0 ? 1 : sine - 1e-14;
}

bool yk_tube_contains(const YkPiece *piece, const YkTube *tube, double at, const YkVec *x, double within)
{
    YkVec line[N];
    yk_tube_at(piece, tube, at, line);
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        double size = size_of(piece, tube, k), most;
        off_line(piece, line, x, k, &most);
        if (!(YK_BALL_OUT(most + within * fmax(size, fabs(x[k].x))) < tube->radius * size)) return false;
    }
    return true;
}

bool yk_tube_excludes(const YkPiece *piece, const YkTube *tube, double at, const YkVec *x, double within)
{
    YkVec line[N];
    yk_tube_at(piece, tube, at, line);
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        double size = size_of(piece, tube, k), most;
        if (off_line(piece, line, x, k, &most) > YK_BALL_OUT((tube->within + within) * fmax(size, fabs(x[k].x))))
            return true;
    }
    return false;
}

void yk_tube_place(const YkPiece *piece, const YkTube *tube, YkDiscs *discs)
{
    YkDual known[N];
    double h = tube->half;
    for (size_t k = 0; k < piece->shape.unknowns; k++) {
        double size = size_of(piece, tube, k), rate = tube->rate[k], way = fabs(rate) * h, off = tube->within * size;
        if (k < piece->shape.angles) {
            known[k].at = yk_ball(tube->x[k], YK_BALL_OUT(way + off + 1e-15));
            known[k].rate =
                yk_ball(yk_scale(rate, yk_quarter(tube->x[k])),
                        YK_BALL_OUT(tube->rate_within * size + (fabs(rate) + tube->rate_within) * (way + off)));
        } else {
            known[k].at = yk_real_disc(tube->x[k].x, YK_BALL_OUT(way + off));
            known[k].rate = yk_real_disc(rate, YK_BALL_OUT(tube->rate_within * size));
        }
    }
    yk_discs_place(discs, piece, known);
}

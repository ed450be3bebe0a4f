// Linearises the equations at an equilibrium, and finds their modes.
#include <string.h>
#include "elementary/elementary.h"
#include "loads/point.h"
#include "num/eigen.h"
#include "rest/rest.h"

static const double NOISE = 1e-12; // of the loads, over inertia and a radian or the machine's size

enum { REDUCE = 20 }; // work of forces and inertia, for each step and each pair of freedoms

bool yk_rest_accelerations(YkRest *rest, const double *q, const double *rates, double *a)
{
    YkState *s = rest->state;
    for (size_t k = 0; k < rest->freedom; k++)
        yk_state_set_input(s, (size_t)rest->input[k], (YkMotion){q[k], rates ? rates[k] : 0, 0});
    if (!yk_pace_spend(rest->pace, REDUCE * (s->mech->step_count + rest->freedom * rest->freedom + 1))) return false;
    YkStatus status = yk_dynamics_reduce(rest->dynamics, s);
    if (status < 0 || status == YK_SINGULAR) return false;
    for (size_t k = 0; k < rest->freedom; k++) a[k] = rest->dynamics->acceleration[rest->input[k]];
    return true;
}

// Returns the step of the differences in units of the inputs, with the state at their middle: beside a limit all
// changes with the square root of the distance to it, which is in proportion to the margin.
static double step_here(const YkState *s)
{
    return fmin(1e-3, fmax(1e-9, 0.01 * s->space.margin[0]));
}

// Differentiates by differences of four accelerations, `unit` times an input's scale apart.
static bool differences(YkRest *rest, const double *q, bool of_rates, double unit, double *matrix)
{
    static const double weight[] = {1.0 / 12, -2.0 / 3, 2.0 / 3, -1.0 / 12}; // at -2h, -h, h, 2h
    static const int place[] = {-2, -1, 1, 2};
    size_t f = rest->freedom;
    double *x = rest->trial, *a = rest->step;
    memset(matrix, 0, f * f * sizeof *matrix);
    for (size_t j = 0; j < f; j++) {
        double h = unit * rest->scale[j];
        for (int p = 0; p < 4; p++) {
            for (size_t k = 0; k < f; k++) x[k] = of_rates ? 0 : q[k];
            x[j] += place[p] * h;
            if (!yk_rest_accelerations(rest, of_rates ? q : x, of_rates ? x : NULL, a)) return false;
            for (size_t i = 0; i < f; i++) matrix[i * f + j] += weight[p] / h * a[i];
        }
    }
    return true;
}

// The scale of an input is the machine's size, and a limit may be much nearer than that: then the step is shortened
// until both of its ends close.
static bool differences_within(YkRest *rest, const double *q, double *unit, double *matrix)
{
    for (int k = 0; k < 8; k++, *unit /= 8)
        if (differences(rest, q, false, *unit, matrix)) return true;
    return false;
}

bool yk_rest_differentiate(YkRest *rest, const double *q, double *matrix)
{
    double unit = step_here(rest->state);
    return differences_within(rest, q, &unit, matrix);
}

// Returns the largest entry of A - B, of A alone where B is NULL, in units of the inputs.
static double distance(const YkRest *rest, const double *A, const double *B)
{
    size_t f = rest->freedom;
    double largest = 0;
    for (size_t i = 0; i < f; i++)
        for (size_t j = 0; j < f; j++) {
            double unit = rest->scale[j] / rest->scale[i];
            largest = fmax(largest, unit * fabs(A[i * f + j] - (B ? B[i * f + j] : 0)));
        }
    return largest;
}

// Returns the largest difference of two matrices of derivatives, over the largest entry; both in units of the inputs.
static double gap_of(const YkRest *rest, const double *A, const double *B)
{
    double size = distance(rest, B, NULL);
    return size > 0 ? distance(rest, A, B) / size : 0;
}

// Differentiates by position at rest->q. Takes ever shorter steps until two in a row agree, or until rounding parts
// them again; `finer` is room for another matrix. Finds by how much they differ then, over the largest entry.
static bool differentiate_finely(YkRest *rest, double *matrix, double *finer, double *gap)
{
    size_t f = rest->freedom;
    double unit = step_here(rest->state), last = HUGE_VAL;
    *gap = 0;
    if (!differences_within(rest, rest->q, &unit, matrix)) return false;
    for (int k = 0; k < 8; k++) {
        if (!differences(rest, rest->q, false, unit /= 4, finer)) return true; // the last one stands
        *gap = gap_of(rest, matrix, finer);
        if (*gap <= 1e-9 || *gap >= last) return true; // the finer one has more rounding
        memcpy(matrix, finer, f * f * sizeof *matrix);
        last = *gap;
    }
    return true;
}

// Differentiates by rates at rest->q, where accelerations are quadratic in them unless a load has a corner at rest, as
// a drag by rate*abs(rate) has, or changes within small rates. Then takes ever shorter steps, removes what is in
// proportion to the step, and keeps the matrix that agrees best with the one before. `size` is that of rates of change
// here.
static bool differentiate_by_rates(YkRest *rest, double size, double *matrix)
{
    enum { SHORTENED = 10 };
    size_t entries = rest->freedom * rest->freedom;
    double *coarse = YK_NEW(rest->arena, double, entries), *fine = YK_NEW(rest->arena, double, entries);
    double *limit = YK_NEW(rest->arena, double, entries), *last = YK_NEW(rest->arena, double, entries);
    double unit = size > 0 ? 1e-3 * size : 1e-3, best = HUGE_VAL;
    if (!coarse || !fine || !limit || !last || !differences(rest, rest->q, true, unit, matrix)) return false;
    memcpy(coarse, matrix, entries * sizeof *coarse);
    for (int k = 0; k < SHORTENED && best > 1e-9; k++) {
        if (!differences(rest, rest->q, true, unit /= 4, fine)) return false;
        if (k == 0 && distance(rest, coarse, fine) <= 1e-9 * fmax(size, distance(rest, fine, NULL))) return true;
        for (size_t i = 0; i < entries; i++) limit[i] = fine[i] + (fine[i] - coarse[i]) / 3;
        double gap = k > 0 ? distance(rest, limit, last) / fmax(size, distance(rest, limit, NULL)) : HUGE_VAL;
        if (k == 0 || gap < best) memcpy(matrix, limit, entries * sizeof *matrix), best = gap;
        memcpy(last, limit, entries * sizeof *last);
        memcpy(coarse, fine, entries * sizeof *coarse);
    }
    return true;
}

// Finds the kinetic energy at rest->q of the inputs i and j moving, each by its scale in a second.
static bool find_energy(YkRest *rest, size_t i, size_t j, double *energy)
{
    YkState *s = rest->state;
    if (!yk_pace_spend(rest->pace, REDUCE * (s->mech->step_count + 1))) return false;
    for (size_t k = 0; k < rest->freedom; k++) {
        double rate = k == i || k == j ? rest->scale[k] : 0;
        yk_state_set_input(s, (size_t)rest->input[k], (YkMotion){rest->q[k], rate, 0});
    }
    if (yk_state_solve(s) < 0 || !yk_state_has_rates(s)) return false;
    *energy = yk_dynamics_energy_at(rest->dynamics, s).kinetic;
    return true;
}

// Returns the power that a spring has in the least favourable direction of its pull: that of a spring which points
// nearly at a pin comes from levers far longer than the one that is left, and a pull from lengths.
static double most_power(const YkRest *rest, const YkLoadItem *spring)
{
    const double ROUNDED = 1e-3; // of the lengths that give the pull, over NOISE of the pull
    YkLoadPoint end[2];
    double speed = 0;
    for (int k = 0; k < 2; k++) {
        end[k] = yk_load_point(rest->mech, &rest->state->space, &spring->end[k]);
        YkVec turning = yk_scale(end[k].w, yk_quarter(end[k].arm)); // about the body's reference point
        speed += yk_norm(end[k].velocity) + yk_norm(yk_sub(end[k].velocity, turning));
    }
    double pull = fabs(yk_norm(yk_sub(end[1].at, end[0].at)) - spring->length);
    pull += ROUNDED * (yk_norm(end[0].at) + yk_norm(end[1].at) + fabs(spring->length) + rest->mech->size);
    return spring->stiffness * pull * speed;
}

// Returns the power of all loads, as the last energy had the bodies move, if none took any, and gravity and springs
// gave all that they may. 0 if one has no value.
static double power_of_loads(const YkRest *rest)
{
    const YkModel *model = rest->mech->model;
    YkDynamics *d = rest->dynamics;
    size_t culprit;
    double power = 0;
    memset(d->load, 0, model->body_count * sizeof *d->load);
    if (!yk_loads_add(d->loads, rest->state, &rest->state->space, d->load, d->power, &culprit)) return 0;
    for (size_t i = 0; i < d->loads->item_count; i++) {
        const YkLoadItem *item = &d->loads->items[i];
        power += fmax(fabs(d->power[i]), item->kind == YK_LOAD_SPRING ? most_power(rest, item) : 0);
    }
    for (size_t b = 0; b < model->body_count; b++) {
        YkVec velocity = yk_body_motion(rest->mech, &rest->state->space, b).velocity;
        power += model->bodies[b].mass * yk_norm(model->gravity) * yk_norm(velocity);
    }
    return power;
}

// Finds the kinetic energy of each input that moves alone, and rest->loads. Returns false if one has none.
static bool find_energies(YkRest *rest, double *own)
{
    rest->loads = 0;
    for (size_t i = 0; i < rest->freedom; i++) {
        if (!find_energy(rest, i, i, &own[i])) return false;
        if (own[i] > 0) rest->loads = fmax(rest->loads, power_of_loads(rest) / (2 * own[i]));
    }
    return true;
}

bool yk_rest_weigh_loads(YkRest *rest)
{
    return find_energies(rest, rest->trial) || !yk_pace_is_stopped(rest->pace);
}

// Finds M, whose form is twice the kinetic energy, and rest->loads.
static bool find_mass(YkRest *rest, double *mass)
{
    size_t f = rest->freedom;
    double *own = rest->trial, both;
    if (!find_energies(rest, own)) return false;
    for (size_t i = 0; i < f; i++) {
        mass[i * f + i] = 2 * own[i] / (rest->scale[i] * rest->scale[i]);
        for (size_t j = 0; j < i; j++) {
            if (!find_energy(rest, i, j, &both)) return false;
            mass[i * f + j] = mass[j * f + i] = (both - own[i] - own[j]) / (rest->scale[i] * rest->scale[j]);
        }
    }
    return true;
}

// Computes out = -M A.
static void times_mass(size_t f, const double *mass, const double *A, double *out)
{
    for (size_t i = 0; i < f; i++)
        for (size_t j = 0; j < f; j++) {
            double sum = 0;
            for (size_t k = 0; k < f; k++) sum -= mass[i * f + k] * A[k * f + j];
            out[i * f + j] = sum;
        }
}

// Factors M = L L^T; returns false if it is not positive definite.
static bool cholesky(size_t f, const double *mass, double *L)
{
    memset(L, 0, f * f * sizeof *L);
    for (size_t j = 0; j < f; j++)
        for (size_t i = j; i < f; i++) {
            double sum = mass[i * f + j];
            for (size_t k = 0; k < j; k++) sum -= L[i * f + k] * L[j * f + k];
            if (i == j && !(sum > 0)) return false;
            L[i * f + j] = i == j ? sqrt(sum) : sum / L[j * f + j];
        }
    return true;
}

// Computes L^-1 S L^-T, with S the symmetric part of K.
static void to_standard(size_t f, const double *L, const double *K, double *S)
{
    for (size_t i = 0; i < f; i++)
        for (size_t j = 0; j < f; j++) S[i * f + j] = 0.5 * (K[i * f + j] + K[j * f + i]);
    for (int side = 0; side < 2; side++) // rows, then (transposed) columns
        for (size_t c = 0; c < f; c++)
            for (size_t i = 0; i < f; i++) {
                double *x = side ? &S[c * f + i] : &S[i * f + c], sum = *x;
                for (size_t k = 0; k < i; k++) sum -= L[i * f + k] * (side ? S[c * f + k] : S[k * f + c]);
                *x = sum / L[i * f + i];
            }
}

static void find_shape(YkRestPoint *p, size_t f, size_t mode, const double *L, const double *vectors)
{
    double *shape = p->shape + mode * f, largest = 0, damping = 0, mass = 0;
    for (size_t i = f; i-- > 0;) { // L^T shape = vector
        double sum = vectors[mode * f + i];
        for (size_t k = i + 1; k < f; k++) sum -= L[k * f + i] * shape[k];
        shape[i] = sum / L[i * f + i];
    }
    for (size_t i = 0; i < f; i++) {
        if (fabs(shape[i]) > fabs(largest)) largest = shape[i];
        for (size_t j = 0; j < f; j++) {
            damping += shape[i] * p->damping[i * f + j] * shape[j];
            mass += shape[i] * p->mass[i * f + j] * shape[j];
        }
    }
    for (size_t i = 0; i < f; i++) shape[i] /= largest;
    double omega = fabs(p->frequency[mode]);
    p->ratio[mode] = omega > 0 ? damping / (2 * mass * omega) : 0;
}

// noise: what rounding leaves of the square of a frequency.
static bool find_modes(YkRest *rest, YkRestPoint *p, double noise)
{
    size_t f = rest->freedom;
    double *L = YK_NEW(rest->arena, double, f *f), *S = YK_NEW(rest->arena, double, f *f),
           *vectors = YK_NEW(rest->arena, double, f *f);
    if (!L || !S || !vectors || !cholesky(f, p->mass, L)) return false;
    to_standard(f, L, p->stiffness, S);
    if (!yk_eigen_symmetric(f, S, p->frequency, vectors)) return false;
    for (size_t k = 0; k < f; k++) {
        double square = fabs(p->frequency[k]) > noise ? p->frequency[k] : 0;
        p->frequency[k] = square < 0 ? -sqrt(-square) : sqrt(square);
        find_shape(p, f, k, L, vectors);
    }
    return true;
}

// Returns how many directions of the inputs meet no force: eigenvalues of the derivatives of the accelerations that are
// no more than noise. `real` and `imaginary` are room for them. SIZE_MAX when out of memory.
static size_t count_forceless(YkRest *rest, const double *by_position, double noise, double *real, double *imaginary)
{
    size_t f = rest->freedom, count = 0;
    double *A = YK_NEW(rest->arena, double, f *f);
    if (!A) return SIZE_MAX;
    memcpy(A, by_position, f * f * sizeof *A);
    if (!yk_eigen_general(f, A, real, imaginary)) return SIZE_MAX;
    for (size_t k = 0; k < f; k++) count += yk_hypot(real[k], imaginary[k]) <= noise;
    return count;
}

// Each direction without force has a root 0 and, without damping, a second one: rounding parts two that are alike by
// its own root.
static void clear_roots(const YkRest *rest, YkRestPoint *p, size_t forceless, double noise)
{
    size_t n = 2 * rest->freedom;
    for (size_t left = 2 * forceless; left > 0; left--) {
        size_t least = 0;
        double size = HUGE_VAL;
        for (size_t k = 0; k < n; k++) {
            double r = yk_hypot(p->real[k], p->imaginary[k]);
            if (r > 0 && r < size) size = r, least = k;
        }
        if (size <= 4 * sqrt(noise)) p->real[least] = p->imaginary[least] = 0;
    }
}

// Finds the roots of the damped motion: eigenvalues of [0 I; -M^-1 K, -M^-1 C], whose lower blocks are the derivatives
// themselves.
static bool find_roots(YkRest *rest, YkRestPoint *p, const double *by_position, const double *by_rate)
{
    size_t f = rest->freedom, n = 2 * f;
    double *A = YK_NEW(rest->arena, double, n *n);
    if (!A) return false;
    for (size_t i = 0; i < f; i++) {
        A[i * n + f + i] = 1;
        for (size_t j = 0; j < f; j++) {
            A[(f + i) * n + j] = by_position[i * f + j];
            A[(f + i) * n + f + j] = by_rate[i * f + j];
        }
    }
    return yk_eigen_general(n, A, p->real, p->imaginary);
}

// A motion grows if the square of its root differs from that of one that does not by more than noise.
static YkStability judge(const YkRest *rest, const YkRestPoint *p, size_t forceless, double noise)
{
    size_t n = 2 * rest->freedom;
    double size = 0;
    for (size_t k = 0; k < n; k++) size = fmax(size, yk_hypot(p->real[k], p->imaginary[k]));
    for (size_t k = 0; k < n; k++) {
        double r = yk_hypot(p->real[k], p->imaginary[k]);
        if (p->real[k] > 1e-10 * size && p->real[k] * r > noise) return YK_STABILITY_UNSTABLE;
    }
    return forceless > 0 || n == 0 ? YK_STABILITY_NEUTRAL : YK_STABILITY_STABLE;
}

bool yk_rest_beside(YkRest *rest, double h, double *a)
{
    for (int k = 0; k < 2; k++) {
        double x = rest->q[0] + (k ? h : -h) * rest->scale[0];
        if (!yk_rest_accelerations(rest, &x, NULL, &a[k])) return false;
    }
    return true;
}

// Judges a pose of a machine with one freedom that meets no force in proportion to the distance, by the first forces
// beside it that are more than rounding: they grow with a higher power.
static YkStability judge_beside(YkRest *rest, YkEquilibrium *at)
{
    double a[2], noise = 10 * NOISE * rest->force_scale * rest->scale[0];
    for (double h = 1e-4; h < 1 && yk_rest_beside(rest, h, a); h *= 10) {
        if (fmax(fabs(a[0]), fabs(a[1])) <= noise) continue;
        at->is_higher_order = true;
        if (a[0] > noise && a[1] < -noise) return YK_STABILITY_STABLE;
        return a[0] < -noise || a[1] > noise ? YK_STABILITY_UNSTABLE : YK_STABILITY_NEUTRAL;
    }
    return YK_STABILITY_NEUTRAL;
}

// Returns whether derivatives of hardly any size are rounding, beside which there is less force than they say, or only
// what a higher power leaves, beside which there is much more.
static bool is_rounding(YkRest *rest, double size)
{
    const double FLAT = 1e-7, BESIDE = 0.03;
    double scale = rest->force_scale;
    double *x = rest->trial, *a = rest->step, slope = 0;
    for (size_t j = 0; j < 2 * rest->freedom && size <= FLAT * scale; j++) {
        memcpy(x, rest->q, rest->freedom * sizeof *x);
        x[j / 2] += (j % 2 ? BESIDE : -BESIDE) * rest->scale[j / 2];
        if (!yk_rest_accelerations(rest, x, NULL, a)) return false;
        for (size_t i = 0; i < rest->freedom; i++) slope = fmax(slope, fabs(a[i]) / (BESIDE * rest->scale[i]));
    }
    return size <= FLAT * scale && (slope < 0.5 * size || size < 3e-8 * slope || slope * BESIDE < NOISE * scale);
}

// Returns whether a machine with one freedom rests on one side of the pose, as a gap in the loads lets it, and not on
// the other.
static bool is_edge(YkRest *rest)
{
    double a[2] = {0, 0}, most[2] = {0, 0}, noise = 10 * NOISE * rest->loads * rest->scale[0];
    for (double h = 1e-3; h < 2e-2; h *= 3) {
        if (!yk_rest_beside(rest, h, a)) return false;
        for (int k = 0; k < 2; k++) most[k] = fmax(most[k], fabs(a[k]));
    }
    return (most[0] <= noise) != (most[1] <= noise);
}

bool yk_rest_linearise(YkRest *rest, YkRestPoint *p)
{
    size_t f = rest->freedom;
    double *by_position = YK_NEW(rest->arena, double, f *f), *by_rate = YK_NEW(rest->arena, double, f *f), gap;
    if (!by_position || !by_rate || !find_mass(rest, p->mass)) return false;
    if (!differentiate_finely(rest, by_position, by_rate, &gap)) return false;
    double size = distance(rest, by_position, NULL), noise = fmax(10 * fmax(gap, 1e-15) * size, NOISE * rest->loads);
    bool ends = f == 1 && is_edge(rest), is_flat = ends || size <= noise || is_rounding(rest, size);
    if (!differentiate_by_rates(rest, sqrt(is_flat ? rest->loads : size), by_rate)) return false;
    if (is_flat) memset(by_position, 0, f * f * sizeof *by_position);
    times_mass(f, p->mass, by_position, p->stiffness);
    times_mass(f, p->mass, by_rate, p->damping);
    size_t forceless = count_forceless(rest, by_position, noise, p->real, p->imaginary);
    if (forceless == SIZE_MAX || !find_modes(rest, p, noise) || !find_roots(rest, p, by_position, by_rate))
        return false;
    p->is_continuous = forceless > 0;
    clear_roots(rest, p, forceless, noise);
    p->at.stability = judge(rest, p, forceless, noise);
    if (is_flat && !ends && f == 1 && p->at.stability == YK_STABILITY_NEUTRAL)
        p->at.stability = judge_beside(rest, &p->at);
    return true;
}

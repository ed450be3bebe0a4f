// Finds the freedom by rank, part by part. Counting is not enough when constraints repeat each other: only the Jacobian
// of the closed loops shows it. Source of the iteration: Levenberg 1944, Marquardt 1963, as least squares.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "compile/closure.h"
#include "compile/freedom_parts.h"
#include "num/dense.h"

typedef struct Work { // on one part; x holds all variables of the machine
    const YkMechanism *mech;
    const int32_t *variables, *loops, *relations, *column;
    const YkCandidates *wish;
    const double *told;     // [coordinate]: the guesses
    const int32_t *members; // the candidates of this part
    size_t member_count;
    size_t loop_count, m, n;
    double *x, *residual, *J, *A, *tau, *step, *old, *guess, *basis;
    double *scale;   // the factor by which each column of A was divided
    double *near[3]; // closed poses: the one found, and two that its free motions lead to
    double *judge;   // the pose to judge by: of the best rank, and one where the accepted inputs determine the motion
    double *kept;    // the same, for the attempt that counts
    bool is_closed;  // there is a closed pose
    bool is_given;   // the guesses close unchanged
    bool holds;      // loops are closed while the inputs that were counted keep their values
    const double *along; // or while the way along this motion does
    bool *other;         // [members] accepted at another pose
    bool *counted;       // [members] accepted by the caller
    size_t *order;
    uint64_t seed;
} Work;

// --- closing

static bool is_angle(const Work *w, size_t column)
{
    return (size_t)w->variables[column] < w->mech->orientation_count - 1;
}

static void save(const Work *w, double *to)
{
    for (size_t j = 0; j < w->n; j++) to[j] = w->x[w->variables[j]];
}
static void restore(Work *w, const double *from)
{
    for (size_t j = 0; j < w->n; j++) w->x[w->variables[j]] = from[j];
}

// Draws a number between -1 and 1.
static double draw(Work *w)
{
    w->seed = w->seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(w->seed >> 11) * 0x1p-52 - 1;
}

// Moves each variable by up to `by` radians, or `by` times the machine's size.
static void disturb(Work *w, double by)
{
    for (size_t j = 0; j < w->n; j++) w->x[w->variables[j]] += by * draw(w) * (is_angle(w, j) ? 1 : w->mech->size);
}

// Evaluates residuals over the size, in dimensionless variables: angles, and distances over the size. Returns their
// length.
static double evaluate(Work *w)
{
    double sum = 0, size = w->mech->size;
    memset(w->J, 0, w->m * w->n * sizeof *w->J);
    for (size_t l = 0; l < w->loop_count; l++)
        yk_closure_loop(w->mech, (size_t)w->loops[l], w->x, w->residual + 2 * l, w->J + 2 * l * w->n, w->n, w->column);
    for (size_t r = 2 * w->loop_count; r < w->m; r++)
        yk_closure_relation(w->mech, (size_t)w->relations[r - 2 * w->loop_count], w->x, w->residual + r,
                            w->J + r * w->n, w->column);
    for (size_t i = 0; i < w->m; i++) {
        w->residual[i] /= size;
        sum += w->residual[i] * w->residual[i];
        for (size_t j = 0; j < w->n; j++)
            if (is_angle(w, j)) w->J[i * w->n + j] /= size;
    }
    return sqrt(sum);
}

// Adds a coordinate's rate, times `by`, as a row of the unknowns.
static void add_rate(const Work *w, int32_t coordinate, double by, double *row)
{
    const YkTreeCoordinate *c = &w->mech->coordinates[coordinate];
    YkJointAngle angle = yk_joint_angle(w->mech, c->joint);
    if (c->is_distance) row[w->column[yk_coordinate_variable(w->mech, coordinate)]] += by;
    if (!c->is_distance && angle.b > 0) row[w->column[angle.b - 1]] += by;
    if (!c->is_distance && angle.a > 0) row[w->column[angle.a - 1]] -= by;
}

// Takes one Levenberg step: least squares of [J; mu I] step = [-r; 0]; while inputs are held, also with their rates 0.
static void damped_step(Work *w, double mu)
{
    const double heavy = 1e6;
    size_t rows = w->m + w->n, held = rows;
    memcpy(w->A, w->J, w->m * w->n * sizeof *w->A);
    memset(w->A + w->m * w->n, 0, 2 * w->n * w->n * sizeof *w->A);
    for (size_t j = 0; j < w->n; j++) w->A[(w->m + j) * w->n + j] = mu;
    for (size_t k = 0; k < w->member_count && w->holds && rows < held + w->n; k++)
        if (w->wish->accepted[w->members[k]]) add_rate(w, w->wish->items[w->members[k]], heavy, w->A + rows++ * w->n);
    for (size_t j = 0; j < w->n && w->along; j++) w->A[rows * w->n + j] = heavy * w->along[j];
    rows += w->along != NULL;
    double *b = w->residual + w->m;
    for (size_t i = 0; i < rows; i++) b[i] = i < w->m ? -w->residual[i] : 0;
    size_t rank = yk_qr_factor(rows, w->n, w->A, w->order, w->tau, 1e-14);
    yk_qr_solve(rows, w->n, w->A, w->order, w->tau, rank, b, w->step);
    for (size_t j = 0; j < w->n; j++) w->x[w->variables[j]] += w->step[j] * (is_angle(w, j) ? 1 : w->mech->size);
}

static bool close_loops(Work *w)
{
    double mu = 0.1, now = evaluate(w);
    for (int iteration = 0; iteration < 200 && now > 1e-13 && mu < 1e8; iteration++) {
        if (!yk_compile_goes_on(w->mech, (w->m + w->n) * w->n * w->n / 300)) return false;
        save(w, w->old);
        damped_step(w, mu);
        double then = evaluate(w);
        if (then < now) {
            now = then;
            mu *= 0.2;
        } else {
            restore(w, w->old);
            evaluate(w);
            mu = mu * 5 + 1e-12;
        }
    }
    return now <= 1e-10;
}

// --- rank

// Copies the Jacobian for its rank: each column divided by its length, so that short links count as much as long ones,
// and without the remainders of lengths that cancel up to rounding.
static void copy_jacobian(Work *w)
{
    const double shortest = 1e-6;
    size_t n = w->n;
    for (size_t j = 0; j < n; j++) {
        double sum = 0;
        for (size_t i = 0; i < w->m; i++) sum += w->J[i * n + j] * w->J[i * n + j];
        w->scale[j] = fmax(sqrt(sum), shortest);
    }
    for (size_t k = 0; k < w->m * n; k++) w->A[k] = fabs(w->J[k]) > YK_CLOSURE_ROUNDING ? w->J[k] / w->scale[k % n] : 0;
}

static size_t factor(Work *w)
{
    copy_jacobian(w);
    return yk_qr_factor(w->m, w->n, w->A, w->order, w->tau, 1e-9);
}

// Makes `v` orthogonal to rows[count][n] of length 1. Returns true, with v of length 1, if more than `tolerance` of it
// is left.
static bool orthogonalise(double *v, const double *rows, size_t count, size_t n, double tolerance)
{
    for (int twice = 0; twice < 2; twice++)
        for (size_t r = 0; r < count; r++) {
            double along = yk_inner_product(v, rows + r * n, n);
            for (size_t k = 0; k < n; k++) v[k] -= along * rows[r * n + k];
        }
    double length = sqrt(yk_inner_product(v, v, n));
    if (!(length > tolerance)) return false;
    for (size_t k = 0; k < n; k++) v[k] /= length;
    return true;
}

// Finds the free motions that the factored Jacobian leaves, as orthonormal rows basis[n - rank][n]. Source: Golub & Van
// Loan 2013, 5.5.
static size_t free_motions(Work *w, size_t rank)
{
    size_t n = w->n, f = 0;
    for (size_t j = rank; j < n; j++) {
        double *v = w->basis + f * n;
        memset(v, 0, n * sizeof *v);
        v[w->order[j]] = 1;
        for (size_t i = rank; i-- > 0;) {
            double sum = w->A[i * n + j];
            for (size_t k = i + 1; k < rank; k++) sum += w->A[i * n + k] * v[w->order[k]];
            v[w->order[i]] = -sum / w->A[i * n + i];
        }
        for (size_t k = 0; k < n; k++) v[k] /= w->scale[k];
        f += orthogonalise(v, w->basis, f, n, 0);
    }
    return f;
}

// Finds how fast a coordinate changes in each free motion.
static void rates_of(const Work *w, int32_t coordinate, size_t f, double *rates)
{
    const YkTreeCoordinate *c = &w->mech->coordinates[coordinate];
    YkJointAngle angle = yk_joint_angle(w->mech, c->joint);
    for (size_t k = 0; k < f; k++) {
        const double *v = w->basis + k * w->n;
        if (c->is_distance)
            rates[k] = v[w->column[yk_coordinate_variable(w->mech, coordinate)]];
        else
            rates[k] = (angle.b > 0 ? v[w->column[angle.b - 1]] : 0) - (angle.a > 0 ? v[w->column[angle.a - 1]] : 0);
    }
}

// Accepts a candidate as an input if its motion does not follow from those before it.
static void accept(Work *w, size_t rank)
{
    size_t f = free_motions(w, rank), taken = 0;
    double *told = w->A; // rows of length f <= n, in an orthonormal basis
    for (size_t k = 0; k < w->member_count; k++) {
        bool *accepted = &w->wish->accepted[w->members[k]];
        *accepted = false;
        if (taken == f) continue;
        rates_of(w, w->wish->items[w->members[k]], f, told + taken * f);
        *accepted = orthogonalise(told + taken * f, told, taken, f, 1e-8);
        taken += *accepted;
    }
}

// Writes a coordinate's rate as a row of the scaled unknowns, of length 1.
static void rate_row(const Work *w, int32_t coordinate, double *row)
{
    memset(row, 0, w->n * sizeof *row);
    add_rate(w, coordinate, 1, row);
    for (size_t j = 0; j < w->n; j++) row[j] /= w->scale[j];
    double length = sqrt(yk_inner_product(row, row, w->n));
    for (size_t j = 0; j < w->n && length > 0; j++) row[j] /= length;
}

// Returns whether the accepted inputs determine the motion at the pose whose Jacobian is J.
static bool inputs_determine(Work *w)
{
    size_t rows = w->m, n = w->n;
    copy_jacobian(w);
    for (size_t k = 0; k < w->member_count && rows < w->m + n; k++)
        if (w->wish->accepted[w->members[k]]) rate_row(w, w->wish->items[w->members[k]], w->A + rows++ * n);
    return yk_qr_factor(rows, n, w->A, w->order, w->tau, 1e-6) == n;
}

// Draws a random motion that the factored Jacobian leaves free, its largest part 1; zero if there is none.
static void draw_motion(Work *w, size_t free_count, double *motion)
{
    double largest = 0;
    memset(motion, 0, w->n * sizeof *motion);
    for (size_t i = 0; i < free_count; i++) {
        double share = draw(w);
        for (size_t j = 0; j < w->n; j++) motion[j] += share * w->basis[i * w->n + j];
    }
    for (size_t j = 0; j < w->n; j++) largest = fmax(largest, fabs(motion[j]));
    for (size_t j = 0; j < w->n && largest > 0; j++) motion[j] /= largest;
}

static void move(Work *w, const double *motion, double by)
{
    for (size_t j = 0; j < w->n; j++) w->x[w->variables[j]] += by * motion[j] * (is_angle(w, j) ? 1 : w->mech->size);
}

// Closes the loops a little along a motion from near[0]. Where branches of motion meet, Newton's method may fall back
// to the meeting point, at which it knows angles to half their digits and every rank is rounding: other motions are
// tried then, and kept from falling back. If none leads anywhere, the machine is rigid, as the rank of the last says.
// Returns whether a pose closes.
static bool close_beside(Work *w, size_t free_count, double *motion)
{
    enum { ATTEMPTS = 9 };
    const double way = 0.02; // of the part that moves most
    for (int attempt = 0; attempt <= ATTEMPTS; attempt++) {
        bool is_last = attempt == ATTEMPTS;
        double away = 0;
        if (attempt > 0) draw_motion(w, free_count, motion);
        restore(w, w->near[0]);
        move(w, motion, way);
        w->along = attempt > 0 && !is_last ? motion : NULL;
        bool is_closed = close_loops(w);
        w->along = NULL;
        if (!is_closed && attempt == 0) return false;
        for (size_t j = 0; j < w->n; j++) {
            double off = w->x[w->variables[j]] - w->near[0][j];
            away = fmax(away, fabs(off) / (is_angle(w, j) ? 1 : w->mech->size));
        }
        if (is_closed && (is_last || away > 0.01 * way)) return true;
    }
    return false;
}

// Compares the present pose with those to which its free motions lead, so that no other assembly is measured. rank[k]
// is 0 if a pose does not close. Returns the largest.
static size_t look_around(Work *w, size_t rank[3])
{
    size_t best = rank[0] = factor(w), free_count = free_motions(w, best);
    save(w, w->near[0]);
    for (int k = 1; k < 3; k++) draw_motion(w, free_count, w->near[k]);
    for (int k = 1; k < 3; k++) {
        rank[k] = 0;
        if (free_count == 0 || !close_beside(w, free_count, w->near[k])) continue;
        rank[k] = factor(w);
        save(w, w->near[k]);
        best = rank[k] > best ? rank[k] : best;
    }
    return best;
}

static void go_to(Work *w, int near)
{
    restore(w, w->near[near]);
    evaluate(w);
}

// Accepts the inputs of a near pose; with `firm`, only if something requested or driven is an input there and was not
// before.
static void accept_at(Work *w, int near, size_t rank, bool firm)
{
    bool *accepted = w->wish->accepted, gains = !firm;
    for (size_t k = 0; k < w->member_count; k++) w->other[k] = accepted[w->members[k]];
    go_to(w, near);
    factor(w);
    accept(w, rank);
    for (size_t k = 0; k < w->member_count; k++)
        gains |= (size_t)w->members[k] < w->wish->firm && accepted[w->members[k]] && !w->other[k];
    for (size_t k = 0; k < w->member_count && !gains; k++) accepted[w->members[k]] = w->other[k];
}

static size_t count_inputs(const Work *w)
{
    size_t count = 0;
    for (size_t k = 0; k < w->member_count; k++) count += w->wish->accepted[w->members[k]];
    return count;
}

// Keeps firm inputs: a drive that stands still on the branch of motion at the guesses may move on another that meets
// it.
static void keep_firm(Work *w)
{
    bool is_lost = false;
    for (size_t k = 0; k < w->member_count; k++)
        is_lost |= (size_t)w->members[k] < w->wish->firm && w->counted[k] && !w->wish->accepted[w->members[k]];
    for (size_t k = 0; k < w->member_count && is_lost; k++) w->wish->accepted[w->members[k]] = w->counted[k];
}

// Finds the freedom at a closed pose, with the largest rank nearby, since dead points and change points have a smaller
// rank than their neighbours. The inputs stay as counted if equations do not repeat each other and they determine the
// motion; otherwise they are those of the pose itself, together with firm ones that stand at their dead point. A pose
// that the guesses do not give may be a dead point by chance: poses beside it then come first.
static int freedom_here(Work *w)
{
    static const int orders[2][3] = {{1, 2, 0}, {0, 1, 2}};
    const int *order = orders[w->is_given];
    size_t rank[3], best = look_around(w, rank);
    int chosen = -1;
    for (int i = 0; i < (w->is_given ? 1 : 3) && best == w->m && chosen < 0; i++) {
        if (rank[order[i]] != best) continue;
        go_to(w, order[i]);
        if (inputs_determine(w)) chosen = order[i];
    }
    bool is_counted = chosen >= 0;
    for (int i = 0; i < 3 && !is_counted; i++) {
        if (rank[order[i]] != best) continue;
        accept_at(w, order[i], best, chosen >= 0);
        if (chosen < 0) chosen = order[i];
    }
    if (!is_counted && w->wish->is_peeled && w->m + count_inputs(w) == w->n) keep_firm(w);
    for (int i = 2; i >= 0 && !is_counted; i--) {
        if (rank[i] != best) continue;
        go_to(w, i);
        if (inputs_determine(w)) chosen = i;
    }
    memcpy(w->judge, w->near[chosen], w->n * sizeof *w->judge);
    return (int)(w->n - best);
}

static bool work_start(Work *w)
{
    size_t rows = w->m + 2 * w->n;
    w->old = calloc(11 * w->n + w->m + rows + (w->m + rows + w->n) * w->n, sizeof *w->old);
    w->order = calloc(w->n, sizeof *w->order);
    w->other = calloc(2 * w->member_count + 1, sizeof *w->other);
    w->counted = w->other ? w->other + w->member_count : NULL;
    for (size_t k = 0; w->counted && k < w->member_count; k++) w->counted[k] = w->wish->accepted[w->members[k]];
    if (!w->old || !w->order || !w->other) return false;
    w->guess = w->old + w->n;
    for (int k = 0; k < 3; k++) w->near[k] = w->guess + (size_t)(k + 1) * w->n;
    w->judge = w->near[2] + w->n;
    w->kept = w->judge + w->n;
    w->scale = w->kept + w->n;
    w->step = w->scale + w->n;
    w->tau = w->step + w->n;
    w->residual = w->tau + w->n; // the right side of a step follows it
    w->J = w->residual + w->m + rows;
    w->A = w->J + w->m * w->n;
    w->basis = w->A + rows * w->n;
    return true;
}

// Returns whether the variables agree with the guesses. Coordinates of bodies that never turn relative to each other
// share an angle: if two differ, only one can be kept.
static bool stands_as_told(const Work *w)
{
    for (size_t k = 0; k < w->member_count; k++) {
        int32_t coordinate = w->wish->items[w->members[k]];
        const YkTreeCoordinate *c = &w->mech->coordinates[coordinate];
        if (c->is_distance) continue;
        YkJointAngle angle = yk_joint_angle(w->mech, c->joint);
        double value = angle.offset + (angle.b > 0 ? w->x[angle.b - 1] : 0) - (angle.a > 0 ? w->x[angle.a - 1] : 0);
        if (!(fabs(yk_nearest_turn(value - w->told[coordinate], 0)) <= 1e-9)) return false;
    }
    return true;
}

// Searches from the guesses with the inputs held, from the guesses, then from points around them, for the first pose
// that closes and moves; -1 if none closes. A machine with repeated constraints can often be put together in rigid ways
// as well: these count only if nothing else is found, or if the guesses close unchanged.
static int measure(Work *w)
{
    int freedom = -1;
    w->is_given = evaluate(w) <= 1e-9 && stands_as_told(w);
    if (w->wish->is_peeled && (!w->is_given || (w->m + count_inputs(w) == w->n && inputs_determine(w)))) return -1;
    save(w, w->guess);
    for (int attempt = 0; attempt < 7 && (freedom < 0 || (freedom == 0 && !w->is_given)); attempt++) {
        restore(w, w->guess);
        if (attempt > 1) disturb(w, attempt < 4 ? 0.1 : 1);
        w->holds = attempt == 0;
        bool is_closed = close_loops(w);
        w->holds = false;
        if (!is_closed) continue;
        int one = freedom_here(w);
        if (freedom == 0 && one == 0) continue; // the first pose remains the one to judge by
        freedom = one;
        memcpy(w->kept, w->judge, w->n * sizeof *w->kept);
    }
    bool has_relations = w->m > 2 * w->loop_count;
    w->is_closed = freedom >= 0;
    if (freedom < 0 && has_relations) { // phases that do not fit together; assembling will report it
        restore(w, w->guess);
        evaluate(w);
        size_t rank = factor(w);
        accept(w, rank);
        freedom = (int)(w->n - rank);
    }
    return freedom;
}

// Hands out the pose to judge by.
static void tell_pose(const Work *w, int freedom, const YkClosedPose *pose)
{
    bool is_repeated = w->is_closed && w->m + (size_t)freedom > w->n;
    for (size_t j = 0; j < w->n && is_repeated; j++) {
        pose->x[w->variables[j]] = w->kept[j];
        pose->is_repeated[w->variables[j]] = true;
    }
}

// Returns the freedom of one part, -1 if it is not measured; *enough becomes false when out of memory.
static int part_freedom(Work *w, const YkFreedomParts *p, size_t part, const YkClosedPose *pose, bool *enough)
{
    int freedom = -1;
    w->members = p->candidates + p->candidate_first[part];
    w->member_count = p->candidate_first[part + 1] - p->candidate_first[part];
    w->variables = p->variables + p->variable_first[part];
    w->loops = p->loops + p->loop_first[part];
    w->n = p->variable_first[part + 1] - p->variable_first[part];
    w->relations = p->relations + p->relation_first[part];
    w->loop_count = p->loop_first[part + 1] - p->loop_first[part];
    w->m = 2 * w->loop_count + p->relation_first[part + 1] - p->relation_first[part];
    if (w->m == 0) return (int)w->n; // an open chain: the caller's choice is correct
    if (w->n > YK_CLOSURE_MAX) return -1;
    *enough = work_start(w);
    if (*enough) freedom = measure(w);
    if (*enough && pose) tell_pose(w, freedom, pose);
    free(w->old);
    free(w->order);
    free(w->other);
    return freedom;
}

bool yk_closure_freedom(const YkMechanism *mech, const double *guess, const YkCandidates *wish, int *freedom,
                        const YkClosedPose *pose)
{
    YkFreedomParts parts = {0};
    YkArena *arena = yk_arena_new();
    Work w = {.mech = mech, .wish = wish, .told = guess, .seed = 20261121};
    bool ok = arena && (w.x = YK_NEW(arena, double, yk_variable_count(mech) + 1)) &&
              yk_freedom_parts_sort(&parts, mech, wish->items, wish->count, arena);
    *freedom = 0;
    if (ok) yk_closure_guess(mech, guess, w.x);
    w.column = parts.column;
    for (size_t p = 0; ok && p < parts.count && yk_compile_goes_on(mech, 3); p++) {
        int one = part_freedom(&w, &parts, p, pose, &ok);
        *freedom = one < 0 || *freedom < 0 ? -1 : *freedom + one;
    }
    yk_arena_free(arena);
    return ok;
}

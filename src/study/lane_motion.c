// Forward dynamics over lanes, from inverse dynamics: the effort that the free inputs lack is r(a) = M a + h - Q,
// affine in their accelerations. r(0) and r at each unit acceleration give h - Q and M. The differences lose digits
// where accelerations are large, so the answer is corrected once by its own residual (Higham 2002, 12: iterative
// refinement).
#include "study/lane_motion.h"
#include <stdlib.h>
#include <string.h>
#include "batch/batch.h"
#include "solve/state.h"

enum { FREE_MAX = 4 };
static const double least_pivot = 1e-9; // over its diagonal: below, the dynamics of one pose judge
static const double most_change = 1e-5; // of the accelerations, by the correction

struct YkLaneMotion {
    const YkMechanism *mech;
    YkBatch *batch;
    const YkState *home;
    size_t free[FREE_MAX], free_count, capacity;
    double *rows;           // [capacity] each, what follows:
    double **given;         // [input]: accelerations
    double *lack[FREE_MAX]; // r
    double *rest[FREE_MAX]; // r(0)
    double *mass[FREE_MAX * FREE_MAX];
    const double **inputs; // of the batch
    signed char *status;
};

static bool find_free(YkLaneMotion *m, const YkDynamics *dynamics)
{
    for (size_t i = 0; i < m->mech->input_count; i++) {
        if (yk_dynamics_is_prescribed(dynamics, i)) continue;
        if (m->free_count == FREE_MAX) return false;
        m->free[m->free_count++] = i;
    }
    return m->free_count > 0;
}

static bool make(YkLaneMotion *m, bool *fits)
{
    YkChannel channels[FREE_MAX];
    for (size_t k = 0; k < m->free_count; k++)
        channels[k] = (YkChannel){.kind = YK_CHANNEL_EFFORT, .index = m->mech->inputs[m->free[k]]};
    m->batch = yk_batch_new(m->home, channels, m->free_count);
    *fits = !m->batch || yk_batch_has_lanes(m->batch);
    if (!m->batch || !*fits) return false;
    size_t n = m->free_count, inputs = m->mech->input_count, rows = inputs + 2 * n + n * n;
    m->rows = calloc(rows * m->capacity, sizeof *m->rows);
    m->given = calloc(inputs, sizeof *m->given);
    m->inputs = calloc(3 * inputs, sizeof *m->inputs);
    m->status = calloc(m->capacity, sizeof *m->status);
    if (!m->rows || !m->given || !m->inputs || !m->status) return false;
    double *row = m->rows;
    for (size_t i = 0; i < inputs; i++, row += m->capacity) m->given[i] = row;
    for (size_t k = 0; k < n; k++, row += 2 * m->capacity) m->lack[k] = row, m->rest[k] = row + m->capacity;
    for (size_t k = 0; k < n * n; k++, row += m->capacity) m->mass[k] = row;
    return true;
}

YkLaneMotion *yk_lane_motion_new(const YkState *home, const YkDynamics *dynamics, size_t capacity, bool *fits)
{
    YkLaneMotion *m = calloc(1, sizeof *m);
    *fits = true;
    if (!m) return NULL;
    m->mech = home->mech;
    m->home = home;
    m->capacity = capacity;
    *fits = find_free(m, dynamics);
    if (*fits && make(m, fits)) return m;
    yk_lane_motion_free(m);
    return NULL;
}

void yk_lane_motion_free(YkLaneMotion *m)
{
    if (!m) return;
    yk_batch_free(m->batch);
    free(m->rows);
    free(m->given);
    free(m->inputs);
    free(m->status);
    free(m);
}

// Finds what the free inputs lack at the accelerations that are given; marks states that have no answer.
static bool find_lack(YkLaneMotion *m, size_t count, bool *is_solved)
{
    if (yk_batch_run(m->batch, m->inputs, m->lack, m->status, count) == YK_NO_MEMORY) return false;
    for (size_t s = 0; s < count; s++) is_solved[s] = is_solved[s] && m->status[s] == YK_OK;
    return true;
}

static void fill(double *row, double value, size_t count)
{
    for (size_t s = 0; s < count; s++) row[s] = value;
}

// Finds r(0) and M.
static bool find_equations(YkLaneMotion *m, size_t count, bool *is_solved)
{
    size_t n = m->free_count;
    for (size_t k = 0; k < n; k++) fill(m->given[m->free[k]], 0, count);
    if (!find_lack(m, count, is_solved)) return false;
    for (size_t k = 0; k < n; k++) memcpy(m->rest[k], m->lack[k], count * sizeof *m->rest[k]);
    for (size_t j = 0; j < n; j++) {
        fill(m->given[m->free[j]], 1, count);
        if (!find_lack(m, count, is_solved)) return false;
        fill(m->given[m->free[j]], 0, count);
        for (size_t i = j; i < n; i++)
            for (size_t s = 0; s < count; s++) m->mass[i * n + j][s] = m->lack[i][s] - m->rest[i][s];
    }
    return true;
}

// Factors M = L D L^T in place; marks states where a pivot is small.
static void factor(YkLaneMotion *m, size_t s, bool *is_solved)
{
    size_t n = m->free_count;
    for (size_t k = 0; k < n; k++) {
        double whole = m->mass[k * n + k][s], pivot = whole;
        for (size_t j = 0; j < k; j++) pivot -= m->mass[k * n + j][s] * m->mass[k * n + j][s] * m->mass[j * n + j][s];
        if (!(pivot > least_pivot * whole)) *is_solved = false;
        m->mass[k * n + k][s] = pivot;
        for (size_t i = k + 1; i < n; i++) {
            double entry = m->mass[i * n + k][s];
            for (size_t j = 0; j < k; j++)
                entry -= m->mass[i * n + j][s] * m->mass[k * n + j][s] * m->mass[j * n + j][s];
            m->mass[i * n + k][s] = entry / pivot;
        }
    }
}

// Subtracts M^-1 r from the accelerations. Returns the largest change over the largest of them.
static double correct(YkLaneMotion *m, size_t s, double *const *r)
{
    size_t n = m->free_count;
    double x[FREE_MAX], change = 0, most = 1;
    for (size_t k = 0; k < n; k++) {
        x[k] = r[k][s];
        for (size_t j = 0; j < k; j++) x[k] -= m->mass[k * n + j][s] * x[j];
    }
    for (size_t k = n; k-- > 0;) {
        x[k] /= m->mass[k * n + k][s];
        for (size_t i = k + 1; i < n; i++) x[k] -= m->mass[i * n + k][s] * x[i];
    }
    for (size_t k = 0; k < n; k++) {
        double *a = &m->given[m->free[k]][s];
        *a -= x[k];
        change = fmax(change, fabs(x[k]));
        most = fmax(most, fabs(*a));
        if (!(x[k] - x[k] == 0)) return INFINITY;
    }
    return change / most;
}

static void set_inputs(YkLaneMotion *m, const YkMotionCase *asked, size_t from, size_t count)
{
    for (size_t i = 0; i < m->mech->input_count; i++) {
        const double *const *position = asked->positions, *const *rate = asked->rates;
        m->inputs[3 * i] = position && position[i] ? position[i] + from : NULL;
        m->inputs[3 * i + 1] = rate && rate[i] ? rate[i] + from : NULL;
        m->inputs[3 * i + 2] = m->given[i];
        fill(m->given[i], m->home->input[3 * i + 2], count);
    }
}

bool yk_lane_motion_run(YkLaneMotion *m, const YkMotionCase *asked, size_t from, size_t count,
                        double *const *accelerations, bool *is_solved)
{
    for (size_t s = 0; s < count; s++) is_solved[s] = true;
    set_inputs(m, asked, from, count);
    if (!find_equations(m, count, is_solved)) return false;
    for (size_t s = 0; s < count; s++) {
        factor(m, s, &is_solved[s]);
        correct(m, s, m->rest); // from 0
    }
    if (!find_lack(m, count, is_solved)) return false;
    for (size_t s = 0; s < count; s++)
        if (!(correct(m, s, m->lack) <= most_change)) is_solved[s] = false;
    for (size_t i = 0; i < m->mech->input_count; i++)
        for (size_t s = 0; s < count; s++) accelerations[i][from + s] = is_solved[s] ? m->given[i][s] : 0;
    return true;
}

// Finds rates at the start that fit those in the file, as well as the loops allow.
#include <stdlib.h>
#include "base/problems.h"
#include "num/dense.h"
#include "simulate/simulation.h"

size_t yk_simulation_given_rates(const YkSimulation *sim, YkStartRate *given)
{
    const YkModel *model = sim->model;
    const YkMechanism *mech = sim->mech;
    size_t count = 0;
    for (size_t k = 0; k < model->start_count; k++) {
        const YkCoordinate *c = &model->coordinates[model->starts[k].coordinate];
        int32_t q = model->starts[k].is_rate ? yk_tree_coordinate(mech, c->joint, c->is_distance) : YK_NONE;
        if (q != YK_NONE) given[count++] = (YkStartRate){(size_t)q, model->starts[k].value};
    }
    for (size_t k = 0; k < sim->options.value_count; k++) {
        const YkStartValue *value = &sim->options.values[k];
        size_t q = value->is_rate ? yk_coordinate_find(mech, value->coordinate) : YK_NOT_FOUND;
        if (q == YK_NOT_FOUND) continue;
        size_t at = 0;
        while (at < count && given[at].coordinate != q) at++;
        given[at] = (YkStartRate){q, value->value};
        if (at == count) count++;
    }
    size_t kept = 0;
    for (size_t k = 0; k < count; k++) { // a drive gives its own rate
        int32_t input = mech->coordinates[given[k].coordinate].input;
        if (input == YK_NONE || sim->dynamics->is_free[input]) given[kept++] = given[k];
    }
    return kept;
}

static double scale_of(const YkSimulation *sim, size_t coordinate)
{
    return sim->mech->coordinates[coordinate].is_distance ? sim->mech->size : 1;
}

// Measures the rates of the given coordinates with the present rates of the free inputs.
static bool measure(YkSimulation *sim, const YkStartRate *given, size_t m, double *rates)
{
    YkState *s = sim->state;
    if (yk_state_solve(s) < 0 || !s->has_rates) return false;
    for (size_t k = 0; k < m; k++)
        rates[k] = yk_state_coordinate(s, given[k].coordinate).velocity / scale_of(sim, given[k].coordinate);
    return true;
}

static void set_rate(YkSimulation *sim, size_t free, double rate)
{
    sim->state->input[3 * sim->free_input[free] + 1] = rate;
}

// Returns whether all given rates belong to inputs.
static bool are_inputs(YkSimulation *sim, const YkStartRate *given, size_t m)
{
    for (size_t k = 0; k < m; k++)
        if (sim->mech->coordinates[given[k].coordinate].input == YK_NONE) return false;
    for (size_t k = 0; k < m; k++)
        sim->state->input[3 * sim->mech->coordinates[given[k].coordinate].input + 1] = given[k].rate;
    return true;
}

static void report(YkSimulation *sim, const YkStartRate *given, const double *wanted, const double *found, size_t m,
                   YkProblems *problems)
{
    for (size_t k = 0; k < m; k++) {
        double scale = scale_of(sim, given[k].coordinate);
        if (fabs(wanted[k] - found[k]) <= 1e-9 * (fabs(wanted[k]) + fabs(found[k]))) continue;
        const YkTreeCoordinate *c = &sim->mech->coordinates[given[k].coordinate];
        double size = 1;
        const char *unit =
            yk_model_unit(sim->mech->model, c->is_distance ? YK_QUANTITY_SPEED : YK_QUANTITY_ANGLE_RATE, &size);
        yk_problem(problems, YK_CODE_RATES_PROJECTED, (YkPlace){0},
                   "the loops do not allow %q the rate %e %s together with the others: it starts with %e %s", c->name,
                   wanted[k] * scale / size, unit, found[k] * scale / size, unit);
    }
}

// Fits the given rates by least squares; rates that they leave open stay 0.
static bool project(YkSimulation *sim, const YkStartRate *given, size_t m, YkProblems *problems)
{
    size_t f = sim->free_count;
    double *A = calloc(m * f + 4 * m + 3 * f + 8, sizeof *A);
    size_t *order = calloc(f + 1, sizeof *order);
    bool ok = A && order;
    if (ok) {
        double *wanted = A + m * f, *offset = wanted + m, *unit = offset + m, *b = unit + m, *x = b + m, *tau = x + f;
        for (size_t k = 0; k < m; k++) wanted[k] = given[k].rate / scale_of(sim, given[k].coordinate);
        for (size_t j = 0; j < f; j++) set_rate(sim, j, 0);
        ok = measure(sim, given, m, offset);
        for (size_t j = 0; j < f && ok; j++) {
            set_rate(sim, j, 1);
            ok = measure(sim, given, m, unit);
            set_rate(sim, j, 0);
            for (size_t k = 0; k < m; k++) A[k * f + j] = unit[k] - offset[k];
        }
        if (ok) {
            for (size_t k = 0; k < m; k++) b[k] = wanted[k] - offset[k];
            size_t rank = yk_qr_factor(m, f, A, order, tau, 1e-10);
            yk_qr_solve(m, f, A, order, tau, rank, b, x);
            for (size_t j = 0; j < f; j++) set_rate(sim, j, x[j]);
            ok = measure(sim, given, m, unit);
            if (ok) report(sim, given, wanted, unit, m, problems);
        }
    }
    free(A);
    free(order);
    return ok;
}

bool yk_simulation_start_rates(YkSimulation *sim, YkProblems *problems)
{
    enum { UNKNOWNS_MAX = 2000 };
    YkStartRate *given = calloc(sim->model->start_count + sim->options.value_count + 1, sizeof *given);
    if (!given) {
        yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while preparing the simulation");
        return false;
    }
    size_t m = yk_simulation_given_rates(sim, given);
    bool ok = true;
    for (size_t k = 0; k < sim->free_count; k++) set_rate(sim, k, 0);
    if (m > 0 && !are_inputs(sim, given, m)) ok = sim->free_count <= UNKNOWNS_MAX && project(sim, given, m, problems);
    free(given);
    for (size_t i = 0; i < sim->mech->input_count; i++)
        if (sim->dynamics->is_free[i]) sim->state->input[3 * i + 2] = 0;
    return ok && yk_state_solve(sim->state) >= 0;
}

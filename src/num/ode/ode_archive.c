// Writes and reads a stepper as bytes: everything on which the next step depends.
#include "num/ode/ode_internal.h"

static void walk_newton(YkOde *ode, YkArchive *a)
{
    YkOdeNewton *newton = &ode->newton;
    size_t m = ode->controlled;
    yk_archive_numbers(a, newton->J, m * ode->n);
    yk_archive_numbers(a, newton->E, m * m);
    yk_archive_numbers(a, newton->guess, ode->n);
    for (size_t k = 0; k < m; k++) {
        int64_t pivot = newton->pivot[k];
        yk_archive_choice(a, &pivot, 0, (int64_t)m - 1);
        newton->pivot[k] = (int)pivot;
    }
    double *const numbers[] = {&newton->factored, &newton->speed, &newton->slowest};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) yk_archive_numbers(a, numbers[k], 1);
    yk_archive_flags(a, &newton->known, 1);
    yk_archive_flags(a, &newton->fresh, 1);
}

void yk_ode_archive(YkOde *ode, YkArchive *a)
{
    double *const numbers[] = {&ode->t, &ode->previous, &ode->start, &ode->end, &ode->direction,
                               &ode->h, &ode->length,   &ode->grid,  &ode->even};
    double *const columns[] = {ode->y, ode->rate, ode->y_previous, ode->rate_previous, ode->z, ode->z_rate};
    size_t *const counts[] = {&ode->counts.steps, &ode->counts.rejected, &ode->counts.evaluations,
                              &ode->counts.jacobians};
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++) yk_archive_numbers(a, numbers[k], 1);
    for (size_t k = 0; k < sizeof columns / sizeof *columns; k++) yk_archive_numbers(a, columns[k], ode->n);
    for (size_t k = 0; k < YK_ODE_MOST_STAGES; k++)
        if (ode->stage[k]) yk_archive_numbers(a, ode->stage[k], ode->n);
    for (size_t k = 0; k < YK_ODE_MOST_DENSE; k++)
        if (ode->dense[k]) yk_archive_numbers(a, ode->dense[k], ode->n);
    yk_archive_numbers(a, ode->floor, ode->controlled);
    yk_archive_flags(a, &ode->started, 1);
    yk_archive_flags(a, &ode->dense_ready, 1);
    yk_archive_sizes(a, counts, sizeof counts / sizeof *counts);
    if (ode->newton.J) walk_newton(ode, a);
}

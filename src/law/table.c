// Tables: a piece between every two points, from their values and, if it is cubic, their slopes.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "law/inside.h"

// The points, with those that close the period; the slopes are to be found.
typedef struct Table {
    double *x, *y, *slope, *work;
    size_t count; // number of points; there are count - 1 intervals
    bool is_periodic;
} Table;

static double width(const Table *table, size_t i)
{
    return table->x[i + 1] - table->x[i];
}
static double rise(const Table *table, size_t i)
{
    return (table->y[i + 1] - table->y[i]) / width(table, i);
}

// Solves low[i] m[i-1] + diagonal[i] m[i] + high[i] m[i+1] = m[i] for n unknowns (right side in, solution out); the
// rows are diagonally dominant. Overwrites diagonal. Source: Golub & Van Loan 2013, 4.3.
static void solve_tridiagonal(size_t n, const double *low, double *diagonal, const double *high, double *m)
{
    for (size_t i = 1; i < n; i++) {
        double factor = low[i] / diagonal[i - 1];
        diagonal[i] -= factor * high[i - 1];
        m[i] -= factor * m[i - 1];
    }
    m[n - 1] /= diagonal[n - 1];
    for (size_t i = n - 1; i-- > 0;) m[i] = (m[i] - high[i] * m[i + 1]) / diagonal[i];
}

// Makes the second derivative continuous at point i, between intervals `left` and `right`.
static void continuity_row(const Table *table, size_t left, size_t right, double row[4])
{
    double hl = width(table, left), hr = width(table, right);
    row[0] = hr;
    row[1] = 2 * (hl + hr);
    row[2] = hl;
    row[3] = 3 * (hr * rise(table, left) + hl * rise(table, right));
}

// Finds the slopes of the natural cubic spline. Source: de Boor 2001, ch. IV.
static void natural_slopes(Table *table)
{
    size_t n = table->count;
    double *low = table->work, *diagonal = low + n, *high = low + 2 * n, *m = table->slope;
    for (size_t i = 0; i < n; i++) {
        double row[4] = {0, 2, 1, 0};
        if (i == 0) row[3] = 3 * rise(table, 0);
        if (i == n - 1) {
            row[0] = 1;
            row[2] = 0;
            row[3] = 3 * rise(table, n - 2);
        }
        if (i > 0 && i < n - 1) continuity_row(table, i - 1, i, row);
        low[i] = row[0];
        diagonal[i] = row[1];
        high[i] = row[2];
        m[i] = row[3];
    }
    solve_tridiagonal(n, low, diagonal, high, m);
}

// Finds those of the periodic spline: handles the corners of the matrix by the Sherman-Morrison formula. The last point
// is the first.
static void periodic_slopes(Table *table)
{
    size_t n = table->count - 1;
    double *low = table->work, *diagonal = low + n, *high = low + 2 * n, *q = low + 3 * n, *m = table->slope;
    for (size_t i = 0; i < n; i++) {
        double row[4];
        continuity_row(table, i == 0 ? n - 1 : i - 1, i, row);
        low[i] = row[0];
        diagonal[i] = row[1];
        high[i] = row[2];
        m[i] = row[3];
        q[i] = 0;
    }
    // A = A' + p r^T with p = (g, 0, .., high[n-1]) and r = (1, 0, .., low[0] / g)
    double g = -diagonal[0], corner = high[n - 1], ratio = low[0] / g;
    q[0] = g;
    q[n - 1] = corner;
    double *again = low + 4 * n;
    diagonal[0] -= g;
    diagonal[n - 1] -= corner * ratio;
    memcpy(again, diagonal, n * sizeof *again);
    solve_tridiagonal(n, low, diagonal, high, m);
    solve_tridiagonal(n, low, again, high, q);
    double factor = (m[0] + ratio * m[n - 1]) / (1 + q[0] + ratio * q[n - 1]);
    for (size_t i = 0; i < n; i++) m[i] -= factor * q[i];
    m[n] = m[0];
}

// Returns the weighted harmonic mean of the slopes on both sides, 0 at a summit: the cubic then stays monotone.
static double inner_slope(const Table *table, size_t left, size_t right)
{
    double hl = width(table, left), hr = width(table, right), a = rise(table, left), b = rise(table, right);
    if (!(a * b > 0)) return 0;
    return 3 * (hl + hr) / ((2 * hr + hl) / a + (hr + 2 * hl) / b);
}

// Returns the slope at an end: that of the parabola through three points, limited to keep the piece monotone.
static double end_slope(double h0, double h1, double a, double b)
{
    double slope = ((2 * h0 + h1) * a - h0 * b) / (h0 + h1);
    if (!(slope * a > 0)) return 0;
    return a * b < 0 && fabs(slope) > 3 * fabs(a) ? 3 * a : slope;
}

static void monotone_slopes(Table *table)
{
    size_t n = table->count;
    double *m = table->slope;
    for (size_t i = 1; i + 1 < n; i++) m[i] = inner_slope(table, i - 1, i);
    if (table->is_periodic) {
        m[0] = m[n - 1] = inner_slope(table, n - 2, 0);
        return;
    }
    m[0] = end_slope(width(table, 0), width(table, 1), rise(table, 0), rise(table, 1));
    m[n - 1] = end_slope(width(table, n - 2), width(table, n - 3), rise(table, n - 2), rise(table, n - 3));
}

// Finds the slopes. Two points make a line. With a period of two intervals the general matrix does not fit; both slopes
// are equal there.
static void find_slopes(Table *table, YkTableShape shape)
{
    if (table->count == 2) {
        table->slope[0] = table->slope[1] = rise(table, 0);
    } else if (shape == YK_TABLE_MONOTONE) {
        monotone_slopes(table);
    } else if (!table->is_periodic) {
        natural_slopes(table);
    } else if (table->count > 3) {
        periodic_slopes(table);
    } else {
        for (size_t i = 0; i < 3; i++) table->slope[i] = rise(table, 0) + rise(table, 1);
    }
}

static bool add_interval(YkLawBuilder *builder, const Table *table, size_t i, YkTableShape shape)
{
    double half = width(table, i) / 2, y0 = table->y[i], y1 = table->y[i + 1], c[4];
    YkPiece frame = {.from = table->x[i],
                     .to = table->x[i + 1],
                     .middle = table->x[i] + half,
                     .scale = 1 / half,
                     .terms = shape == YK_TABLE_LINEAR ? 2 : 4};
    c[0] = y0 + (y1 - y0) / 2;
    c[1] = (y1 - y0) / 2;
    if (shape != YK_TABLE_LINEAR) { // p(-1), p(1), p'(-1), p'(1) are given; T_2' = 4 u, T_3' = 12 u^2 - 3
        double d0 = table->slope[i] * half, d1 = table->slope[i + 1] * half;
        c[2] = (d1 - d0) / 8;
        c[0] -= c[2];
        c[3] = ((d0 + d1) / 2 - c[1]) / 8;
        c[1] -= c[3];
    }
    return yk_law_add_piece(builder, &frame, c);
}

static YkLawFault check(YkLawBuilder *builder, const double *x, size_t count, double period)
{
    if (builder->piece_count > 0) return YK_LAW_OVERLAP;
    if (count < 2) return YK_LAW_TOO_FEW;
    for (size_t i = 1; i < count; i++) {
        builder->culprit = i;
        if (!(x[i] > x[i - 1])) return YK_LAW_UNORDERED;
    }
    return period > 0 && x[count - 1] - x[0] > period * (1 + 1e-9) ? YK_LAW_OVERFILLED : YK_LAW_OK;
}

// Copies the points and adds one that closes the period.
static void fill(Table *table, const double *x, const double *y, size_t count, double period)
{
    memcpy(table->x, x, count * sizeof *x);
    memcpy(table->y, y, count * sizeof *y);
    table->count = count;
    table->is_periodic = period > 0;
    if (period > 0 && x[count - 1] - x[0] < period * (1 - 1e-9)) {
        table->x[count] = x[0] + period;
        table->y[count] = y[0];
        table->count++;
    }
}

YkLawFault yk_law_add_table(YkLawBuilder *builder, const double *x, const double *y, size_t count, YkTableShape shape,
                            double period)
{
    YkLawFault fault = check(builder, x, count, period);
    if (fault != YK_LAW_OK) return fault;
    Table table = {.x = malloc(8 * (count + 1) * sizeof(double))};
    if (!table.x) return YK_LAW_NO_MEMORY;
    table.y = table.x + (count + 1);
    table.slope = table.y + (count + 1);
    table.work = table.slope + (count + 1);
    fill(&table, x, y, count, period);
    if (shape != YK_TABLE_LINEAR) find_slopes(&table, shape);
    builder->from = builder->at = x[0];
    bool is_whole = true;
    for (size_t i = 0; i + 1 < table.count && is_whole; i++) is_whole = add_interval(builder, &table, i, shape);
    free(table.x);
    if (is_whole) return yk_law_end_segment(builder, YK_LAW_TABLE, 0, 0, 1);
    yk_law_take_back(builder, 0, 0);
    return YK_LAW_NO_MEMORY;
}

// Evaluates a law: finds the piece, sums its polynomial and its waves.
#include "elementary/elementary.h"
#include "elementary/kernel.h"
#include "law/inside.h"

enum { ORDERS = YK_LAW_ORDER + 1 };

// Adds sum c_k T_k(u) and its derivatives with respect to u by Clenshaw's recurrence b_k = c_k + 2 u b_{k+1} - b_{k+2},
// differentiated term by term. Source: Clenshaw 1955; Mason & Handscomb 2003, 2.4.
static void add_polynomial(const double *c, size_t terms, double u, double sum[ORDERS])
{
    double b1[ORDERS] = {0}, b2[ORDERS] = {0};
    if (terms == 0) return;
    for (size_t k = terms - 1; k > 0; k--) {
        for (int m = ORDERS - 1; m >= 0; m--) {
            double b = 2 * u * b1[m] - b2[m];
            if (m > 0) b += 2 * m * b1[m - 1];
            if (m == 0) b += c[k];
            b2[m] = b1[m];
            b1[m] = b;
        }
    }
    for (int m = 0; m < ORDERS; m++) {
        sum[m] += u * b1[m] - b2[m];
        if (m > 0) sum[m] += m * b1[m - 1];
    }
    sum[0] += c[0];
}

// Adds amplitude cos(frequency u + phase): the derivatives cycle through -sin, -cos, sin, cos.
static void add_wave(const double wave[3], double u, double sum[ORDERS])
{
    double angle = wave[1] * u + wave[2], factor = wave[0];
    double s, c;
    yk_sincos(angle, &s, &c);
    const double cycle[4] = {c, -s, -c, s};
    for (int m = 0; m < ORDERS; m++) {
        sum[m] += factor * cycle[m % 4];
        factor *= wave[1];
    }
}

void yk_piece_eval(const YkPiece *piece, const double *numbers, double x, double d[ORDERS])
{
    const double *c = numbers + piece->first;
    double u = (x - piece->middle) * piece->scale, factor = 1;
    for (int m = 0; m < ORDERS; m++) d[m] = 0;
    add_polynomial(c, piece->terms, u, d);
    for (size_t i = 0; i < piece->waves; i++) add_wave(c + piece->terms + 3 * i, u, d);
    for (int m = 1; m < ORDERS; m++) {
        factor *= piece->scale;
        d[m] *= factor;
    }
}

// Returns the last piece that begins at or before x.
static const YkPiece *find(const YkLaw *law, double x)
{
    size_t low = 0, high = law->piece_count;
    while (high - low > 1) {
        size_t middle = low + (high - low) / 2;
        if (law->pieces[middle].from <= x)
            low = middle;
        else
            high = middle;
    }
    return &law->pieces[low];
}

// Returns x in [from, from + period).
static double within_period(const YkLaw *law, double x)
{
    if (x >= law->from && x < law->from + law->period) return x;
    double past = yk_fmod(x - law->from, law->period);
    if (past < 0) past += law->period;
    return past >= law->period ? law->from : law->from + past;
}

static void stand(double value, double d[ORDERS])
{
    d[0] = value;
    for (int m = 1; m < ORDERS; m++) d[m] = 0;
}

void yk_law_eval(const YkLaw *law, double x, double d[ORDERS])
{
    if (law->period > 0) {
        x = within_period(law, x);
    } else if (x < law->from) {
        stand(law->start, d);
        return;
    } else if (x >= law->to) {
        stand(law->end, d);
        return;
    }
    yk_piece_eval(find(law, x), law->numbers, x, d);
}

// --- many places

enum { WIDE = 8 }; // fewer places are not worth a pass

// Returns how many places, from the first, lie in one piece that is a polynomial; less than WIDE count as none.
static size_t run_of(const YkLaw *law, const double *x, size_t n, const YkPiece **piece)
{
    double end = law->period > 0 ? law->from + law->period : law->to;
    size_t count = 0;
    if (n < WIDE) return 0;
    *piece = find(law, *x);
    if (*piece + 1 < law->pieces + law->piece_count && (*piece)[1].from < end) end = (*piece)[1].from;
    if ((*piece)->waves > 0 || (*piece)->terms == 0) return 0;
    bool within = false;
    if (YK_KNOWS_BLOCKS) yk_law_within(&within, x, (*piece)->from, end, n);
    if (within) return n;
    while (count < n && x[count] >= (*piece)->from && x[count] < end) count++;
    return count < WIDE ? 0 : count;
}

void yk_law_eval_lanes(const YkLaw *law, const double *x, double *const d[3], size_t n)
{
    const YkPiece *piece = NULL;
    for (size_t at = 0; at < n;) {
        size_t count = run_of(law, x + at, n - at, &piece);
        if (count > 0) {
            double *const out[] = {d[0] + at, d[1] + at, d[2] + at};
            yk_law_polynomial(law->numbers + piece->first, piece->terms, piece->middle, piece->scale, x + at, out,
                              count);
            at += count;
            continue;
        }
        double one[ORDERS];
        yk_law_eval(law, x[at], one);
        for (size_t k = 0; k < 3; k++) d[k][at] = one[k];
        at++;
    }
}

YkLawRange yk_law_range(const YkLaw *law)
{
    return (YkLawRange){law->from, law->to, law->period};
}

size_t yk_law_segment_count(const YkLaw *law)
{
    return law->segment_count;
}

YkLawSegment yk_law_segment(const YkLaw *law, size_t segment)
{
    return law->segments[segment];
}

// Finds where a law is not smooth, and where it is largest, from both sides of every joint of its pieces.
#include <math.h>
#include "elementary/elementary.h"
#include "law/inside.h"

enum { ORDERS = YK_LAW_ORDER + 1, JUMP_ORDERS = 3, HALVINGS = 60 };
#define SMALL 1e-9

static void piece_eval(const YkLaw *law, size_t index, double x, double d[ORDERS])
{
    yk_piece_eval(&law->pieces[index], law->numbers, x, d);
}

// Returns how many samples show every hill of the piece.
static size_t sample_count(const YkPiece *piece)
{
    return 8 + 4u * piece->terms + 16u * piece->waves;
}

static double sample_at(const YkPiece *piece, size_t i, size_t count)
{
    if (i == count) return piece->to;
    return piece->from + (piece->to - piece->from) * ((double)i / (double)count);
}

// Estimates the largest magnitude of each order from samples, closely enough to judge by. Order 0 counts from the start
// value, so that an offset does not matter. Each is at least the average of a motion of that height over the whole
// range.
static void find_scales(const YkLaw *law, double scale[JUMP_ORDERS])
{
    double length = law->to - law->from;
    for (int m = 0; m < JUMP_ORDERS; m++) scale[m] = 0;
    for (size_t i = 0; i < law->piece_count; i++) {
        const YkPiece *piece = &law->pieces[i];
        size_t count = sample_count(piece);
        for (size_t k = 0; k <= count; k++) {
            double d[ORDERS];
            piece_eval(law, i, sample_at(piece, k, count), d);
            d[0] -= law->start;
            for (int m = 0; m < JUMP_ORDERS; m++) scale[m] = fmax(scale[m], fabs(d[m]));
        }
    }
    // rounding of the values themselves is not a jump
    scale[0] = fmax(scale[0], 1e-6 * fabs(law->start));
    for (int m = 1; m < JUMP_ORDERS; m++) scale[m] = fmax(scale[m], scale[0] / yk_pow(length, m));
}

typedef struct Jumps {
    YkLawJump *jumps;
    size_t count, capacity;
    double scale[JUMP_ORDERS];
} Jumps;

static void compare(Jumps *found, double x, const double *before, const double *after)
{
    for (int m = 0; m < JUMP_ORDERS; m++) {
        double size = after[m] - before[m];
        if (!(fabs(size) > SMALL * found->scale[m])) continue;
        if (found->count < found->capacity) found->jumps[found->count] = (YkLawJump){x, m, size};
        found->count++;
    }
}

size_t yk_law_jumps(const YkLaw *law, YkLawJump *jumps, size_t capacity)
{
    Jumps found = {.jumps = jumps, .capacity = capacity};
    size_t last = law->piece_count - 1;
    double before[ORDERS], after[ORDERS];
    const double at_start[ORDERS] = {law->start}, at_end[ORDERS] = {law->end};
    find_scales(law, found.scale);
    piece_eval(law, last, law->to, before);
    piece_eval(law, 0, law->from, after);
    compare(&found, law->from, law->period > 0 ? before : at_start, after);
    for (size_t i = 0; i < last; i++) {
        piece_eval(law, i, law->pieces[i].to, before);
        piece_eval(law, i + 1, law->pieces[i + 1].from, after);
        compare(&found, law->pieces[i + 1].from, before, after);
    }
    piece_eval(law, last, law->to, before);
    if (!(law->period > 0)) compare(&found, law->to, before, at_end);
    return found.count;
}

// Narrows [low, high] down to the summit of |d| in it, by golden sections. Source: Kiefer 1953.
static double climb(const YkLaw *law, size_t piece, int order, double low, double high)
{
    const double part = 0.6180339887498949;
    double d[ORDERS], a = high - part * (high - low), b = low + part * (high - low);
    piece_eval(law, piece, a, d);
    double at_a = fabs(d[order]);
    piece_eval(law, piece, b, d);
    double at_b = fabs(d[order]);
    for (int i = 0; i < HALVINGS && b > a; i++) {
        if (at_a >= at_b) {
            high = b;
            b = a;
            at_b = at_a;
            a = high - part * (high - low);
            piece_eval(law, piece, a, d);
            at_a = fabs(d[order]);
        } else {
            low = a;
            a = b;
            at_a = at_b;
            b = low + part * (high - low);
            piece_eval(law, piece, b, d);
            at_b = fabs(d[order]);
        }
    }
    return low + (high - low) / 2;
}

static void raise(const YkLaw *law, size_t piece, int order, double x, YkLawPeak *peak)
{
    double d[ORDERS];
    piece_eval(law, piece, x, d);
    if (fabs(d[order]) > fabs(peak->value)) *peak = (YkLawPeak){x, d[order]};
}

// Finds a peak by climbing every summit among the samples: of two hills the samples may show the wrong one as the
// higher.
static void find_peak(const YkLaw *law, size_t index, int order, YkLawPeak *peak)
{
    const YkPiece *piece = &law->pieces[index];
    size_t count = sample_count(piece);
    double before = 0, here = 0, d[ORDERS];
    for (size_t i = 0; i <= count + 1; i++) {
        double next = 0;
        if (i <= count) {
            double x = sample_at(piece, i, count);
            raise(law, index, order, x, peak);
            piece_eval(law, index, x, d);
            next = fabs(d[order]);
        }
        if (i > 0 && here >= before && here >= next && here > 0) {
            double low = sample_at(piece, i > 1 ? i - 2 : 0, count),
                   high = sample_at(piece, i > count ? count : i, count);
            raise(law, index, order, climb(law, index, order, low, high), peak);
        }
        before = here;
        here = next;
    }
}

YkLawPeak yk_law_peak(const YkLaw *law, int order)
{
    YkLawPeak peak = {law->from, 0};
    for (size_t i = 0; i < law->piece_count; i++) find_peak(law, i, order, &peak);
    return peak;
}

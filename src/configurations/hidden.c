// Hides an unknown of a group's system, and restores all unknowns.
#include "configurations/hidden.h"
#include "num/complex.h"

enum { N_MAX = 2 * YK_SYSTEM_LOOPS_MAX };

// Returns which line a slide follows once everything is seen from the body with the angle `from`.
static int line_from(int turning, int from)
{
    if (from < 0) return turning;
    return turning == from ? -1 : turning < 0 ? from : turning;
}

// Returns the unknown with a number among those that can be hidden: slides first, then angles with which no line turns.
// shape->unknowns: there are fewer.
static size_t find_hidden(const YkShape *shape, size_t number)
{
    size_t n = shape->unknowns, slides = n - shape->angles;
    if (number < slides) return shape->angles + number;
    for (size_t angle = 0, at = slides; angle < shape->angles; angle++) {
        bool turns = false;
        for (size_t k = shape->angles; k < n; k++) turns |= shape->turning[k] == (int)angle;
        if (!turns && at++ == number) return angle;
    }
    return n;
}

bool yk_hide(YkHidden *h, const YkShape *shape, const YkVec *coefficients, size_t number)
{
    size_t n = shape->unknowns, hidden = find_hidden(shape, number);
    if (hidden == n) return false;
    bool is_angle = hidden < shape->angles;
    *h = (YkHidden){.loops = shape->loops, .is_angle = is_angle, .hidden = hidden};
    h->angles = shape->angles - is_angle;
    h->slides = n - shape->angles - !is_angle;
    h->seen_from = shape->turning[h->hidden];
    int place[N_MAX];
    for (size_t k = 0, count = 0; k < n; k++) {
        place[k] = k == h->hidden ? -1 : (int)count;
        if (k != h->hidden) h->unknown[count++] = k;
    }
    for (size_t k = h->angles; k < h->angles + h->slides; k++) {
        int turning = line_from(shape->turning[h->unknown[k]], h->seen_from);
        h->turning[k - h->angles] = turning < 0 ? -1 : place[turning];
    }
    for (size_t row = 0; row < 2 * h->loops; row++) {
        const YkVec *from = coefficients + row * (n + 1);
        YkVec *to = h->coefficients + row * n;
        for (size_t k = 0; k < n - 1; k++) to[k] = from[h->unknown[k]];
        to[n - 1] = from[n];
        h->times[row] = from[h->hidden];
        if (h->seen_from < 0) continue;
        to[n - 1] = from[h->seen_from];
        to[place[h->seen_from]] = from[n];
    }
    return true;
}

// Adds |row|^2 to the normal equations of the distances; the last entry is what the row has without them.
static void add_row(size_t count, const YkVec *row, YkVec *A, YkVec *b)
{
    for (size_t i = 0; i < count; i++) {
        YkVec a = yk_conj(row[i]);
        for (size_t j = 0; j < count; j++) A[i * count + j] = yk_add_product(A[i * count + j], a, row[j]);
        b[i] = yk_sub(b[i], yk_mul(a, row[count]));
    }
}

static bool find_distances(const YkHidden *h, YkVec hidden, const YkVec *angles, YkVec *distances)
{
    YkVec A[N_MAX * N_MAX] = {{0, 0}};
    int pivot[N_MAX];
    size_t n = h->angles + h->slides + 1;
    for (size_t k = 0; k < h->slides; k++) distances[k] = yk_vec(0, 0);
    for (size_t r = 0; r < 2 * h->loops; r++) {
        const YkVec *a = h->coefficients + r * n;
        YkVec row[N_MAX],
            sum = yk_add_product(a[n - 1], h->times[r], r < h->loops || !h->is_angle ? hidden : yk_inverse(hidden));
        for (size_t k = 0; k < h->angles; k++)
            sum = yk_add_product(sum, a[k], r < h->loops ? angles[k] : yk_inverse(angles[k]));
        for (size_t k = 0; k < h->slides; k++) {
            int turning = h->turning[k];
            YkVec way = turning < 0 ? yk_vec(1, 0) : r < h->loops ? angles[turning] : yk_inverse(angles[turning]);
            row[k] = yk_mul(a[h->angles + k], way);
        }
        row[h->slides] = sum;
        add_row(h->slides, row, A, distances);
    }
    if (!yk_complex_factor(h->slides, A, pivot)) return false;
    yk_complex_solve(h->slides, A, pivot, distances);
    return true;
}

bool yk_hidden_restore(const YkHidden *h, YkVec hidden, const YkVec *angles, YkVec *x)
{
    YkVec distances[N_MAX], own = yk_vec(1, 0);
    if (h->slides > 0 && !find_distances(h, hidden, angles, distances)) return false;
    for (size_t k = 0; k < h->angles; k++) {
        x[h->unknown[k]] = angles[k];
        if ((int)h->unknown[k] == h->seen_from) own = yk_inverse(angles[k]);
    }
    for (size_t k = 0; k < h->angles && h->seen_from >= 0; k++)
        x[h->unknown[k]] = (int)h->unknown[k] == h->seen_from ? own : yk_mul(angles[k], own);
    for (size_t k = 0; k < h->slides; k++) x[h->unknown[h->angles + k]] = distances[k];
    x[h->hidden] = hidden;
    return true;
}

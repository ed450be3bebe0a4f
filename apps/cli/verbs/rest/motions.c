// The small motions with damping and with loads that follow the machine, for people, where the modes leave them out.
#include <math.h>
#include "elementary/elementary.h"
#include "verbs/rest/rest.h"
#include "write/table.h"

static const double full_turn = 6.28318530717958647692;
static const double damping_noise = 1e-20;  // of the largest rate: without damping, far less is left
static const double stiffness_noise = 1e-6; // of the largest stiffness, which is a difference of accelerations
static const double root_noise = 1e-10;     // of the largest root

// Returns the largest |a[i][j] - (is_transposed_less ? a[j][i] : 0)|, beside the inertias of its row and column.
static double largest(const YkRestAnswer *answer, size_t index, const double *a, bool is_transposed_less)
{
    size_t f = yk_rest_freedom(answer->rest);
    const double *M = yk_rest_mass(answer->rest, index);
    double most = 0;
    for (size_t i = 0; i < f; i++)
        for (size_t j = 0; j < f; j++) {
            double value = a[i * f + j] - (is_transposed_less ? a[j * f + i] : 0);
            most = fmax(most, fabs(value) / sqrt(M[i * f + i] * M[j * f + j]));
        }
    return most;
}

// Returns what the modes leave out, as the sentence before the table; NULL if they are the whole motion.
static const char *left_out(const YkRestAnswer *answer, size_t index)
{
    double stiffness = largest(answer, index, yk_rest_stiffness(answer->rest, index), false);
    double damping = largest(answer, index, yk_rest_damping(answer->rest, index), false);
    double skew = largest(answer, index, yk_rest_stiffness(answer->rest, index), true);
    bool has_damping = damping > damping_noise * sqrt(stiffness), has_skew = skew > stiffness_noise * stiffness;
    if (has_damping && has_skew)
        return "\n  The modes leave out damping and loads without a potential. With both, the small motions are:\n";
    if (has_skew) return "\n  The modes leave out loads without a potential. With them, the small motions are:\n";
    return has_damping ? "\n  The modes leave out damping. With it, the small motions are:\n" : NULL;
}

static double largest_root(const YkRestAnswer *answer, size_t index)
{
    double size = 0, real, imaginary;
    for (size_t k = 2 * yk_rest_freedom(answer->rest); k-- > 0;) {
        yk_rest_root(answer->rest, index, k, &real, &imaginary);
        size = fmax(size, yk_hypot(real, imaginary));
    }
    return size;
}

void yk_rest_motions(const YkRestAnswer *answer, size_t index)
{
    const char *sentence = left_out(answer, index);
    if (!sentence) return;
    YkText *out = &answer->session->out;
    YkTable *table = yk_table_new(4);
    static const char *const heads[] = {"small motion", "frequency", "period", "growth"};
    static const char *const units[] = {NULL, "Hz", "s", "1/s"};
    for (size_t i = 0; i < 4; i++) yk_table_head(table, heads[i], units[i]);
    double limit = root_noise * largest_root(answer, index), real, imaginary;
    for (size_t k = 2 * yk_rest_freedom(answer->rest); k-- > 0;) {
        yk_rest_root(answer->rest, index, k, &real, &imaginary);
        if (imaginary < 0) continue; // the other of a pair
        double hertz = imaginary > limit ? imaginary / full_turn : (double)NAN, growth = fabs(real) > limit ? real : 0;
        yk_table_word(table, growth > 0 ? "grows" : growth < 0 ? "dies out" : "stays");
        yk_table_number(table, hertz, YK_DIGITS);
        yk_table_number(table, 1 / hertz, YK_DIGITS);
        yk_table_number(table, growth, YK_DIGITS);
    }
    yk_text_puts(out, sentence);
    yk_table_write(table, 2, out);
    yk_table_free(table);
}

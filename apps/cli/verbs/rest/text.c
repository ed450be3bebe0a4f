// `yoke rest` for people.
#include <math.h>
#include "verbs/rest/rest.h"
#include "write/table.h"

static const double noise = 1e-12;         // of the largest: stiffnesses are differences
static const double damping_noise = 1e-20; // without damping, far less is left

enum { SHAPES_MAX = 8 }; // columns that fit a page; the JSON has all

static void add_coordinates(const YkRestAnswer *answer, const YkState *state, bool is_distance)
{
    const YkSession *session = answer->session;
    YkTable *table = yk_table_new(2);
    yk_table_head(table, is_distance ? "distance" : "angle", NULL);
    yk_table_head(table, "at rest", yk_unit_of(session, yk_quantity_of(is_distance, 0)));
    for (size_t i = 0; i < yk_coordinate_count(answer->mech); i++) {
        YkCoordinateInfo info = yk_coordinate_info(answer->mech, i);
        if (info.is_distance != is_distance) continue;
        yk_table_word(table, info.name);
        yk_table_number(table,
                        yk_shown(session, yk_state_coordinate(state, i).position, yk_quantity_of(is_distance, 0)),
                        YK_DIGITS);
    }
    yk_table_show(table, NULL, &answer->session->out);
}

static size_t shapes(const YkRestAnswer *answer)
{
    size_t freedom = yk_rest_freedom(answer->rest);
    return freedom <= SHAPES_MAX ? freedom : 0;
}

static double without_noise(double value, double limit)
{
    return fabs(value) <= limit ? 0 : value;
}

// Returns an entry of M, C or K relative to the inertias of its row and column: 1, a rate, the square of one.
static double beside_inertia(const YkRestAnswer *answer, size_t index, const double *entries, size_t i)
{
    size_t size = shapes(answer);
    const double *M = yk_rest_mass(answer->rest, index);
    return fabs(entries[i]) / sqrt(M[i / size * (size + 1)] * M[i % size * (size + 1)]);
}

static double largest_beside_inertia(const YkRestAnswer *answer, size_t index, const double *entries)
{
    double largest = 0;
    for (size_t i = 0; i < shapes(answer) * shapes(answer); i++)
        largest = fmax(largest, beside_inertia(answer, index, entries, i));
    return largest;
}

// Writes frequencies, damping and shapes, in SI: the motion of each free input relative to the largest, 1.
static void add_modes(const YkRestAnswer *answer, size_t index)
{
    size_t freedom = yk_rest_freedom(answer->rest), columns = shapes(answer);
    YkTable *table = yk_table_new(5 + columns);
    YkText words = {0};
    static const char *const heads[] = {"mode", "frequency", "period", "damping ratio", "growth"};
    static const char *const units[] = {NULL, "Hz", "s", NULL, "1/s"};
    for (size_t i = 0; i < 5; i++) yk_table_head(table, heads[i], units[i]);
    for (size_t k = 0; k < columns; k++)
        yk_table_head(table, yk_coordinate_info(answer->mech, yk_rest_input(answer->rest, k)).name, NULL);
    for (size_t k = 0; k < freedom; k++) {
        YkMode mode = yk_rest_mode(answer->rest, index, k);
        double hertz = yk_mode_hertz(mode);
        yk_text_clear(&words);
        yk_text_format(&words, "%z", k + 1);
        yk_table_word(table, yk_text_get(&words));
        yk_table_number(table, hertz, YK_DIGITS);
        yk_table_number(table, hertz > 0 ? 1 / hertz : (double)NAN, YK_DIGITS);
        yk_table_number(table, hertz > 0 ? without_noise(mode.damping_ratio, damping_noise) : (double)NAN, YK_DIGITS);
        yk_table_number(table, mode.frequency < 0 ? -mode.frequency : (double)NAN, YK_DIGITS);
        for (size_t i = 0; i < columns; i++) yk_table_number(table, without_noise(mode.shape[i], noise), YK_DIGITS);
    }
    yk_table_show(table, NULL, &answer->session->out);
    yk_text_free(&words);
}

static void add_matrix(const YkRestAnswer *answer, const char *name, const double *entries, size_t index)
{
    size_t size = shapes(answer);
    double rate = sqrt(largest_beside_inertia(answer, index, yk_rest_stiffness(answer->rest, index)));
    bool is_damping = entries == yk_rest_damping(answer->rest, index);
    double limit = noise * largest_beside_inertia(answer, index, entries);
    if (is_damping) limit = fmax(limit, damping_noise * rate); // without damping, noise is the largest
    YkTable *table = yk_table_new(size + 1);
    yk_table_head(table, name, NULL);
    for (size_t k = 0; k < size; k++)
        yk_table_head(table, yk_coordinate_info(answer->mech, yk_rest_input(answer->rest, k)).name, NULL);
    for (size_t row = 0; row < size; row++) {
        yk_table_word(table, yk_coordinate_info(answer->mech, yk_rest_input(answer->rest, row)).name);
        for (size_t k = 0; k < size; k++) {
            bool is_noise = beside_inertia(answer, index, entries, row * size + k) <= limit;
            yk_table_number(table, is_noise ? 0 : entries[row * size + k], YK_DIGITS);
        }
    }
    yk_table_show(table, NULL, &answer->session->out);
}

static void add_equilibrium(const YkRestAnswer *answer, size_t index)
{
    YkSession *session = answer->session;
    YkText *out = &session->out;
    YkEquilibrium rest = yk_rest_equilibrium(answer->rest, index);
    const YkState *state = yk_rest_state(answer->rest, index);
    yk_text_format(out, "\nEquilibrium %z: %s, potential energy ", index + 1, yk_stability_word(rest.stability));
    yk_add_value(session, out, rest.potential, YK_QUANTITY_ENERGY, YK_DIGITS);
    yk_text_puts(out, rest.is_reachable ? "\n" : "; not reachable from the start in its own assembly\n");
    if (rest.is_higher_order)
        yk_text_puts(out,
                     "K is 0: the force grows with a higher power of the distance, and a frequency with the swing\n");
    add_coordinates(answer, state, false);
    add_coordinates(answer, state, true);
    add_modes(answer, index);
    yk_rest_motions(answer, index);
    if (!session->request->modes) return;
    add_matrix(answer, "M (SI)", yk_rest_mass(answer->rest, index), index);
    add_matrix(answer, "C (SI)", yk_rest_damping(answer->rest, index), index);
    add_matrix(answer, "K (SI)", yk_rest_stiffness(answer->rest, index), index);
}

// Scales energies by the largest of them, and by weights times the machine's size.
static void find_scale(const YkRestAnswer *answer)
{
    YkSession *session = answer->session;
    const double about_g = 10; // m/s^2
    yk_scale_begin(session);
    session->scale.is_exact = false; // a pose at rest comes from a search
    for (size_t i = 0; i < yk_rest_count(answer->rest); i++)
        yk_scale_add(session, yk_rest_equilibrium(answer->rest, i).potential, YK_QUANTITY_ENERGY);
    if (yk_model_loads(session->model).has_gravity)
        yk_scale_add(session, session->scale.mass * about_g, YK_QUANTITY_FORCE);
}

void yk_rest_text(const YkRestAnswer *answer)
{
    const YkSession *session = answer->session;
    size_t count = yk_rest_count(answer->rest);
    find_scale(answer);
    yk_text_format(&answer->session->out, "%s: %z equilibri%s found%s\n", yk_model_name(session->model), count,
                   count == 1 ? "um" : "a",
                   yk_rest_is_complete(answer->rest) ? " on all circuits"
                   : yk_rest_is_wound(answer->rest)  ? " in one turn; its loads differ in other turns"
                                                     : "; there may be others");
    for (size_t i = 0; i < count; i++) add_equilibrium(answer, i);
}

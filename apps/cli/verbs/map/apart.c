// Hints at a coordinate that distinguishes the configurations of --pose.
#include <math.h>
#include "session.h"
#include "verbs/map/map.h"

enum { LISTED_MAX = 8 }; // values: more do not fit a line

// Returns the least difference between two values of a coordinate over the largest value. rows: [count][n].
static double least_gap(const double *rows, size_t count, size_t n, size_t coordinate)
{
    double least = INFINITY, most = 0;
    for (size_t k = 0; k < count; k++) {
        double value = rows[k * n + coordinate];
        most = fmax(most, fabs(value));
        for (size_t j = 0; j < k; j++) least = fmin(least, fabs(value - rows[j * n + coordinate]));
    }
    return most > 0 ? least / most : 0;
}

// Writes "theta3 is 20 deg or 60 deg" for the coordinate that differs most between the poses. Returns false if none
// does.
static bool add_values(const YkMapAnswer *answer, const double *given, const double *rows, size_t count, YkText *text)
{
    const YkMechanism *mech = answer->session->mech;
    size_t n = yk_coordinate_count(mech), best = YK_NOT_FOUND;
    double widest = 0.02; // values are recognised by about two digits
    for (size_t c = 0; c < n; c++) {
        double gap = isnan(given[c]) ? least_gap(rows, count, n, c) : 0;
        if (gap > widest) widest = gap, best = c;
    }
    if (best == YK_NOT_FOUND) return false;
    YkCoordinateInfo info = yk_coordinate_info(mech, best);
    yk_text_format(text, "give another coordinate too: `%s` is", info.name);
    for (size_t k = 0; k < count; k++) {
        yk_text_puts(text, k == 0 ? " " : k + 1 < count ? ", " : " or ");
        yk_add_value(answer->session, text, rows[k * n + best], yk_quantity_of(info.is_distance, 0), 5);
    }
    return true;
}

void yk_map_hint_apart(const YkMapAnswer *answer, const double *given, const YkMapPlace *places, size_t count)
{
    size_t n = yk_coordinate_count(answer->session->mech);
    double *rows = count <= LISTED_MAX ? yk_session_alloc(answer->session, count * n + 1, sizeof *rows) : NULL;
    YkText text = {0};
    bool good = rows;
    for (size_t k = 0; k < count && good; k++) good = yk_map_coordinates_at(answer->map, places[k], rows + k * n);
    if (good && add_values(answer, given, rows, count, &text))
        yk_problem_hint(answer->session->problems, "%s", yk_text_get(&text));
    else
        yk_problem_hint(answer->session->problems, "give another coordinate too; `yoke solve --all` lists them");
    yk_text_free(&text);
}

// `yoke synthesize` for people.
#include <math.h>
#include "verbs/synthesize/synthesize.h"
#include "write/table.h"

enum { DIGITS = 6, DYADS_SHOWN = 12, DEFECTS_SHOWN = 200 };

typedef struct Units {
    const char *length, *angle;
    double length_size, angle_size;
} Units;

static void add_number_word(YkTable *table, size_t number)
{
    YkText word = {0};
    yk_text_format(&word, "%z", number);
    yk_table_word(table, yk_text_get(&word));
    yk_text_free(&word);
}

static void add_dyads(YkText *out, const YkSynthesis *synthesis, const Units *u)
{
    static const char *const kinds[] = {"RR", "PR", "RP"};
    size_t count = yk_synthesis_dyad_count(synthesis);
    if (count == 0) return;
    if (count > DYADS_SHOWN) {
        yk_text_format(out, "%z dyads were taken from those that reach the positions; the JSON lists them.\n", count);
        return;
    }
    YkTable *table = yk_table_new(8);
    static const char *const heads[] = {"dyad", "kind", "fixed x", "y", "moving x", "y", "length"};
    for (size_t k = 0; k < 7; k++) yk_table_head(table, heads[k], k < 2 ? NULL : u->length);
    yk_table_head(table, "line", u->angle);
    for (size_t k = 0; k < count; k++) {
        YkDyad d = yk_synthesis_dyad(synthesis, k);
        const double lengths[] = {d.fixed[0], d.fixed[1], d.moving[0], d.moving[1]};
        add_number_word(table, k + 1);
        yk_table_word(table, kinds[d.kind]);
        for (size_t i = 0; i < 4; i++) yk_table_number(table, lengths[i] / u->length_size, DIGITS);
        if (d.kind == YK_DYAD_RR) {
            yk_table_number(table, d.length / u->length_size, DIGITS);
            yk_table_word(table, "-");
        } else {
            yk_table_word(table, "-");
            yk_table_number(table, d.direction / u->angle_size, DIGITS);
        }
    }
    yk_table_show(table, NULL, out);
}

// Returns whether a deviation is an angle: of functions and strokes, but for those of a slider.
static bool is_turning(const char *kind, const YkCandidate *c)
{
    return (kind[0] == 'f' || kind[0] == 's') && c->lengths[3] > 0;
}

static void add_candidates(YkText *out, const YkSynthesis *synthesis, const Units *u, const char *kind)
{
    size_t count = yk_synthesis_count(synthesis), turning = 0;
    if (count == 0) return;
    bool is_evened = false, has_offset = false;
    YkText both = {0};
    for (size_t k = 0; k < count; k++) {
        YkCandidate c = yk_synthesis_candidate(synthesis, k);
        turning += is_turning(kind, &c);
        has_offset = has_offset || !isnan(c.offset);
        is_evened = is_evened || !isnan(yk_synthesis_interpolating(synthesis, k));
    }
    yk_text_format(&both, "%s, sliders %s", u->angle, u->length);
    const char *deviation = turning == count ? u->angle : turning == 0 ? u->length : yk_text_get(&both);
    YkTable *table = yk_table_new(10 + (size_t)has_offset + is_evened);
    static const char *const heads[] = {"rank",    "type",   "worst",  "transmission from", "to", "ground", "input",
                                        "coupler", "output", "offset", "circuits"};
    const char *units[] = {NULL,      NULL,      deviation, u->angle,  u->angle, u->length,
                           u->length, u->length, u->length, u->length, NULL};
    for (size_t k = 0; k < 11; k++)
        if (k != 9 || has_offset) yk_table_head(table, heads[k], units[k]);
    if (is_evened) yk_table_head(table, "interpolating", deviation);
    for (size_t k = 0; k < count; k++) {
        YkCandidate c = yk_synthesis_candidate(synthesis, k);
        bool is_angle = is_turning(kind, &c);
        double noise = is_angle ? 1e-9 : 1e-9 * c.size, unit = is_angle ? u->angle_size : u->length_size;
        add_number_word(table, k + 1);
        yk_table_word(table, c.type);
        yk_table_number(table, c.worst < noise ? 0 : c.worst / unit, DIGITS);
        for (size_t i = 0; i < 2; i++) yk_table_number(table, c.transmission[i] / u->angle_size, DIGITS);
        for (size_t i = 0; i < 4; i++) {
            if (c.lengths[i] > 0)
                yk_table_number(table, c.lengths[i] / u->length_size, DIGITS);
            else
                yk_table_word(table, "-");
        }
        if (has_offset && isnan(c.offset)) yk_table_word(table, "-");
        if (has_offset && !isnan(c.offset))
            yk_table_number(table, fabs(c.offset) < 1e-9 * c.size ? 0 : c.offset / u->length_size, DIGITS);
        add_number_word(table, c.circuits);
        double before = yk_synthesis_interpolating(synthesis, k);
        if (is_evened && isnan(before)) yk_table_word(table, "-");
        if (is_evened && !isnan(before)) yk_table_number(table, before / unit, DIGITS);
    }
    yk_table_show(table, NULL, out);
    yk_text_free(&both);
}

// Names the links that begin half a turn from the angles that the task fixes.
static void add_reversed(YkText *out, const YkSynthesis *synthesis)
{
    for (size_t k = 0; k < yk_synthesis_count(synthesis); k++) {
        bool input = yk_synthesis_is_reversed(synthesis, k, false),
             output = yk_synthesis_is_reversed(synthesis, k, true);
        if (!input && !output) continue;
        yk_text_format(
            out, "\n%z: the %s half a turn from the angle in `fix`: written with a negative length, %s there.\n", k + 1,
            input && output ? "input and the output begin"
            : input         ? "input begins"
                            : "output begins",
            input && output ? "they begin" : "it begins");
    }
}

// Parameters of a machine, each in the unit of its file.
static void add_machines(YkText *out, const YkSynthesisAnswer *answer)
{
    const YkSynthesis *synthesis = answer->synthesis;
    size_t count = yk_synthesis_count(synthesis), free_count = 0;
    double value = 0;
    if (count == 0) return;
    while (yk_synthesis_parameter(synthesis, 0, free_count, &value)) free_count++;
    YkTable *table = yk_table_new(2 + free_count);
    yk_table_head(table, "rank", NULL);
    yk_table_head(table, "error", "SI");
    for (size_t i = 0; i < free_count; i++)
        yk_table_head(table, yk_synthesis_parameter(synthesis, 0, i, NULL),
                      yk_task_parameter_unit(answer->task, i, NULL));
    for (size_t k = 0; k < count; k++) {
        add_number_word(table, k + 1);
        yk_table_number(table, yk_synthesis_candidate(synthesis, k).error, DIGITS);
        for (size_t i = 0; i < free_count; i++) {
            double size = 1;
            yk_task_parameter_unit(answer->task, i, &size);
            yk_synthesis_parameter(synthesis, k, i, &value);
            yk_table_number(table, value / size, DIGITS);
        }
    }
    yk_table_show(table, NULL, out);
}

static void add_left_out(YkText *out, const YkSynthesis *synthesis)
{
    size_t kinds = 0;
    for (int k = 1; k < YK_DEFECT_COUNT; k++) {
        size_t count = yk_synthesis_left_out(synthesis, (YkDefect)k);
        if (count == 0) continue;
        yk_text_format(out, "%s%z %s", kinds++ == 0 ? "\nleft out: " : ", ", count, yk_defect_name((YkDefect)k));
    }
    if (kinds > 0) yk_text_puts(out, "\n");
}

static void add_defects(YkText *out, const YkSynthesis *synthesis, const Units *u)
{
    size_t count = yk_synthesis_defect_count(synthesis);
    if (count == 0) return;
    YkTable *table = yk_table_new(7);
    static const char *const heads[] = {"left out for", "dyads", "type", "ground", "input", "coupler", "output"};
    for (size_t k = 0; k < 7; k++) yk_table_head(table, heads[k], k < 3 ? NULL : u->length);
    for (size_t k = 0; k < count && k < DEFECTS_SHOWN; k++) {
        YkCandidate c = yk_synthesis_defect(synthesis, k);
        YkText pair = {0};
        if (c.dyads[0] >= 0) yk_text_format(&pair, "%d, %d", c.dyads[0] + 1, c.dyads[1] + 1);
        yk_table_word(table, yk_defect_name(c.defect));
        yk_table_word(table, yk_text_get(&pair));
        yk_table_word(table, c.type);
        for (size_t i = 0; i < 4; i++) {
            if (c.lengths[i] > 0)
                yk_table_number(table, c.lengths[i] / u->length_size, DIGITS);
            else
                yk_table_word(table, "-");
        }
        yk_text_free(&pair);
    }
    yk_table_show(table, NULL, out);
    if (count > DEFECTS_SHOWN) yk_text_format(out, "and %z more\n", count - DEFECTS_SHOWN);
}

// Says how many solutions the equations have, and whether all of them were found.
static void add_solutions(YkText *out, const YkSynthesis *synthesis, size_t complex_count, size_t real_count)
{
    enum { OF_NINE_POINTS = 8652 }; // the only ones that may be missing
    if (yk_synthesis_is_complete(synthesis)) {
        yk_text_format(out, "The equations have %z solutions, %z of them real: all are here.\n", complex_count,
                       real_count);
        return;
    }
    if (complex_count < OF_NINE_POINTS)
        yk_text_format(out, "General points have %d solutions; for these %z were found, %z of them real.\n",
                       (int)OF_NINE_POINTS, complex_count, real_count);
    else
        yk_text_format(out, "The equations of four-bars have %z solutions, %z of them real.\n", complex_count,
                       real_count);
    yk_text_puts(out, "Machines that miss the points come from least squares from random starts: other seeds may find "
                      "other ones.\n");
}

void yk_synthesis_text(const YkSynthesisAnswer *answer)
{
    YkText *out = &answer->session->out;
    const YkSynthesis *synthesis = answer->synthesis;
    const char *word = yk_synthesis_word(answer), *kind = yk_task_kind(answer->task);
    size_t count = yk_synthesis_count(synthesis), complex_count, real_count;
    Units u;
    u.length = yk_task_unit(answer->task, YK_QUANTITY_LENGTH, &u.length_size);
    u.angle = yk_task_unit(answer->task, YK_QUANTITY_ANGLE, &u.angle_size);
    yk_text_format(out, "%s: %s, %z machine%s\n", yk_task_name(answer->task), kind, count, count == 1 ? "" : "s");
    bool has_solutions = yk_synthesis_solutions(synthesis, &complex_count, &real_count);
    if (has_solutions)
        add_solutions(out, synthesis, complex_count, real_count);
    else if (kind[1] == 'a') // path, machine
        yk_text_puts(out, "Least squares from random starts: other seeds may find other machines.\n");
    else if (!yk_synthesis_is_complete(synthesis))
        yk_text_puts(out, "The task leaves a choice: samples of it were tried, and the best are shown.\n");
    if (word[0] == 't' || word[0] == 'i') yk_text_puts(out, "The search was ended early: these are the best so far.\n");
    add_dyads(out, synthesis, &u);
    if (kind[0] == 'm' && kind[1] == 'a') { // "machine"
        add_machines(out, answer);
        add_left_out(out, synthesis);
        return;
    }
    add_candidates(out, synthesis, &u, kind);
    add_reversed(out, synthesis);
    add_left_out(out, synthesis);
    if (answer->session->request->defects) add_defects(out, synthesis, &u);
}

// Writes the model file of a design.
#include <math.h>
#include "base/number.h"
#include "synthesis/design.h"

enum { DIGITS = 12, PATH_DIGITS = 15, ALL_DIGITS = 17 }; // of lengths and angles: of a search, of a path; of a formula

typedef struct Writer {
    YkText *text;
    double unit; // of length, m
    int digits;
} Writer;

static void add_number(const Writer *w, double value)
{
    char digits[YK_NUMBER_SIZE];
    size_t length = yk_number_write_digits(value == 0 ? 0 : value, w->digits, digits);
    yk_text_add(w->text, digits, length);
}

static void add_length(const Writer *w, const char *before, double value)
{
    yk_text_puts(w->text, before);
    add_number(w, value / w->unit);
}

static void add_angle(const Writer *w, const char *before, double value, const char *after)
{
    yk_text_puts(w->text, before);
    add_number(w, value * 180 / YK_PI);
    yk_text_puts(w->text, after);
}

static void add_name(const Writer *w, const YkText *name)
{
    YkNode scalar = {.kind = YK_NODE_SCALAR, .text = yk_text_get(name), .length = name->length};
    yk_text_puts(w->text, "name: ");
    yk_doc_write_scalar(&scalar, w->text);
    if (name->failed) yk_text_fail(w->text);
}

static void add_head(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    bool is_four_bar = design->kind == YK_DESIGN_FOUR_BAR;
    const YkTask *task = journey->task;
    YkText name = {0};
    if (!task) {
        yk_text_puts(&name, journey->name);
        yk_text_format(w->text, "# %s\n", journey->origin);
        add_name(w, &name);
        yk_text_free(&name);
        return;
    }
    yk_text_format(&name, "%s, %s", yk_task_name(task), is_four_bar ? "four-bar" : "slider-crank");
    if (design->dyad[0] >= 0) yk_text_format(&name, " of dyads %d and %d", design->dyad[0] + 1, design->dyad[1] + 1);
    yk_text_format(w->text, "# Found by `yoke synthesize` for a task of the kind %s. Lengths are parameters.\n",
                   yk_task_kind(task));
    add_name(w, &name);
    yk_text_free(&name);
}

static void add_parameters(const Writer *w, const YkDesign *design)
{
    bool is_four_bar = design->kind == YK_DESIGN_FOUR_BAR;
    add_length(w, "\nparameters:\n  {x1: ", design->pivot[0].x);
    add_length(w, ", y1: ", design->pivot[0].y);
    add_length(w, ", x2: ", design->pivot[1].x);
    add_length(w, ", y2: ", design->pivot[1].y);
    add_length(w, ", a: ", design->length[1]);
    add_length(w, ", b: ", design->length[2]);
    if (is_four_bar) add_length(w, ", c: ", design->length[3]);
    if (design->has_point) {
        add_length(w, ", px: ", design->point.x);
        add_length(w, ", py: ", design->point.y);
    }
    yk_text_puts(w->text, "}\n");
}

static void add_bodies(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    bool is_four_bar = design->kind == YK_DESIGN_FOUR_BAR;
    yk_text_puts(w->text, is_four_bar ? "bodies:\n  ground: {points: {A0: [x1, y1], B0: [x2, y2]"
                                      : "bodies:\n  ground: {points: {A0: [x1, y1], R: [x2, y2]");
    for (size_t k = 0; k < journey->count && (journey->pose || journey->point); k++) {
        YkVec at = journey->pose ? journey->pose[k].at : journey->point[k];
        yk_text_format(w->text, ", T%z: [", k + 1);
        add_length(w, "", at.x);
        add_length(w, ", ", at.y);
        yk_text_puts(w->text, "]");
    }
    yk_text_puts(w->text, "}}\n  input: {points: {A0: [0, 0], A: [a, 0]}}\n  coupler: {points: {A: [0, 0], B: [b, 0]");
    if (design->has_point) { // P and Q lie on the x axis of the task's body
        YkVec mark = yk_add(design->point, yk_scale(design->length[2] / 4, yk_unit(design->turn)));
        yk_text_puts(w->text, ", P: [px, py]");
        add_length(w, ", Q: [", mark.x);
        add_length(w, ", ", mark.y);
        yk_text_puts(w->text, "]");
    }
    yk_text_puts(w->text, is_four_bar ? "}}\n  output: {points: {B0: [0, 0], B: [c, 0]}}\n"
                                      : "}}\n  slider: {points: {B: [0, 0]}}\n");
}

static void add_joints(const Writer *w, const YkDesign *design)
{
    yk_text_puts(w->text, "joints:\n  A0: {pin: [ground, input], angle: theta}\n"
                          "  A: {pin: [input, coupler], angle: phi}\n");
    if (design->kind == YK_DESIGN_FOUR_BAR) {
        yk_text_puts(w->text, "  B0: {pin: [ground, output], angle: psi}\n  B: {pin: [coupler, output]}\n");
        return;
    }
    add_angle(w, "  S: {slide: [ground, slider], along: ", design->along, " deg, from: R, to: B, distance: s}\n");
    yk_text_puts(w->text, "  B: {pin: [coupler, slider]}\n");
}

// A crank turns steadily; any other input swings between the ends of its way, in a second each.
static void add_drive(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    if (journey->count == 0) return;
    double first = journey->input[0], low = first, high = first, last = journey->input[journey->count - 1];
    if (journey->turns || yk_design_turns(design)) {
        add_angle(w, "drives: {theta: ", first, last < first ? " deg - 60 rpm * t}\n" : " deg + 60 rpm * t}\n");
        return;
    }
    for (size_t k = 0; k < journey->count; k++) {
        low = fmin(low, journey->input[k]);
        high = fmax(high, journey->input[k]);
    }
    double middle = (low + high) / 2, half = (high - low) / 2, part = fmin(fmax((first - middle) / half, -1), 1);
    double phase = first == high ? 0 : first == low ? YK_PI : yk_acos(part);
    add_angle(w, "drives: {theta: ", middle, " deg + ");
    add_angle(w, "", half, " deg * cos(180 deg/s * t + ");
    add_angle(w, "", phase, " deg)}\n");
}

void yk_design_write(const YkDesign *design, const YkJourney *journey, YkText *text)
{
    Writer writer = {.text = text}, *w = &writer;
    const YkModel *sheet = journey->task ? journey->task->sheet : journey->sheet;
    const char *unit = yk_model_unit(sheet, YK_QUANTITY_LENGTH, &writer.unit);
    writer.digits = !journey->task ? ALL_DIGITS : journey->point ? PATH_DIGITS : DIGITS;
    add_head(w, design, journey);
    add_parameters(w, design);
    add_bodies(w, design, journey);
    add_joints(w, design);
    add_drive(w, design, journey);
    if (journey->count == 0) add_angle(w, "start: {theta: ", design->angle[0], ", phi: ");
    add_angle(w,
              journey->count == 0 ? "" : "start: {phi: ", yk_remainder(design->angle[1] - design->angle[0], 2 * YK_PI),
              "");
    if (design->kind == YK_DESIGN_FOUR_BAR)
        add_angle(w, ", psi: ", design->angle[2], "}\n");
    else {
        add_length(w, ", s: ", design->angle[2]);
        yk_text_puts(text, "}\n");
    }
    yk_text_format(text, "units: {length: %s, angle: deg}\n", unit);
}

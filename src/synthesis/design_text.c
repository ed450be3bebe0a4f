// Writes the model file of a design.
#include <math.h>
#include "synthesis/design_writer.h"
#include "synthesis/paths/path_chain.h"

enum { DIGITS = 12, PATH_DIGITS = 15, ALL_DIGITS = 17 }; // of lengths and angles: of a search, of a path; of a formula

typedef YkDesignWriter Writer;

static void add_name(const Writer *w, const YkText *name)
{
    YkNode scalar = {.kind = YK_NODE_SCALAR, .text = yk_text_get(name), .length = name->length};
    yk_text_puts(w->text, "name: ");
    yk_doc_write_scalar(&scalar, w->text);
    if (name->failed) yk_text_fail(w->text);
}

static void add_head(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    const YkTask *task = journey->task;
    YkText name = {0};
    if (!task) {
        yk_text_puts(&name, journey->name);
        yk_text_format(w->text, "# %s\n", journey->origin);
        add_name(w, &name);
        yk_text_free(&name);
        return;
    }
    yk_text_format(&name, "%s, %s", yk_task_name(task), yk_design_kind_name(design->kind));
    if (design->dyad[0] >= 0) yk_text_format(&name, " of dyads %d and %d", design->dyad[0] + 1, design->dyad[1] + 1);
    yk_text_format(w->text, "# Found by `yoke synthesize` for a task of the kind %s. Lengths are parameters.\n",
                   yk_task_kind(task));
    add_name(w, &name);
    yk_text_free(&name);
}

static void add_parameters(const Writer *w, const YkDesign *design)
{
    yk_write_length(w, "\nparameters:\n  {x1: ", design->pivot[0].x);
    yk_write_length(w, ", y1: ", design->pivot[0].y);
    yk_write_length(w, ", x2: ", design->pivot[1].x);
    yk_write_length(w, ", y2: ", design->pivot[1].y);
    yk_write_length(w, ", a: ", design->length[1]);
    if (yk_bar_is_length(design->kind, YK_BAR_COUPLER)) yk_write_length(w, ", b: ", design->length[2]);
    if (yk_bar_is_length(design->kind, YK_BAR_OUTPUT)) yk_write_length(w, ", c: ", design->length[3]);
    if (design->kind == YK_DESIGN_INVERTED) yk_write_length(w, ", e: ", design->length[3]);
    if (design->has_point) {
        yk_write_length(w, ", px: ", design->point.x);
        yk_write_length(w, ", py: ", design->point.y);
    }
    yk_write_dyad_parameters(w, design);
    yk_text_puts(w->text, "}\n");
}

static void add_ground(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    yk_text_puts(w->text, design->kind != YK_DESIGN_SLIDER_CRANK
                              ? "bodies:\n  ground: {points: {A0: [x1, y1], B0: [x2, y2]"
                              : "bodies:\n  ground: {points: {A0: [x1, y1], R: [x2, y2]");
    yk_write_dyad_points(w, design, YK_CHAIN_GROUND);
    for (size_t k = 0; k < journey->count && (journey->pose || journey->point); k++) {
        YkVec at = journey->pose ? journey->pose[k].at : journey->point[k];
        yk_text_format(w->text, ", T%z: [", k + 1);
        yk_write_length(w, "", at.x);
        yk_write_length(w, ", ", at.y);
        yk_text_puts(w->text, "]");
    }
    yk_text_puts(w->text, "}}\n");
}

static void add_coupler(const Writer *w, const YkDesign *design)
{
    if (design->kind == YK_DESIGN_GEARED) return;
    yk_text_puts(w->text, design->kind == YK_DESIGN_INVERTED ? "  coupler: {points: {A: [0, 0], K: [0, e]"
                                                             : "  coupler: {points: {A: [0, 0], B: [b, 0]");
    yk_write_dyad_points(w, design, YK_CHAIN_COUPLER);
    if (design->has_point &&
        yk_bar_size(design->kind) == YK_BAR_PLAIN) { // P and Q lie on the x axis of the task's body
        double apart = design->kind == YK_DESIGN_INVERTED ? design->length[1] : design->length[2] / 4;
        YkVec mark = yk_add(design->point, yk_scale(apart, yk_unit(design->turn)));
        yk_text_puts(w->text, ", P: [px, py]");
        yk_write_length(w, ", Q: [", mark.x);
        yk_write_length(w, ", ", mark.y);
        yk_text_puts(w->text, "]");
    }
    yk_text_puts(w->text, "}}\n");
}

static void add_output(const Writer *w, const YkDesign *design)
{
    if (design->kind == YK_DESIGN_SLIDER_CRANK) {
        yk_text_puts(w->text, "  slider: {points: {B: [0, 0]}}\n");
        return;
    }
    yk_text_puts(w->text, design->kind == YK_DESIGN_INVERTED ? "  output: {points: {B0: [0, 0]"
                                                             : "  output: {points: {B0: [0, 0], B: [c, 0]");
    yk_write_dyad_points(w, design, YK_CHAIN_OUTPUT);
    yk_text_puts(w->text, "}}\n");
}

static void add_bodies(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    add_ground(w, design, journey);
    yk_text_puts(w->text, "  input: {points: {A0: [0, 0], A: [a, 0]");
    yk_write_dyad_points(w, design, YK_CHAIN_INPUT);
    yk_text_puts(w->text, "}}\n");
    add_coupler(w, design);
    add_output(w, design);
    yk_write_dyad_bodies(w, design);
}

static void add_joints(const Writer *w, const YkDesign *design)
{
    yk_text_puts(w->text, "joints:\n  A0: {pin: [ground, input], angle: theta}\n");
    if (design->kind != YK_DESIGN_GEARED) yk_text_puts(w->text, "  A: {pin: [input, coupler], angle: phi}\n");
    if (design->kind == YK_DESIGN_SLIDER_CRANK) {
        yk_write_angle(w, "  S: {slide: [ground, slider], along: ", design->along,
                       " deg, from: R, to: B, distance: s}\n");
        yk_text_puts(w->text, "  B: {pin: [coupler, slider]}\n");
    } else if (design->kind == YK_DESIGN_INVERTED) {
        yk_text_puts(w->text, "  S: {slide: [coupler, output], along: x, from: K, to: B0, distance: s}\n"
                              "  B0: {pin: [ground, output]}\n");
    } else {
        yk_text_puts(w->text, "  B0: {pin: [ground, output], angle: psi}\n");
        if (design->kind != YK_DESIGN_GEARED) yk_text_puts(w->text, "  B: {pin: [coupler, output]}\n");
    }
    yk_write_dyad_joints(w, design);
}

// A crank turns steadily; any other input swings between the ends of its way, in a second each.
static void add_drive(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    if (journey->count == 0) return;
    double first = journey->input[0], low = first, high = first, last = journey->input[journey->count - 1];
    if (journey->turns || yk_design_turns(design)) {
        yk_write_angle(w, "drives: {theta: ", first, last < first ? " deg - 60 rpm * t}\n" : " deg + 60 rpm * t}\n");
        return;
    }
    for (size_t k = 0; k < journey->count; k++) {
        low = fmin(low, journey->input[k]);
        high = fmax(high, journey->input[k]);
    }
    double middle = (low + high) / 2, half = (high - low) / 2, part = fmin(fmax((first - middle) / half, -1), 1);
    double phase = first == high ? 0 : first == low ? YK_PI : yk_acos(part);
    yk_write_angle(w, "drives: {theta: ", middle, " deg + ");
    yk_write_angle(w, "", half, " deg * cos(180 deg/s * t + ");
    yk_write_angle(w, "", phase, " deg)}\n");
}

static void add_start(const Writer *w, const YkDesign *design, const YkJourney *journey)
{
    yk_text_puts(w->text, "start: {");
    if (journey->count == 0) yk_write_angle(w, "theta: ", design->angle[0], ", ");
    if (design->kind != YK_DESIGN_GEARED)
        yk_write_angle(w, "phi: ", yk_remainder(design->angle[1] - design->angle[0], 2 * YK_PI), ", ");
    if (design->kind == YK_DESIGN_SLIDER_CRANK || design->kind == YK_DESIGN_INVERTED)
        yk_write_length(w, "s: ", design->angle[2]);
    else
        yk_write_angle(w, "psi: ", design->angle[2], "");
    yk_write_dyad_start(w, design);
    yk_text_puts(w->text, "}\n");
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
    add_start(w, design, journey);
    yk_text_format(text, "units: {length: %s, angle: deg}\n", unit);
}

// Writes a gear train's motion for people: inputs, speeds, ratio, shift table.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "verbs/gears/gears.h"
#include "write/table.h"

enum { EXACT_MAX = 24, FORMULA_MAX = 100 };
static const double rpm = 30 / 3.14159265358979323846;

static const char *short_exact(const char *exact)
{
    return exact && strlen(exact) <= EXACT_MAX ? exact : "";
}

static bool is_unit(const YkTrain *train)
{
    return yk_train_input_count(train) == 1 && yk_train_input(train, 0).is_unit;
}

static void add_inputs(const YkGearsAnswer *answer)
{
    YkText *out = &answer->session->out;
    size_t count = yk_train_input_count(answer->train);
    if (count == 0) {
        yk_text_puts(out, "\nNothing drives the train: give `drives:`, or name an input with --in\n");
        return;
    }
    yk_text_puts(out, "\nInputs\n");
    for (size_t k = 0; k < count; k++) {
        YkTrainInput input = yk_train_input(answer->train, k);
        if (input.is_unit) {
            yk_text_format(out, "  one turn of %s\n", input.name);
        } else if (input.exact) {
            yk_text_format(out, "  %s: %s\n", input.name, input.exact);
        } else {
            yk_text_format(out, "  %s: %e %s\n", input.name, input.is_distance ? input.speed : input.speed * rpm,
                           input.is_distance ? "m/s" : "rpm");
        }
    }
}

static bool is_needed(const char *exact)
{
    return exact && strcmp(exact, "0") != 0;
}

// Writes "theta1*(1 + N1/N2) - theta2*N1/N2", the speed in terms of the inputs; as fractions where no formula exists.
static void write_relation(const YkGearsAnswer *answer, size_t member, YkText *text)
{
    bool is_first = true;
    for (size_t k = 0; k < yk_train_input_count(answer->train); k++) {
        YkTrainShare share = yk_train_share(answer->train, member, k);
        const char *by = share.formula && strlen(share.formula) <= FORMULA_MAX ? share.formula : share.exact;
        if (!by || (!is_needed(by) && share.value == 0)) continue;
        const char *name = yk_train_input(answer->train, k).name;
        bool is_sum = strchr(by, ' ') && by[0] != '(';
        bool is_negative = !is_sum && by[0] == '-';
        yk_text_puts(text, is_first ? (is_negative ? "-" : "") : is_negative ? " - " : " + ");
        by += is_negative;
        if (strcmp(by, "1") == 0) {
            yk_text_puts(text, name);
        } else {
            yk_text_format(text, is_sum ? "%s*(%s)" : "%s*%s", name, by);
        }
        is_first = false;
    }
    if (is_first) yk_text_puts(text, "0");
}

static void add_speeds(const YkGearsAnswer *answer)
{
    const YkTrain *train = answer->train;
    bool unit = is_unit(train);
    YkTable *table = yk_table_new(unit ? 4 : 5);
    YkText word = {0};
    yk_table_head(table, "body", NULL);
    yk_table_head(table, "exact", NULL);
    yk_table_head(table, unit ? "turns" : "speed", unit ? NULL : "rpm");
    if (!unit) yk_table_head(table, "", "rad/s");
    yk_table_head(table, "is (names of inputs stand for their speeds)", NULL);
    for (size_t i = 0; i < yk_train_body_count(train); i++) {
        YkTrainBody body = yk_train_body(train, i);
        yk_table_word(table, yk_gears_body(answer, body.body));
        yk_table_word(table, body.is_determined ? short_exact(body.exact) : "open");
        yk_table_number(table, unit ? body.speed : body.speed * rpm, 7);
        if (!unit) yk_table_number(table, body.speed, 7);
        yk_text_clear(&word);
        if (body.is_determined) write_relation(answer, i, &word);
        yk_table_word(table, yk_text_get(&word));
    }
    yk_text_free(&word);
    yk_table_show(table, unit ? "Turns for one turn of the input" : "Speeds (counter-clockwise)",
                  &answer->session->out);
}

static void add_racks(const YkGearsAnswer *answer)
{
    YkText *out = &answer->session->out;
    double size = 1;
    const char *unit = yk_model_unit(answer->session->model, YK_QUANTITY_SPEED, &size);
    for (size_t m = 0; m < yk_train_mesh_count(answer->train); m++) {
        double speed = yk_train_rack_speed(answer->train, m);
        if (isnan(speed)) continue;
        YkTrainMesh mesh = yk_train_mesh(answer->train, m);
        yk_text_format(out, "  %s moves on %s at %e %s\n", yk_gears_body(answer, mesh.body[1]),
                       yk_gears_body(answer, mesh.carrier), speed / size, unit);
    }
}

static void add_ratio(const YkGearsAnswer *answer)
{
    YkText *out = &answer->session->out;
    YkTrainRatio ratio = yk_train_ratio(answer->train);
    if (!ratio.is_known) return;
    yk_text_format(out, "\nRatio %s / %s%s\n  ", yk_gears_body(answer, ratio.in), yk_gears_body(answer, ratio.out),
                   yk_gears_leave_drives_out(answer->session, answer->train) ? " without the file's drives"
                   : ratio.is_by_drives                                      ? " at these inputs"
                                                                             : "");
    if (ratio.out_stands) {
        yk_text_puts(out, "infinite: the output stands still\n");
        return;
    }
    char number[YK_NUMBER_SIZE];
    const char *exact = short_exact(ratio.exact);
    yk_text_puts(out, exact);
    if (strchr(exact, '/')) yk_text_puts(out, " = ");
    if (!*exact || strchr(exact, '/')) yk_text_add(out, number, yk_number_write_digits(ratio.value, 10, number));
    if (ratio.formula) yk_text_format(out, "\n  = %s", ratio.formula);
    yk_text_puts(out, "\n");
    if (!ratio.formula && !ratio.is_by_drives)
        yk_text_puts(out, "  (too large a train for a formula in tooth numbers)\n");
}

// Shows the step from the gear before, as a driver feels it.
static void add_gear(YkTable *table, const YkTrainGear *gear, double before)
{
    const YkTrainRatio *ratio = &gear->ratio;
    bool is_number = ratio->is_known && !ratio->out_stands;
    yk_table_word(table, gear->lock);
    yk_table_word(table, is_number ? short_exact(ratio->exact) : ratio->is_known ? "output stands" : "-");
    yk_table_number(table, is_number ? ratio->value : NAN, 7);
    yk_table_number(table, is_number ? before / ratio->value : NAN, 4);
    yk_table_word(table, !ratio->is_known ? gear->message : ratio->formula ? ratio->formula : "");
}

static void add_shift_table(const YkGearsAnswer *answer)
{
    size_t count = yk_train_gear_count(answer->train);
    YkText title = {0};
    double before = NAN;
    if (count == 0) return;
    YkTrainRatio ratio = yk_train_ratio(answer->train);
    static const char *const heads[] = {"lock", "ratio", "", "step", "formula"};
    YkTable *table = yk_table_new(5);
    for (size_t i = 0; i < 5; i++) yk_table_head(table, heads[i], NULL);
    for (size_t i = 0; i < count; i++) {
        YkTrainGear gear = yk_train_gear(answer->train, i);
        add_gear(table, &gear, before);
        before = gear.ratio.is_known ? gear.ratio.value : NAN;
    }
    yk_text_format(&title, "Shift table, %s / %s", yk_gears_body(answer, ratio.in), yk_gears_body(answer, ratio.out));
    yk_table_show(table, yk_text_get(&title), &answer->session->out);
    yk_text_free(&title);
}

void yk_gears_motion_text(const YkGearsAnswer *answer)
{
    YkTrainStatus status = yk_train_status(answer->train);
    bool is_shifted = yk_train_gear_count(answer->train) > 0;
    add_inputs(answer);
    if (status == YK_TRAIN_STATUS_OK || (status == YK_TRAIN_STATUS_UNDETERMINED && !is_shifted)) add_speeds(answer);
    add_racks(answer);
    add_ratio(answer);
    add_shift_table(answer);
}

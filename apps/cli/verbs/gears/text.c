// Writes a gear train for people: the wheels, Willis' equations, the tabular method, remarks on the teeth.
#include <math.h>
#include <string.h>
#include "base/number.h"
#include "verbs/gears/gears.h"
#include "write/table.h"

enum { EXACT_MAX = 24 }; // longer fractions are shown as decimals

static void add_word(YkTable *table, YkText *word)
{
    yk_table_word(table, yk_text_get(word));
    yk_text_clear(word);
}

static void add_head(const YkGearsAnswer *answer)
{
    const YkTrain *train = answer->train;
    YkText *out = &answer->session->out;
    int freedom = yk_train_freedom(train);
    const char *lock = yk_train_lock(train);
    yk_text_format(out, "%s\n  gear train of %z bod%s besides the ground, %z mesh%s; %d degree%s of freedom",
                   yk_model_name(answer->session->model), yk_train_body_count(train),
                   yk_train_body_count(train) == 1 ? "y" : "ies", yk_train_mesh_count(train),
                   yk_train_mesh_count(train) == 1 ? "" : "es", freedom, freedom == 1 ? "" : "s");
    if (lock) yk_text_format(out, " under the lock %s", lock);
    yk_text_puts(out, "\n");
    if (*yk_train_message(train) && yk_train_gear_count(train) == 0)
        yk_text_format(out, "  %s\n", yk_train_message(train));
}

static void add_length(const YkGearsAnswer *answer, YkTable *table, double value)
{
    double size = 1;
    yk_model_unit(answer->session->model, YK_QUANTITY_LENGTH, &size);
    yk_table_number(table, value > 0 ? value / size : NAN, 6);
}

static void add_wheel(YkText *word, const YkTrainMesh *mesh, int side)
{
    if (mesh->teeth[side] > 0) {
        yk_text_format(word, "%s = %d", mesh->symbol[side], (int)mesh->teeth[side]);
    } else {
        yk_text_puts(word, mesh->symbol[side]);
    }
}

static void add_meshes(const YkGearsAnswer *answer)
{
    static const char *const heads[] = {"mesh", "kind", "first", "", "second", "", "carrier"};
    const char *unit = yk_model_unit(answer->session->model, YK_QUANTITY_LENGTH, NULL);
    YkTable *table = yk_table_new(10);
    YkText word = {0};
    for (size_t i = 0; i < 7; i++) yk_table_head(table, heads[i], NULL);
    yk_table_head(table, "pitch radii", unit);
    yk_table_head(table, "", NULL);
    yk_table_head(table, "centres", unit);
    for (size_t m = 0; m < yk_train_mesh_count(answer->train); m++) {
        YkTrainMesh mesh = yk_train_mesh(answer->train, m);
        const char *kind = mesh.kind == YK_TRAIN_KIND_RACK   ? "rack"
                           : mesh.kind == YK_TRAIN_KIND_BELT ? (mesh.is_internal ? "open belt" : "crossed belt")
                                                             : (mesh.is_internal ? "internal" : "external");
        yk_table_word(table, mesh.name);
        yk_table_word(table, kind);
        for (int k = 0; k < 2; k++) {
            yk_table_word(table, yk_gears_body(answer, mesh.body[k]));
            add_wheel(&word, &mesh, k);
            add_word(table, &word);
        }
        yk_table_word(table, yk_gears_body(answer, mesh.carrier));
        for (int k = 0; k < 2; k++) add_length(answer, table, mesh.radius[k]);
        add_length(answer, table, mesh.distance);
    }
    yk_text_free(&word);
    yk_table_show(table, "Meshes", &answer->session->out);
}

static void add_willis(const YkGearsAnswer *answer)
{
    YkText *out = &answer->session->out;
    yk_text_puts(out, "\nWillis' equations (names stand for speeds)\n");
    for (size_t m = 0; m < yk_train_mesh_count(answer->train); m++) {
        YkTrainMesh mesh = yk_train_mesh(answer->train, m);
        yk_text_format(out, "  %s: %s\n", mesh.name, mesh.willis);
    }
}

static const char *times_x(const char *turns, YkText *word)
{
    yk_text_clear(word);
    if (strcmp(turns, "1") == 0) {
        yk_text_puts(word, "x");
    } else if (strcmp(turns, "-1") == 0) {
        yk_text_puts(word, "-x");
    } else {
        yk_text_format(word, "%s x", turns);
    }
    return yk_text_get(word);
}

static void add_row(YkTable *table, const YkTrainTable *t, int row, YkText *word)
{
    static const char *const conditions[] = {"arm stands, the first wheel turns once", "times x", "plus y"};
    yk_text_clear(word);
    yk_text_puts(word, conditions[row]);
    add_word(table, word);
    yk_table_word(table, row < 2 ? "0" : "y");
    for (size_t k = 0; k < t->count; k++) {
        if (row == 0) {
            yk_table_word(table, t->turns[k]);
            continue;
        }
        times_x(t->turns[k], word);
        if (row == 2) yk_text_puts(word, " + y");
        add_word(table, word);
    }
}

static void add_speed(YkText *text, const char *exact, double speed)
{
    char number[YK_NUMBER_SIZE];
    if (exact && strlen(exact) <= EXACT_MAX) {
        yk_text_puts(text, exact);
        return;
    }
    yk_text_add(text, number, yk_number_write_digits(speed * 30 / 3.14159265358979323846, 6, number));
    yk_text_puts(text, " rpm");
}

static void add_tabular(const YkGearsAnswer *answer, size_t index)
{
    YkText *out = &answer->session->out, word = {0};
    YkTrainTable t = yk_train_table(answer->train, index);
    YkTable *table = yk_table_new(t.count + 2);
    yk_table_head(table, "condition", NULL);
    yk_table_head(table, yk_gears_body(answer, t.carrier), NULL);
    for (size_t k = 0; k < t.count; k++) yk_table_head(table, yk_gears_body(answer, t.body[k]), NULL);
    for (int row = 0; row < 3; row++) add_row(table, &t, row, &word);
    yk_text_clear(&word);
    yk_text_format(&word, "Tabular method for the arm %s", yk_gears_body(answer, t.carrier));
    yk_table_show(table, yk_text_get(&word), &answer->session->out);
    yk_text_free(&word);
    if (!t.has_speeds) return;
    yk_text_puts(out, "  here x = ");
    add_speed(out, t.exact_x, t.x);
    yk_text_puts(out, " and y = ");
    add_speed(out, t.exact_y, t.y);
    yk_text_puts(out, "\n");
}

static void add_remarks(const YkGearsAnswer *answer)
{
    YkText *out = &answer->session->out;
    size_t count = yk_train_remark_count(answer->train);
    if (count > 0) yk_text_puts(out, "\nTeeth and planets\n");
    for (size_t i = 0; i < count; i++) {
        YkTrainRemark remark = yk_train_remark(answer->train, i);
        yk_text_format(out, "  %s: %s%s\n", remark.mesh, remark.is_fault ? "FAULT: " : "", remark.text);
    }
}

void yk_gears_text(const YkGearsAnswer *answer)
{
    add_head(answer);
    add_meshes(answer);
    add_willis(answer);
    for (size_t i = 0; i < yk_train_table_count(answer->train); i++) add_tabular(answer, i);
    yk_gears_motion_text(answer);
    yk_gears_power_text(answer);
    add_remarks(answer);
}

// Writes a gear train: its meshes, all speeds, the shift table.
#include <math.h>
#include <string.h>
#include <yoke/train.h>
#include "report/html.h"
#include "report/report.h"
#include "write/amount.h"

enum { DIGITS = 6 };
static const double rpm = 30 / YK_PI;

// Ties of an engaged lock are listed with the belts.
static bool is_lock(const YkModel *model, const char *name)
{
    for (size_t k = 0; k < model->belt_count; k++)
        if (model->belts[k].is_lock && strcmp(model->belts[k].name, name) == 0) return true;
    return false;
}

static bool has_lock(const YkModel *model)
{
    bool has = false;
    for (size_t k = 0; k < model->belt_count; k++) has |= model->belts[k].is_lock;
    return has;
}

static void add_meshes(const YkReportPage *report, const YkTrain *train, YkText *html)
{
    static const char *const heads[] = {"mesh", "kind", "first", "second", "carrier", "Willis' equation"};
    YkTable *table = yk_table_new(8);
    const char *unit = yk_model_shown_unit(report->model, YK_QUANTITY_LENGTH, NULL);
    for (int i = 0; i < 6; i++) yk_table_head(table, heads[i], NULL);
    yk_table_head(table, "first radius", unit);
    yk_table_head(table, "second radius", unit);
    for (size_t m = 0; m < yk_train_mesh_count(train); m++) {
        YkTrainMesh mesh = yk_train_mesh(train, m);
        if (is_lock(report->model, mesh.name)) continue;
        yk_table_word(table, mesh.name);
        yk_table_word(table, mesh.kind == YK_TRAIN_KIND_RACK   ? "rack"
                             : mesh.kind == YK_TRAIN_KIND_BELT ? (mesh.is_internal ? "open belt" : "crossed belt")
                                                               : (mesh.is_internal ? "internal" : "external"));
        for (int k = 0; k < 2; k++) {
            YkText wheel = {0};
            yk_text_puts(&wheel, report->model->bodies[mesh.body[k]].name);
            if (mesh.teeth[k] > 0) yk_text_format(&wheel, ", %d teeth", (int)mesh.teeth[k]);
            yk_table_word(table, yk_text_get(&wheel));
            html->failed |= wheel.failed;
            yk_text_free(&wheel);
        }
        yk_table_word(table, report->model->bodies[mesh.carrier].name);
        yk_table_word(table, mesh.willis);
        for (int k = 0; k < 2; k++)
            yk_table_number(table,
                            mesh.radius[k] > 0
                                ? yk_amount_in_unit(report->model, NULL, mesh.radius[k], YK_QUANTITY_LENGTH)
                                : (double)NAN,
                            DIGITS);
    }
    yk_html_table(html, table, "Meshes; in the equations names stand for speeds");
}

static void add_speeds(const YkReportPage *report, const YkTrain *train, YkText *html)
{
    bool is_unit = yk_train_input_count(train) == 1 && yk_train_input(train, 0).is_unit;
    YkTable *table = yk_table_new(3);
    if (yk_train_input_count(train) > 0) {
        yk_table_head(table, "body", NULL);
        yk_table_head(table, "exactly", NULL);
        yk_table_head(table, is_unit ? "turns" : "speed", is_unit ? NULL : "rpm");
        for (size_t i = 0; i < yk_train_body_count(train); i++) {
            YkTrainBody body = yk_train_body(train, i);
            yk_table_word(table, report->model->bodies[body.body].name);
            yk_table_word(table, !body.is_determined ? "open" : body.exact ? body.exact : "");
            yk_table_number(table, is_unit ? body.speed : body.speed * rpm, DIGITS);
        }
    }
    yk_html_table(html, table, is_unit ? "Turns for one turn of the input" : "Speeds, counter-clockwise");
}

static void add_gears(const YkTrain *train, YkText *html)
{
    YkTable *table = yk_table_new(4);
    static const char *const heads[] = {"lock", "exactly", "ratio", "formula"};
    for (int i = 0; i < 4; i++) yk_table_head(table, heads[i], NULL);
    for (size_t k = 0; k < yk_train_gear_count(train); k++) {
        YkTrainGear gear = yk_train_gear(train, k);
        yk_table_word(table, gear.lock);
        yk_table_word(table, gear.ratio.is_known && gear.ratio.exact ? gear.ratio.exact
                             : gear.ratio.is_known                   ? ""
                                                                     : yk_train_status_name(gear.status));
        yk_table_number(table, gear.ratio.is_known ? gear.ratio.value : (double)NAN, DIGITS);
        yk_table_word(table, gear.ratio.is_known && gear.ratio.formula ? gear.ratio.formula : "");
    }
    yk_html_table(html, table, "Ratios, one for each set of locks");
}

void yk_section_gears(YkReportPage *report, YkText *html, YkProblems *problems)
{
    const YkModel *model = report->model;
    (void)problems;
    if (model->gear_count + model->belt_count + model->rack_count == 0) return;
    YkProblems *own = yk_problems_new(); // its problems are answers here
    YkTrain *train = own ? yk_train_new(model, NULL, own) : NULL;
    yk_report_note_problems(report, own);
    if (train) {
        if (*yk_train_message(train) && yk_train_gear_count(train) == 0)
            yk_html_element(html, "p", yk_train_message(train));
        add_meshes(report, train, html);
        add_speeds(report, train, html);
        if (!has_lock(model)) add_gears(train, html); // with one lock engaged the others cannot be
        for (size_t i = 0; i < yk_train_remark_count(train); i++) {
            YkTrainRemark remark = yk_train_remark(train, i);
            yk_text_format(html, "<p>%s: ", remark.mesh);
            yk_html_words(html, remark.text);
            yk_text_puts(html, ".</p>\n");
        }
    } else if (own && yk_problems_count(own) > 0) {
        yk_html_element(html, "p", yk_problems_get(own, 0)->message);
    }
    yk_train_free(train);
    yk_problems_free(own);
}

// Findings on gears and cams.
#include <math.h>
#include <string.h>
#include <yoke/train.h>
#include "report/report.h"

static void find_train(YkReportPage *report, YkText *text)
{
    const YkModel *model = report->model;
    if (model->gear_count + model->belt_count + model->rack_count == 0) return;
    YkProblems *problems = yk_problems_new();
    YkTrain *train = problems ? yk_train_new(model, NULL, problems) : NULL;
    yk_report_note_problems(report, problems);
    yk_problems_free(problems);
    if (!train) return;
    YkTrainRatio ratio = yk_train_ratio(train);
    if (ratio.is_known && ratio.in != (size_t)-1 && ratio.out != (size_t)-1 && !ratio.out_stands) {
        yk_text_format(text, "The gear train's ratio of %s to %s is ", model->bodies[ratio.in].name,
                       model->bodies[ratio.out].name);
        bool is_fraction = ratio.exact && strchr(ratio.exact, '/');
        if (ratio.exact) yk_text_puts(text, ratio.exact);
        if (is_fraction) yk_text_puts(text, " = ");
        if (is_fraction || !ratio.exact) yk_text_format(text, "%e", ratio.value);
        yk_text_puts(text, ".");
        yk_report_find(report, YK_FINDING_FACT, text);
    }
    if (yk_train_status(train) == YK_TRAIN_STATUS_LOCKED) {
        yk_text_format(text, "The gear train is locked: %s.", yk_train_message(train));
        yk_report_find(report, YK_FINDING_LOOK, text);
    }
    for (size_t i = 0; i < yk_train_remark_count(train); i++) {
        YkTrainRemark remark = yk_train_remark(train, i);
        if (!remark.is_fault) continue;
        yk_text_format(text, "Mesh %s: %s.", remark.mesh, remark.text);
        yk_report_find(report, YK_FINDING_LOOK, text);
    }
    yk_train_free(train);
}

static void find_cam(YkReportPage *report, size_t cam, YkText *text)
{
    YkCamDesign *design = yk_cam_design_new(report->model, cam);
    report->failed |= !design;
    if (!design) return;
    YkCamSize size = yk_cam_size(design);
    YkCamSummary summary = yk_cam_summary(design);
    YkQuantity lift = size.oscillates ? YK_QUANTITY_ANGLE : YK_QUANTITY_LENGTH;
    yk_text_format(text, "The cam %s lifts its follower by ", size.name);
    yk_report_amount(report, text, summary.lift_high.value - summary.lift_low.value, lift);
    if (size.face != YK_CAM_FACE_FLAT) {
        yk_text_puts(text, " with a pressure angle of at most ");
        yk_report_amount(report, text, fabs(summary.pressure.value), YK_QUANTITY_ANGLE);
    }
    yk_text_puts(text, ".");
    yk_report_find(report, YK_FINDING_FACT, text);
    if (summary.undercut_count > 0) {
        yk_text_format(text, "The cam %s is undercut: part of its surface is cut away.", size.name);
        yk_report_find(report, YK_FINDING_LOOK, text);
    }
    YkCamLoads loads = yk_cam_loads(design);
    if (size.speed != 0 && (loads.has_mass || loads.has_spring)) {
        YkCamForceSummary forces = yk_cam_force_summary(design, fabs(size.speed));
        if (isfinite(forces.jump_speed)) {
            yk_text_format(text, "The follower of %s leaves the cam from ", size.name);
            yk_report_amount(report, text, forces.jump_speed, YK_QUANTITY_ANGLE_RATE);
            yk_text_puts(text, forces.jump_speed < fabs(size.speed) ? " on: at its drive's speed it does." : " on.");
            yk_report_find(report, forces.jump_speed < fabs(size.speed) ? YK_FINDING_LOOK : YK_FINDING_FACT, text);
        }
    }
    yk_cam_design_free(design);
}

void yk_findings_parts(YkReportPage *report, YkText *text)
{
    find_train(report, text);
    for (size_t cam = 0; cam < report->model->cam_count; cam++) find_cam(report, cam, text);
}

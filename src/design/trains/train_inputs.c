// Finds what turns a train - drives of the model, or one turn of a body - and writes speeds as exact text.
#include <math.h>
#include "design/trains/train.h"

// Returns "40 rpm" for 4 pi / 3, "740 rad/s", "1/2 m/s"; NULL if it is not so simple.
static const char *exact_text(YkArena *arena, const YkFraction *value, int32_t pi, bool is_distance)
{
    YkText text = {0};
    YkOverflow overflow = false;
    YkFraction thirty = yk_fraction(30, 1), rpm = yk_fraction_multiply(value, &thirty, &overflow);
    bool is_zero = yk_fraction_is_zero(value), is_rpm = pi == 1 || is_zero;
    if (overflow || (!is_zero && pi != (is_rpm ? 1 : 0)) || (is_distance && !is_zero && pi != 0)) return NULL;
    yk_fraction_write(is_rpm && !is_distance ? &rpm : value, &text);
    yk_text_puts(&text, is_distance ? " m/s" : is_rpm ? " rpm" : " rad/s");
    return yk_train_keep(arena, &text);
}

static bool add_drive(YkTrain *train, const YkDrive *drive)
{
    const YkCoordinate *coordinate = &train->model->coordinates[drive->coordinate];
    const YkJoint *joint = &train->model->joints[coordinate->joint];
    YkTrainDrive *input = &train->drives[train->drive_count++];
    YkJet jet = {{0}};
    if (yk_model_eval(train->model, drive->expr, train->options.time, &jet, NULL) != YK_OK) jet.d[1] = NAN;
    *input = (YkTrainDrive){.coordinate = drive->coordinate, .body = joint->body[1]};
    input->exact = yk_model_exact_rate(train->model, drive->expr);
    input->shown = (YkTrainInput){.name = coordinate->name, .is_distance = coordinate->is_distance, .speed = jet.d[1]};
    if (input->exact.is_exact) {
        YkFraction value = yk_fraction(input->exact.numerator, input->exact.denominator);
        input->shown.exact = exact_text(train->arena, &value, input->exact.pi, coordinate->is_distance);
    }
    return true;
}

bool yk_train_drives(YkTrain *train, int32_t in)
{
    const YkModel *model = train->model;
    train->drives = YK_NEW(train->arena, YkTrainDrive, model->drive_count + 1);
    if (!train->drives) return false;
    for (size_t i = 0; i < model->drive_count; i++) {
        const YkDrive *drive = &model->drives[i];
        const YkCoordinate *coordinate = &model->coordinates[drive->coordinate];
        if (yk_train_has_joint(&train->net, coordinate->joint, coordinate->is_distance)) add_drive(train, drive);
    }
    if (train->drive_count > 0 || in == YK_NONE) return true;
    train->drives[train->drive_count++] =
        (YkTrainDrive){.coordinate = YK_NONE,
                       .body = in,
                       .exact = {.is_exact = true, .numerator = 1, .denominator = 1},
                       .shown = {.name = model->bodies[in].name, .is_unit = true, .speed = 1, .exact = "1"}};
    return true;
}

const char *yk_train_exact_speed(const YkTrain *train, const YkFraction *shares, int32_t count, bool is_distance)
{
    YkFraction sum = yk_fraction(0, 1);
    YkOverflow overflow = !train->net.is_exact;
    int32_t pi = 0;
    for (int32_t k = 0; k < count; k++) {
        const YkTrainDrive *drive = &train->drives[k];
        if (yk_fraction_is_zero(&shares[k])) continue;
        if (!drive->exact.is_exact) return NULL;
        if (drive->exact.numerator == 0) continue;
        if (!yk_fraction_is_zero(&sum) && pi != drive->exact.pi) return NULL;
        YkFraction speed = yk_fraction(drive->exact.numerator, drive->exact.denominator);
        speed = yk_fraction_multiply(&speed, &shares[k], &overflow);
        sum = yk_fraction_add(&sum, &speed, &overflow);
        pi = drive->exact.pi;
    }
    if (overflow) return NULL;
    if (count == 1 && train->drives[0].shown.is_unit) {
        YkText text = {0};
        yk_fraction_write(&sum, &text);
        return yk_train_keep(train->arena, &text);
    }
    return exact_text(train->arena, &sum, pi, is_distance);
}

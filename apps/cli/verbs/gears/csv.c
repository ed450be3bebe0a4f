// Writes the train as rows of numbers: the shift table if there is one, otherwise the speeds.
#include <math.h>
#include "verbs/gears/gears.h"
#include "write/csv.h"

static void add_gears(const YkGearsAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    yk_text_puts(csv.text, "lock,ratio\n");
    for (size_t i = 0; i < yk_train_gear_count(answer->train); i++) {
        YkTrainGear gear = yk_train_gear(answer->train, i);
        yk_csv_name(&csv, gear.lock);
        yk_csv_number(&csv, gear.ratio.is_known ? gear.ratio.value : NAN);
        yk_csv_row(&csv);
    }
}

static void add_bodies(const YkGearsAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    yk_csv_name(&csv, "body");
    yk_csv_name(&csv, "speed");
    for (size_t k = 0; k < yk_train_input_count(answer->train); k++)
        yk_csv_name(&csv, yk_train_input(answer->train, k).name);
    yk_csv_row(&csv);
    for (size_t i = 0; i < yk_train_body_count(answer->train); i++) {
        YkTrainBody body = yk_train_body(answer->train, i);
        yk_csv_name(&csv, yk_gears_body(answer, body.body));
        yk_csv_number(&csv, body.speed);
        for (size_t k = 0; k < yk_train_input_count(answer->train); k++)
            yk_csv_number(&csv, body.is_determined ? yk_train_share(answer->train, i, k).value : NAN);
        yk_csv_row(&csv);
    }
}

void yk_gears_csv(const YkGearsAnswer *answer)
{
    if (yk_train_gear_count(answer->train) > 0) {
        add_gears(answer);
    } else {
        add_bodies(answer);
    }
}

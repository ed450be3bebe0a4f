// Writes one line per equilibrium: its number, stability, potential, coordinates, and its modes' frequencies in Hz.
#include "verbs/rest/rest.h"
#include "write/csv.h"

static void add_head(const YkRestAnswer *answer, YkCsv *csv)
{
    static const char *const names[] = {"equilibrium", "stability", "potential"};
    YkText name = {0};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) yk_csv_name(csv, names[i]);
    for (size_t i = 0; i < yk_coordinate_count(answer->mech); i++)
        yk_csv_name(csv, yk_coordinate_info(answer->mech, i).name);
    for (size_t k = 0; k < yk_rest_freedom(answer->rest); k++) {
        yk_text_clear(&name);
        yk_text_format(&name, "frequency%z", k + 1);
        yk_csv_name(csv, yk_text_get(&name));
    }
    yk_csv_row(csv);
    yk_text_free(&name);
}

void yk_rest_csv(const YkRestAnswer *answer)
{
    YkCsv csv = {.text = &answer->session->out};
    add_head(answer, &csv);
    for (size_t i = 0; i < yk_rest_count(answer->rest); i++) {
        YkEquilibrium rest = yk_rest_equilibrium(answer->rest, i);
        const YkState *state = yk_rest_state(answer->rest, i);
        yk_csv_number(&csv, (double)(i + 1));
        yk_csv_name(&csv, yk_stability_word(rest.stability));
        yk_csv_number(&csv, rest.potential);
        for (size_t c = 0; c < yk_coordinate_count(answer->mech); c++)
            yk_csv_number(&csv, yk_state_coordinate(state, c).position);
        for (size_t k = 0; k < yk_rest_freedom(answer->rest); k++)
            yk_csv_number(&csv, yk_mode_hertz(yk_rest_mode(answer->rest, i, k)));
        yk_csv_row(&csv);
    }
}

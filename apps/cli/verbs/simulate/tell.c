// Reports on a simulation besides its rows: events, the work of each load, the cost and the errors.
#include "base/number.h"
#include "certify.h"
#include "verbs/simulate/simulate.h"

enum { LINES_MAX = 50, TIME_DIGITS = 10, ERROR_DIGITS = 2 };

const char *yk_happening_word(YkHappeningKind kind)
{
    static const char *const words[] = {"stop",     "release",  "stick",    "slip",    "change-point", "dead-point",
                                        "crossing", "lift-off", "law-left", "landing", "pull"};
    return words[kind];
}

// Writes "  stop        t = 0.451524 s  h".
static void add_event(const YkSimulationAnswer *answer, size_t index, YkText *text)
{
    YkHappening happening = yk_simulation_happening(answer->simulation, index);
    yk_text_format(text, "simulate: %s of %s at t = ", yk_happening_word(happening.kind), happening.name);
    bool is_blurred = happening.kind == YK_HAPPENING_CHANGE_POINT; // found between two steps, to 1e-6 or so
    yk_add_value(answer->session, text, happening.time, YK_QUANTITY_TIME, is_blurred ? YK_DIGITS : TIME_DIGITS);
    yk_text_puts(text, "\n");
}

static void add_events(const YkSimulationAnswer *answer, YkText *text)
{
    size_t count = yk_simulation_happening_count(answer->simulation), shown = count < LINES_MAX ? count : LINES_MAX;
    for (size_t k = 0; k < shown; k++) add_event(answer, k, text);
    if (count > shown) yk_text_format(text, "simulate: %z more events (--format json lists all)\n", count - shown);
}

static void add_works(const YkSimulationAnswer *answer, YkText *text)
{
    size_t count = yk_simulation_work_count(answer->simulation), shown = 0;
    for (size_t k = 0; k < count && shown < LINES_MAX; k++) {
        double work = yk_simulation_work(answer->simulation, k);
        if (work == 0) continue;
        yk_text_format(text, "simulate: work of %s ", yk_simulation_work_name(answer->simulation, k));
        yk_add_value(answer->session, text, work, YK_QUANTITY_ENERGY, YK_DIGITS);
        yk_text_puts(text, "\n");
        shown++;
    }
    if (shown == LINES_MAX) yk_text_puts(text, "simulate: and work of more loads (--format json lists all)\n");
}

static void add_small(YkText *text, double value)
{
    char number[YK_NUMBER_SIZE];
    yk_text_add(text, number, yk_number_write_digits(value, ERROR_DIGITS, number));
}

void yk_simulate_tell(const YkSimulationAnswer *answer, YkText *text)
{
    YkSimulationSummary summary = yk_simulation_summary(answer->simulation);
    if (!answer->session->request->quiet) {
        add_events(answer, text);
        add_works(answer, text);
        yk_certify_text(answer->session, "simulate: ", text);
    }
    yk_text_puts(text, "simulate: ");
    if (answer->is_interrupted) {
        yk_text_puts(text, "interrupted at t = ");
        yk_add_value(answer->session, text, yk_simulation_time(answer->simulation), YK_QUANTITY_TIME, TIME_DIGITS);
        yk_text_puts(text, "; ");
    }
    yk_text_format(text, "%z steps, %z evaluations; energy error ", summary.steps, summary.evaluations);
    add_small(text, summary.energy_error);
    yk_text_puts(text, "; worst residual ");
    add_small(text, summary.worst_residual);
    yk_text_puts(text, "\n");
}

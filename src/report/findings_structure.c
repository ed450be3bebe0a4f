// Findings on structure: freedom, redundant constraints, four-bars.
#include <stdlib.h>
#include <yoke/configurations.h>
#include <yoke/design.h>
#include "base/sort.h"
#include "report/report.h"

enum { FOUR_BARS_MAX = 4, NAMES_MAX = 6 };

static const char *plural(size_t count)
{
    return count == 1 ? "" : "s";
}

static void find_freedom(YkReportPage *report, YkText *text)
{
    YkFreedom freedom = yk_mechanism_freedom(report->mech);
    int degrees = freedom.by_rank >= 0 ? freedom.by_rank : freedom.gruebler;
    size_t driven = freedom.driven;
    if (degrees <= 0) {
        yk_text_puts(text, "It has no degree of freedom: it is a structure and does not move.");
        yk_report_find(report, YK_FINDING_FACT, text);
        return;
    }
    yk_text_format(text, "It has %d degree%s of freedom", degrees, plural((size_t)degrees));
    if (freedom.by_rank >= 0 && freedom.by_rank != freedom.gruebler)
        yk_text_format(text, " by the rank of its constraints, though Gruebler's count says %d", freedom.gruebler);
    if (driven == 0) {
        yk_text_puts(text, report->dynamics ? ", none of them driven: it moves under its loads." : ", none driven.");
    } else if ((int)driven >= degrees) {
        yk_text_format(text, " and as many drives: the motion is determined.");
    } else {
        yk_text_format(text, ", %z of them driven; the other%s.", driven,
                       report->dynamics
                           ? degrees - (int)driven == 1 ? " moves under the loads" : "s move under the loads"
                       : degrees - (int)driven == 1 ? " stays at its start"
                                                    : "s stay at their start");
    }
    yk_report_find(report, YK_FINDING_FACT, text);
}

static void find_redundant(YkReportPage *report, YkText *text)
{
    YkFreedom freedom = yk_mechanism_freedom(report->mech);
    size_t count = yk_redundant_count(report->mech), shown = count < NAMES_MAX ? count : NAMES_MAX;
    if (freedom.redundant == 0) return;
    yk_text_format(text, "%z constraint%s repeat%s others", freedom.redundant, plural(freedom.redundant),
                   freedom.redundant == 1 ? "s" : "");
    for (size_t i = 0; i < shown; i++)
        yk_text_format(text, "%s%s", i == 0 ? ", at joint " : ", ",
                       yk_model_joint_name(report->model, yk_redundant_joint(report->mech, i)));
    if (count > shown) yk_text_puts(text, ", ...");
    yk_text_puts(text, ": it moves only as long as its dimensions are exact, and forces between the constraints that "
                       "repeat each other are one choice of many, the least in norm.");
    yk_report_find(report, YK_FINDING_LOOK, text);
}

// Grashof: shortest + longest against the other two.
static void find_four_bars(YkReportPage *report, YkText *text)
{
    YkFourBar bars[FOUR_BARS_MAX];
    size_t count = yk_four_bars(report->mech, bars, FOUR_BARS_MAX);
    report->failed |= count == YK_NOT_FOUND;
    if (count == YK_NOT_FOUND) return;
    for (size_t i = 0; i < count && i < FOUR_BARS_MAX; i++) {
        const YkFourBar *bar = &bars[i];
        double sorted[4];
        for (int k = 0; k < 4; k++) {
            sorted[k] = bar->length[k];
            yk_text_format(text, "%s%s",
                           k == 0  ? "The bodies "
                           : k < 3 ? ", "
                                   : " and ",
                           yk_model_body_name(report->model, bar->body[k]));
        }
        qsort(sorted, 4, sizeof *sorted, yk_by_size);
        yk_text_format(text, " are a four-bar, %s on the frame %s: shortest and longest link are together ",
                       yk_four_bar_name(bar->kind), yk_model_body_name(report->model, bar->body[0]));
        yk_report_amount(report, text, sorted[0] + sorted[3], YK_QUANTITY_LENGTH);
        yk_text_puts(text, ", the other two ");
        yk_report_amount(report, text, sorted[1] + sorted[2], YK_QUANTITY_LENGTH);
        yk_text_puts(text, ".");
        yk_report_find(report, YK_FINDING_FACT, text);
    }
    if (count > FOUR_BARS_MAX) {
        yk_text_format(text, "It contains %z more four-bars.", count - FOUR_BARS_MAX);
        yk_report_find(report, YK_FINDING_FACT, text);
    }
}

static bool count_one(void *context, YkState *state)
{
    (void)state;
    return ++*(size_t *)context < 4096;
}

static void find_configurations(YkReportPage *report, YkText *text)
{
    size_t count = 0;
    const char *name = "";
    YkConfigurationsReport found = {.complete = false};
    YkConfigurationsOptions options = yk_default_configurations_options();
    if (report->status < 0 || yk_block_count(report->mech) > 10) return;
    options.in_search_order = true;
    YkState *state = yk_report_new_state(report);
    YkStatus status = state ? yk_state_copy(state, report->start) : YK_NO_MEMORY;
    YkConfigurations *all = status >= 0 ? yk_configurations_new(report->mech) : NULL;
    if (status >= 0)
        status = all ? yk_configurations_each(all, state, &options, count_one, &count, &found) : YK_NO_MEMORY;
    if (status >= 0) status = yk_configurations_name(all, state, &options, &name);
    yk_report_note(report, status);
    if (status >= 0 && count > 1) {
        yk_text_format(
            text, "At its start it can be assembled in %s%z ways; this page shows the one nearest to its start values",
            found.complete ? "" : "at least ", count);
        if (*name) yk_text_format(text, " (%s)", name);
        yk_text_puts(text, ".");
        yk_report_find(report, YK_FINDING_FACT, text);
    }
    yk_configurations_free(all);
    yk_state_free(state);
}

void yk_findings_structure(YkReportPage *report, YkText *text)
{
    find_freedom(report, text);
    find_redundant(report, text);
    find_four_bars(report, text);
    find_configurations(report, text);
}

// Passed from part to part of a report: findings, lack of memory, states that are watched.
#include "base/problems.h"
#include "report/report.h"
#include "solve/state.h"

void yk_report_note(YkReportPage *report, YkStatus status)
{
    report->failed |= status == YK_NO_MEMORY;
}

void yk_report_note_problems(YkReportPage *report, const YkProblems *problems)
{
    report->failed |= !problems || yk_problems_ran_out(problems);
}

// Drops the marks round names in messages, which a page would show.
static void drop_marks(YkText *text)
{
    size_t kept = 0;
    for (size_t k = 0; k < text->length; k++)
        if (text->data[k] != '`') text->data[kept++] = text->data[k];
    text->length = kept;
}

void yk_report_find(YkReportPage *report, YkFindingKind kind, YkText *text)
{
    report->failed |= text->failed;
    if (text->length == 0) return;
    drop_marks(text);
    if (!YK_ROOM(report->findings, report->finding_count, report->finding_capacity)) {
        report->failed = true;
        return;
    }
    const char *own = yk_arena_copy(report->arena, yk_text_get(text), text->length);
    report->failed |= !own;
    report->findings[report->finding_count++] = (YkFinding){kind, own ? own : ""};
    yk_text_clear(text);
}

YkState *yk_report_new_state(YkReportPage *report)
{
    YkState *state = yk_state_new(report->mech);
    report->failed |= !state;
    if (state) yk_state_lend(state, &report->pace);
    return state;
}

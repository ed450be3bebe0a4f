// Keeps the configurations at the asked pose and where the machine was assembled, and names them.
#include <stdlib.h>
#include <string.h>
#include "answer.h"
#include "base/memory.h"
#include "solve/gap.h"
#include "reach.h"
#include "roll.h"
#include "stop.h"

typedef struct Entry {
    YkText label;
    double *positions; // of all coordinates
} Entry;

typedef struct Roll {
    bool is_made;
    double *inputs; // where
    Entry *entries;
    size_t count, capacity;
} Roll;

struct YkRolls {
    YkConfigurations *configurations;
    Roll here, start;
    double deadline; // --within; 0: none
};

static void clear_roll(Roll *roll)
{
    for (size_t k = 0; k < roll->count; k++) {
        yk_text_free(&roll->entries[k].label);
        free(roll->entries[k].positions);
    }
    free(roll->entries);
    free(roll->inputs);
    *roll = (Roll){0};
}

void yk_roll_end(YkSession *session)
{
    struct YkRolls *rolls = session->rolls;
    if (!rolls) return;
    clear_roll(&rolls->here);
    clear_roll(&rolls->start);
    yk_configurations_free(rolls->configurations);
    free(rolls);
    session->rolls = NULL;
}

// --- enumerating

static bool is_within(void *context, double part)
{
    const struct YkRolls *rolls = context;
    (void)part;
    return yk_stop_now() < rolls->deadline && !yk_stop_is_asked();
}

bool yk_roll_within(YkSession *session, double *seconds)
{
    const char *within = session->request->within;
    *seconds = 0;
    if (!within) return true;
    if (!session->request->all)
        return yk_session_refuse(session, YK_CODE_OPTION_MISSING, "--within %s needs --all", within);
    if (!yk_session_value(session, "--within", "", within, YK_QUANTITY_TIME, seconds)) return false;
    if (*seconds > 0) return true;
    return yk_session_refuse(session, YK_CODE_OPTION_VALUE, "--within %s: a time above 0 is needed", within);
}

static bool make_rolls(YkSession *session)
{
    if (session->rolls) return true;
    session->rolls = calloc(1, sizeof *session->rolls);
    if (session->rolls) session->rolls->configurations = yk_configurations_new(session->mech);
    if (!session->rolls || !session->rolls->configurations) {
        yk_roll_end(session);
        yk_session_run_out(session);
        return false;
    }
    double seconds;
    if (yk_roll_within(session, &seconds) && seconds > 0) session->rolls->deadline = yk_stop_now() + seconds;
    return true;
}

static YkStatus each(YkSession *session, YkState *state, bool (*visit)(void *, YkState *), void *context,
                     YkConfigurationsReport *report)
{
    YkConfigurationsOptions options = yk_default_configurations_options();
    options.in_search_order = true;
    if (session->rolls->deadline > 0) options.enough = (YkProgress){is_within, session->rolls};
    return yk_configurations_each(session->rolls->configurations, state, &options, visit, context, report);
}

typedef struct Writer {
    Roll *roll;
    bool failed;
} Writer;

static bool enter(void *context, YkState *state)
{
    Writer *w = context;
    size_t count = yk_coordinate_count(yk_state_mechanism(state));
    Entry entry = {yk_label_of(state), calloc(count + 1, sizeof(double))};
    w->failed |=
        !entry.positions || entry.label.failed || !YK_ROOM(w->roll->entries, w->roll->count, w->roll->capacity);
    if (w->failed) {
        free(entry.positions);
        yk_text_free(&entry.label);
        return false;
    }
    for (size_t c = 0; c < count; c++) entry.positions[c] = yk_state_coordinate(state, c).position;
    w->roll->entries[w->roll->count++] = entry;
    return true;
}

static bool is_at(const Roll *roll, const YkState *state, size_t inputs)
{
    for (size_t i = 0; roll->is_made && i < inputs; i++)
        if (roll->inputs[i] != yk_state_input(state, i).position) return false;
    return roll->is_made;
}

// Makes the roll at the inputs of a state, unless it is there already.
static YkStatus make_roll(YkSession *session, Roll *roll, YkState *state)
{
    size_t inputs = yk_input_count(session->mech);
    if (is_at(roll, state, inputs)) return YK_OK;
    clear_roll(roll);
    roll->inputs = calloc(inputs + 1, sizeof *roll->inputs);
    Writer writer = {roll, !roll->inputs};
    YkStatus status = writer.failed ? YK_NO_MEMORY : each(session, state, enter, &writer, NULL);
    if (writer.failed) status = YK_NO_MEMORY;
    if (status == YK_NO_MEMORY) yk_session_run_out(session);
    if (status == YK_NO_MEMORY || status == YK_STOPPED) return status;
    for (size_t i = 0; i < inputs; i++) roll->inputs[i] = yk_state_input(state, i).position;
    roll->is_made = true;
    return YK_OK;
}

// --- names

static bool is_entry(const YkSession *session, const Entry *entry, const YkState *state)
{
    const double same = 1e-6; // rad, or lengths over the size
    for (size_t c = 0; c < yk_coordinate_count(session->mech); c++) {
        double off = yk_state_coordinate(state, c).position - entry->positions[c];
        if (!(yk_gap(session->mech, yk_coordinate_info(session->mech, c).is_distance, off) < same)) return false;
    }
    return true;
}

// Counts the configurations with a label; *place: which of them, from 1, the state is, or 0.
static size_t count_namesakes(const YkSession *session, const Roll *roll, const char *label, const YkState *state,
                              size_t *place)
{
    size_t count = 0;
    *place = 0;
    for (size_t k = 0; k < roll->count; k++) {
        if (strcmp(yk_text_get(&roll->entries[k].label), label) != 0) continue;
        count++;
        if (is_entry(session, &roll->entries[k], state)) *place = count;
    }
    return count;
}

static bool has_namesakes(const Roll *roll)
{
    for (size_t k = 0; k < roll->count; k++)
        for (size_t j = 0; j < k; j++)
            if (strcmp(yk_text_get(&roll->entries[j].label), yk_text_get(&roll->entries[k].label)) == 0) return true;
    return false;
}

// Makes the rolls from which the configurations at the inputs of a state get their names.
static YkStatus prepare_names(YkSession *session, YkState *state)
{
    if (!make_rolls(session)) return YK_NO_MEMORY;
    YkStatus status = make_roll(session, &session->rolls->here, state);
    if (status < 0 || !has_namesakes(&session->rolls->here)) return status;
    YkState *start = yk_session_new_state(session, session->mech);
    if (!start) yk_session_run_out(session);
    if (!start) return YK_NO_MEMORY;
    if (yk_state_set_time(start, 0, NULL) >= 0) status = make_roll(session, &session->rolls->start, start);
    yk_state_free(start);
    return status;
}

// Moves a configuration back to where the machine was assembled. Returns its number there within its label, or 0.
static size_t number_at_start(YkSession *session, const YkState *state)
{
    const Roll *roll = &session->rolls->start;
    size_t count = yk_input_count(session->mech), number = 0;
    if (!roll->is_made) return 0;
    YkState *back = yk_session_new_state(session, session->mech);
    YkMotion *goal = calloc(count + 1, sizeof *goal);
    YkState *start = yk_session_new_state(session, session->mech);
    if (!back || !start || !goal) yk_session_run_out(session);
    if (back && start && goal && yk_state_copy(back, state) >= 0 && yk_state_set_time(start, 0, NULL) >= 0) {
        for (size_t i = 0; i < count; i++) goal[i] = yk_state_input(start, i);
        YkStatus status = yk_state_move_to(back, goal, NULL, NULL);
        if (status == YK_NO_MEMORY) yk_session_run_out(session);
        YkText label = yk_label_of(back);
        if (label.failed) yk_session_run_out(session);
        if (status >= 0) count_namesakes(session, roll, yk_text_get(&label), back, &number);
        yk_text_free(&label);
    }
    free(goal);
    yk_state_free(start);
    yk_state_free(back);
    return number;
}

YkText yk_configuration_name(YkSession *session, const YkState *state)
{
    size_t place = 0, inputs = yk_input_count(session->mech);
    YkText name = yk_label_of(state);
    if (!session->rolls || !is_at(&session->rolls->here, state, inputs)) {
        YkState *here = yk_session_new_state(session, session->mech);
        if (!here || yk_state_copy(here, state) < 0) yk_session_run_out(session);
        YkStatus status = here ? prepare_names(session, here) : YK_NO_MEMORY;
        yk_state_free(here);
        if (status < 0) return name;
    }
    if (count_namesakes(session, &session->rolls->here, yk_text_get(&name), state, &place) > 1) {
        size_t number = number_at_start(session, state);
        yk_text_format(&name, number > 0 ? ".%z" : ".x%z", number > 0 ? number : place);
    }
    return name;
}

YkStatus yk_session_each(YkSession *session, YkState *state, bool (*visit)(void *, YkState *), void *context,
                         YkConfigurationsReport *report)
{
    if (report) *report = (YkConfigurationsReport){.block = -1};
    YkStatus status = prepare_names(session, state);
    return status < 0 ? status : each(session, state, visit, context, report);
}

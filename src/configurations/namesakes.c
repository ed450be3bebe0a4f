// Names of configurations. A number that distinguishes configurations with one label is counted at the start, where the
// machine was assembled, so that a configuration keeps its name while the machine moves.
#include "configurations/namesakes.h"
#include <stdlib.h>
#include <string.h>
#include "base/memory.h"
#include "solve/gap.h"
#include "solve/state.h"
#include <yoke/move.h>

static void clear_roll(YkRoll *roll)
{
    for (size_t k = 0; k < roll->count; k++) {
        yk_text_free(&roll->entries[k].label);
        free(roll->entries[k].positions);
    }
    free(roll->entries);
    free(roll->inputs);
    *roll = (YkRoll){0};
}

void yk_namesakes_end(YkNamesakes *namesakes)
{
    clear_roll(&namesakes->here);
    clear_roll(&namesakes->start);
    yk_text_free(&namesakes->name);
}

// A state of the same machine, watched as this one is; NULL when out of memory.
static YkState *new_beside(const YkState *state)
{
    YkState *own = yk_state_new(state->mech);
    if (own && yk_state_set_progress(own, state->progress) == YK_OK) return own;
    yk_state_free(own);
    return NULL;
}

// --- rolls

typedef struct Writer {
    YkRoll *roll;
    bool failed;
} Writer;

static bool enter(void *context, YkState *state)
{
    Writer *w = context;
    size_t count = state->mech->coordinate_count;
    YkRollEntry entry = {.positions = calloc(count + 1, sizeof(double))};
    yk_state_write_label(state, &entry.label);
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

static bool is_roll_of(const YkRoll *roll, const YkState *state)
{
    for (size_t i = 0; roll->is_made && i < state->mech->input_count; i++)
        if (roll->inputs[i] != yk_state_input(state, i).position) return false;
    return roll->is_made;
}

bool yk_namesakes_are_ready(const YkNamesakes *namesakes, const YkState *state)
{
    return !state->mech->has_groups || is_roll_of(&namesakes->here, state);
}

static YkStatus make_roll(YkRoll *roll, YkConfigurations *all, YkState *state, const YkConfigurationsOptions *options)
{
    size_t inputs = state->mech->input_count;
    if (is_roll_of(roll, state)) return YK_OK;
    clear_roll(roll);
    roll->inputs = calloc(inputs + 1, sizeof *roll->inputs);
    Writer writer = {roll, !roll->inputs};
    YkConfigurationsOptions own = options ? *options : yk_default_configurations_options();
    own.in_search_order = true;
    own.with_names = false;
    YkStatus status = writer.failed ? YK_NO_MEMORY : yk_configurations_each(all, state, &own, enter, &writer, NULL);
    if (writer.failed) status = YK_NO_MEMORY;
    if (status == YK_NO_MEMORY || status == YK_STOPPED) return status;
    for (size_t i = 0; i < inputs; i++) roll->inputs[i] = yk_state_input(state, i).position;
    roll->is_made = true;
    return YK_OK;
}

static bool has_namesakes(const YkRoll *roll)
{
    for (size_t k = 0; k < roll->count; k++)
        for (size_t j = 0; j < k; j++)
            if (strcmp(yk_text_get(&roll->entries[j].label), yk_text_get(&roll->entries[k].label)) == 0) return true;
    return false;
}

YkStatus yk_namesakes_prepare(YkNamesakes *namesakes, YkConfigurations *all, const YkState *state,
                              const YkConfigurationsOptions *options)
{
    YkState *own = new_beside(state);
    YkStatus status = own ? yk_state_copy(own, state) : YK_NO_MEMORY;
    if (status >= 0) status = make_roll(&namesakes->here, all, own, options);
    yk_state_free(own);
    if (status < 0 || !has_namesakes(&namesakes->here)) return status;
    YkState *start = new_beside(state);
    if (!start) return YK_NO_MEMORY;
    if (yk_state_set_time(start, 0, NULL) >= 0) status = make_roll(&namesakes->start, all, start, options);
    yk_state_free(start);
    return status;
}

// --- names

static bool is_entry(const YkRollEntry *entry, const YkState *state)
{
    const YkMechanism *mech = state->mech;
    const double same = 1e-6; // rad, or lengths over the size
    for (size_t c = 0; c < mech->coordinate_count; c++) {
        double off = yk_state_coordinate(state, c).position - entry->positions[c];
        if (!(yk_gap(mech, mech->coordinates[c].is_distance, off) < same)) return false;
    }
    return true;
}

// Counts the configurations with a label; *place: which of them, from 1, the state is, or 0.
static size_t count_namesakes(const YkRoll *roll, const char *label, const YkState *state, size_t *place)
{
    size_t count = 0;
    *place = 0;
    for (size_t k = 0; k < roll->count; k++) {
        if (strcmp(yk_text_get(&roll->entries[k].label), label) != 0) continue;
        count++;
        if (is_entry(&roll->entries[k], state)) *place = count;
    }
    return count;
}

// Moves a configuration back to where the machine was assembled. *number: its number there within its label, or 0.
static YkStatus number_at_start(const YkNamesakes *namesakes, const YkState *state, size_t *number)
{
    size_t count = state->mech->input_count;
    *number = 0;
    if (!namesakes->start.is_made) return YK_OK;
    YkState *back = new_beside(state), *start = new_beside(state);
    YkMotion *goal = calloc(count + 1, sizeof *goal);
    YkText label = {0};
    YkStatus status = back && start && goal ? yk_state_copy(back, state) : YK_NO_MEMORY;
    if (status >= 0 && yk_state_set_time(start, 0, NULL) >= 0) {
        for (size_t i = 0; i < count; i++) goal[i] = yk_state_input(start, i);
        status = yk_state_move_to(back, goal, NULL, NULL);
        yk_state_write_label(back, &label);
        if (status >= 0) count_namesakes(&namesakes->start, yk_text_get(&label), back, number);
    }
    if (label.failed) status = YK_NO_MEMORY;
    yk_text_free(&label);
    free(goal);
    yk_state_free(start);
    yk_state_free(back);
    return status == YK_NO_MEMORY || status == YK_STOPPED ? status : YK_OK; // else it cannot move back
}

YkStatus yk_namesakes_write(YkNamesakes *namesakes, const YkState *state)
{
    YkText *name = &namesakes->name;
    size_t place = 0, number = 0;
    YkStatus status = YK_OK;
    yk_text_free(name);
    yk_state_write_label(state, name);
    if (is_roll_of(&namesakes->here, state) &&
        count_namesakes(&namesakes->here, yk_text_get(name), state, &place) > 1) {
        status = number_at_start(namesakes, state, &number);
        if (status >= 0) yk_text_format(name, number > 0 ? ".%z" : ".x%z", number > 0 ? number : place);
    }
    return name->failed ? YK_NO_MEMORY : status;
}

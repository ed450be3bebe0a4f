// Reads --of, and computes the columns' values at a pose.
#include "columns.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "answer.h"
#include "session.h"
#include "write/amount.h"

bool yk_columns_add(YkSession *session, YkAnswerColumns *columns, const char *name)
{
    if (!name || !YK_ROOM(columns->items, columns->count, columns->capacity))
        return yk_session_refuse_for_memory(session);
    YkAnswerColumn *column = &columns->items[columns->count++];
    column->name = name;
    return yk_channel_parse(session->mech, name, &column->channel, session->problems) == YK_OK;
}

bool yk_columns_read(YkSession *session, YkAnswerColumns *columns)
{
    bool good = true;
    for (const char *at = session->request->of; at && *at;) {
        size_t length = strcspn(at, ",");
        const char *name = yk_arena_copy(session->request->arena, at, length);
        if (length > 0 || at[length] == ',') good &= yk_columns_add(session, columns, name);
        at += length + (at[length] == ',');
    }
    return good;
}

bool yk_columns_need_forces(const YkAnswerColumns *columns)
{
    for (size_t c = 0; c < columns->count; c++)
        if (yk_channel_needs_forces(columns->items[c].channel)) return true;
    return false;
}

void yk_columns_free(YkAnswerColumns *columns)
{
    free(columns->items);
    *columns = (YkAnswerColumns){0};
}

double yk_column_value(const YkSession *session, const YkState *state, YkChannel channel)
{
    if (yk_channel_needs_forces(channel))
        return session->dynamics ? yk_dynamics_channel(session->dynamics, state, channel) : (double)NAN;
    double value = yk_state_channel(state, channel);
    if (channel.order == 2) return yk_if_accelerations(session, state, value);
    bool is_rate = channel.order == 1 || channel.kind == YK_CHANNEL_POINT_SPEED;
    return is_rate ? yk_if_rates(state, value) : value;
}

double yk_column_shown(const YkSession *session, double value, YkChannel channel)
{
    if (channel.kind != YK_CHANNEL_KINETIC) return yk_shown(session, value, channel.quantity);
    return value <= yk_scale_kinetic_noise(session) ? 0 : yk_amount_of(session->model, value, channel.quantity);
}

// Reads --over.
#include "range.h"
#include <string.h>
#include "answer.h"
#include "base/number.h"
#include "session.h"

// Returns the length of the number at the start of the text, or of a ratio of two, with its sign.
static size_t number_length(const char *text)
{
    double value;
    size_t sign = *text == '-' || *text == '+', length = yk_number_read(text + sign, strlen(text + sign), &value);
    if (length == 0) return 0;
    length += sign;
    if (text[length] != '/') return length;
    size_t under = yk_number_read(text + length + 1, strlen(text + length + 1), &value);
    return under > 0 ? length + 1 + under : length;
}

// Returns the unit that ends a number ("deg" of "360 deg"); NULL if there is none, or more than a unit.
static const char *unit_after(const char *text)
{
    size_t length = number_length(text);
    const char *unit = text + length + strspn(text + length, " ");
    bool is_letter = (*unit | 0x20) >= 'a' && (*unit | 0x20) <= 'z';
    return length > 0 && is_letter && !strpbrk(unit, " +-(") ? unit : NULL;
}

// Gives the first end the second one's unit if it has none of its own.
static const char *share_unit(YkArena *arena, const char *from, const char *to)
{
    const char *unit = unit_after(to);
    if (!unit || number_length(from) != strlen(from)) return from;
    YkText whole = {0};
    yk_text_format(&whole, "%s %s", from, unit);
    const char *copy = yk_arena_copy(arena, yk_text_get(&whole), whole.length);
    yk_text_free(&whole);
    return copy;
}

bool yk_over_split(YkSession *session, const char *text, YkOver *over)
{
    YkArena *arena = session->request->arena;
    const char *equals = strchr(text, '='), *colon = equals ? strchr(equals, ':') : NULL;
    bool good = colon && equals > text && colon > equals + 1 && colon[1] != '\0' && !strchr(colon + 1, ':');
    if (!good) {
        yk_session_refuse(session, YK_CODE_OPTION_RANGE, "--over takes NAME=FROM:TO, not %q", text);
        yk_problem_hint(session->problems, "as in --over theta1=0:360deg, or --over t=0:2s");
        return false;
    }
    *over = (YkOver){.name = yk_arena_copy(arena, text, (size_t)(equals - text)),
                     .from_text = yk_arena_copy(arena, equals + 1, (size_t)(colon - equals - 1)),
                     .to_text = colon + 1,
                     .coordinate = -1,
                     .quantity = YK_QUANTITY_TIME};
    if (over->from_text) over->from_text = share_unit(arena, over->from_text, over->to_text);
    if (over->name && over->from_text) return true;
    return yk_session_refuse_for_memory(session);
}

bool yk_over_read(YkSession *session, YkOver *over)
{
    if (strcmp(over->name, "t") != 0) {
        size_t found = yk_coordinate_find(session->mech, over->name);
        if (found == YK_NOT_FOUND)
            return yk_session_refuse(session, YK_CODE_NOT_A_COORDINATE, "the machine has no coordinate %q", over->name);
        over->coordinate = (int)found;
        YkCoordinateInfo info = yk_coordinate_info(session->mech, found);
        if (info.input < 0)
            return yk_session_refuse(session, YK_CODE_NOT_AN_INPUT, "no freedom is left to move %q", over->name);
        over->quantity = yk_quantity_of(info.is_distance, 0);
    }
    // Reads TO first: if it lends its unit to FROM, an error in the unit is best quoted there.
    return yk_session_value(session, "--over", over->name, over->to_text, over->quantity, &over->to) &&
           yk_session_value(session, "--over", over->name, over->from_text, over->quantity, &over->from);
}

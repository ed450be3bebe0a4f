// Channels: names of the numbers of a pose.
#include <string.h>
#include "base/letters.h"
#include "base/problems.h"
#include "base/text.h"
#include "compile/mechanism.h"

enum { NAME_MAX = 240 };

static int find_joint(const YkMechanism *mech, const char *name)
{
    return yk_names_find(&mech->model->joint_names, name);
}
// Finds a joint, or a contact, which come after the joints: gears, racks, belts and cams by name.
static int find_contact(const YkMechanism *mech, const char *name)
{
    int joint = find_joint(mech, name);
    for (size_t k = 0; joint < 0 && k < yk_contact_count(mech); k++)
        if (strcmp(yk_contact_name(mech, k), name) == 0) return (int)(mech->model->joint_count + k);
    return joint;
}
static int find_body(const YkMechanism *mech, const char *name)
{
    return yk_names_find(&mech->model->body_names, name);
}

static int find_coordinate(const YkMechanism *mech, const char *name)
{
    size_t found = yk_coordinate_find(mech, name);
    return found == YK_NOT_FOUND ? -1 : (int)found;
}

static YkQuantity quantity_of(bool is_length, int order)
{
    static const YkQuantity lengths[] = {YK_QUANTITY_LENGTH, YK_QUANTITY_SPEED, YK_QUANTITY_ACCELERATION};
    static const YkQuantity angles[] = {YK_QUANTITY_ANGLE, YK_QUANTITY_ANGLE_RATE, YK_QUANTITY_ANGLE_ACCELERATION};
    return is_length ? lengths[order] : angles[order];
}

static bool set(YkChannel *channel, YkChannelKind kind, int index, int order, bool is_length)
{
    if (index < 0) return false;
    *channel = (YkChannel){kind, index, order, quantity_of(is_length, order)};
    return true;
}

static int find_block(const YkMechanism *mech, const char *label)
{
    for (size_t b = 0; b < mech->block_count; b++)
        if (strcmp(mech->blocks[b].label, label) == 0) return (int)b;
    return -1;
}

static bool parse_point(const YkMechanism *mech, const char *asked, int order, YkChannel *channel)
{
    char name[NAME_MAX];
    strcpy(name, asked); // cut below
    if (yk_cut_ending(name, ".x"))
        return set(channel, YK_CHANNEL_POINT_X, yk_names_find(&mech->model->point_names, name), order, true);
    if (yk_cut_ending(name, ".y"))
        return set(channel, YK_CHANNEL_POINT_Y, yk_names_find(&mech->model->point_names, name), order, true);
    if (order == 0 && yk_cut_ending(name, ".speed")) {
        if (!set(channel, YK_CHANNEL_POINT_SPEED, yk_names_find(&mech->model->point_names, name), 0, true))
            return false;
        channel->quantity = YK_QUANTITY_SPEED;
        return true;
    }
    return false;
}

static bool set_force(YkChannel *channel, YkChannelKind kind, int index, YkQuantity quantity)
{
    if (index < 0) return false;
    *channel = (YkChannel){kind, index, 0, quantity};
    return true;
}

// Parses a channel of the whole machine.
static bool parse_whole(const char *name, YkChannel *channel)
{
    static const struct {
        const char *name;
        YkChannelKind kind;
        YkQuantity quantity;
    } whole[] = {{"energy", YK_CHANNEL_ENERGY, YK_QUANTITY_ENERGY},
                 {"kinetic", YK_CHANNEL_KINETIC, YK_QUANTITY_ENERGY},
                 {"potential", YK_CHANNEL_POTENTIAL, YK_QUANTITY_ENERGY},
                 {"shaking.x", YK_CHANNEL_SHAKING_X, YK_QUANTITY_FORCE},
                 {"shaking.y", YK_CHANNEL_SHAKING_Y, YK_QUANTITY_FORCE},
                 {"shaking.moment", YK_CHANNEL_SHAKING_MOMENT, YK_QUANTITY_TORQUE}};
    for (size_t k = 0; k < sizeof whole / sizeof *whole; k++)
        if (strcmp(name, whole[k].name) == 0) return set_force(channel, whole[k].kind, 0, whole[k].quantity);
    return false;
}

// Parses a force in a joint or along a coordinate.
static bool parse_force(const YkMechanism *mech, const char *asked, YkChannel *channel)
{
    char name[NAME_MAX];
    strcpy(name, asked); // cut below
    static const struct {
        const char *suffix;
        YkChannelKind kind;
    } forces[] = {{".force.x", YK_CHANNEL_FORCE_X}, {".force.y", YK_CHANNEL_FORCE_Y}, {".force", YK_CHANNEL_FORCE}};
    for (size_t k = 0; k < sizeof forces / sizeof *forces; k++)
        if (yk_cut_ending(name, forces[k].suffix))
            return set_force(channel, forces[k].kind, find_contact(mech, name), YK_QUANTITY_FORCE);
    if (yk_cut_ending(name, ".moment"))
        return set_force(channel, YK_CHANNEL_MOMENT, find_contact(mech, name), YK_QUANTITY_TORQUE);
    YkChannelKind kind = yk_cut_ending(name, ".effort.from") ? YK_CHANNEL_EFFORT_FROM
                         : yk_cut_ending(name, ".effort.to") ? YK_CHANNEL_EFFORT_TO
                                                             : YK_CHANNEL_EFFORT;
    if (kind == YK_CHANNEL_EFFORT && !yk_cut_ending(name, ".effort")) return false;
    int found = find_coordinate(mech, name);
    bool is_distance = found >= 0 && mech->coordinates[found].is_distance;
    return set_force(channel, kind, found, is_distance ? YK_QUANTITY_FORCE : YK_QUANTITY_TORQUE);
}

static bool parse(const YkMechanism *mech, char *name, YkChannel *channel)
{
    int order = yk_cut_ending(name, ".rate") ? 1 : yk_cut_ending(name, ".accel") ? 2 : 0;
    if (strcmp(name, "t") == 0 && order == 0) {
        *channel = (YkChannel){YK_CHANNEL_TIME, 0, 0, YK_QUANTITY_TIME};
        return true;
    }
    int found = find_coordinate(mech, name);
    if (found >= 0) return set(channel, YK_CHANNEL_COORDINATE, found, order, mech->coordinates[found].is_distance);
    if (order > 0 && find_body(mech, name) >= 0)
        return set(channel, YK_CHANNEL_BODY, find_body(mech, name), order, false);
    if (parse_point(mech, name, order, channel)) return true;
    if (order == 0 && (parse_whole(name, channel) || parse_force(mech, name, channel))) return true;
    if (order == 0 && yk_cut_ending(name, ".transmission"))
        return set(channel, YK_CHANNEL_TRANSMISSION, find_block(mech, name), 0, false);
    if (yk_cut_ending(name, ".angle")) {
        int joint = find_joint(mech, name);
        if (joint >= 0 && yk_part(mech->model->joints[joint].kind)->turns)
            return set(channel, YK_CHANNEL_JOINT_ANGLE, joint, order, false);
        return set(channel, YK_CHANNEL_BODY, find_body(mech, name), order, false);
    }
    if (yk_cut_ending(name, ".distance")) {
        int joint = find_joint(mech, name);
        if (joint >= 0 && (mech->joint_distance[joint] == YK_NONE || mech->model->joints[joint].is_free)) return false;
        return set(channel, YK_CHANNEL_JOINT_DISTANCE, joint, order, true);
    }
    return false;
}

static const char *nearest(const char *name, const YkNames *names)
{
    return yk_nearest(name, names->keys, names->capacity);
}

// Suggests the name that may have been meant; keeps its ending.
static bool suggest_name(const YkMechanism *mech, const char *asked, char *name, YkProblems *problems)
{
    const YkModel *model = mech->model;
    const struct {
        const char *suffix;
        const YkNames *names[2];
    } kinds[] = {{".x", {&model->point_names}},
                 {".y", {&model->point_names}},
                 {".speed", {&model->point_names}},
                 {".angle", {&model->body_names, &model->joint_names}},
                 {".distance", {&model->joint_names}},
                 {".transmission", {&model->joint_names}},
                 {"", {&model->coordinate_names, &model->body_names}}};
    bool is_derivative = yk_cut_ending(name, ".rate") || yk_cut_ending(name, ".accel");
    size_t k = 0;
    while (*kinds[k].suffix && !yk_cut_ending(name, kinds[k].suffix)) k++;
    const char *near = nearest(name, kinds[k].names[0]);
    bool may_be_second = kinds[k].names[1] && (*kinds[k].suffix || is_derivative); // a body alone is not a number
    if (!near && may_be_second) near = nearest(name, kinds[k].names[1]);
    if (!near || strcmp(near, name) == 0) return false;
    YkText meant = {0};
    yk_text_format(&meant, "%s%s", near, asked + strlen(name));
    yk_problem_hint(problems, "did you mean %q?", yk_text_get(&meant));
    yk_text_free(&meant);
    return true;
}

// Suggests the ending that means here what `asked` says: `theta.effort` for `theta.torque`. The rest is known.
static bool suggest_ending(const YkMechanism *mech, const char *asked, YkProblems *problems)
{
    static const char *const endings[][2] = {
        {".torque", ".effort"}, {".moment", ".effort"},  {".force", ".effort"},   {".velocity", ".rate"},
        {".speed", ".rate"},    {".omega", ".rate"},     {".velocity", ".speed"}, {".acceleration", ".accel"},
        {".alpha", ".accel"},   {".reaction", ".force"}, {".position", ""},
    };
    for (size_t k = 0; k < sizeof endings / sizeof *endings; k++) {
        YkChannel channel;
        YkText meant = {0};
        char name[NAME_MAX], parsed[NAME_MAX];
        strcpy(name, asked); // cut below
        if (!yk_cut_ending(name, endings[k][0])) continue;
        yk_text_format(&meant, "%s%s", name, endings[k][1]);
        bool fits = !meant.failed && meant.length < NAME_MAX;
        if (fits) strcpy(parsed, yk_text_get(&meant));
        bool is_known = fits && parse(mech, parsed, &channel);
        if (is_known) yk_problem_hint(problems, "did you mean %q?", yk_text_get(&meant));
        yk_text_free(&meant);
        if (is_known) return true;
    }
    return false;
}

static void suggest(const YkMechanism *mech, const char *asked, YkProblems *problems)
{
    char copy[NAME_MAX];
    size_t n = strlen(asked);
    if (n < NAME_MAX) {
        memcpy(copy, asked, n + 1);
        if (suggest_ending(mech, asked, problems) || suggest_name(mech, asked, copy, problems)) return;
    }
    yk_problem_hint(problems,
                    "ask for a coordinate (theta2, theta2.rate, theta2.accel), a body (lever.angle), a point (ram.C.x) "
                    "or a transmission angle (C.transmission)");
}

YkStatus yk_channel_parse(const YkMechanism *mech, const char *name, YkChannel *channel, YkProblems *problems)
{
    char copy[NAME_MAX];
    size_t n = strlen(name);
    if (n < NAME_MAX) {
        memcpy(copy, name, n + 1);
        if (parse(mech, copy, channel)) return YK_OK;
    }
    yk_problem(problems, YK_CODE_UNKNOWN_CHANNEL, (YkPlace){0}, "this machine has nothing called %q", name);
    suggest(mech, name, problems);
    return YK_BAD_ARGUMENT;
}

static void force_name(const YkMechanism *mech, YkChannel channel, YkText *name)
{
    static const char *const suffixes[] = {".force.x",       ".force.y",     ".force",    ".moment",   ".effort",
                                           "energy",         "kinetic",      "potential", "shaking.x", "shaking.y",
                                           "shaking.moment", ".effort.from", ".effort.to"};
    if (channel.kind == YK_CHANNEL_EFFORT || channel.kind >= YK_CHANNEL_EFFORT_FROM)
        yk_text_puts(name, mech->coordinates[channel.index].name);
    else if (channel.kind < YK_CHANNEL_EFFORT && (size_t)channel.index >= mech->model->joint_count)
        yk_text_puts(name, yk_contact_name(mech, (size_t)channel.index - mech->model->joint_count));
    else if (channel.kind < YK_CHANNEL_EFFORT)
        yk_text_puts(name, mech->model->joints[channel.index].name);
    yk_text_puts(name, suffixes[channel.kind - YK_CHANNEL_FORCE_X]);
}

size_t yk_channel_name(const YkMechanism *mech, YkChannel channel, char *text, size_t capacity)
{
    static const char *const orders[] = {"", ".rate", ".accel"};
    YkText name = {0};
    const YkModel *model = mech->model;
    switch (channel.kind) {
    case YK_CHANNEL_TIME:
        yk_text_puts(&name, "t");
        break;
    case YK_CHANNEL_COORDINATE:
        yk_text_puts(&name, mech->coordinates[channel.index].name);
        break;
    case YK_CHANNEL_JOINT_ANGLE:
        yk_text_format(&name, "%s.angle", model->joints[channel.index].name);
        break;
    case YK_CHANNEL_JOINT_DISTANCE:
        yk_text_format(&name, "%s.distance", model->joints[channel.index].name);
        break;
    case YK_CHANNEL_BODY:
        yk_text_format(&name, "%s.angle", model->bodies[channel.index].name);
        break;
    case YK_CHANNEL_TRANSMISSION:
        yk_text_format(&name, "%s.transmission", mech->blocks[channel.index].label);
        break;
    case YK_CHANNEL_POINT_X:
    case YK_CHANNEL_POINT_Y:
    case YK_CHANNEL_POINT_SPEED: {
        const YkPoint *p = &model->points[channel.index];
        const char *what = channel.kind == YK_CHANNEL_POINT_X   ? "x"
                           : channel.kind == YK_CHANNEL_POINT_Y ? "y"
                                                                : "speed";
        yk_text_format(&name, "%s.%s.%s", model->bodies[p->body].name, p->name, what);
        break;
    }
    default:
        force_name(mech, channel, &name);
    }
    yk_text_puts(&name, orders[channel.order]);
    const char *data = yk_text_get(&name);
    size_t length = strlen(data), n = capacity > 0 && length >= capacity ? capacity - 1 : length;
    if (capacity > 0) {
        memcpy(text, data, n);
        text[n] = 0;
    }
    yk_text_free(&name);
    return length;
}

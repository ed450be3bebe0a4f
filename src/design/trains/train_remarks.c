// Remarks on the teeth: whether planets can be spaced equally, whether they clear each other, whether teeth are
// undercut.
// Sources: Mueller 1982, Epicyclic Drive Trains (assembly); Norton, Design of Machinery, 9.3 (undercut).
#include <math.h>
#include "design/trains/train.h"
#include "elementary/elementary.h"

static int64_t common(int64_t a, int64_t b)
{
    while (b != 0) {
        int64_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

static bool add(YkTrain *train, const char *mesh, bool is_fault, YkText *text)
{
    const char *words = yk_train_keep(train->arena, text);
    train->remarks[train->remark_count++] = (YkTrainRemark){.mesh = mesh, .is_fault = is_fault, .text = words};
    return words != NULL;
}

// Returns which of the two is the planet: the one that the carrier holds by a pin while it does not hold the other.
static int planet_side(const YkModel *model, const YkGear *gear)
{
    bool holds[2] = {false, false};
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *joint = &model->joints[i];
        for (int k = 0; k < 2; k++)
            for (int end = 0; end < 2; end++)
                holds[k] |=
                    joint->kind == YK_PIN && joint->body[end] == gear->body[k] && joint->body[1 - end] == gear->carrier;
    }
    if (holds[0] != holds[1]) return holds[1];
    return gear->is_internal ? 0 : 1;
}

static bool is_round(const YkGear *gear)
{
    return gear->planets >= 2;
}

// Checks equal spacing: 1/n of a turn of the carrier must bring a planet to the next one's place. With planet gears
// p, q and central gears s, r this means: s q -+ r p is a multiple of n gcd(p, q).
static bool check_spacing(YkTrain *train, const YkGear *a, const YkGear *b)
{
    int side_a = planet_side(train->model, a), side_b = b->body[0] == a->body[side_a] ? 0 : 1;
    int64_t n = (int64_t)a->planets, p = a->teeth[side_a], s = a->teeth[1 - side_a], q = b->teeth[side_b],
            r = b->teeth[1 - side_b];
    int64_t sign = a->is_internal == b->is_internal ? -1 : 1;
    int64_t sum = s * q + sign * r * p, unit = common(p, q);
    YkText text = {0};
    bool fits = sum % (n * unit) == 0;
    if (p == q) {
        yk_text_format(&text, "%d planets equally spaced %s: (%d %c %d)/%d is %swhole", (int)n,
                       fits ? "fit" : "do not fit", (int)s, sign > 0 ? '+' : '-', (int)r, (int)n, fits ? "" : "not ");
    } else {
        yk_text_format(&text, "%d planets equally spaced %s: (%d*%d %c %d*%d)/(%d*%d) is %swhole", (int)n,
                       fits ? "fit" : "do not fit", (int)s, (int)q, sign > 0 ? '+' : '-', (int)r, (int)p, (int)n,
                       (int)unit, fits ? "" : "not ");
    }
    return add(train, a->name, !fits, &text);
}

static bool check_partner(YkTrain *train, const YkGear *gear)
{
    const YkModel *model = train->model;
    int32_t planet = gear->body[planet_side(model, gear)];
    for (size_t i = 0; i < model->gear_count; i++) {
        const YkGear *other = &model->gears[i];
        if (other == gear || other->carrier != gear->carrier) continue;
        if (other->body[0] != planet && other->body[1] != planet) continue;
        if (is_round(other) && other < gear) continue; // reported there
        if (!check_spacing(train, gear, other)) return false;
    }
    return true;
}

// Checks the room between neighbours: their tip circles, one module outside the pitch circles, must stay apart.
static bool check_room(YkTrain *train, const YkGear *gear)
{
    int side = planet_side(train->model, gear);
    int64_t z = gear->teeth[side],
            across = gear->is_internal ? gear->teeth[1] - gear->teeth[0] : gear->teeth[0] + gear->teeth[1];
    double room = (double)across * yk_sin(YK_PI / gear->planets) - (double)(z + 2);
    YkText text = {0};
    if (side == 1 && gear->is_internal) return true;
    yk_text_format(&text, "neighbours of %d planets %s: %d sin(180 deg/%d) = %e %s %d + 2 teeth", (int)gear->planets,
                   room > 0 ? "clear each other" : "touch each other", (int)across, (int)gear->planets,
                   (double)across * yk_sin(YK_PI / gear->planets), room > 0 ? ">" : "<=", (int)z);
    return add(train, gear->name, room <= 0, &text);
}

// Checks for undercut: full-depth teeth cut by a rack need 2/sin^2(pressure angle) of them; a rack cannot cut a ring.
static bool check_undercut(YkTrain *train, const YkGear *gear)
{
    double sine = yk_sin(gear->pressure_angle), least = 2 / (sine * sine);
    for (int k = 0; k < (gear->is_internal ? 1 : 2); k++) {
        if ((double)gear->teeth[k] >= floor(least)) continue; // 17.1: 17 teeth are made in practice
        YkText text = {0};
        yk_text_format(&text, "%d teeth of %s are undercut when cut by a rack: below %e at %e deg", (int)gear->teeth[k],
                       train->model->bodies[gear->body[k]].name, least, gear->pressure_angle * 180 / YK_PI);
        if (!add(train, gear->name, false, &text)) return false;
    }
    return true;
}

bool yk_train_remarks(YkTrain *train)
{
    const YkModel *model = train->model;
    train->remarks = YK_NEW(train->arena, YkTrainRemark, model->gear_count * (model->gear_count + 4) + 1);
    for (size_t i = 0; train->remarks && i < model->gear_count; i++) {
        const YkGear *gear = &model->gears[i];
        if (is_round(gear) && (!check_partner(train, gear) || !check_room(train, gear))) return false;
        if (!check_undercut(train, gear)) return false;
    }
    return train->remarks != NULL;
}

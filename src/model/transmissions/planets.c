// Equal planets that share the load of an epicyclic set: `planets: N` of gears.
//
// The file has one planet; the others are its copies, turned about the carrier's axis by equal angles. By symmetry all
// of them turn alike, so that N planets need no further motion, only further inertia and other forces:
// - The planet's inertia counts N times, and so does the viscous friction of its pin.
// - The N - 1 other masses m become a body of their own, welded to the carrier. With the planet at the distance r from
//   the axis, their common centre is at -r/(N - 1), and their inertia about it is m r^2 (N - 1 - 1/(N - 1)).
// - Teeth push the planet as before. On the wheel about the axis the pushes of all planets add up to a couple; their
//   sum bears on the carrier's axis instead. `copies` at gears and joints is for the rooms that find forces.
// Each planet is taken to carry an equal share.
#include <math.h>
#include "model/transmissions/planets.h"

typedef struct Planets {
    YkLoader *loader;
    YkModel *model;
    YkPlanet *of; // per body
    size_t count; // bodies of the file
} Planets;

size_t yk_load_count_planets(YkLoader *loader)
{
    const YkNode *section = yk_node_get(loader->root, "gears");
    bool any = false;
    if (!section || section->kind != YK_NODE_MAP) return 0;
    for (size_t i = 0; i < section->count; i++) {
        const YkNode *gear = section->pairs[i].value;
        any = any || (gear->kind == YK_NODE_MAP && yk_node_get(gear, "planets"));
    }
    return any ? 2 * section->count : 0;
}

// --- which bodies are planets

// Returns whether another joint of the carrier lies at the same place, as for wheels about its own axis.
static bool is_on_axis(const YkModel *model, int32_t joint, int32_t carrier)
{
    const YkJoint *own = &model->joints[joint];
    YkVec at = own->at[own->body[1] == carrier];
    for (int32_t j = 0; j < (int32_t)model->joint_count; j++)
        for (int side = 0; side < 2; side++) {
            const YkJoint *other = &model->joints[j];
            if (j == joint || other->kind != YK_PIN || other->body[side] != carrier) continue;
            if (yk_norm(yk_sub(other->at[side], at)) == 0) return true;
        }
    return false;
}

// Returns the pin by which alone a wheel is held, beside the axis of its moving carrier; YK_NONE if it is not a planet.
static int32_t pin_of(const YkModel *model, int32_t body, int32_t carrier)
{
    int32_t found = YK_NONE;
    if (body <= 0 || carrier <= 0) return YK_NONE;
    for (int32_t j = 0; j < (int32_t)model->joint_count; j++) {
        const YkJoint *joint = &model->joints[j];
        if (joint->body[0] != body && joint->body[1] != body) continue;
        if (found != YK_NONE || joint->kind != YK_PIN || joint->body[joint->body[0] == body] != carrier) return YK_NONE;
        found = j;
    }
    return found == YK_NONE || is_on_axis(model, found, carrier) ? YK_NONE : found;
}

static void refuse(YkPlanet *planet, const char *why)
{
    if (!planet->why) planet->why = why;
}

// Makes a body a planet. Returns whether it became one.
static bool enter(Planets *p, int32_t body, const YkGear *gear, int32_t copies)
{
    int32_t joint = pin_of(p->model, body, gear->carrier);
    if (joint == YK_NONE) return false;
    YkPlanet *planet = &p->of[body];
    if (planet->copies > 0) {
        if (planet->copies != copies) refuse(planet, "gears give %q two numbers of planets");
        return false;
    }
    int32_t side = p->model->joints[joint].body[1] == body;
    *planet = (YkPlanet){copies, joint, side, YK_REPORTED, NULL};
    return true;
}

// Planets that mesh with each other are as many, and share all or none.
static bool spread(Planets *p, const YkGear *gear)
{
    bool grows = false;
    for (int k = 0; k < 2; k++) {
        YkPlanet *from = &p->of[gear->body[k]], *to = &p->of[gear->body[1 - k]];
        if (from->copies == 0) continue;
        bool is_new = enter(p, gear->body[1 - k], gear, from->copies);
        if (to->copies == 0) continue;
        grows = grows || is_new || (from->why && !to->why) || (from->axis != YK_REPORTED && to->axis == YK_REPORTED);
        if (from->why) refuse(to, from->why);
        if (to->axis == YK_REPORTED) to->axis = from->axis;
    }
    return grows;
}

static void spread_all(Planets *p)
{
    for (bool grows = true; grows;) {
        grows = false;
        for (size_t i = 0; i < p->model->gear_count; i++) grows = spread(p, &p->model->gears[i]) || grows;
    }
}

// --- whether they can share

// Finds a point of the carrier, or its origin, at the place of an axis. Returns whether there is one.
static bool find_axis(const YkModel *model, int32_t carrier, YkVec at, int32_t *point)
{
    for (size_t j = 0; j < model->joint_count; j++)
        for (int side = 0; side < 2; side++) {
            const YkJoint *joint = &model->joints[j];
            if (joint->kind != YK_PIN && joint->kind != YK_WELD) continue;
            if (joint->body[side] != carrier || yk_norm(yk_sub(joint->at[side], at)) != 0) continue;
            *point = joint->point[side];
            return true;
        }
    return false;
}

// Takes the axis from a mesh with a wheel that turns about it.
static void take_axis(Planets *p, const YkGear *gear, int k)
{
    YkPlanet *planet = &p->of[gear->body[k]];
    int32_t point;
    if (!find_axis(p->model, gear->carrier, gear->center[1 - k], &point))
        refuse(planet, "no joint of the carrier of %q lies on the axis");
    else if (planet->axis == YK_REPORTED)
        planet->axis = point;
    else if (planet->axis != point)
        refuse(planet, "%q meshes with wheels on different axes");
}

// Refuses a planet of which the file has a copy as a body: a wheel that meshes alike with the same wheel.
static void find_twins(Planets *p, const YkGear *gear, int k)
{
    for (size_t i = 0; i < p->model->gear_count; i++) {
        const YkGear *other = &p->model->gears[i];
        for (int side = 0; side < 2; side++) {
            bool is_alike = other->body[1 - side] == gear->body[1 - k] && other->teeth[side] == gear->teeth[k] &&
                            other->carrier == gear->carrier && other->is_internal == gear->is_internal;
            if (is_alike && other->body[side] != gear->body[k] && p->of[other->body[side]].copies > 0)
                refuse(&p->of[gear->body[k]], "the file has a second planet like %q as a body of its own");
        }
    }
}

static void check_gears(Planets *p)
{
    for (size_t i = 0; i < p->model->gear_count; i++) {
        const YkGear *gear = &p->model->gears[i];
        for (int k = 0; k < 2; k++) {
            YkPlanet *planet = &p->of[gear->body[k]];
            if (planet->copies == 0) continue;
            const YkJoint *pin = &p->model->joints[planet->joint];
            if (gear->carrier != pin->body[!planet->side] || !(gear->center_distance > 0))
                refuse(planet, "%q meshes with a wheel that another body carries");
            else if (p->of[gear->body[1 - k]].copies == 0) {
                take_axis(p, gear, k);
                find_twins(p, gear, k);
            }
        }
    }
}

// Refuses a planet on which something besides gears acts.
static void act(Planets *p, int32_t body)
{
    if (body != YK_NONE && p->of[body].copies > 0) refuse(&p->of[body], "something besides gears acts on %q");
}

static void check_neighbours(Planets *p)
{
    const YkModel *m = p->model;
    for (size_t i = 0; i < m->rack_count; i++) act(p, m->racks[i].pinion), act(p, m->racks[i].rack);
    for (size_t i = 0; i < m->belt_count; i++) act(p, m->belts[i].body[0]), act(p, m->belts[i].body[1]);
    for (size_t i = 0; i < m->cam_count; i++) act(p, m->cams[i].cam), act(p, m->cams[i].follower);
    for (size_t i = 0; i < m->force_count; i++) act(p, m->forces[i].body);
    for (size_t i = 0; i < m->spring_count; i++)
        for (int k = 0; k < 2; k++) act(p, m->springs[i].body[k]);
}

// Returns whether anything moves a coordinate, or loads it.
static bool is_acted_on(const YkModel *m, int32_t coordinate)
{
    if (coordinate == YK_NONE) return false;
    bool is = m->coordinates[coordinate].drive != YK_NONE;
    for (size_t i = 0; i < m->follow_count; i++)
        is = is || m->follows[i].coordinate == coordinate || m->follows[i].of == coordinate;
    for (size_t i = 0; i < m->effort_count; i++) is = is || m->efforts[i].coordinate == coordinate;
    for (size_t i = 0; i < m->spring_count; i++) is = is || m->springs[i].coordinate == coordinate;
    return is;
}

static bool is_zero(const YkExpr *expr, double value)
{
    return !expr || (value == 0 && !yk_expr_has_names(expr));
}

static void check_bodies(Planets *p)
{
    for (size_t b = 0; b < p->count; b++) {
        YkPlanet *planet = &p->of[b];
        const YkBody *body = &p->model->bodies[b];
        if (planet->copies == 0) continue;
        const YkJoint *pin = &p->model->joints[planet->joint];
        bool is_centred = is_zero(body->center_x, body->center.x) && is_zero(body->center_y, body->center.y);
        if (body->rod[0] != YK_NONE || !is_centred) refuse(planet, "the centre of mass of %q is not on its axis");
        if (pin->at[planet->side].x != 0 || pin->at[planet->side].y != 0)
            refuse(planet, "the pin of %q is not at its origin");
        if (is_acted_on(p->model, pin->angle)) act(p, (int32_t)b);
        if (pin->friction.coulomb_expr) refuse(planet, "the pin of %q has dry friction");
        if (p->model->carriage_count > 0) refuse(planet, "the machine of %q has free joints");
    }
}

// --- the loader's step

static bool has_forces(const YkModel *model)
{
    bool has = model->effort_count + model->force_count + model->spring_count > 0;
    for (size_t b = 0; b < model->body_count; b++) has = has || model->bodies[b].has_mass;
    for (size_t j = 0; j < model->joint_count; j++) has = has || model->joints[j].has_friction;
    return has;
}

static void warn(YkLoader *loader, const YkGear *gear, const char *why, const char *body)
{
    YkText reason = {0};
    if (!has_forces(loader->model)) return;
    yk_text_format(&reason, why, body);
    yk_problem(loader->problems, YK_CODE_PLANETS_ONCE, gear->planets_expr->place,
               "gears %q: masses and forces count one planet, not %d: %s", gear->name, (int)gear->planets,
               yk_text_get(&reason));
    yk_problem_hint(loader->problems, "give it the mass and the inertia of all %d", (int)gear->planets);
    loader->failed |= reason.failed;
    yk_text_free(&reason);
}

static bool is_given(const YkGear *gear)
{
    return gear->planets_expr && gear->planets >= 2 && gear->planets == rint(gear->planets);
}

static const char no_planet[] = "no wheel is held by one pin alone, beside the axis of a carrier that moves";

static bool is_good(const YkPlanet *planet)
{
    return planet->copies > 0 && !planet->why;
}

static void share(Planets *p)
{
    YkLoader *loader = p->loader;
    YkModel *model = p->model;
    for (size_t i = 0; i < model->gear_count; i++) {
        YkGear *gear = &model->gears[i];
        bool is[2] = {is_good(&p->of[gear->body[0]]), is_good(&p->of[gear->body[1]])};
        if (is[0] || is[1]) gear->copies = p->of[gear->body[is[0] ? 0 : 1]].copies;
        gear->planet = is[0] && is[1] ? 2 : is[1];
        if (!is_given(gear) || is[0] || is[1]) continue;
        int k = p->of[gear->body[0]].copies > 0 ? 0 : 1;
        const YkPlanet *planet = &p->of[gear->body[k]];
        warn(loader, gear, planet->copies > 0 ? planet->why : no_planet, model->bodies[gear->body[k]].name);
    }
    for (size_t b = 0; b < p->count && !loader->failed; b++) {
        const YkPlanet *planet = &p->of[b];
        if (is_good(planet)) yk_load_copy_planet(loader, planet, (int32_t)b);
    }
}

void yk_load_share_planets(YkLoader *loader)
{
    YkModel *model = loader->model;
    Planets p = {.loader = loader, .model = model, .count = model->body_count};
    bool any = false;
    for (size_t i = 0; i < model->gear_count; i++) {
        const YkGear *gear = &model->gears[i];
        any = any || is_given(gear);
        if (gear->carrier < 0 || gear->body[0] == YK_NONE || gear->body[1] == YK_NONE) return; // reported already
    }
    p.of = any && !loader->has_bad_joint ? YK_NEW(loader->arena, YkPlanet, p.count) : NULL;
    if (!p.of) return;
    for (size_t i = 0; i < model->gear_count; i++) {
        const YkGear *gear = &model->gears[i];
        for (int k = 0; k < 2 && is_given(gear); k++) enter(&p, gear->body[k], gear, (int32_t)gear->planets);
    }
    spread_all(&p);
    check_gears(&p);
    check_neighbours(&p);
    check_bodies(&p);
    spread_all(&p);
    for (size_t b = 0; b < p.count; b++)
        if (p.of[b].copies > 0 && p.of[b].axis == YK_REPORTED) refuse(&p.of[b], "no wheel on the axis meshes with %q");
    spread_all(&p);
    share(&p);
}

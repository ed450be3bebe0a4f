// Reads `forces:` at points of bodies, in world axes or the body's own, and moments on bodies: each component an
// expression or a law.
#include <string.h>
#include "model/load.h"

static void read_axes(YkLoader *loader, YkForce *force, const YkNode *axes)
{
    const YkSubject subject = {.noun = "axes", .owner = force->name};
    if (!axes || !yk_load_expect(loader, axes, YK_NODE_SCALAR, &subject)) return;
    force->in_body_axes = strcmp(axes->text, "body") == 0;
    if (force->in_body_axes || strcmp(axes->text, "world") == 0) return;
    yk_problem(loader->problems, YK_CODE_WRONG_WORD, axes->place, "the axes of a force are `body` or `world`, not %q",
               axes->text);
}

// Reads [x, y], each a strength of its own.
static void read_components(YkLoader *loader, YkForce *force, const YkNode *value, YkWant *want)
{
    if (!yk_load_expect_pair(loader, value, want)) return;
    want->subject.axis = "x of ";
    force->x = yk_load_strength(loader, value->items[0], want);
    want->subject.axis = "y of ";
    force->y = yk_load_strength(loader, value->items[1], want);
}

// Reads the force, the moment, or both.
static void read_value(YkLoader *loader, YkForce *force, const YkNode *node, const YkSubject *subject)
{
    const YkNode *moment = yk_node_get(node, "moment");
    const YkNode *value = moment ? yk_node_get(node, "value") : yk_load_require(loader, node, "value", subject);
    YkWant want = {.dimension = YK_DIM_FORCE, .scope = YK_SCOPE_STATE, .subject = *subject};
    force->x = force->y = force->moment = (YkStrength){.law = YK_NONE};
    if (value) read_components(loader, force, value, &want);
    want.dimension = YK_DIM_TORQUE;
    want.subject = (YkSubject){.noun = "moment", .owner = force->name};
    if (moment) force->moment = yk_load_strength(loader, moment, &want);
}

// Returns the body on which it acts: `body:`, or `on:`, which other readers of YAML take for a boolean.
static const YkNode *body_of(YkLoader *loader, const YkNode *node, const YkSubject *subject)
{
    const YkNode *on = yk_node_get(node, "on");
    if (!on) return yk_load_require(loader, node, "body", subject);
    if (!yk_node_get(node, "body")) return on;
    yk_problem(loader->problems, YK_CODE_RIVAL_KEYS, yk_load_key(node, "on")->place,
               "%s has a `body`; leave out `on`, which means the same", yk_load_subject(loader, subject));
    return NULL;
}

static void read_force(YkLoader *loader, YkForce *force, const YkNode *node)
{
    static const char *const keys[] = {"body", "at", "value", "axes", "moment", "on", NULL};
    const YkSubject subject = {.noun = "force", .part = force->name};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, keys, &subject);
    const YkNode *body = body_of(loader, node, &subject), *at = yk_node_get(node, "at");
    if (body) force->body = yk_load_body(loader, body);
    if (at && force->body != YK_NONE) force->point = yk_load_point(loader, force->body, at);
    read_value(loader, force, node, &subject);
    read_axes(loader, force, yk_node_get(node, "axes"));
}

void yk_load_forces(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "forces");
    YkModel *model = loader->model;
    if (!section) return;
    model->forces = YK_NEW(loader->arena, YkForce, section->count);
    if (!model->forces) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkForce *force = &model->forces[model->force_count++];
        *force = (YkForce){.name = pair->key->text, .place = pair->key->place, .body = YK_NONE, .point = YK_NONE};
        yk_load_name(loader, pair->key, "force");
        read_force(loader, force, pair->value);
    }
}

void yk_load_finish_forces(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->force_count; i++) {
        YkForce *force = &model->forces[i];
        if (force->point != YK_NONE) force->at = model->points[force->point].at;
    }
}

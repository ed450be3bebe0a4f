// Reads `racks:`, pinions that roll on racks.
#include <math.h>
#include "model/load.h"

static void read_rack(YkLoader *loader, YkRack *rack, const YkNode *node)
{
    static const char *const keys[] = {"pinion", "rack", "radius", "carrier", NULL};
    const YkSubject subject = {.noun = "rack", .part = rack->name};
    const YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "radius", .owner = rack->name}};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, keys, &subject);
    const YkNode *pinion = yk_load_require(loader, node, "pinion", &subject);
    const YkNode *bar = yk_load_require(loader, node, "rack", &subject);
    const YkNode *radius = yk_load_require(loader, node, "radius", &subject);
    if (pinion) rack->pinion = yk_load_body(loader, pinion);
    if (bar) rack->rack = yk_load_body(loader, bar);
    if (radius) rack->radius_expr = yk_load_value(loader, radius, &want, &rack->radius);
    rack->carrier = yk_load_carrier(loader, node);
    if (rack->pinion == YK_NONE || rack->pinion != rack->rack) return;
    yk_problem(loader->problems, YK_CODE_SELF_MESH, bar->place, "rack %q: %q cannot drive itself", rack->name,
               loader->model->bodies[rack->pinion].name);
    rack->rack = YK_NONE;
}

void yk_load_racks(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "racks");
    YkModel *model = loader->model;
    if (!section) return;
    model->racks = YK_NEW(loader->arena, YkRack, section->count);
    if (!model->racks) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkRack *rack = &model->racks[model->rack_count++];
        *rack = (YkRack){.name = pair->key->text,
                         .place = pair->key->place,
                         .pinion = YK_NONE,
                         .rack = YK_NONE,
                         .carrier = YK_NONE,
                         .slide = YK_NONE,
                         .sense = 1};
        yk_load_name(loader, pair->key, "rack");
        read_rack(loader, rack, pair->value);
    }
}

// --- with values known

static bool is_at_origin(YkVec at)
{
    return at.x == 0 && at.y == 0;
}

const YkJoint *yk_rack_pin(const YkModel *model, const YkRack *rack, int32_t body)
{
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *joint = &model->joints[i];
        for (int k = 0; k < 2; k++) {
            bool is_between = joint->body[k] == rack->pinion && joint->body[1 - k] == body;
            if (joint->kind == YK_PIN && is_between && is_at_origin(joint->at[k])) return joint;
        }
    }
    return NULL;
}

// Returns whether the body holds the pinion's centre by a pin; *at is its place on the body.
static bool holds_pinion(const YkModel *model, const YkRack *rack, int32_t body, YkVec *at)
{
    const YkJoint *pin = yk_rack_pin(model, rack, body);
    if (pin) *at = pin->at[pin->body[1] == body];
    return pin != NULL;
}

// Returns the distance of the pinion's centre from the line of the slide, positive to the left of its direction, in the
// axes of the slide's first body. A slide written from the rack to the carrier fixes its line in the rack, and the line
// passes through the carrier's point: both signs change.
static double side_of(const YkJoint *slide, bool is_reversed, YkVec center)
{
    return yk_cross(slide->along, yk_sub(center, slide->at[is_reversed ? 1 : 0]));
}

static int32_t sense_on(double side, bool is_reversed)
{
    return (side < 0) == is_reversed ? 1 : -1;
}

// Says where the line passes through the pinion's centre that the side is a guess.
static int32_t sense_of(YkLoader *loader, const YkRack *rack, const YkJoint *slide, bool is_reversed, YkVec center)
{
    double side = side_of(slide, is_reversed, center);
    if (fabs(side) <= 1e-9 * rack->radius) {
        yk_problem(loader->problems, YK_CODE_RACK_SIDE, rack->place,
                   "rack %q: slide %q passes through the centre of %q, which is taken to lie to the left of the line",
                   rack->name, slide->name, loader->model->bodies[rack->pinion].name);
        yk_problem_hint(loader->problems, "begin the slide with `from:` at a point beside the pinion");
    }
    return sense_on(side, is_reversed);
}

bool yk_rack_keeps_side(const YkModel *model, const YkRack *rack)
{
    const YkJoint *slide = &model->joints[rack->slide];
    bool is_reversed = slide->body[0] == rack->rack;
    YkVec center;
    return !holds_pinion(model, rack, rack->carrier, &center) ||
           sense_on(side_of(slide, is_reversed, center), is_reversed) == rack->sense;
}

static bool find_slide(YkLoader *loader, YkRack *rack)
{
    YkModel *model = loader->model;
    int32_t given = rack->carrier;
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *joint = &model->joints[i];
        for (int k = 0; k < 2; k++) {
            int32_t carrier = joint->body[1 - k];
            YkVec center;
            if (joint->kind != YK_SLIDE || joint->body[k] != rack->rack || carrier == YK_NONE) continue;
            if ((given != YK_NONE && given != carrier) || !holds_pinion(model, rack, carrier, &center)) continue;
            rack->carrier = carrier;
            rack->slide = (int32_t)i;
            rack->sense = sense_of(loader, rack, joint, k == 0, center);
            return true;
        }
    }
    return false;
}

static void finish_rack(YkLoader *loader, YkRack *rack)
{
    YkModel *model = loader->model;
    if (rack->radius_expr) rack->exact_radius = yk_model_exact(model, rack->radius_expr);
    if (rack->radius_expr && rack->radius <= 0)
        yk_load_refuse_amount(loader, YK_CODE_BAD_RADIUS, rack->radius_expr, rack->radius, YK_DIM_LENGTH,
                              "the %s of %q is %e %s; it must be positive", "radius", rack->name);
    if (rack->pinion == YK_NONE || rack->rack == YK_NONE || rack->carrier == YK_REPORTED || loader->has_bad_joint)
        return;
    if (find_slide(loader, rack)) return;
    yk_problem(loader->problems, YK_CODE_NO_CARRIER, rack->place,
               "rack %q: no body holds the centre of %q by a pin and %q by a slide", rack->name,
               model->bodies[rack->pinion].name, model->bodies[rack->rack].name);
}

void yk_load_finish_racks(YkLoader *loader)
{
    for (size_t i = 0; i < loader->model->rack_count; i++) finish_rack(loader, &loader->model->racks[i]);
}

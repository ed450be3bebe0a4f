// Reads `friction:` of a joint: dry (coulomb), with the radius at which it acts in a pin, and viscous.
#include "model/load.h"

// Reads the radius, which only a pin needs: its friction is a moment. A slide and a pin-slot rub by a force along their
// line.
static void read_radius(YkLoader *loader, YkJoint *joint, const YkNode *node)
{
    YkFriction *friction = &joint->friction;
    const YkNode *key = yk_load_key(node, "radius");
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "radius of the friction", .owner = joint->name}};
    if (!yk_part(joint->kind)->slides) {
        friction->radius_expr = yk_load_key_value(loader, node, "radius", &want, &friction->radius);
        if (key || !yk_node_get(node, "coulomb")) return;
        yk_problem(loader->problems, YK_CODE_MISSING_KEY, node->place, "friction of %q needs `radius`", joint->name);
        yk_problem_hint(loader->problems,
                        "`coulomb` in a pin gives a moment, coulomb * radius * |reaction|: add the pin's radius");
    } else if (key) {
        yk_problem(loader->problems, YK_CODE_UNKNOWN_KEY, key->place,
                   "friction of %q has no `radius`: in a %s it is a force along the line", joint->name,
                   yk_part(joint->kind)->key);
    }
}

void yk_load_friction(YkLoader *loader, const YkNode *node, YkJoint *joint)
{
    static const char *const keys[] = {"coulomb", "radius", "viscous", NULL};
    const YkPart *part = yk_part(joint->kind);
    const YkSubject subject = {.noun = "friction", .owner = joint->name};
    if (!node || (!part->turns && !part->slides)) return; // on a weld the key itself is refused
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, keys, &subject);
    YkFriction *friction = &joint->friction;
    joint->has_friction = true;
    friction->place = node->place;
    YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "coulomb", .owner = joint->name}};
    friction->coulomb_expr = yk_load_key_value(loader, node, "coulomb", &want, &friction->coulomb);
    want.subject.noun = "viscous";
    want.dimension = part->slides ? YK_DIM_DAMPING : YK_DIM_TURN_DAMPING;
    friction->viscous_expr = yk_load_key_value(loader, node, "viscous", &want, &friction->viscous);
    read_radius(loader, joint, node);
}

static void check_friction(YkLoader *loader, const YkJoint *joint)
{
    const YkFriction *friction = &joint->friction;
    if (friction->coulomb_expr && friction->coulomb < 0) {
        yk_problem(loader->problems, YK_CODE_BAD_FRICTION, friction->coulomb_expr->place,
                   "the coefficient `coulomb` of %q is %g; it cannot be negative", joint->name, friction->coulomb);
    }
    if (friction->radius_expr && friction->radius <= 0)
        yk_load_refuse_amount(loader, YK_CODE_BAD_FRICTION, friction->radius_expr, friction->radius, YK_DIM_LENGTH,
                              "the %s of %q is %e %s; it must be positive", "friction radius", joint->name);
    if (friction->viscous_expr && friction->viscous < 0)
        yk_load_refuse_amount(loader, YK_CODE_BAD_DAMPING, friction->viscous_expr, friction->viscous,
                              yk_part(joint->kind)->slides ? YK_DIM_DAMPING : YK_DIM_TURN_DAMPING,
                              "the %s of %q is %e %s; it cannot be negative", "viscous friction", joint->name);
}

void yk_load_finish_friction(YkLoader *loader)
{
    const YkModel *model = loader->model;
    for (size_t i = 0; i < model->joint_count; i++) {
        if (model->joints[i].has_friction) check_friction(loader, &model->joints[i]);
    }
}

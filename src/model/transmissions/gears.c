// Reads `gears:`, pairs of gears in mesh.
#include <math.h>
#include "model/load.h"

static const double default_pressure_angle = 20 * YK_PI / 180;
enum { TEETH_MAX = 1000000, PLANETS_MAX = 1000 };

static void read_teeth(YkLoader *loader, YkGear *gear, const YkNode *node, const YkSubject *subject)
{
    const YkNode *teeth = yk_load_two_values(loader, node, "teeth", subject);
    const YkWant want = {.dimension = YK_DIM_NUMBER, .subject = {.noun = "number of teeth", .owner = gear->name}};
    for (int k = 0; teeth && k < 2; k++)
        gear->teeth_expr[k] = yk_load_value(loader, teeth->items[k], &want, &gear->teeth_value[k]);
}

static void read_gear(YkLoader *loader, YkGear *gear, const YkNode *node)
{
    static const char *const keys[] = {"mesh",    "teeth",    "module",  "pressure_angle",
                                       "carrier", "internal", "planets", NULL};
    const YkSubject subject = {.noun = "gears", .part = gear->name};
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = "module", .owner = gear->name}};
    if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, node, keys, &subject);
    yk_load_two_bodies(loader, yk_load_two_values(loader, node, "mesh", &subject), &subject, gear->body);
    read_teeth(loader, gear, node, &subject);
    gear->module_expr = yk_load_key_value(loader, node, "module", &want, &gear->module);
    want.dimension = YK_DIM_ANGLE;
    want.subject.noun = "pressure angle";
    gear->pressure_angle_expr = yk_load_key_value(loader, node, "pressure_angle", &want, &gear->pressure_angle);
    want.dimension = YK_DIM_NUMBER;
    want.subject.noun = "number of planets";
    gear->planets_expr = yk_load_key_value(loader, node, "planets", &want, &gear->planets);
    gear->is_internal = yk_load_yes_or_no(loader, node, "internal", &subject);
    gear->carrier = yk_load_carrier(loader, node);
}

void yk_load_gears(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "gears");
    YkModel *model = loader->model;
    if (!section) return;
    model->gears = YK_NEW(loader->arena, YkGear, section->count);
    if (!model->gears) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkGear *gear = &model->gears[model->gear_count++];
        *gear = (YkGear){.name = pair->key->text,
                         .place = pair->key->place,
                         .body = {YK_NONE, YK_NONE},
                         .carrier = YK_NONE,
                         .teeth_value = {NAN, NAN}};
        yk_load_name(loader, pair->key, "pair of gears");
        read_gear(loader, gear, pair->value);
    }
}

// --- with values known

static bool finish_teeth(YkLoader *loader, YkGear *gear)
{
    bool good = true;
    for (int k = 0; k < 2; k++) {
        double value = gear->teeth_value[k];
        if (isnan(value)) { // reported already
            good = false;
            continue;
        }
        if (value >= 0.5 && value <= TEETH_MAX && fabs(value - rint(value)) <= 1e-9 * value) {
            gear->teeth[k] = (int64_t)rint(value);
            continue;
        }
        good = false;
        yk_problem(loader->problems, YK_CODE_BAD_TEETH, gear->teeth_expr[k]->place,
                   "gears %q: %g is not a number of teeth, which is whole and positive", gear->name, value);
    }
    return good;
}

static void check_ring(YkLoader *loader, const YkGear *gear)
{
    if (!gear->is_internal || gear->teeth[1] > gear->teeth[0]) return;
    yk_problem(loader->problems, YK_CODE_RING_TOO_SMALL, gear->place,
               "gears %q: the ring has %d teeth, the gear inside it %d; the ring needs more", gear->name,
               (int)gear->teeth[1], (int)gear->teeth[0]);
    yk_problem_hint(loader->problems, "in an internal pair the second body is the ring");
}

static void check_sizes(YkLoader *loader, YkGear *gear)
{
    if (!gear->pressure_angle_expr) gear->pressure_angle = default_pressure_angle;
    if (gear->module_expr && gear->module <= 0)
        yk_load_refuse_amount(loader, YK_CODE_BAD_MODULE, gear->module_expr, gear->module, YK_DIM_LENGTH,
                              "the %s of %q is %e %s; it must be positive", "module", gear->name);
    if (gear->pressure_angle <= 0 || gear->pressure_angle > YK_PI / 4) {
        yk_problem(loader->problems, YK_CODE_BAD_MODULE, gear->pressure_angle_expr->place,
                   "the pressure angle of gears %q is %e deg; it must be above 0 and at most 45 deg", gear->name,
                   gear->pressure_angle * 180 / YK_PI);
    }
    double planets = gear->planets;
    if (gear->planets_expr && !isnan(planets) && (planets < 1 || planets > PLANETS_MAX || planets != rint(planets))) {
        yk_problem(loader->problems, YK_CODE_BAD_TEETH, gear->planets_expr->place,
                   "gears %q: %g is not a number of planets, which is whole and positive", gear->name, planets);
    }
}

// Checks that module and centres agree: a = module (z2 +- z1) / 2.
static void check_distance(YkLoader *loader, const YkGear *gear)
{
    if (!gear->module_expr || !(gear->module > 0)) return;
    int64_t teeth = gear->is_internal ? gear->teeth[1] - gear->teeth[0] : gear->teeth[0] + gear->teeth[1];
    double wanted = gear->module * (double)teeth / 2, off = gear->center_distance - wanted, size = 1;
    if (wanted <= 0 || fabs(off) <= 1e-9 * wanted) return;
    const char *unit = yk_model_unit(loader->model, YK_QUANTITY_LENGTH, &size);
    yk_problem(loader->problems, YK_CODE_CENTER_DISTANCE, gear->place,
               "gears %q: the centres are %e %s apart on %q, but module and teeth ask for %e %s; that is %e %s too %s",
               gear->name, gear->center_distance / size, unit, loader->model->bodies[gear->carrier].name, wanted / size,
               unit, fabs(off) / size, unit, off > 0 ? "much" : "little");
    if (gear->center_distance == 0) {
        yk_problem_hint(loader->problems, "both pins lie at one place of %q: put one at a point %e %s away",
                        loader->model->bodies[gear->carrier].name, wanted / size, unit);
        return;
    }
    yk_problem_hint(loader->problems, "the distance is module * (%d %c %d) / 2; without `module` it does not matter",
                    (int)gear->teeth[gear->is_internal], gear->is_internal ? '-' : '+',
                    (int)gear->teeth[!gear->is_internal]);
}

void yk_load_finish_gears(YkLoader *loader)
{
    YkModel *model = loader->model;
    for (size_t i = 0; i < model->gear_count; i++) {
        YkGear *gear = &model->gears[i];
        const YkWheelPair pair = {"gears", gear->name, gear->place, {gear->body[0], gear->body[1]}, gear->carrier};
        bool has_teeth = finish_teeth(loader, gear);
        if (has_teeth) check_ring(loader, gear);
        check_sizes(loader, gear);
        gear->carrier = yk_load_find_carrier(loader, &pair, &gear->center_distance, gear->center);
        if (has_teeth && gear->carrier != YK_NONE) check_distance(loader, gear);
    }
}

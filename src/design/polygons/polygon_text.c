// Writes the steps of a polygon's construction in words.
#include <string.h>
#include "design/polygons/polygon.h"

static double size_of(const YkPolygonVector *v)
{
    return yk_norm(yk_vec(v->value[0], v->value[1]));
}

void yk_polygon_tell_direction(YkPolygonPart part, const char *body, YkText *text)
{
    static const char *const along[] = {
        [YK_POLYGON_TURNING] = "perpendicular to the line between these points of %s",
        [YK_POLYGON_NORMAL] = "along the line between these points of %s, towards the first",
        [YK_POLYGON_TANGENTIAL] = "perpendicular to the line between these points of %s",
        [YK_POLYGON_SLIDING] = "along the line on %s",
        [YK_POLYGON_CORIOLIS] = "perpendicular to the line on %s (Coriolis)",
    };
    yk_text_format(text, along[part], body);
}

// "From a to b: 0.25 m/s perpendicular to the line between these points of rod"
static void tell_vector(const YkPolygon *p, const YkPolygonVector *v, bool continues, YkText *text)
{
    yk_text_format(text, continues ? ", then " : " From %s to %s: ", v->from, v->to);
    yk_polygon_number(p->model, size_of(v), yk_polygon_quantity(p), text);
    yk_text_puts(text, " ");
    yk_polygon_tell_direction(v->part, p->model->bodies[v->body].name, text);
}

static void tell_bodies(const YkModel *model, const YkPolygonStep *step, YkText *text)
{
    for (size_t k = 0; k < step->count; k++)
        yk_text_format(text, "%s%s",
                       k == 0                ? ""
                       : k + 1 < step->count ? ", "
                                             : " and ",
                       model->bodies[step->body[k]].name);
}

void yk_polygon_tell_step(const YkPolygonPlan *plan, const YkPolygonStep *step, YkPolygonKind kind, YkText *text)
{
    tell_bodies(plan->mech->model, step, text);
    if (step->block >= 0)
        yk_text_format(text,
                       ", which meet at %s: the directions are known; closing the polygon gives the sizes, and from "
                       "them follow the %s",
                       plan->mech->blocks[step->block].label,
                       kind == YK_POLYGON_VELOCITY ? "rates" : "angular accelerations");
    else
        yk_text_puts(text, ", whose motion is given");
}

void yk_polygon_tell(YkPolygon *p, const YkPolygonPlan *plan, const YkPolygonStep *step, size_t first,
                     const double *rate)
{
    YkText text = {0};
    YkQuantity turning = p->kind == YK_POLYGON_VELOCITY ? YK_QUANTITY_ANGLE_RATE : YK_QUANTITY_ANGLE_ACCELERATION;
    yk_polygon_tell_step(plan, step, p->kind, &text);
    yk_text_puts(&text, step->block >= 0 ? " " : ": ");
    for (size_t k = 0; k < step->count; k++) {
        yk_text_puts(&text, k > 0 ? ", " : "");
        yk_polygon_number(p->model, rate[step->body[k]], turning, &text);
    }
    yk_text_puts(&text, ".");
    for (size_t k = first; k < p->vector_count; k++) {
        const YkPolygonVector *v = &p->vector[k], *before = k > first ? v - 1 : NULL;
        bool continues =
            before && strcmp(before->from, v->from) == 0 && strcmp(before->to, v->to) == 0 && before->body == v->body;
        if (continues && size_of(v) == 0) continue;
        if (k > first && !continues) yk_text_puts(&text, ".");
        tell_vector(p, v, continues, &text);
    }
    if (p->vector_count > first) yk_text_puts(&text, ".");
    p->step[p->step_count] = yk_arena_copy(p->arena, yk_text_get(&text), text.length);
    p->failed |= text.failed || !p->step[p->step_count];
    p->step_count++;
    yk_text_free(&text);
}

// Writes the force polygon of a body in words.
#include "design/polygons/force_polygon.h"
#include "design/polygons/polygon.h"

static double size_of(const YkForceVector *v)
{
    return yk_norm(yk_vec(v->value[0], v->value[1]));
}

// "weight, 9.81 N", "at A from crank, 12.5 N, with 0.2 N m"
static void tell_vector(const YkForcePolygons *p, const YkForceVector *v, YkText *text)
{
    if (v->by != YK_NOT_FOUND)
        yk_text_format(text, "at %s from %s, ", v->name, p->model->bodies[v->by].name);
    else
        yk_text_format(text, "%s, ", v->name);
    bool has_force = size_of(v) > 0;
    if (has_force) yk_polygon_number(p->model, size_of(v), YK_QUANTITY_FORCE, text);
    if (has_force && v->moment != 0) yk_text_puts(text, ", with ");
    if (v->moment != 0) yk_polygon_number(p->model, v->moment, YK_QUANTITY_TORQUE, text);
    if (!has_force && v->moment != 0) yk_text_puts(text, " alone");
    if (!v->is_determinate) yk_text_puts(text, ", which is one of many");
}

// Returns whether two forces alone act on the body, each at a place of its own, without moments.
static bool is_two_force(const YkForcePolygons *p, const YkForceVector *v, size_t count)
{
    if (count != 2) return false;
    double apart = yk_norm(yk_vec(v[0].at[0] - v[1].at[0], v[0].at[1] - v[1].at[1]));
    for (size_t k = 0; k < 2; k++)
        if (v[k].by == YK_NOT_FOUND || fabs(v[k].moment) > 1e-9 * apart * size_of(&v[k])) return false;
    return apart > 1e-9 * p->size;
}

static void tell_two(const YkForcePolygons *p, const YkForceVector *v, YkText *text)
{
    yk_text_puts(text, "two forces of ");
    yk_polygon_number(p->model, size_of(v), YK_QUANTITY_FORCE, text);
    yk_text_puts(text, " act, ");
    for (size_t k = 0; k < 2; k++)
        yk_text_format(text, "%sat %s from %s", k > 0 ? " and " : "", v[k].name, p->model->bodies[v[k].by].name);
    yk_text_puts(text, "; they are equal and opposite, along the line between these points.");
}

static void tell_all(const YkForcePolygons *p, const YkForceVector *v, size_t count, YkText *text)
{
    size_t known = 0;
    while (known < count && v[known].part <= YK_FORCE_INERTIA) known++;
    for (size_t k = 0; k < count; k++) {
        bool begins = k == known && k > 0;
        yk_text_puts(text, begins
                               ? count - known == 1 ? ". One force closes the polygon: " : ". These close the polygon: "
                           : k > 0 ? "; "
                                   : "");
        tell_vector(p, &v[k], text);
    }
    yk_text_puts(text, ".");
}

void yk_force_polygon_tell(YkForcePolygons *p, size_t first)
{
    YkText text = {0};
    const YkForceVector *v = &p->vector[first];
    size_t count = p->vector_count - first;
    yk_text_format(&text, "%s: ", p->model->bodies[v->body].name);
    if (is_two_force(p, v, count))
        tell_two(p, v, &text);
    else
        tell_all(p, v, count, &text);
    p->step[p->step_count] = yk_arena_copy(p->arena, yk_text_get(&text), text.length);
    p->failed |= text.failed || !p->step[p->step_count];
    p->step_count++;
    yk_text_free(&text);
}

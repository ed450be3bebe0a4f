// Section: positions, velocities and accelerations of centres of mass and of points that no joint holds.
#include "derive/forces/free_bodies.h"
#include "derive/sections.h"

// Marks the points that joints hold.
static bool *joint_points(YkDerivation *d)
{
    bool *marked = YK_NEW(d->arena, bool, d->model->point_count + 1);
    for (size_t j = 0; marked && j < d->model->joint_count; j++)
        for (int side = 0; side < 2; side++)
            if (d->model->joints[j].point[side] != YK_NONE) marked[d->model->joints[j].point[side]] = true;
    return marked;
}

static void put_motion(YkDerivation *d, YkPage *page, const char *name, const YkPoisson *position)
{
    static const char *const letters[] = {"p", "v", "a"};
    const YkPoisson *vector = yk_derive_shown(d, position);
    for (int order = 0; order < 3 && vector; order++) {
        YkLine *line = yk_page_formula(page, NULL);
        yk_line_vector(page, line, letters[order], name, NULL);
        yk_line_sign(page, line, "=");
        yk_line_column(page, line, vector, NULL);
        vector = yk_ring_time_derivative(d->ring, vector);
    }
}

static void put_center(YkDerivation *d, YkPage *page, int32_t body)
{
    const char *name = yk_derive_center_name(d, body);
    YkText title = {0};
    yk_text_format(&title, "%s, centre of mass of %s", name, d->model->bodies[body].name);
    yk_page_heading(page, 2, yk_text_get(&title));
    yk_text_free(&title);
    put_motion(d, page, name, yk_derive_position(d, body, yk_derive_center(d, body)));
}

bool yk_derive_section_points(YkDerivation *d, YkPage *page)
{
    const bool *is_held = joint_points(d);
    if (!is_held) return false;
    if (yk_derive_put_depth(d, page)) return true;
    yk_derive_put_angles(d, page);
    bool is_empty = true;
    for (size_t b = 1; b < d->model->body_count; b++)
        if (d->model->bodies[b].has_mass) {
            put_center(d, page, (int32_t)b);
            is_empty = false;
        }
    for (size_t p = 0; p < d->model->point_count; p++) {
        const YkPoint *point = &d->model->points[p];
        if (point->body == 0 || is_held[p]) continue;
        is_empty = false;
        const char *name = yk_derive_point_name(d, point->body, (int32_t)p);
        YkText title = {0};
        yk_text_format(&title, "%s of %s", name, d->model->bodies[point->body].name);
        yk_page_heading(page, 2, yk_text_get(&title));
        yk_text_free(&title);
        put_motion(d, page, name, yk_derive_position(d, point->body, yk_derive_at(d, (int32_t)p)));
    }
    if (is_empty) yk_page_words(page, "No body has mass, and all points are joints: name bodies' points in `points:`.");
    return true;
}

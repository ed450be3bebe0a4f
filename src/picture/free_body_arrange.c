// Arranges the arrows of free-body drawings: at which end of the arrow the point is, and which way a force of unknown
// direction points, so that arrows keep clear of each other and of the body.
#include <stdlib.h>
#include <string.h>
#include "picture/free_body_inside.h"

static const double clear = 13; // px between an arrow and anything else, if there is room

// --- Obstacles

// Adds the body's rods, along which others slide.
static size_t add_rods(const YkFreeBodyDrawings *p, int32_t body, YkVec (*lines)[2])
{
    const YkFrame *frames = yk_drawing_frames(p->drawing, 0);
    size_t count = 0;
    for (size_t j = 0; j < p->d->model->joint_count; j++) {
        const YkJoint *joint = &p->d->model->joints[j];
        if (joint->is_free || joint->body[0] != body || (joint->kind != YK_SLIDE && joint->kind != YK_PIN_SLOT))
            continue;
        for (int side = 0; side < 2; side++)
            lines[count][side] = yk_drawing_pixel(p->drawing, yk_drawing_joint(p->drawing, frames, joint, side));
        count++;
    }
    return count;
}

static size_t add_edges(const YkFreeBodyDrawings *p, int32_t body, YkVec (*lines)[2])
{
    const YkFrame *frame = &yk_drawing_frames(p->drawing, 0)[body];
    YkOutline outline = p->drawing->outlines[body];
    size_t count = outline.count < 3 ? outline.count / 2 : outline.count; // a dot has none, a bar one
    for (size_t i = 0; i < count; i++)
        for (size_t end = 0; end < 2; end++) {
            YkVec corner = p->drawing->corners[outline.first + (i + end) % outline.count];
            lines[i][end] = yk_drawing_pixel(p->drawing, yk_frame_apply(*frame, corner));
        }
    return count;
}

// Rims of wheels as polygons.
enum { RIM = 24 };

typedef struct Rims {
    const YkFreeBodyDrawings *p;
    YkVec (*lines)[2]; // NULL: only counted
    size_t count;
} Rims;

static void add_rim(void *context, YkVec center, double radius, bool is_base)
{
    Rims *rims = context;
    (void)is_base;
    for (int i = 0; i < RIM && rims->lines; i++)
        for (int end = 0; end < 2; end++) {
            YkVec at = yk_add(center, yk_scale(radius, yk_unit(2 * YK_PI * (i + end) / RIM)));
            rims->lines[rims->count + (size_t)i][end] = yk_drawing_pixel(rims->p->drawing, at);
        }
    rims->count += RIM;
}

static size_t add_rims(const YkFreeBodyDrawings *p, int32_t body, YkVec (*lines)[2])
{
    Rims rims = {p, lines, 0};
    yk_drawing_each_wheel(p->drawing, yk_drawing_frames(p->drawing, 0), body, add_rim, &rims);
    return rims.count;
}

size_t yk_free_body_line_count(const YkFreeBodyDrawings *p, const YkFreeBodyDrawing *picture)
{
    if (picture->body == YK_NONE) return picture->count;
    return picture->count + p->drawing->outlines[picture->body].count + p->d->model->joint_count +
           add_rims(p, picture->body, NULL);
}

size_t yk_free_body_lines(const YkFreeBodyDrawings *p, const YkFreeBodyDrawing *picture, YkVec (*lines)[2])
{
    size_t count = 0;
    for (size_t k = 0; k < picture->count; k++) {
        const YkArrow *arrow = &p->arrows[picture->first + k];
        if (arrow->turn != 0 || !arrow->is_laid) continue;
        lines[count][0] = arrow->from;
        lines[count++][1] = arrow->to;
    }
    if (picture->body == YK_NONE) return count;
    count += add_edges(p, picture->body, lines + count);
    count += add_rods(p, picture->body, lines + count);
    return count + add_rims(p, picture->body, lines + count);
}

static double distance_to(YkVec at, const YkVec line[2])
{
    YkVec d = yk_sub(line[1], line[0]), from = yk_sub(at, line[0]);
    double square = yk_dot(d, d), t = square > 0 ? fmin(fmax(yk_dot(from, d) / square, 0), 1) : 0;
    return yk_norm(yk_sub(from, yk_scale(t, d)));
}

typedef struct Place { // a candidate
    YkVec from, to;
    double price;
} Place;

// --- The price of a place: how near the arrow runs to obstacles, sampled from just off its point

static double price_of(YkVec (*lines)[2], size_t count, YkVec at, const Place *place)
{
    enum { SAMPLES = 8 };
    bool begins_at = yk_norm(yk_sub(place->from, at)) < yk_norm(yk_sub(place->to, at));
    YkVec near = begins_at ? place->from : place->to, far = begins_at ? place->to : place->from;
    double sum = 0;
    for (int i = 1; i <= SAMPLES; i++) {
        double t = 0.2 + 0.8 * i / SAMPLES;
        YkVec sample = yk_add(near, yk_scale(t, yk_sub(far, near)));
        for (size_t k = 0; k < count; k++) sum += fmax(0, clear - distance_to(sample, lines[k]));
        sum += fmax(0, 60 - sample.y) + fmax(0, sample.y - YK_FREE_BODY_HEIGHT + 60); // title and axes
    }
    return sum;
}

// Returns the better of leaving the point or arriving at it, on the line or a little beside it.
static Place best_place(const YkArrow *arrow, YkVec along, YkVec (*lines)[2], size_t count)
{
    static const double aside[] = {0, 14, -14};
    static const double gap = 8; // off the point
    Place best = {.price = INFINITY};
    for (size_t k = 0; k < 3; k++)
        for (int arrives = 0; arrives < 2 - arrow->leaves_point; arrives++) {
            YkVec foot = yk_add(arrow->at, yk_scale(aside[k], yk_quarter(along)));
            double start = arrives ? -gap - YK_ARROW_LENGTH : gap;
            Place place = {yk_add(foot, yk_scale(start, along)), yk_add(foot, yk_scale(start + YK_ARROW_LENGTH, along)),
                           0};
            place.price = price_of(lines, count, arrow->at, &place) + (k > 0 ? 20 : 0) + arrives;
            if (place.price < best.price - 1e-6) best = place;
        }
    return best;
}

// --- Arrows

static size_t lines_most(const YkFreeBodyDrawings *p) // of any picture
{
    size_t most = 0;
    for (size_t k = 0; k < p->count; k++) {
        size_t count = yk_free_body_line_count(p, &p->pictures[k]);
        if (count > most) most = count;
    }
    return most + 1;
}

static size_t lines_for(YkFreeBodyDrawings *p, const YkArrow *arrow, YkVec (*lines)[2])
{
    const YkFreeBodyDrawing *picture = &p->pictures[arrow->picture];
    yk_free_body_turn_to(p, picture);
    return yk_free_body_lines(p, picture, lines);
}

static void put(YkArrow *arrow, YkVec along, const Place *place)
{
    arrow->along = along;
    arrow->from = place->from;
    arrow->to = place->to;
    arrow->is_laid = true;
}

static YkVec direction(const YkArrow *arrow, double degrees)
{
    YkVec e = yk_conj(yk_unit(degrees * YK_PI / 180));
    return arrow->is_negative ? yk_scale(-1, e) : e;
}

// Chooses one direction for both bodies that the force acts on, opposite on the second.
static void arrange_free(YkFreeBodyDrawings *p, YkArrow *arrow, YkVec (*lines)[2], YkVec (*others)[2])
{
    static const double degrees[] = {45, 35, 55, 25, 65, 15, 75};
    YkArrow *partner = arrow->partner == YK_NONE ? NULL : &p->arrows[arrow->partner];
    size_t count = lines_for(p, arrow, lines), other_count = partner ? lines_for(p, partner, others) : 0;
    double least = INFINITY;
    for (size_t k = 0; k < (arrow->angle > 0 ? 1 : sizeof degrees / sizeof *degrees); k++) {
        double angle = arrow->angle > 0 ? arrow->angle : degrees[k];
        YkVec along = direction(arrow, angle);
        Place own = best_place(arrow, along, lines, count), other = {.price = 0};
        if (partner) other = best_place(partner, yk_scale(-1, along), others, other_count);
        double price = own.price + other.price + 2 * (double)k;
        if (price >= least - 1e-6) continue;
        least = price;
        put(arrow, along, &own);
        if (partner) put(partner, yk_scale(-1, along), &other);
    }
}

// Puts moments at one point round each other.
static void arrange_moment(const YkFreeBodyDrawings *p, YkArrow *arrow)
{
    const YkFreeBodyDrawing *picture = &p->pictures[arrow->picture];
    arrow->radius = 17;
    for (size_t k = 0; k < picture->count; k++) {
        const YkArrow *other = &p->arrows[picture->first + k];
        if (other != arrow && other->radius > 0 && yk_norm(yk_sub(other->at, arrow->at)) < 10)
            arrow->radius = fmax(arrow->radius, other->radius + 8);
    }
}

// --- The same force on two pictures

static bool is_same_force(const YkArrow *a, const YkArrow *b)
{
    return a->turn == 0 && b->turn == 0 && !a->is_inertia && !b->is_inertia && a->name.sub == b->name.sub &&
           a->is_negative != b->is_negative && strcmp(a->name.base, b->name.base) == 0;
}

static void pair(YkArrow *arrows, int32_t a, int32_t b)
{
    arrows[a].partner = b;
    arrows[b].partner = a;
    arrows[a].angle = arrows[b].angle = fmax(arrows[a].angle, arrows[b].angle); // a junction's
}

// Finds equal names in lists, last one first; these are short, whatever the machine's size.
static void find_partners(YkFreeBodyDrawings *p)
{
    YkNames names = {0};
    int32_t *before = calloc(p->arrow_count + 1, sizeof *before), *last = calloc(p->arrow_count + 1, sizeof *last);
    p->failed |= !before || !last;
    for (size_t a = 0; a < p->arrow_count && !p->failed; a++) {
        const char *name = p->arrows[a].name.sub ? p->arrows[a].name.sub : "";
        int32_t list;
        p->failed |= !yk_names_add(&names, name, (int32_t)a, &list);
        if (p->failed) break;
        before[a] = list == YK_NONE ? YK_NONE : last[list];
        last[list == YK_NONE ? (int32_t)a : list] = (int32_t)a;
        for (int32_t b = before[a]; b != YK_NONE && p->arrows[a].partner == YK_NONE; b = before[b])
            if (p->arrows[b].partner == YK_NONE && is_same_force(&p->arrows[a], &p->arrows[b]))
                pair(p->arrows, b, (int32_t)a);
    }
    yk_names_free(&names);
    free(before);
    free(last);
}

bool yk_free_body_arrange(YkFreeBodyDrawings *p)
{
    size_t most = lines_most(p);
    YkVec(*lines)[2] = calloc(2 * most, sizeof *lines);
    find_partners(p);
    if (!lines || p->failed) {
        free(lines);
        return false;
    }
    for (size_t k = 0; k < p->arrow_count; k++) { // first what has a direction
        YkArrow *arrow = &p->arrows[k];
        if (arrow->turn != 0) arrange_moment(p, arrow);
        if (arrow->turn != 0 || arrow->is_free) continue;
        size_t count = lines_for(p, arrow, lines);
        Place place = best_place(arrow, arrow->along, lines, count);
        put(arrow, arrow->along, &place);
    }
    for (int inertia = 0; inertia < 2; inertia++)
        for (size_t k = 0; k < p->arrow_count; k++) {
            YkArrow *arrow = &p->arrows[k];
            if (arrow->is_free && !arrow->is_laid && arrow->is_inertia == (inertia == 1))
                arrange_free(p, arrow, lines, lines + most);
        }
    free(lines);
    return true;
}

// Collects the action on every body and junction, as arrows with names, and the view of each picture.
#include "page/print.h"
#include "picture/free_body_inside.h"

static const char minus[] = "\xe2\x88\x92"; // the Unicode minus

// --- Places

// Returns a body's reference point, m.
static YkVec reference_of(const YkFreeBodyDrawings *p, int32_t body)
{
    const YkBody *of = &p->d->model->bodies[body]; // from the pose: far from the ground no formula is written out
    return yk_frame_apply(yk_drawing_frames(p->drawing, 0)[body], of->has_mass ? of->center : yk_vec(0, 0));
}

static YkVec place_of(const YkFreeBodyDrawings *p, const YkDerivePush *push)
{
    YkVec arm = push->arm ? yk_ring_value(p->d->ring, push->arm, p->values) : yk_vec(0, 0);
    return yk_add(reference_of(p, push->body), arm);
}

// Draws a load's couple at its joint, as couples have no place of their own.
static YkVec couple_place(const YkFreeBodyDrawings *p, const YkDeriveLoad *load, const YkDerivePush *push)
{
    if (load->joint == YK_NONE) return place_of(p, push);
    const YkJoint *joint = &p->d->model->joints[load->joint];
    const YkFrame *frames = yk_drawing_frames(p->drawing, 0);
    return yk_drawing_joint(p->drawing, frames, joint, joint->body[1] == push->body);
}

static void name_spot(YkFreeBodyDrawings *p, size_t picture, const char *name, YkVec at, bool is_center)
{
    YkFreeBodyDrawing *of = &p->pictures[picture];
    int32_t known;
    p->failed |= !yk_names_add(&p->spot_names, name, (int32_t)of->spot_count, &known);
    if (known == YK_NONE && !p->failed) of->spots[of->spot_count++] = (YkSpotName){name, at, is_center};
}

// --- Arrows

static YkArrow *add_arrow(YkFreeBodyDrawings *p, size_t picture, YkSvgName name, YkVec at)
{
    if (!YK_ROOM(p->arrows, p->arrow_count, p->arrow_capacity)) {
        p->failed = true;
        return NULL;
    }
    YkArrow *arrow = &p->arrows[p->arrow_count++];
    *arrow = (YkArrow){.name = name, .picture = picture, .at = at, .partner = YK_NONE};
    arrow->is_negative = name.sign != NULL;
    p->pictures[picture].count++;
    return arrow;
}

// Returns the direction of a vector on the page; `otherwise` for a zero vector.
static YkVec direction_of(const YkFreeBodyDrawings *p, const YkPoisson *vector, YkVec otherwise)
{
    YkVec v = yk_conj(yk_ring_value(p->d->ring, vector, p->values));
    double length = yk_norm(v);
    return length > 0 && isfinite(length) ? yk_scale(1 / length, v) : otherwise;
}

// Two unknowns: a force of any direction.
static bool is_any_direction(const YkFreeBodyDrawings *p, const YkPoisson *force)
{
    const YkRing *ring = p->d->ring;
    size_t unknowns = 0;
    for (int32_t s = yk_ring_next_symbol(ring, force, -1); s >= 0; s = yk_ring_next_symbol(ring, force, s))
        unknowns += p->is_reaction[s];
    return unknowns >= 2;
}

static const char *contact_words(const YkFreeBodyDrawings *p, const YkDeriveContact *contact)
{
    const char *by = yk_derive_text(p->d, "by ", yk_derive_giver(p->forces, contact), " at ");
    return yk_derive_text(p->d, by, yk_derive_contact_point(p->d, contact), "");
}

static void add_contact(YkFreeBodyDrawings *p, size_t picture, const YkDeriveContact *contact)
{
    YkSvgName name = {.sign = contact->is_negative ? minus : NULL, .base = contact->letter, .sub = contact->between};
    YkVec at = place_of(p, &contact->push), right = yk_vec(contact->is_negative ? -1 : 1, 0);
    name_spot(p, picture, yk_derive_contact_point(p->d, contact), at, false);
    YkArrow *arrow = contact->letter ? add_arrow(p, picture, name, at) : NULL;
    if (arrow) {
        arrow->words = contact_words(p, contact);
        arrow->along = direction_of(p, contact->push.force, right);
        arrow->is_free = is_any_direction(p, contact->push.force);
    }
    if (!contact->moment) return;
    name.base = contact->moment;
    arrow = add_arrow(p, picture, name, at);
    if (!arrow) return;
    arrow->words = contact_words(p, contact);
    arrow->turn = contact->is_negative ? -1 : 1;
}

static void add_load(YkFreeBodyDrawings *p, size_t picture, const YkDeriveLoad *load, size_t k)
{
    const YkDerivePush *push = &load->push[k];
    YkSvgName name = {.sign = k == 1 ? minus : NULL, .base = yk_derive_load_letter(load->kind), .sub = load->name};
    const char *words = yk_derive_load_word(load->kind);
    if (!yk_ring_is_zero(push->force)) {
        const char *point = yk_derive_load_point(p->forces, load, k);
        YkVec at = place_of(p, push);
        YkArrow *arrow = add_arrow(p, picture, name, at);
        if (load->kind != YK_DERIVE_GRAVITY) name_spot(p, picture, point, at, false);
        if (arrow) {
            arrow->words = yk_derive_text(p->d, words, " at ", point);
            arrow->along = direction_of(p, push->force, yk_vec(k == 1 ? -1 : 1, 0));
            arrow->leaves_point = load->kind == YK_DERIVE_GRAVITY;
        }
    }
    if (yk_ring_is_zero(push->moment)) return;
    name.base = "M", name.sub = yk_derive_couple_name(p->forces, load);
    YkArrow *arrow = add_arrow(p, picture, name, couple_place(p, load, push));
    if (!arrow) return;
    arrow->words = words;
    arrow->turn = k == 1 ? -1 : 1;
}

// Writes l^2 as it is printed: powers of a factor are squares and cubes.
static void raise_powers(const char *from, YkText *to)
{
    for (const char *c = from; *c; c++) {
        bool is_power = c[0] == '^' && (c[1] == '2' || c[1] == '3') && !(c[2] >= '0' && c[2] <= '9');
        if (is_power)
            yk_text_puts(to, *++c == '2' ? "\xc2\xb2" : "\xc2\xb3");
        else
            yk_text_add(to, c, 1);
    }
}

// Returns a factor before a name: in brackets if it is a sum, with a blank after it.
static const char *factor_text(YkFreeBodyDrawings *p, const YkPoisson *factor)
{
    YkText text = {0}, raised = {0};
    const char *copy = "";
    if (yk_ring_write(p->d->ring, factor, YK_RING_BOOK, YK_RING_TEXTBOOK, &text)) {
        bool is_sum = yk_print_has_sum(yk_text_get(&text));
        raise_powers(yk_text_get(&text), &raised);
        copy = yk_derive_text(p->d, is_sum ? "(" : "", yk_text_get(&raised), is_sum ? ") " : " ");
    }
    p->failed |= text.failed || raised.failed;
    yk_text_free(&text);
    yk_text_free(&raised);
    return copy;
}

static void add_inertia(YkFreeBodyDrawings *p, size_t picture, int32_t body)
{
    const YkDeriveMass *m = &p->forces->bodies[body];
    YkVec at = reference_of(p, body);
    const char *center = yk_derive_center_name(p->d, body);
    if (p->d->model->bodies[body].has_mass) name_spot(p, picture, center, at, true);
    if (!yk_ring_is_zero(m->mass)) {
        YkArrow *arrow = add_arrow(p, picture, (YkSvgName){minus, factor_text(p, m->mass), "a", center, NULL}, at);
        if (arrow) {
            arrow->words = "inertia";
            arrow->is_inertia = arrow->is_free = true;
        }
    }
    const YkPoisson *couple = yk_ring_multiply(p->d->ring, m->inertia, p->d->bodies[body].spin_rate);
    if (!couple || yk_ring_is_zero(couple)) return;
    YkSvgName name = {minus, factor_text(p, m->inertia), "\xce\xb1", NULL, p->d->bodies[body].name}; // alpha
    YkArrow *arrow = add_arrow(p, picture, name, at);
    if (!arrow) return;
    arrow->words = "inertia";
    arrow->is_inertia = true;
    arrow->turn = -1;
}

// --- Pictures

typedef struct Extent {
    YkVec low, high;
} Extent;

static void include(Extent *extent, YkVec at)
{
    extent->low = yk_vec(fmin(extent->low.x, at.x), fmin(extent->low.y, at.y));
    extent->high = yk_vec(fmax(extent->high.x, at.x), fmax(extent->high.y, at.y));
}

static void include_body(const YkFreeBodyDrawings *p, int32_t body, Extent *extent)
{
    const YkFrame *frame = &yk_drawing_frames(p->drawing, 0)[body];
    YkOutline outline = p->drawing->outlines[body];
    double reach = 0;
    for (size_t k = 0; k < outline.count; k++)
        include(extent, yk_frame_apply(*frame, p->drawing->corners[outline.first + k]));
    yk_drawing_wheel_reach(p->drawing, body, &reach);
    for (int corner = 0; corner < 4 && reach > 0; corner++)
        include(extent, yk_add(frame->origin, yk_vec(corner & 1 ? reach : -reach, corner & 2 ? reach : -reach)));
}

// Centres the page on the body and all places at which something acts.
static void look_at(YkFreeBodyDrawings *p, YkFreeBodyDrawing *picture)
{
    static const double across = 230, up = 170; // px
    Extent e = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};
    if (picture->body != YK_NONE) include_body(p, picture->body, &e);
    for (size_t k = 0; k < picture->count; k++) include(&e, p->arrows[picture->first + k].at);
    for (size_t k = 0; k < picture->spot_count; k++) include(&e, picture->spots[k].at);
    if (!(e.low.x <= e.high.x)) e.low = e.high = yk_vec(0, 0);
    YkVec size = yk_sub(e.high, e.low);
    picture->middle = yk_scale(0.5, yk_add(e.low, e.high));
    picture->scale = fmin(across / size.x, up / size.y);
    if (!(fmax(size.x, size.y) > 1e-9 * p->extent)) picture->scale = 1; // a body in one point
    yk_free_body_turn_to(p, picture);
    for (size_t k = 0; k < picture->count; k++) {
        YkArrow *arrow = &p->arrows[picture->first + k];
        arrow->at = yk_drawing_pixel(p->drawing, arrow->at);
        if (!isfinite(arrow->at.x) || !isfinite(arrow->at.y)) p->failed = p->is_infinite = true;
    }
    for (size_t k = 0; k < picture->spot_count; k++)
        picture->spots[k].at = yk_drawing_pixel(p->drawing, picture->spots[k].at);
}

static const char *number_text(YkFreeBodyDrawings *p, const char *before, int32_t number, const char *after)
{
    YkText text = {0};
    yk_text_format(&text, "%s%d%s", before, (int)number, after);
    const char *copy = yk_derive_text(p->d, yk_text_get(&text), "", "");
    p->failed |= text.failed;
    yk_text_free(&text);
    return copy;
}

static bool begin_picture(YkFreeBodyDrawings *p, size_t picture, size_t spots)
{
    YkFreeBodyDrawing *of = &p->pictures[picture];
    of->first = p->arrow_count;
    yk_names_free(&p->spot_names);
    p->spot_names = (YkNames){0};
    of->spots = YK_NEW(p->arena, YkSpotName, spots + 2);
    return of->spots != NULL;
}

static bool gather_body(YkFreeBodyDrawings *p, size_t picture)
{
    const YkDeriveForces *f = p->forces;
    int32_t body = p->pictures[picture].body;
    const char *name = p->d->model->bodies[body].name;
    p->pictures[picture].title = number_text(p, yk_derive_text(p->d, name, ", body ", ""), body, "");
    p->pictures[picture].stem = number_text(p, "", body, yk_derive_text(p->d, "-", name, ""));
    size_t contacts, pushes;
    const int32_t *contact = yk_derive_contacts_on(f, body, &contacts), *push = yk_derive_pushes_on(f, body, &pushes);
    if (!begin_picture(p, picture, contacts + pushes)) return false;
    for (size_t k = 0; k < contacts; k++) add_contact(p, picture, &f->contacts[contact[k]]);
    for (size_t k = 0; k < pushes; k++) add_load(p, picture, &f->loads[push[k] / 2], (size_t)push[k] % 2);
    add_inertia(p, picture, body);
    look_at(p, &p->pictures[picture]);
    return !p->failed;
}

// The pin itself: the bodies' forces on it are opposite. The arrows share a quarter turn.
static bool gather_junction(YkFreeBodyDrawings *p, size_t picture)
{
    const YkDeriveForces *f = p->forces;
    int32_t junction = p->pictures[picture].junction;
    size_t count = 0, index = 0;
    p->pictures[picture].title = yk_derive_text(p->d, "Junction ", f->junctions[junction].name, ", a pin without mass");
    p->pictures[picture].stem = yk_derive_text(p->d, "junction-", f->junctions[junction].name, "");
    if (!begin_picture(p, picture, 1)) return false;
    const int32_t first = f->junctions[junction].first_contact;
    for (int32_t k = first; k != YK_NONE; k = f->contacts[k].next) count++;
    for (int32_t k = first; k != YK_NONE; k = f->contacts[k].next) {
        const YkDeriveContact *contact = &f->contacts[k];
        YkSvgName name = {.sign = minus, .base = contact->letter, .sub = contact->between};
        YkVec at = place_of(p, &contact->push);
        name_spot(p, picture, f->junctions[junction].name, at, false);
        YkArrow *arrow = add_arrow(p, picture, name, at);
        if (!arrow) continue;
        arrow->words = yk_derive_text(p->d, "by ", p->d->model->bodies[contact->push.body].name, "");
        arrow->is_free = arrow->leaves_point = true;
        arrow->angle = 90 * ((double)index++ + 0.5) / (double)count;
    }
    look_at(p, &p->pictures[picture]);
    return !p->failed;
}

// --- All of them

bool yk_free_body_gather(YkFreeBodyDrawings *p)
{
    p->is_reaction = YK_NEW(p->arena, bool, yk_ring_symbol_count(p->d->ring) + 1);
    for (size_t k = 0; k < p->forces->reaction_count && p->is_reaction; k++)
        p->is_reaction[p->forces->reactions[k]] = true;
    p->extent = yk_drawing_extent(p->drawing);
    for (size_t k = 0; k < p->count && p->is_reaction; k++) {
        bool good = p->pictures[k].body != YK_NONE ? gather_body(p, k) : gather_junction(p, k);
        if (!good) return false;
    }
    return p->is_reaction && !p->failed && yk_derivation_is_well(p->d);
}

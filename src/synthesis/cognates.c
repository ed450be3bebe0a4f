// Cognates: other machines with the same coupler curve.
//
// In complex numbers the coupler point is P = A + l (B - A) with a constant l. The links of a cognate are those of the
// machine, stretched and turned by l: its input A0 A1 = P - A turns with the coupler, its coupler from A1 to
// C1 = A1 + l (A - A0) with the input, and P = A1 + (A - A0) belongs to it. C1 moves about A0 + l (B0 - A0), or on a
// line turned by l for a slider-crank. The other cognate begins at B0, with 1 - l. Source: Roberts 1875.
#include "synthesis/cognates.h"
#include <math.h>
#include <stdlib.h>
#include "synthesis/linkage.h"

// The machine as a design: P in the coupler's axes, angles of the present pose.
static YkDesign own_design(const YkLinkage *ring, YkVec P)
{
    YkVec across = yk_sub(ring->B, ring->A), input = yk_sub(ring->A, ring->A0), output = yk_sub(ring->B, ring->B0);
    YkDesign d = {.kind = ring->is_slider ? YK_DESIGN_SLIDER_CRANK : YK_DESIGN_FOUR_BAR, .has_point = true};
    d.dyad[0] = d.dyad[1] = -1;
    d.pivot[0] = ring->A0;
    d.pivot[1] = ring->B0;
    d.length[1] = yk_norm(input);
    d.length[2] = yk_norm(across);
    d.point = yk_scale(d.length[2], yk_divide(yk_sub(P, ring->A), across));
    d.angle[0] = yk_argument(input);
    d.angle[1] = yk_argument(across);
    if (ring->is_slider) {
        d.along = yk_argument(ring->along);
        d.angle[2] = yk_dot(output, ring->along);
        return d;
    }
    d.length[0] = yk_norm(yk_sub(ring->B0, ring->A0));
    d.length[3] = yk_norm(output);
    d.angle[2] = yk_argument(output);
    return d;
}

// The cognate on the side of A0 of a machine and its coupler point.
static YkDesign cognate_of(const YkLinkage *ring, YkVec P)
{
    YkVec l = yk_divide(yk_sub(P, ring->A), yk_sub(ring->B, ring->A));
    YkLinkage other = {.A0 = ring->A0, .is_slider = ring->is_slider};
    other.A = yk_add(ring->A0, yk_sub(P, ring->A));
    other.B = yk_add(other.A, yk_mul(l, yk_sub(ring->A, ring->A0)));
    other.B0 = yk_add(ring->A0, yk_mul(l, yk_sub(ring->B0, ring->A0)));
    if (ring->is_slider) other.along = yk_scale(1 / yk_norm(l), yk_mul(l, ring->along));
    return own_design(&other, P);
}

static bool write_model(YkCognates *c, YkCognate *cognate, size_t index)
{
    static const char *const places[] = {"first", "second"};
    YkText name = {0}, origin = {0};
    yk_text_format(&name, "%s, %s cognate", yk_model_name(c->model), places[index]);
    yk_text_puts(&origin, "Has the coupler curve of another machine (Roberts' theorem), by `yoke cognates`.");
    YkJourney journey = {.sheet = c->model, .name = yk_text_get(&name), .origin = yk_text_get(&origin)};
    yk_design_write(&cognate->design, &journey, &cognate->model);
    bool good = !name.failed && !origin.failed && !cognate->model.failed;
    yk_text_free(&name);
    yk_text_free(&origin);
    return good;
}

// --- measured by the engine

typedef struct Follower {
    YkModel *model;
    YkMechanism *mech;
    YkState *state;
    size_t point;
    double offset; // of its input's angle to the machine's coupler, rad
} Follower;

static bool load_follower(const YkCognate *cognate, Follower *f)
{
    f->model = yk_model_parse(yk_text_get(&cognate->model), cognate->model.length, "cognate", NULL, NULL);
    f->mech = f->model ? yk_mechanism_compile(f->model, NULL, NULL) : NULL;
    f->state = f->mech ? yk_state_new(f->mech) : NULL;
    if (!f->state) return false;
    f->point = yk_model_find_point(f->model, "coupler.P");
    yk_state_set_time(f->state, 0, NULL);
    return yk_state_assemble(f->state) >= 0;
}

static void free_follower(Follower *f)
{
    yk_state_free(f->state);
    yk_mechanism_free(f->mech);
    yk_model_free(f->model);
}

// Returns how far the nearest of the cognate's two configurations is from P when its input stands at an angle.
static double distance(Follower *f, double angle, YkVec P)
{
    double nearest = INFINITY;
    yk_state_set_input_to(f->state, 0, angle, 0, 0);
    for (int branch = -1; branch <= 1; branch += 2) {
        for (size_t b = 0; b < yk_block_count(f->mech); b++)
            if (yk_state_branch(f->state, b) != 0) yk_state_set_branch(f->state, b, branch);
        if (yk_state_solve(f->state) < 0) continue;
        YkPointMotion p = yk_state_point(f->state, f->point);
        nearest = fmin(nearest, yk_norm(yk_sub(yk_vec(p.position[0], p.position[1]), P)));
    }
    return nearest;
}

typedef struct Comparison {
    YkCognates *cognates;
    Follower follower[YK_COGNATES_MAX];
    int32_t coupler;
    double coupler_angle; // at the start, rad
} Comparison;

static void compare_pose(void *context, const YkState *state)
{
    Comparison *c = context;
    YkCognates *cognates = c->cognates;
    YkPointMotion p = yk_state_point(state, cognates->point);
    YkVec P = yk_vec(p.position[0], p.position[1]);
    double turned = yk_state_body(state, (size_t)c->coupler).position - c->coupler_angle;
    if (cognates->rows < YK_CURVE_ROWS) {
        cognates->curve[2 * cognates->rows] = P.x;
        cognates->curve[2 * cognates->rows++ + 1] = P.y;
    }
    for (size_t k = 0; k < cognates->count; k++)
        cognates->item[k].apart =
            fmax(cognates->item[k].apart, distance(&c->follower[k], cognates->item[k].design.angle[0] + turned, P));
}

// Moves the machine through its range, and every cognate beside it.
static bool compare(YkCognates *cognates, const YkState *state, const YkLinkage *ring)
{
    Comparison c = {.cognates = cognates, .coupler = ring->coupler};
    YkSweepOptions options = yk_default_sweep_options();
    YkRange ranges[16];
    YkState *moving = yk_state_new(state->mech);
    bool good = moving && yk_state_copy(moving, state) == YK_OK;
    for (size_t k = 0; k < cognates->count && good; k++) good = load_follower(&cognates->item[k], &c.follower[k]);
    c.coupler_angle = yk_state_body(state, (size_t)ring->coupler).position;
    if (good && yk_input_count(state->mech) == 1) {
        size_t coordinate = yk_input_coordinate(state->mech, 0);
        double now = yk_state_input(state, 0).position, inset = 1e-6;
        size_t count = yk_closing_ranges(moving, coordinate, ranges, 16);
        good = count != YK_NOT_FOUND;
        for (size_t k = 0; k < count && k < 16 && good; k++) {
            if (now < ranges[k].from || now > ranges[k].to) continue;
            bool is_turn = ranges[k].to - ranges[k].from > 2 * YK_PI - 1e-9;
            options.coordinate = (int)coordinate;
            options.from = ranges[k].from + (is_turn ? 0 : inset);
            options.to = ranges[k].to - (is_turn ? 0 : inset);
            options.steps = YK_CURVE_ROWS - 1;
            options.visit = compare_pose;
            options.context = &c;
            YkSweep *sweep = yk_sweep_run(moving, &options, NULL, 0, NULL);
            good = sweep != NULL;
            yk_sweep_free(sweep);
            break;
        }
    } else if (good) {
        compare_pose(&c, state);
    }
    for (size_t k = 0; k < cognates->count; k++) free_follower(&c.follower[k]);
    yk_state_free(moving);
    return good;
}

// --- the door

static bool fill(YkCognates *c, const YkState *state, const YkLinkage *ring)
{
    const YkPoint *point = &c->model->points[c->point];
    YkVec P = yk_linkage_place(state, point->body, point->at);
    YkLinkage mirrored = *ring;
    c->own = own_design(ring, P);
    c->item[0].design = cognate_of(ring, P);
    c->count = ring->is_slider ? 1 : 2;
    if (!ring->is_slider) { // the same from the other end
        mirrored.A0 = ring->B0;
        mirrored.A = ring->B;
        mirrored.B = ring->A;
        mirrored.B0 = ring->A0;
        c->item[1].design = cognate_of(&mirrored, P);
    }
    for (size_t k = 0; k < c->count; k++)
        if (!write_model(c, &c->item[k], k)) return false;
    return compare(c, state, ring);
}

YkCognates *yk_cognates_new(const YkState *state, size_t point, YkProblems *problems)
{
    YkLinkage ring;
    if (!state || !yk_state_has_pose(state)) return NULL;
    bool ran_out;
    size_t found = yk_linkage_find(state, point, &ring, &ran_out);
    if (found == YK_NOT_FOUND && !ran_out) {
        yk_problem(problems, YK_CODE_NO_COGNATES, (YkPlace){0},
                   point == YK_NOT_FOUND
                       ? "the machine has no four-bar or slider-crank on the ground whose coupler has a point "
                         "besides its joints"
                       : "this point is not one of a four-bar's or slider-crank's coupler, away from its joints");
        yk_problem_hint(problems,
                        "give the coupler a point, as in `coupler: {points: {A: [0, 0], B: [b, 0], P: [px, py]}}`");
        return NULL;
    }
    YkCognates *c = ran_out ? NULL : calloc(1, sizeof *c);
    if (c) {
        c->model = state->mech->model;
        c->point = found;
    }
    if (c && fill(c, state, &ring)) return c;
    yk_cognates_free(c);
    yk_problem(problems, YK_CODE_OUT_OF_MEMORY, (YkPlace){0}, "out of memory while finding cognates");
    return NULL;
}

void yk_cognates_free(YkCognates *c)
{
    if (!c) return;
    for (size_t k = 0; k < YK_COGNATES_MAX; k++) yk_text_free(&c->item[k].model);
    yk_text_free(&c->picture);
    free(c);
}

size_t yk_cognates_count(const YkCognates *c)
{
    return c ? c->count : 0;
}

size_t yk_cognates_point(const YkCognates *c)
{
    return c ? c->point : YK_NOT_FOUND;
}

YkCandidate yk_cognates_at(const YkCognates *c, size_t index)
{
    static const char *const files[] = {"first-cognate.yaml", "second-cognate.yaml"};
    if (!c || (index != YK_NOT_FOUND && index >= c->count)) return (YkCandidate){.file = NULL};
    if (index == YK_NOT_FOUND) return yk_found_candidate(&(YkFound){.design = c->own});
    const YkCognate *item = &c->item[index];
    YkFound found = {.design = item->design, .file = files[index], .worst = item->apart};
    found.model = yk_text_get(&item->model);
    return yk_found_candidate(&found);
}

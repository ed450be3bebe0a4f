// Finds a four-bar or a slider-crank with a coupler point.
#include "synthesis/linkage.h"
#include "loads/loads.h"

enum { RINGS_MAX = 64 };

YkVec yk_linkage_place(const YkState *state, int32_t body, YkVec at)
{
    YkBodyMotion m = yk_body_motion(state->mech, &state->space, (size_t)body);
    YkVec arm = yk_sub(at, yk_reference_point(state->mech->model, (size_t)body));
    return yk_add(m.at, yk_mul(m.e, arm));
}

static YkVec joint_place(const YkState *state, size_t joint)
{
    const YkJoint *j = &state->mech->model->joints[joint];
    return yk_linkage_place(state, j->body[0], j->at[0]);
}

// Returns a point of the body that is not at any of three places, `wished` if it is one; YK_NOT_FOUND if there is none.
static size_t free_point(const YkState *state, int32_t body, size_t wished, const YkLinkage *ring)
{
    const YkModel *model = state->mech->model;
    double near_to = 1e-9 * state->mech->size;
    for (size_t p = 0; p < model->point_count; p++) {
        if (model->points[p].body != body || (wished != YK_NOT_FOUND && wished != p)) continue;
        YkVec at = yk_linkage_place(state, body, model->points[p].at);
        if (yk_norm(yk_sub(at, ring->A)) > near_to && yk_norm(yk_sub(at, ring->B)) > near_to) return p;
    }
    return YK_NOT_FOUND;
}

static size_t find_four_bar(const YkState *state, size_t point, YkLinkage *ring, bool *ran_out)
{
    YkFourBar all[RINGS_MAX];
    size_t count = yk_four_bars(state->mech, all, RINGS_MAX);
    *ran_out = count == YK_NOT_FOUND;
    for (size_t k = 0; k < count && k < RINGS_MAX && !*ran_out; k++) {
        if (all[k].body[0] != 0) continue;
        *ring = (YkLinkage){.input = (int32_t)all[k].body[1], .coupler = (int32_t)all[k].body[2]};
        ring->output = (int32_t)all[k].body[3];
        ring->A0 = joint_place(state, all[k].joint[0]);
        ring->A = joint_place(state, all[k].joint[1]);
        ring->B = joint_place(state, all[k].joint[2]);
        ring->B0 = joint_place(state, all[k].joint[3]);
        size_t found = free_point(state, ring->coupler, point, ring);
        if (found != YK_NOT_FOUND) return found;
    }
    return YK_NOT_FOUND;
}

// Looks whether a joint guides the end of the coupler along a line of the ground: a slide of a block, or a slot.
static bool is_guide(const YkState *state, const YkJoint *j, int32_t coupler, YkLinkage *ring)
{
    const YkModel *model = state->mech->model;
    if (j->body[0] != 0 || (j->kind != YK_SLIDE && j->kind != YK_PIN_SLOT) || j->is_free) return false;
    ring->along = j->along;
    ring->B0 = yk_linkage_place(state, 0, j->at[0]);
    if (j->kind == YK_PIN_SLOT) {
        ring->output = YK_NONE;
        ring->B = yk_linkage_place(state, coupler, j->at[1]);
        return j->body[1] == coupler;
    }
    ring->output = j->body[1];
    for (size_t k = 0; k < model->joint_count; k++) {
        const YkJoint *pin = &model->joints[k];
        if (pin->kind != YK_PIN || yk_joint_other_body(pin, coupler) != j->body[1]) continue;
        ring->B = joint_place(state, k);
        ring->B0 = ring->B; // the line on which it moves
        return true;
    }
    return false;
}

static size_t find_slider_crank(const YkState *state, size_t point, YkLinkage *ring)
{
    const YkModel *model = state->mech->model;
    for (size_t a = 0; a < model->joint_count; a++) {
        int32_t input = yk_joint_other_body(&model->joints[a], 0);
        if (model->joints[a].kind != YK_PIN || input == YK_NONE) continue;
        for (size_t b = 0; b < model->joint_count; b++) {
            int32_t coupler = yk_joint_other_body(&model->joints[b], input);
            if (b == a || model->joints[b].kind != YK_PIN || coupler == YK_NONE || coupler == 0) continue;
            *ring = (YkLinkage){.input = input, .coupler = coupler, .is_slider = true};
            ring->A0 = joint_place(state, a);
            ring->A = joint_place(state, b);
            for (size_t c = 0; c < model->joint_count; c++) {
                if (!is_guide(state, &model->joints[c], coupler, ring)) continue;
                size_t found = free_point(state, coupler, point, ring);
                if (found != YK_NOT_FOUND) return found;
            }
        }
    }
    return YK_NOT_FOUND;
}

size_t yk_linkage_find(const YkState *state, size_t point, YkLinkage *ring, bool *ran_out)
{
    size_t found = find_four_bar(state, point, ring, ran_out);
    return found != YK_NOT_FOUND || *ran_out ? found : find_slider_crank(state, point, ring);
}

// Reads `cams:`, a cam on a shaft and the follower that it drives by a law.
#include <string.h>
#include "model/load.h"

static void read_length(YkLoader *loader, const YkNode *map, const char *key, const char *owner, YkExpr **expr,
                        double *target)
{
    YkWant want = {.dimension = YK_DIM_LENGTH, .subject = {.noun = key, .owner = owner}};
    *expr = yk_load_key_value(loader, map, key, &want, target);
}

static bool read_switch(YkLoader *loader, const YkNode *map, const char *key, const char *owner)
{
    const YkNode *node = yk_node_get(map, key);
    if (!node || !yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = key, .owner = owner})) return false;
    bool is_true = strcmp(node->text, "true") == 0;
    if (!is_true && strcmp(node->text, "false") != 0) {
        yk_problem(loader->problems, YK_CODE_WRONG_WORD, node->place, "`%s` of %q is `true` or `false`, not %q", key,
                   owner, node->text);
    }
    return is_true;
}

// Reads the face: a roller makes it round; without one it is a knife edge.
static void read_face(YkLoader *loader, YkCam *cam, const YkNode *map)
{
    static const char *const words[] = {"knife", "roller", "flat", NULL};
    const YkNode *node = yk_node_get(map, "face");
    cam->face = yk_node_get(map, "roller") ? YK_CAM_FACE_ROLLER : YK_CAM_FACE_KNIFE;
    if (!node || !yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "face", .owner = cam->name}))
        return;
    for (int i = 0; words[i]; i++) {
        if (strcmp(node->text, words[i]) != 0) continue;
        if (i != YK_CAM_FACE_ROLLER && cam->face == YK_CAM_FACE_ROLLER) {
            yk_problem(loader->problems, YK_CODE_CAM_KEY, yk_load_key(map, "roller")->place,
                       "cam %q: a %s face has no roller", cam->name, words[i]);
        } else if (i == YK_CAM_FACE_ROLLER && cam->face != YK_CAM_FACE_ROLLER) {
            yk_problem(loader->problems, YK_CODE_MISSING_KEY, node->place,
                       "cam %q: a roller needs its radius, `roller`", cam->name);
        }
        cam->face = (YkCamFace)i;
        return;
    }
    yk_problem(loader->problems, YK_CODE_WRONG_WORD, node->place, "a follower's face is flat, roller or knife, not %q",
               node->text);
    yk_load_hint_nearest_key(loader, node->text, words);
}

// Finds the joints of cam and follower on one body: the pin and the pin or slide. Returns the number of ways.
static size_t find_joints(const YkModel *model, YkCam *cam, int32_t wanted)
{
    size_t count = 0;
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *pin = &model->joints[i];
        int32_t carrier = pin->kind == YK_PIN ? yk_joint_other_body(pin, cam->cam) : YK_NONE;
        if (carrier == YK_NONE || carrier == cam->follower || (wanted != YK_NONE && carrier != wanted)) continue;
        for (size_t k = 0; k < model->joint_count; k++) {
            const YkJoint *guide = &model->joints[k];
            if (guide->kind != YK_PIN && guide->kind != YK_SLIDE) continue;
            if (yk_joint_other_body(guide, cam->follower) != carrier) continue;
            if (count++ > 0) continue;
            cam->carrier = carrier;
            cam->cam_joint = (int32_t)i;
            cam->follower_joint = (int32_t)k;
            cam->oscillates = guide->kind == YK_PIN;
        }
    }
    return count;
}

static void read_carrier(YkLoader *loader, YkCam *cam, const YkNode *map)
{
    const YkNode *node = yk_node_get(map, "carrier");
    const YkModel *model = loader->model;
    int32_t wanted = node ? yk_load_body(loader, node) : YK_NONE;
    if (loader->has_bad_joint || cam->cam < 0 || cam->follower < 0 || (node && wanted == YK_NONE)) return;
    YkPlace place = node ? node->place : cam->place;
    size_t count = cam->cam == cam->follower ? 0 : find_joints(model, cam, wanted);
    if (count == 1) return;
    cam->carrier = YK_NONE;
    if (count == 0) {
        yk_problem(loader->problems, YK_CODE_CAM_CARRIER, place,
                   "cam %q: no body holds both %q by a pin and %q by a pin or slide", cam->name,
                   model->bodies[cam->cam].name, model->bodies[cam->follower].name);
        yk_problem_hint(loader->problems, "pin the cam's shaft to the ground, and guide the follower there");
    } else {
        yk_problem(loader->problems, YK_CODE_CAM_CARRIER, place,
                   "cam %q: %q and %q are joined by more than one body or joint", cam->name,
                   model->bodies[cam->cam].name, model->bodies[cam->follower].name);
        yk_problem_hint(loader->problems, "name the body that holds both: `carrier: ground`");
    }
}

static const char *not_for(const YkCam *cam, const char *key)
{
    bool is_arm = strcmp(key, "arm") == 0 || strcmp(key, "at") == 0;
    if (!cam->oscillates && (is_arm || strcmp(key, "centers") == 0)) return "a follower that slides has no";
    if (cam->face == YK_CAM_FACE_FLAT && is_arm) return "a flat face has no";
    if (cam->oscillates && cam->face != YK_CAM_FACE_FLAT && strcmp(key, "offset") == 0)
        return "a follower that turns, with a roller or edge, has no";
    if (cam->face != YK_CAM_FACE_ROLLER && (strcmp(key, "groove") == 0 || strcmp(key, "conjugate") == 0))
        return "a follower without a roller has no";
    return NULL;
}

// Checks for keys that do not go together.
static void check_fit(YkLoader *loader, const YkCam *cam, const YkNode *map)
{
    static const char *const keys[] = {"arm", "at", "centers", "offset", "groove", "conjugate"};
    if (cam->carrier == YK_NONE) return;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const YkNode *key = yk_load_key(map, keys[i]);
        const char *why = key ? not_for(cam, keys[i]) : NULL;
        if (why) yk_problem(loader->problems, YK_CODE_CAM_KEY, key->place, "cam %q: %s `%s`", cam->name, why, keys[i]);
    }
}

// Reads {roller: ..., span: ...}, or {roller: ..., arm: ..., angle: ...} for a follower that oscillates.
static void read_conjugate(YkLoader *loader, YkCam *cam, const YkNode *map)
{
    static const char *const slides[] = {"roller", "span", NULL}, *const turns[] = {"roller", "arm", "angle", NULL};
    const YkNode *node = yk_node_get(map, "conjugate");
    const YkSubject subject = {.noun = "conjugate", .owner = cam->name};
    if (!node || !yk_load_expect(loader, node, YK_NODE_MAP, &subject) || cam->carrier == YK_NONE) return;
    cam->is_conjugate = true;
    yk_load_check_keys(loader, node, cam->oscillates ? turns : slides, &subject);
    read_length(loader, node, "roller", cam->name, &cam->other_roller_expr, &cam->other_roller);
    if (!cam->oscillates) {
        yk_load_require(loader, node, "span", &subject);
        read_length(loader, node, "span", cam->name, &cam->other_span_expr, &cam->other_span);
        return;
    }
    YkWant want = {.dimension = YK_DIM_ANGLE, .subject = {.noun = "angle", .owner = cam->name}};
    read_length(loader, node, "arm", cam->name, &cam->other_arm_expr, &cam->other_arm);
    yk_load_require(loader, node, "angle", &subject);
    cam->other_angle_expr = yk_load_key_value(loader, node, "angle", &want, &cam->other_angle);
}

static void read_sizes(YkLoader *loader, YkCam *cam, const YkNode *map)
{
    const YkNode *at = yk_node_get(map, "at");
    yk_load_require(loader, map, "base", &(YkSubject){.noun = "cam", .part = cam->name});
    read_length(loader, map, "base", cam->name, &cam->base_expr, &cam->base);
    read_length(loader, map, "roller", cam->name, &cam->roller_expr, &cam->roller);
    read_length(loader, map, "offset", cam->name, &cam->offset_expr, &cam->offset);
    read_length(loader, map, "arm", cam->name, &cam->arm_expr, &cam->arm);
    read_length(loader, map, "centers", cam->name, &cam->centers_expr, &cam->centers);
    if (at && cam->follower >= 0) cam->point = yk_load_point(loader, cam->follower, at);
    if (!at || !cam->arm_expr) return;
    yk_problem(loader->problems, YK_CODE_CAM_KEY, yk_load_key(map, "arm")->place,
               "cam %q: the point given by `at` already determines the arm", cam->name);
}

static void read_cam(YkLoader *loader, YkCam *cam, const YkNode *map)
{
    static const char *const keys[] = {"cam",    "follower", "law", "arcs",    "carrier", "face",      "roller", "base",
                                       "offset", "arm",      "at",  "centers", "groove",  "conjugate", NULL};
    const YkSubject subject = {.noun = "cam", .part = cam->name};
    if (!yk_load_expect(loader, map, YK_NODE_MAP, &subject)) return;
    yk_load_check_keys(loader, map, keys, &subject);
    const YkNode *body = yk_load_require(loader, map, "cam", &subject);
    const YkNode *follower = yk_load_require(loader, map, "follower", &subject);
    const YkNode *arcs = yk_node_get(map, "arcs");
    const YkNode *law = arcs ? yk_node_get(map, "law") : yk_load_require(loader, map, "law", &subject);
    if (body) cam->cam = yk_load_body(loader, body);
    if (follower) cam->follower = yk_load_body(loader, follower);
    if (law) cam->law = yk_load_law(loader, law);
    if (arcs && law) {
        yk_problem(loader->problems, YK_CODE_CAM_KEY, yk_load_key(map, "arcs")->place,
                   "cam %q has both a `law` and `arcs`: the lift follows from one of them", cam->name);
    } else if (arcs) {
        yk_load_cam_arcs(loader, cam, arcs);
    }
    read_face(loader, cam, map);
    read_carrier(loader, cam, map);
    read_sizes(loader, cam, map);
    cam->is_groove = read_switch(loader, map, "groove", cam->name);
    read_conjugate(loader, cam, map);
    check_fit(loader, cam, map);
}

void yk_load_cams(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "cams");
    YkModel *model = loader->model;
    if (!section) return;
    model->cams = YK_NEW(loader->arena, YkCam, section->count);
    if (!model->cams) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkCam *cam = &model->cams[model->cam_count++];
        *cam = (YkCam){.name = pair->key->text,
                       .place = pair->key->place,
                       .cam = YK_NONE,
                       .follower = YK_NONE,
                       .carrier = YK_NONE,
                       .law = YK_NONE,
                       .point = YK_NONE};
        yk_load_name(loader, pair->key, "cam");
        read_cam(loader, cam, pair->value);
    }
}

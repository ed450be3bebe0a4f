// Shared by the tests of compile and design: a machine from text or from the gallery, and where its bodies are,
// computed without orientations, sums or plans: joint after joint along the tree, in complex numbers with a complex
// step.
#ifndef TESTS_COMPILE_MACHINE_H
#define TESTS_COMPILE_MACHINE_H
#include <complex.h>
#include <stdbool.h>
#include <stdlib.h>
#include "base/problems.h"
#include "check.h"
#include "compile/closure.h"
#include "compile/mechanism.h"

typedef struct Machine {
    YkProblems *problems;
    YkModel *model;
    YkMechanism *mech; // NULL when it was refused
} Machine;

static inline void machine_free(Machine *m)
{
    yk_mechanism_free(m->mech);
    yk_model_free(m->model);
    yk_problems_free(m->problems);
    *m = (Machine){0};
}

// Loads (which must succeed) and compiles (which may not). source: an example's name when it has no newline, or a text.
static inline Machine machine_try_with(const char *source, const YkLoadOptions *load, const YkCompileOptions *options)
{
    Machine m = {.problems = yk_problems_new()};
    assert_non_null(m.problems);
    if (strchr(source, '\n')) {
        m.model = yk_model_parse(source, strlen(source), "test.yaml", load, m.problems);
    } else {
        char path[512];
        snprintf(path, sizeof path, YOKE_ROOT "/examples/%.100s.yaml", source);
        m.model = yk_model_load(path, load, m.problems);
    }
    if (!m.model) print_error("%s\n%s", source, yk_problems_text(m.problems, 0));
    assert_non_null(m.model);
    m.mech = yk_mechanism_compile(m.model, options, m.problems);
    return m;
}
static inline Machine machine_try(const char *source, const YkCompileOptions *options)
{
    return machine_try_with(source, NULL, options);
}

static inline Machine machine_with(const char *source, const YkCompileOptions *options)
{
    Machine m = machine_try(source, options);
    if (!m.mech) print_error("%s\n%s", source, yk_problems_text(m.problems, 0));
    assert_non_null(m.mech);
    return m;
}
static inline Machine machine(const char *source)
{
    return machine_with(source, NULL);
}

// Must be refused with this code; message or hint of the first such problem holds `part`.
static inline void machine_refused(const char *source, const YkCompileOptions *options, int code, const char *part)
{
    Machine m = machine_try(source, options);
    bool is_right = false;
    for (size_t k = 0; k < yk_problems_count(m.problems); k++) {
        const YkProblem *p = yk_problems_get(m.problems, k);
        is_right = is_right || (p->code == code && (strstr(p->message, part) || (p->hint && strstr(p->hint, part))));
    }
    if (m.mech || !is_right)
        print_error("expected E%04d (%s) of\n%s\nfound\n%s", code, part, source, yk_problems_text(m.problems, 0));
    assert_null(m.mech);
    assert_true(is_right);
    machine_free(&m);
}

// --- bodies without the engine
// ------------------------------------------------------------------------------------------

// A vector whose components carry a complex step.
typedef struct Vector {
    double complex x, y;
} Vector;

typedef struct Pose {
    double complex *angle;    // per body
    double complex *distance; // per joint
    Vector *origin;           // per body
} Pose;

static inline Vector turned(double complex angle, double x, double y)
{
    double complex c = ccos(angle), s = csin(angle);
    return (Vector){c * x - s * y, s * x + c * y};
}
static inline Vector sum(Vector a, Vector b, double sign)
{
    return (Vector){a.x + sign * b.x, a.y + sign * b.y};
}

// Where the joint's place on its first body, moved along its line, is; and its place on the second body.
static inline Vector first_point(const YkModel *model, const Pose *pose, size_t joint)
{
    const YkJoint *j = &model->joints[joint];
    Vector at = sum(pose->origin[j->body[0]], turned(pose->angle[j->body[0]], j->at[0].x, j->at[0].y), 1);
    Vector line = turned(pose->angle[j->body[0]], j->along.x, j->along.y);
    double complex d = yk_part(j->kind)->slides ? pose->distance[joint] : 0;
    return (Vector){at.x + d * line.x, at.y + d * line.y};
}
static inline Vector second_point(const YkModel *model, const Pose *pose, size_t joint)
{
    const YkJoint *j = &model->joints[joint];
    return sum(pose->origin[j->body[1]], turned(pose->angle[j->body[1]], j->at[1].x, j->at[1].y), 1);
}

static inline Pose pose_new(const YkModel *model)
{
    Pose pose = {calloc(model->body_count, sizeof *pose.angle), calloc(model->joint_count + 1, sizeof *pose.distance),
                 calloc(model->body_count, sizeof *pose.origin)};
    assert_true(pose.angle && pose.distance && pose.origin);
    return pose;
}
static inline void pose_free(Pose *pose)
{
    free(pose->angle);
    free(pose->distance);
    free(pose->origin);
}

// Origins from angles and distances: each body is hung on one that stands, over the tree's joint, until all stand.
static inline void pose_place(const YkMechanism *mech, Pose *pose)
{
    const YkModel *model = mech->model;
    bool *stands = calloc(model->body_count, sizeof *stands);
    assert_non_null(stands);
    stands[0] = true;
    pose->origin[0] = (Vector){0, 0};
    for (bool more = true; more;) {
        more = false;
        for (size_t b = 1; b < model->body_count; b++) {
            int32_t up = mech->tree.parent[b], joint = mech->tree.joint[b];
            if (stands[b] || up < 0 || !stands[up]) continue;
            pose->origin[b] = (Vector){0, 0};
            Vector one = first_point(model, pose, (size_t)joint), two = second_point(model, pose, (size_t)joint);
            bool is_second = model->joints[joint].body[1] == (int32_t)b;
            // the origin of b counted as zero so far: what is missing between both points
            pose->origin[b] = is_second ? sum(one, two, -1) : sum(two, one, -1);
            stands[b] = more = true;
        }
    }
    for (size_t b = 0; b < model->body_count; b++) assert_true(stands[b]);
    free(stands);
}

// From the engine's variables (angles of orientations 1.., distances) with a step in one of them; turns by the joints.
static inline void pose_from_variables(const YkMechanism *mech, const double *x, size_t stepped, double h, Pose *pose)
{
    const YkModel *model = mech->model;
    size_t o = mech->orientation_count - 1;
    bool *is_set = calloc(model->body_count, sizeof *is_set);
    assert_non_null(is_set);
    for (size_t k = 0; k <= o; k++) {
        int32_t b = mech->orientation_body[k];
        pose->angle[b] = k == 0 ? 0 : x[k - 1] + (stepped == k - 1 ? h * I : 0);
        is_set[b] = true;
    }
    for (bool more = true; more;) {
        more = false;
        for (size_t j = 0; j < model->joint_count; j++) {
            const YkJoint *joint = &model->joints[j];
            int32_t a = joint->body[0], b = joint->body[1];
            if (yk_part(joint->kind)->turns || is_set[a] == is_set[b]) continue;
            if (is_set[a])
                pose->angle[b] = pose->angle[a] + joint->turned;
            else
                pose->angle[a] = pose->angle[b] - joint->turned;
            is_set[a] = is_set[b] = more = true;
        }
    }
    for (size_t b = 0; b < model->body_count; b++) assert_true(is_set[b]);
    for (size_t j = 0; j < model->joint_count; j++) {
        int32_t d = mech->joint_distance[j];
        if (d >= 0) pose->distance[j] = x[o + (size_t)d] + (stepped == o + (size_t)d ? h * I : 0);
    }
    free(is_set);
    pose_place(mech, pose);
}

static inline Vector loop_gap(const YkMechanism *mech, const Pose *pose, size_t loop)
{
    size_t joint = yk_loop_joint(mech, loop);
    return sum(first_point(mech->model, pose, joint), second_point(mech->model, pose, joint), -1);
}

static inline void random_variables(const YkMechanism *mech, uint64_t *seed, double *x)
{
    size_t o = mech->orientation_count - 1;
    for (size_t k = 0; k < yk_variable_count(mech); k++)
        x[k] = k < o ? check_uniform(seed, -3.2, 3.2) : check_uniform(seed, -2, 2) * mech->size;
}

// --- what a mechanism is, as one line
// ----------------------------------------------------------------------------------

static inline void add_text(char *text, size_t capacity, const char *format, const char *a, const char *b)
{
    size_t n = strlen(text);
    snprintf(text + n, capacity - n, format, n > 0 ? ", " : "", a, b);
}
static inline const char *short_kind(YkBlockKind kind)
{
    static const char *const names[] = {"RRR", "RRP", "RPR", "PP", "LINK", "CHECK", "GROUP"};
    return names[kind];
}
// "RPR A, RRP C"
static inline void describe_blocks(const YkMechanism *mech, char *text, size_t capacity)
{
    text[0] = 0;
    for (size_t b = 0; b < yk_block_count(mech); b++) {
        YkBlockInfo info = yk_block_info(mech, b);
        add_text(text, capacity, "%s%s %s", short_kind(info.kind), info.label);
    }
}
static inline void describe_inputs(const YkMechanism *mech, char *text, size_t capacity)
{
    text[0] = 0;
    for (size_t i = 0; i < yk_input_count(mech); i++)
        add_text(text, capacity, "%s%s%s", yk_coordinate_info(mech, yk_input_coordinate(mech, i)).name, "");
}
static inline void describe_coordinates(const YkMechanism *mech, char *text, size_t capacity)
{
    text[0] = 0;
    for (size_t k = 0; k < yk_coordinate_count(mech); k++)
        add_text(text, capacity, "%s%s%s", yk_coordinate_info(mech, k).name, "");
}

#endif

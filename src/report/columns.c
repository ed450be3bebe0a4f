// Chooses what is recorded on the way: for diagrams, for arrows in the drawing, for findings. In large machines, the
// first ones.
#include <math.h>
#include <string.h>
#include "elementary/elementary.h"
#include "report/report.h"

enum {
    COORDINATES_MAX = 16,
    BLOCKS_MAX = 8,
    EFFORTS_MAX = 8,
    JOINTS_MAX = 16,
    POINTS_MAX = 12,
    JOINT_PATHS_MAX = 4,
    NAME_SIZE = 256
};

// Skips what no channel can name, and what is already there.
static void add(YkReportPage *report, const char *name, YkReportRole role, size_t of)
{
    YkChannel channel;
    if (yk_channel_parse(report->mech, name, &channel, NULL) != YK_OK) return;
    if (!YK_ROOM(report->columns, report->column_count, report->column_capacity)) {
        report->failed = true;
        return;
    }
    const char *own = yk_arena_copy(report->arena, name, strlen(name));
    report->failed |= !own;
    report->columns[report->column_count++] = (YkReportColumn){own, channel, role, of};
}

// Adds "NAME" with each of the endings.
static void add_each(YkReportPage *report, const char *base, const char *const *endings, size_t count,
                     YkReportRole role, size_t of)
{
    YkText name = {0};
    for (size_t i = 0; i < count; i++) {
        yk_text_clear(&name);
        yk_text_format(&name, "%s%s", base, endings[i]);
        add(report, yk_text_get(&name), role, of);
    }
    report->failed |= name.failed;
    yk_text_free(&name);
}

// Adds the coordinates that the file names, if it names any.
static void add_coordinates(YkReportPage *report)
{
    static const char *const orders[] = {"", ".rate", ".accel"};
    size_t count = yk_coordinate_count(report->mech), added = 0;
    bool names_some = false;
    for (size_t i = 0; i < count; i++) names_some |= yk_coordinate_info(report->mech, i).is_declared;
    for (size_t i = 0; i < count && added < COORDINATES_MAX; i++) {
        YkCoordinateInfo info = yk_coordinate_info(report->mech, i);
        if (names_some && !info.is_declared) continue;
        add_each(report, info.name, orders, 3, YK_ROLE_COORDINATE, i);
        added++;
    }
}

// A simulation may change its coordinates on the way, and with them the blocks.
static void add_transmissions(YkReportPage *report)
{
    static const char *const ending[] = {".transmission"};
    size_t added = 0;
    if (report->motion.kind == YK_REPORT_SIMULATION) return;
    for (size_t b = 0; b < yk_block_count(report->mech) && added < BLOCKS_MAX; b++) {
        YkBlockInfo block = yk_block_info(report->mech, b);
        if (block.kind > YK_BLOCK_RPR || !block.label) continue;
        add_each(report, block.label, ending, 1, YK_ROLE_TRANSMISSION, b);
        added++;
    }
}

static void add_forces(YkReportPage *report)
{
    static const char *const effort[] = {".effort"}, *const size[] = {".force"},
                             *const axes[] = {".force.x", ".force.y"};
    static const char *const energies[] = {"kinetic", "potential", "energy"};
    static const char *const shaking[] = {"shaking.x", "shaking.y"};
    size_t efforts = 0,
           joints = yk_model_joint_count(report->model) < JOINTS_MAX ? yk_model_joint_count(report->model) : JOINTS_MAX;
    if (!report->dynamics) return;
    for (size_t c = 0; c < yk_coordinate_count(report->mech) && efforts < EFFORTS_MAX; c++) {
        if (!yk_dynamics_has_effort(report->dynamics, c)) continue;
        add_each(report, yk_coordinate_info(report->mech, c).name, effort, 1, YK_ROLE_EFFORT, c);
        efforts++;
    }
    for (size_t j = 0; j < joints; j++) add_each(report, report->model->joints[j].name, size, 1, YK_ROLE_REACTION, j);
    add_each(report, "", energies, 3, YK_ROLE_ENERGY, 0);
    add_each(report, "", shaking, 2, YK_ROLE_SHAKING, 0);
    for (size_t j = 0; j < joints; j++) add_each(report, report->model->joints[j].name, axes, 2, YK_ROLE_FORCE, j);
}

static void add_velocities(YkReportPage *report)
{
    static const char *const axes[] = {".x.rate", ".y.rate"};
    YkText name = {0};
    for (size_t i = 0; i < report->traced_count; i++) {
        const YkPoint *point = &report->model->points[report->traced[i]];
        yk_text_clear(&name);
        yk_text_format(&name, "%s.%s", report->model->bodies[point->body].name, point->name);
        add_each(report, yk_text_get(&name), axes, 2, YK_ROLE_VELOCITY, report->traced[i]);
    }
    report->failed |= name.failed;
    yk_text_free(&name);
}

void yk_report_choose_columns(YkReportPage *report)
{
    add_coordinates(report);
    add_transmissions(report);
    add_forces(report);
    add_velocities(report);
}

int yk_report_column(const YkReportPage *report, YkReportRole role, size_t of, int order)
{
    for (size_t c = 0; c < report->column_count; c++) {
        const YkReportColumn *column = &report->columns[c];
        if (column->role == role && column->of == of && (role != YK_ROLE_COORDINATE || column->channel.order == order))
            return (int)c;
    }
    return -1;
}

// --- Points with a path

static bool is_at_joint(const YkModel *model, size_t point)
{
    const YkPoint *p = &model->points[point];
    for (size_t j = 0; j < model->joint_count; j++)
        for (int side = 0; side < 2; side++)
            if (model->joints[j].body[side] == p->body && yk_norm(yk_sub(model->joints[j].at[side], p->at)) == 0)
                return true;
    return false;
}

// Returns whether the point coincides with an earlier one, as where two bodies meet in a pin.
static bool is_seen(const YkReportPage *report, size_t point)
{
    YkPointMotion own = yk_state_point(report->start, point);
    for (size_t i = 0; i < report->model->point_count; i++) {
        bool counts = report->model->points[i].body == 0;
        for (size_t k = 0; k < report->traced_count; k++) counts |= report->traced[k] == i;
        YkPointMotion other = yk_state_point(report->start, i);
        if (counts && yk_hypot(own.position[0] - other.position[0], own.position[1] - other.position[1]) <
                          1e-9 * yk_mechanism_size(report->mech))
            return true;
    }
    return false;
}

static void trace(YkReportPage *report, size_t point)
{
    if (report->traced_count < POINTS_MAX && report->model->points[point].body > 0 && !is_seen(report, point))
        report->traced[report->traced_count++] = point;
}

// Chooses first the points asked for, then points that no joint uses, then the others.
void yk_report_choose_traces(YkReportPage *report)
{
    const YkModel *model = report->model;
    report->traced = YK_NEW(report->arena, size_t, POINTS_MAX);
    if (!report->traced) {
        report->failed = true;
        return;
    }
    for (size_t i = 0; i < report->options.traced_count; i++) trace(report, report->options.traced_points[i]);
    report->options.traced_count = report->traced_shown = report->traced_count;
    for (int round = 0; round < 2; round++) {
        for (size_t i = 0; i < model->point_count; i++)
            if (is_at_joint(model, i) == (round == 1)) trace(report, i);
        size_t most = round == 0 ? POINTS_MAX : JOINT_PATHS_MAX;
        if (report->traced_shown == 0) report->traced_shown = report->traced_count < most ? report->traced_count : most;
    }
}

// The routines of the file: the results of each, as values.
#include "code/file.h"
#include "base/problems.h"
#include "model/load.h"

static void add_result(YkFile *file, YkRoutine *routine, YkChannel channel, const char *comment, YkRef value,
                       const char *format, ...)
{
    YkText name = {0};
    va_list arguments;
    va_start(arguments, format);
    yk_text_vformat(&name, format, arguments);
    va_end(arguments);
    const char *copy = yk_arena_copy(file->program.arena, yk_text_get(&name), name.length);
    if (!copy || !routine->results)
        file->program.failed = true;
    else
        routine->results[routine->count++] = (YkResult){copy, comment, value, channel};
    yk_text_free(&name);
}

static YkRoutine *begin(YkFile *file, const char *name, const char *about, size_t room)
{
    YkRoutine *r = &file->routines[file->routine_count++];
    *r = (YkRoutine){.name = name, .about = about, .witness = file->program.witness};
    r->regular = r->settled = r->moves = -1;
    r->results = YK_NEW(file->program.arena, YkResult, room + 1);
    if (!r->results) file->program.failed = true;
    return r;
}

static YkChannel of(YkChannelKind kind, size_t index, int order)
{
    return (YkChannel){.kind = kind, .index = (int)index, .order = order};
}

static YkRef witness(YkProgram *p, YkRef sum, YkRef value)
{
    return yk_graph_add(&p->graph, sum, yk_graph_unary(&p->graph, YK_VALUE_WITNESS, value));
}

static const char *unit_of(bool is_distance, int order)
{
    static const char *const units[2][3] = {{"rad", "rad/s", "rad/s^2"}, {"m", "m/s", "m/s^2"}};
    return units[is_distance][order];
}

// Velocities and accelerations for those of the inputs.
typedef struct Rates {
    YkRates velocities, accelerations;
} Rates;

static Rates find_rates(YkFile *file)
{
    YkProgram *p = &file->program;
    size_t n = p->mech->input_count;
    YkRef *v = YK_NEW(p->arena, YkRef, n + 1), *a = YK_NEW(p->arena, YkRef, n + 1);
    Rates r = {{0}, {0}};
    if (!v || !a) {
        p->failed = true;
        return r;
    }
    for (size_t i = 0; i < n; i++) {
        v[i] = p->input[i].velocity;
        a[i] = p->input[i].acceleration;
    }
    r.velocities = yk_program_velocities(p, v);
    r.accelerations = yk_program_accelerations(p, &r.velocities, a);
    return r;
}

static YkRef rates_witness(YkProgram *p)
{
    YkRef sum = p->witness;
    for (size_t i = 0; i < p->mech->input_count; i++)
        sum = witness(p, witness(p, sum, p->input[i].velocity), p->input[i].acceleration);
    return sum;
}

static void add_motion(YkFile *file, const Rates *r)
{
    YkProgram *p = &file->program;
    size_t n = p->mech->coordinate_count;
    YkRoutine *routine = begin(file, "motion", "Coordinates that are not inputs, with rates and accelerations.", 3 * n);
    yk_graph_section(&p->graph, "Answers: angles between bodies, nearest to the configuration's.");
    for (size_t k = 0; k < n && !p->failed; k++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[k];
        const char *name = p->names.coordinate[k];
        if (c->input != YK_NONE) continue;
        add_result(file, routine, of(YK_CHANNEL_COORDINATE, k, 0), unit_of(c->is_distance, 0),
                   yk_program_coordinate(p, k), "%s", name);
        add_result(file, routine, of(YK_CHANNEL_COORDINATE, k, 1), unit_of(c->is_distance, 1),
                   yk_program_coordinate_rate(p, k, &r->velocities), "%s_rate", name);
        add_result(file, routine, of(YK_CHANNEL_COORDINATE, k, 2), unit_of(c->is_distance, 2),
                   yk_program_coordinate_rate(p, k, &r->accelerations), "%s_accel", name);
    }
    routine->witness = rates_witness(p);
    routine->has_designs = true;
    if (routine->count == 0) file->routine_count--;
}

static void add_points(YkFile *file, const Rates *r)
{
    YkProgram *p = &file->program;
    YkGraph *g = &p->graph;
    YkRoutine *routine =
        begin(file, "points", "Points of the moving bodies: places, velocities, accelerations, in world axes.",
              6 * p->model->point_count);
    yk_graph_section(g, "Points.");
    for (size_t k = 0; k < p->model->point_count && !p->failed; k++) {
        const YkPoint *point = &p->model->points[k];
        if (point->body == 0) continue;
        const char *name = p->names.point[k];
        YkRefVec at = yk_program_point(p, (int32_t)k);
        YkRefVec place = yk_program_at(p, point->body, at),
                 rate = yk_program_at_rate(p, point->body, at, &r->velocities);
        YkRefVec accel = yk_program_at_accel(p, point->body, at, &r->velocities, &r->accelerations);
        add_result(file, routine, of(YK_CHANNEL_POINT_X, k, 0), "m", place.x, "%s_x", name);
        add_result(file, routine, of(YK_CHANNEL_POINT_Y, k, 0), "m", place.y, "%s_y", name);
        add_result(file, routine, of(YK_CHANNEL_POINT_X, k, 1), "m/s", rate.x, "%s_x_rate", name);
        add_result(file, routine, of(YK_CHANNEL_POINT_Y, k, 1), "m/s", rate.y, "%s_y_rate", name);
        add_result(file, routine, of(YK_CHANNEL_POINT_X, k, 2), "m/s^2", accel.x, "%s_x_accel", name);
        add_result(file, routine, of(YK_CHANNEL_POINT_Y, k, 2), "m/s^2", accel.y, "%s_y_accel", name);
    }
    routine->witness = rates_witness(p);
    if (routine->count == 0) file->routine_count--;
}

static YkRef above_rounding(YkGraph *g, YkRef determinant)
{
    YkRef size = yk_graph_unary(g, YK_VALUE_SIZE, determinant);
    return yk_graph_subtract(g, size, yk_graph_number(g, 1e-14));
}

// Enters what dry friction asks of a routine.
static void meet_dry(YkFile *file, YkRoutine *routine, const YkDryResult *dry)
{
    YkGraph *g = &file->program.graph;
    if (file->forces.dry_count == 0) return;
    YkRef regular = above_rounding(g, dry->determinant);
    routine->regular = routine->regular < 0 ? regular : yk_graph_binary(g, YK_VALUE_LEAST, routine->regular, regular);
    routine->settled = dry->settled;
    routine->moves = dry->moves;
}

static void add_efforts(YkFile *file)
{
    YkProgram *p = &file->program;
    size_t n = p->mech->input_count;
    YkRoutine *routine = begin(
        file, "efforts",
        "Inverse dynamics: what each input must exert, besides all loads, for its acceleration; energies.", n + 2);
    for (size_t i = 0; i < n; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        add_result(file, routine, of(YK_CHANNEL_EFFORT, (size_t)p->mech->inputs[i], 0), c->is_distance ? "N" : "N m",
                   file->forces.effort[i], "%s_effort", p->names.coordinate[p->mech->inputs[i]]);
    }
    add_result(file, routine, of(YK_CHANNEL_KINETIC, 0, 0), "J", file->forces.kinetic, "kinetic");
    add_result(file, routine, of(YK_CHANNEL_POTENTIAL, 0, 0), "J, of gravity and springs", file->forces.potential,
               "potential");
    routine->checks_results = routine->has_designs = true;
    routine->kind = YK_ROUTINE_INVERSE;
    routine->witness = rates_witness(p);
    meet_dry(file, routine, &file->forces.dry_inverse);
}

static void add_accelerations(YkFile *file)
{
    YkProgram *p = &file->program;
    size_t n = p->mech->input_count;
    if (file->forces.free_count == 0) return;
    YkRoutine *routine =
        begin(file, "accelerations",
              "Forward dynamics: accelerations of the inputs that no drive moves, under all loads and `_effort`.", n);
    for (size_t i = 0; i < n; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        if (!file->forces.is_free[i]) continue;
        add_result(file, routine, of(YK_CHANNEL_COORDINATE, (size_t)p->mech->inputs[i], 2), unit_of(c->is_distance, 2),
                   file->forces.acceleration[i], "%s_accel", p->names.coordinate[p->mech->inputs[i]]);
    }
    routine->regular = file->forces.inertia;
    routine->kind = YK_ROUTINE_FORWARD;
    routine->checks_results = routine->has_designs = true;
    meet_dry(file, routine, &file->forces.dry_forward);
}

// Returns whether something bears: free joints transmit nothing.
static bool has_bearing(const YkModel *model)
{
    return model->joint_count > 2 * model->carriage_count || model->follow_count > 0;
}

// Writes what drives that follow a law exert. If constraints repeat others, the engine knows this of some alone.
static void add_law_efforts(YkFile *file, YkRoutine *routine)
{
    YkProgram *p = &file->program;
    for (size_t k = 0; k < p->mech->coordinate_count && !file->forces.is_least; k++) {
        int32_t law = yk_law_relation(p->mech, k);
        if (law == YK_NONE) continue;
        add_result(file, routine, of(YK_CHANNEL_EFFORT, k, 0), p->mech->coordinates[k].is_distance ? "N" : "N m",
                   file->forces.contact[law].moment, "%s_effort", p->names.coordinate[k]);
    }
}

// Returns the sentence about the reactions of the machine: what is among them.
static const char *about_reactions(YkFile *file)
{
    const YkProgram *p = &file->program;
    const char *contacts =
        yk_contact_count(p->mech) > 0 ? " Forces of gears, racks, belts and cams on their second body." : "";
    const char *laws = p->model->follow_count > 0 && !file->forces.is_least ? " Efforts of drives by laws." : "";
    return yk_graph_text(&file->program.graph, "%s%s%s",
                         "Reactions: the force of each joint's first body on its second, world axes; moment about its "
                         "point.",
                         contacts, laws);
}

// Writes what gears, racks, belts and cams transmit: a force on the second body, or the couple on it where no force is
// known.
static void add_contacts(YkFile *file, YkRoutine *routine)
{
    YkProgram *p = &file->program;
    for (size_t k = 0; k < yk_contact_count(p->mech); k++) {
        const YkContactRef *c = &file->forces.contact[k];
        const char *name = p->names.contact[k];
        size_t index = p->model->joint_count + k;
        if (c->has_force) {
            add_result(file, routine, of(YK_CHANNEL_FORCE_X, index, 0), "N", c->force.x, "%s_force_x", name);
            add_result(file, routine, of(YK_CHANNEL_FORCE_Y, index, 0), "N", c->force.y, "%s_force_y", name);
        } else {
            add_result(file, routine, of(YK_CHANNEL_MOMENT, index, 0), "N m", c->moment, "%s_moment", name);
        }
    }
}

static void add_reactions(YkFile *file, const Rates *r)
{
    YkProgram *p = &file->program;
    YkForces *f = &file->forces;
    if (!has_bearing(p->model)) return;
    if (f->dry_count == 0) yk_forces_reactions(f, &r->velocities, &r->accelerations);
    if (p->failed) return;
    if (!f->reaction) {
        if (!f->why_no_reactions) return;
        yk_problem(p->problems, YK_CODE_NOT_PRINTED, (YkPlace){0}, "the reactions in the joints are not printed: %s",
                   f->why_no_reactions);
        return;
    }
    size_t most = 3 * p->model->joint_count + 2 * yk_contact_count(p->mech) + p->model->follow_count;
    YkRoutine *routine = begin(file, "reactions", about_reactions(file), most);
    for (size_t j = 0; j < p->model->joint_count; j++) {
        const char *name = p->names.joint[j];
        if (p->model->joints[j].is_free) continue; // it transmits nothing
        add_result(file, routine, of(YK_CHANNEL_FORCE_X, j, 0), "N", f->reaction[3 * j], "%s_force_x", name);
        add_result(file, routine, of(YK_CHANNEL_FORCE_Y, j, 0), "N", f->reaction[3 * j + 1], "%s_force_y", name);
        if (!yk_part(p->model->joints[j].kind)->turns)
            add_result(file, routine, of(YK_CHANNEL_MOMENT, j, 0), "N m", f->reaction[3 * j + 2], "%s_moment", name);
    }
    add_contacts(file, routine);
    add_law_efforts(file, routine);
    routine->regular = above_rounding(&p->graph, f->determinant);
    routine->checks_results = true;
    routine->kind = YK_ROUTINE_INVERSE;
    routine->witness = rates_witness(p);
    meet_dry(file, routine, &f->dry_inverse);
}

// --- drives

// Returns a drive's value: its expression, or a law of it, with two time derivatives.
static YkMotionRef drive_of(YkProgram *p, const YkDrive *drive)
{
    YkGraph *g = &p->graph;
    YkRef x = yk_program_expr(p, drive->expr), v = yk_graph_derivative(g, x, p->time),
          a = yk_graph_derivative(g, v, p->time);
    if (drive->law == YK_NONE) return (YkMotionRef){x, v, a};
    int32_t call = yk_program_call_law(p, drive->law, x);
    YkRef d1 = yk_graph_result(g, call, 1), d2 = yk_graph_result(g, call, 2);
    YkRef bend = yk_graph_multiply(g, d2, yk_graph_multiply(g, v, v));
    YkMotionRef motion = {.position = yk_graph_result(g, call, 0)};
    motion.velocity = yk_graph_multiply(g, d1, v);
    motion.acceleration = yk_graph_add(g, yk_graph_multiply(g, d1, a), bend);
    return motion;
}

static void add_drives(YkFile *file)
{
    YkProgram *p = &file->program;
    file->drives = YK_NEW(p->arena, YkResult, 3 * p->mech->input_count + 1);
    if (!file->drives) {
        p->failed = true;
        return;
    }
    yk_graph_section(&p->graph, NULL);
    for (size_t i = 0; i < p->mech->input_count; i++) {
        const YkTreeCoordinate *c = &p->mech->coordinates[p->mech->inputs[i]];
        if (c->drive == YK_NONE) continue;
        const char *name = p->names.coordinate[p->mech->inputs[i]];
        YkMotionRef m = drive_of(p, &p->model->drives[c->drive]);
        file->drives[file->drive_count++] = (YkResult){.name = name, .value = m.position};
        file->drives[file->drive_count++] =
            (YkResult){.name = yk_graph_text(&p->graph, "%s_rate", name), .value = m.velocity};
        file->drives[file->drive_count++] =
            (YkResult){.name = yk_graph_text(&p->graph, "%s_accel", name), .value = m.acceleration};
    }
}

// --- racks

// Returns how far a rack's line passes from its pinion's centre, positive on the side of the file
// (model/transmissions).
static YkRef side_of(YkProgram *p, const YkRack *rack)
{
    YkGraph *g = &p->graph;
    const YkJoint *slide = &p->model->joints[rack->slide], *pin = yk_rack_pin(p->model, rack, rack->carrier);
    bool is_reversed = slide->body[0] == rack->rack;
    if (!pin) return yk_graph_number(g, rack->radius);
    YkRefVec center = yk_program_point(p, pin->point[pin->body[1] == rack->carrier]);
    YkRefVec apart = yk_graph_vec_subtract(g, center, yk_program_point(p, slide->point[is_reversed]));
    YkRef side = yk_graph_cross(g, yk_program_along(p, slide), apart);
    return yk_graph_multiply(g, yk_graph_number(g, is_reversed ? -rack->sense : rack->sense), side);
}

// Finds whether the parameters leave every rack on its side of the pinion: its teeth mesh there in the printed file.
// A line through the centre may lie a hair beyond it.
static YkRef find_side(YkProgram *p)
{
    YkGraph *g = &p->graph;
    YkRef least = YK_NONE;
    for (size_t k = 0; k < p->model->rack_count; k++) {
        YkRef side = side_of(p, &p->model->racks[k]), hair = yk_graph_number(g, 1e-9 * p->model->racks[k].radius);
        if (g->values[side].op == YK_VALUE_NUMBER) continue;
        side = yk_graph_add(g, side, hair);
        least = least == YK_NONE ? side : yk_graph_binary(g, YK_VALUE_LEAST, side, least);
    }
    return least == YK_NONE ? YK_NONE : yk_graph_name(g, least, "rack_side");
}

bool yk_file_routines(YkFile *file)
{
    YkProgram *p = &file->program;
    yk_program_pose(p);
    if (p->failed) return false;
    Rates r = find_rates(file);
    file->rack_side = find_side(p);
    if (p->failed) return false;
    add_motion(file, &r);
    add_points(file, &r);
    if (file->has_forces) {
        if (!yk_forces_build(&file->forces, p)) return false;
        if (file->forces.dry_count > 0 && !yk_forces_dry(&file->forces, &r.velocities, &r.accelerations)) return false;
        add_efforts(file);
        add_accelerations(file);
        add_reactions(file, &r);
    }
    add_drives(file);
    return yk_file_residuals(file) && !p->failed && !p->graph.failed;
}

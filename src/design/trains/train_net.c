// The equations of a train: which bodies belong to it, the names of teeth and radii, one row for each mesh.
#include <string.h>
#include "design/trains/train.h"

// --- Members

static void take(YkTrainNet *net, int32_t body)
{
    if (body >= 0) net->column_of[body] = 0; // numbered later
}

static void take_wheels(YkTrainNet *net)
{
    const YkModel *model = net->model;
    for (size_t i = 0; i < model->gear_count; i++) {
        const YkGear *gear = &model->gears[i];
        take(net, gear->body[0]);
        take(net, gear->body[1]);
        take(net, gear->carrier);
    }
    for (size_t i = 0; i < model->belt_count; i++) {
        const YkBelt *belt = &model->belts[i];
        take(net, belt->body[0]);
        take(net, belt->body[1]);
        take(net, belt->carrier);
    }
    for (size_t i = 0; i < model->rack_count; i++) {
        take(net, model->racks[i].pinion);
        take(net, model->racks[i].carrier);
    }
}

static void take_locked(YkTrainNet *net)
{
    for (size_t l = 0; l < net->model->lock_count; l++) {
        const YkLock *lock = &net->model->locks[l];
        for (size_t i = 0; i < lock->hold_count; i++) {
            const YkHold *hold = &lock->holds[i];
            take(net, hold->body);
            if (hold->body != YK_NONE) continue;
            const YkCoordinate *coordinate = &net->model->coordinates[hold->coordinate];
            for (int k = 0; k < 2 && !coordinate->is_distance; k++)
                take(net, net->model->joints[coordinate->joint].body[k]);
        }
        for (size_t i = 0; i < lock->join_count; i++)
            for (int k = 0; k < 2; k++) take(net, lock->joins[i][k]);
    }
}

static bool is_member(const YkTrainNet *net, int32_t body)
{
    return body > 0 && net->column_of[body] >= 0;
}

static bool keeps_angle(const YkJoint *joint)
{
    return joint->kind == YK_SLIDE || joint->kind == YK_WELD;
}

static bool is_driven(const YkModel *model, size_t joint)
{
    for (size_t i = 0; i < model->drive_count; i++) {
        const YkCoordinate *coordinate = &model->coordinates[model->drives[i].coordinate];
        if (!coordinate->is_distance && coordinate->joint == (int32_t)joint) return true;
    }
    return false;
}

// Adds the bodies that keep their angle to a member, or are driven against one: they are members too.
static void take_followers(YkTrainNet *net)
{
    for (bool grows = true; grows;) {
        grows = false;
        for (size_t i = 0; i < net->model->joint_count; i++) {
            const YkJoint *joint = &net->model->joints[i];
            int32_t a = joint->body[0], b = joint->body[1];
            if (!keeps_angle(joint) && !is_driven(net->model, i)) continue;
            if (is_member(net, a) == is_member(net, b) || a == 0 || b == 0) continue;
            take(net, a);
            take(net, b);
            grows = true;
        }
    }
}

static bool number_columns(YkTrainNet *net)
{
    const YkModel *model = net->model;
    net->body_of = YK_NEW(net->arena, int32_t, model->body_count + model->rack_count);
    if (!net->body_of) return false;
    take(net, 0);
    for (int32_t b = 0; b < (int32_t)model->body_count; b++) {
        if (net->column_of[b] < 0) continue;
        net->column_of[b] = net->columns;
        net->body_of[net->columns++] = b;
    }
    net->bodies = net->columns;
    for (size_t r = 0; r < model->rack_count; r++) net->body_of[net->columns++] = -1;
    return true;
}

// --- Symbols

static bool is_taken(const YkTrainNet *net, const char *name)
{
    for (int32_t s = 0; s < net->symbol_count; s++)
        if (strcmp(net->symbols[s].name, name) == 0) return true;
    return yk_names_find(&net->model->parameter_names, name) != YK_NONE ||
           yk_names_find(&net->model->coordinate_names, name) != YK_NONE;
}

// Makes "z_sun", with a number behind it if a body has several gears; names in formulas cannot contain `-`.
static const char *make_name(YkTrainNet *net, const char *letter, const char *body)
{
    YkText text = {0};
    for (int number = 1; number < 1000; number++) {
        yk_text_clear(&text);
        yk_text_format(&text, "%s_%s", letter, body);
        if (number > 1) yk_text_format(&text, "_%d", number);
        for (size_t i = 0; !text.failed && i < text.length; i++)
            if (text.data[i] == '-') text.data[i] = '_';
        if (text.failed || !is_taken(net, yk_text_get(&text))) break;
    }
    return yk_train_keep(net->arena, &text);
}

static bool is_same_value(const YkFraction *a, const YkFraction *b)
{
    return yk_whole_compare(&a->over, &b->over) == 0 && yk_whole_compare(&a->under, &b->under) == 0;
}

// Finds the symbol of a wheel: its parameter's name, or that of the same body with the same number, or a new one.
static int32_t find_symbol(YkTrainNet *net, const char *letter, int32_t body, const YkExpr *expr, YkFraction value)
{
    bool is_parameter = expr->kind == YK_EXPR_NAME;
    const char *body_name = net->model->bodies[body].name, *name = is_parameter ? expr->name : NULL;
    size_t length = strlen(body_name);
    for (int32_t s = 0; s < net->symbol_count; s++) {
        const YkTrainSymbol *symbol = &net->symbols[s];
        if (!is_same_value(&symbol->value, &value)) continue;
        if (is_parameter ? strcmp(symbol->name, name) == 0
                         : symbol->expr->kind != YK_EXPR_NAME && strncmp(symbol->name + 2, body_name, length) == 0)
            return s;
    }
    if (!name) name = make_name(net, letter, body_name);
    if (!name) return -1;
    net->symbols[net->symbol_count] = (YkTrainSymbol){.name = name, .expr = expr, .value = value};
    return net->symbol_count++;
}

// Returns a radius as a fraction: exact if the file writes it so, otherwise the double itself.
static YkFraction fraction_of(YkTrainNet *net, YkExact exact, double value)
{
    if (exact.is_exact && exact.pi == 0) return yk_fraction(exact.numerator, exact.denominator);
    net->is_exact = false;
    return yk_fraction_of(value);
}

static bool name_symbols(YkTrainNet *net)
{
    const YkModel *model = net->model;
    size_t meshes = (size_t)net->mesh_count;
    net->symbols = YK_NEW(net->arena, YkTrainSymbol, 2 * meshes + 1);
    net->symbol_of = yk_arena_alloc(net->arena, meshes + 1, sizeof *net->symbol_of);
    if (!net->symbols || !net->symbol_of) return false;
    int32_t mesh = 0;
    net->is_exact = true;
    for (size_t i = 0; i < model->gear_count; i++, mesh++) {
        const YkGear *gear = &model->gears[i];
        for (int k = 0; k < 2; k++)
            net->symbol_of[mesh][k] =
                find_symbol(net, "z", gear->body[k], gear->teeth_expr[k], yk_fraction(gear->teeth[k], 1));
    }
    for (size_t i = 0; i < model->belt_count; i++, mesh++) {
        const YkBelt *belt = &model->belts[i];
        for (int k = 0; k < 2; k++)
            net->symbol_of[mesh][k] = find_symbol(net, "r", belt->body[k], belt->radius_expr[k],
                                                  fraction_of(net, belt->exact_radius[k], belt->radius[k]));
    }
    for (size_t i = 0; i < model->rack_count; i++, mesh++) {
        const YkRack *rack = &model->racks[i];
        net->symbol_of[mesh][0] =
            find_symbol(net, "r", rack->pinion, rack->radius_expr, fraction_of(net, rack->exact_radius, rack->radius));
        net->symbol_of[mesh][1] = -1;
    }
    return !yk_arena_failed(net->arena);
}

// --- Rows

static YkTrainRow *new_row(YkTrainNet *net, YkTrainRowKind kind, size_t index)
{
    YkTrainRow *row = &net->rows[net->row_count++];
    *row = (YkTrainRow){.kind = kind, .index = (int32_t)index, .input = -1};
    return row;
}

static void add_term(const YkTrainNet *net, YkTrainRow *row, int32_t body, int32_t sign, int32_t symbol)
{
    row->terms[row->count++] = (YkTrainTerm){net->column_of[body], sign, symbol};
}

// (a - c) z_a + sense (b - c) z_b = 0: Willis; sense is +1 if the two turn against each other.
static void willis(YkTrainNet *net, YkTrainRow *row, const int32_t body[2], int32_t carrier, int32_t sense,
                   const int32_t symbol[2])
{
    add_term(net, row, body[0], 1, symbol[0]);
    add_term(net, row, body[1], sense, symbol[1]);
    add_term(net, row, carrier, -1, symbol[0]);
    add_term(net, row, carrier, -sense, symbol[1]);
}

static void add_rack(YkTrainNet *net, size_t index, int32_t symbol)
{
    const YkRack *rack = &net->model->racks[index];
    YkTrainRow *row = new_row(net, YK_ROW_RACK, index);
    add_term(net, row, rack->pinion, 1, symbol);
    add_term(net, row, rack->carrier, -1, symbol);
    row->terms[row->count++] = (YkTrainTerm){net->bodies + (int32_t)index, -rack->sense, -1};
}

static bool write_rows(YkTrainNet *net)
{
    const YkModel *model = net->model;
    net->rows = YK_NEW(net->arena, YkTrainRow, model->joint_count + (size_t)net->mesh_count + 1);
    if (!net->rows) return false;
    for (size_t i = 0; i < model->gear_count; i++) {
        const YkGear *gear = &model->gears[i];
        willis(net, new_row(net, YK_ROW_GEARS, i), gear->body, gear->carrier, gear->is_internal ? -1 : 1,
               net->symbol_of[i]);
    }
    for (size_t i = 0; i < model->belt_count; i++) {
        const YkBelt *belt = &model->belts[i];
        willis(net, new_row(net, YK_ROW_BELT, i), belt->body, belt->carrier, belt->is_crossed ? 1 : -1,
               net->symbol_of[model->gear_count + i]);
    }
    for (size_t i = 0; i < model->rack_count; i++)
        add_rack(net, i, net->symbol_of[model->gear_count + model->belt_count + i][0]);
    add_term(net, new_row(net, YK_ROW_GROUND, 0), 0, 1, -1);
    for (size_t i = 0; i < model->joint_count; i++) {
        const YkJoint *joint = &model->joints[i];
        if (!keeps_angle(joint) || net->column_of[joint->body[0]] < 0 || net->column_of[joint->body[1]] < 0) continue;
        YkTrainRow *row = new_row(net, YK_ROW_KEPT, i);
        add_term(net, row, joint->body[1], 1, -1);
        add_term(net, row, joint->body[0], -1, -1);
    }
    return true;
}

const YkTrainRow *yk_train_mesh_row(const YkTrainNet *net, int32_t mesh)
{
    return &net->rows[mesh]; // meshes come first
}

bool yk_train_net_build(YkTrainNet *net, const YkModel *model, YkArena *arena)
{
    *net = (YkTrainNet){.model = model, .arena = arena};
    net->mesh_count = (int32_t)(model->gear_count + model->belt_count + model->rack_count);
    net->column_of = YK_NEW(arena, int32_t, model->body_count);
    if (!net->column_of) return false;
    for (size_t b = 0; b < model->body_count; b++) net->column_of[b] = -1;
    take_wheels(net);
    take_locked(net);
    take_followers(net);
    return number_columns(net) && name_symbols(net) && write_rows(net);
}

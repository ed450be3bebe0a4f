// Solves one case of a train, its equations under a lock and with inputs, and says what is wrong if it has no solution.
#include <string.h>
#include "design/trains/train.h"

enum { NAMES_SHOWN = 12 };

const char *yk_train_keep(YkArena *arena, YkText *text)
{
    const char *copy = yk_arena_copy(arena, yk_text_get(text), text->length);
    yk_text_free(text);
    return copy;
}

YkFraction yk_train_coefficient(const YkTrainNet *net, const YkTrainRow *row, int32_t term)
{
    const YkTrainTerm *t = &row->terms[term];
    if (t->symbol < 0) return yk_fraction(t->sign, 1);
    return t->sign < 0 ? yk_fraction_negative(&net->symbols[t->symbol].value) : net->symbols[t->symbol].value;
}

// --- Rows

static YkTrainRow *new_row(YkTrainCase *one, YkTrainRowKind kind, size_t index)
{
    YkTrainRow *row = &one->rows[one->row_count++];
    *row = (YkTrainRow){.kind = kind, .index = (int32_t)index, .input = -1};
    return row;
}

static void add_term(const YkTrainCase *one, YkTrainRow *row, int32_t body, int32_t sign)
{
    row->terms[row->count++] = (YkTrainTerm){one->net->column_of[body], sign, -1};
}

// Adds the rate of a joint's angle or distance: between two bodies, or of a rack. Adds nothing if it has no place in
// the train.
static void add_rate(const YkTrainCase *one, YkTrainRow *row, int32_t index, bool is_distance)
{
    const YkModel *model = one->net->model;
    const YkJoint *joint = &model->joints[index];
    if (!yk_train_has_joint(one->net, index, is_distance)) return;
    if (!is_distance) {
        add_term(one, row, joint->body[1], 1);
        add_term(one, row, joint->body[0], -1);
        return;
    }
    for (size_t r = 0; r < model->rack_count && row->count == 0; r++)
        if (model->racks[r].slide == index)
            row->terms[row->count++] = (YkTrainTerm){one->net->bodies + (int32_t)r, 1, -1};
}

static void add_coordinate(const YkTrainCase *one, YkTrainRow *row, int32_t index)
{
    const YkCoordinate *coordinate = &one->net->model->coordinates[index];
    add_rate(one, row, coordinate->joint, coordinate->is_distance);
}

static void add_lock(YkTrainCase *one)
{
    for (size_t i = 0; one->lock && i < one->lock->hold_count; i++) {
        const YkHold *hold = &one->lock->holds[i];
        YkTrainRow *row = new_row(one, YK_ROW_HOLD, i);
        if (hold->body != YK_NONE) {
            add_term(one, row, hold->body, 1);
        } else {
            add_coordinate(one, row, hold->coordinate); // outside the train: 0 = 0
        }
    }
    for (size_t i = 0; one->lock && i < one->lock->join_count; i++) {
        YkTrainRow *row = new_row(one, YK_ROW_JOIN, i);
        add_term(one, row, one->lock->joins[i][1], 1);
        add_term(one, row, one->lock->joins[i][0], -1);
    }
}

static void add_inputs(YkTrainCase *one, const YkTrainDrive *drives, int32_t count)
{
    for (int32_t i = 0; i < count; i++) {
        YkTrainRow *row = new_row(one, YK_ROW_INPUT, (size_t)i);
        row->input = i;
        if (drives[i].is_joint) {
            add_rate(one, row, drives[i].joint, drives[i].shown.is_distance);
        } else if (drives[i].coordinate != YK_NONE) {
            add_coordinate(one, row, drives[i].coordinate);
        } else {
            add_term(one, row, drives[i].body, 1);
        }
    }
}

static bool write_rows(YkTrainCase *one, const YkTrainDrive *drives, int32_t drive_count, YkArena *arena)
{
    size_t count = (size_t)one->net->row_count + (size_t)drive_count;
    if (one->lock) count += one->lock->hold_count + one->lock->join_count;
    one->rows = YK_NEW(arena, YkTrainRow, count + 1);
    if (!one->rows) return false;
    memcpy(one->rows, one->net->rows, (size_t)one->net->row_count * sizeof *one->rows);
    one->row_count = one->net->row_count;
    add_lock(one);
    add_inputs(one, drives, drive_count);
    return true;
}

// --- Solution

// Solves the rows. With traces, each row has one more right-hand side: which rows a reduced row was made of.
static bool solve(const YkTrainCase *one, YkExactSystem *system, bool has_traces)
{
    int32_t rights = one->input_count + (has_traces ? one->row_count : 0);
    if (!yk_exact_new(system, one->row_count, one->net->columns, rights)) return false;
    for (int32_t r = 0; r < one->row_count; r++) {
        const YkTrainRow *row = &one->rows[r];
        for (int32_t t = 0; t < row->count; t++) {
            YkFraction *cell = yk_exact_cell(system, r, row->terms[t].column);
            YkFraction by = yk_train_coefficient(one->net, row, t);
            *cell = yk_fraction_add(cell, &by, &system->overflow);
        }
        if (row->input >= 0) *yk_exact_cell(system, r, one->net->columns + row->input) = yk_fraction(1, 1);
        if (has_traces) *yk_exact_cell(system, r, one->net->columns + one->input_count + r) = yk_fraction(1, 1);
    }
    yk_exact_reduce(system);
    return true;
}

// --- Words

static void add_row_name(const YkTrainCase *one, const YkTrainRow *row, YkText *text)
{
    const YkModel *model = one->net->model;
    switch (row->kind) {
    case YK_ROW_GROUND:
        yk_text_puts(text, "the ground");
        break;
    case YK_ROW_KEPT:
        yk_text_format(text, "joint %q", model->joints[row->index].name);
        break;
    case YK_ROW_GEARS:
        yk_text_format(text, "gears %q", model->gears[row->index].name);
        break;
    case YK_ROW_BELT:
        yk_text_format(text, "belt %q", model->belts[row->index].name);
        break;
    case YK_ROW_RACK:
        yk_text_format(text, "rack %q", model->racks[row->index].name);
        break;
    case YK_ROW_HOLD: {
        const YkHold *hold = &one->lock->holds[row->index];
        yk_text_format(text, "the hold of %q",
                       hold->body != YK_NONE ? model->bodies[hold->body].name
                                             : model->coordinates[hold->coordinate].name);
        break;
    }
    case YK_ROW_JOIN:
        yk_text_format(text, "the join of %q and %q", model->bodies[one->lock->joins[row->index][0]].name,
                       model->bodies[one->lock->joins[row->index][1]].name);
        break;
    case YK_ROW_INPUT:
        yk_text_puts(text, "a drive");
        break;
    }
}

static void name_row(const YkTrainCase *one, const YkTrainDrive *drives, const YkTrainRow *row, YkText *text)
{
    if (row->kind == YK_ROW_INPUT) {
        yk_text_format(text, "the drive of %q", drives[row->index].shown.name);
    } else {
        add_row_name(one, row, text);
    }
}

static void join(YkText *text, int32_t index, int32_t count)
{
    if (index > 0) yk_text_puts(text, index + 1 == count ? " and " : ", ");
}

// Returns whether a row without unknowns says 0 = something at the drives' speeds; drives may repeat each other or
// stand.
static bool is_contradiction(const YkExactSystem *system, const YkTrainDrive *drives, int32_t drive_count, int32_t row)
{
    YkFraction sum = yk_fraction(0, 1);
    YkOverflow overflow = false;
    int32_t pi = 0;
    for (int32_t k = 0; k < drive_count; k++) {
        const YkFraction *by = yk_exact_cell(system, row, system->columns + k);
        const YkExact *speed = &drives[k].exact;
        if (yk_fraction_is_zero(by) || (speed->is_exact && speed->numerator == 0)) continue;
        if (!speed->is_exact || (!yk_fraction_is_zero(&sum) && speed->pi != pi)) return true;
        YkFraction part = yk_fraction(speed->numerator, speed->denominator);
        part = yk_fraction_multiply(&part, by, &overflow);
        sum = yk_fraction_add(&sum, &part, &overflow);
        pi = speed->pi;
    }
    return overflow || !yk_fraction_is_zero(&sum);
}

static int32_t find_contradiction(const YkExactSystem *system, const YkTrainDrive *drives, int32_t drive_count)
{
    for (int32_t r = 0; r < system->rows; r++)
        if (system->pivot_column[r] < 0 && is_contradiction(system, drives, drive_count, r)) return r;
    return -1;
}

// Says which rows contradict each other: those that combine to 0 = something.
static const char *tell_contradiction(const YkTrainCase *one, const YkTrainDrive *drives, YkArena *arena)
{
    YkExactSystem system;
    YkText text = {0};
    int32_t count = 0, shown = 0, columns = one->net->columns;
    if (!solve(one, &system, true)) return NULL;
    int32_t row = find_contradiction(&system, drives, one->input_count);
    for (int pass = 0; pass < 2 && row >= 0; pass++) {
        for (int32_t r = 0; r < one->row_count && shown < NAMES_SHOWN; r++) {
            if (one->rows[r].kind == YK_ROW_GROUND) continue;
            if (yk_fraction_is_zero(yk_exact_cell(&system, row, columns + one->input_count + r))) continue;
            if (pass == 0) {
                count++;
                continue;
            }
            join(&text, shown++, count);
            name_row(one, drives, &one->rows[r], &text);
        }
    }
    if (count > shown) yk_text_puts(&text, " and more");
    yk_text_puts(&text,
                 count == 1 ? " asks for motion where there is none" : " contradict each other: the train is locked");
    yk_exact_free(&system);
    return yk_train_keep(arena, &text);
}

static const char *tell_open(const YkTrainCase *one, int32_t open, YkArena *arena)
{
    YkText text = {0};
    int32_t shown = 0, freedoms = one->net->columns - one->system.rank;
    yk_text_puts(&text, open == 1 ? "the speed of " : "the speeds of ");
    for (int32_t c = 0; c < one->net->bodies && shown < NAMES_SHOWN; c++) {
        if (yk_exact_is_determined(&one->system, c)) continue;
        join(&text, shown++, open);
        yk_text_format(&text, "%q", one->net->model->bodies[one->net->body_of[c]].name);
    }
    if (open > shown) yk_text_format(&text, " and %d more", (int)(open - shown));
    yk_text_format(&text, " %s open: %d more %s needed, by a drive or a lock", open == 1 ? "stays" : "stay",
                   (int)freedoms, freedoms == 1 ? "condition is" : "conditions are");
    return yk_train_keep(arena, &text);
}

static bool judge(YkTrainCase *one, const YkTrainDrive *drives, YkArena *arena)
{
    int32_t open = 0;
    one->message = "";
    one->status = YK_TRAIN_STATUS_OK;
    if (one->system.overflow) return false;
    if (find_contradiction(&one->system, drives, one->input_count) >= 0) {
        one->status = YK_TRAIN_STATUS_LOCKED;
        one->message = tell_contradiction(one, drives, arena);
        return one->message != NULL;
    }
    for (int32_t c = 0; c < one->net->bodies; c++) open += !yk_exact_is_determined(&one->system, c);
    if (open == 0) return true;
    one->status = one->input_count > 0 ? YK_TRAIN_STATUS_UNDETERMINED : YK_TRAIN_STATUS_FREE;
    one->message = tell_open(one, open, arena);
    return one->message != NULL;
}

bool yk_train_case_solve(YkTrainCase *one, const YkTrainNet *net, const YkLock *lock, const YkTrainDrive *drives,
                         int32_t drive_count, YkArena *arena)
{
    *one = (YkTrainCase){.net = net, .lock = lock, .input_count = drive_count};
    return write_rows(one, drives, drive_count, arena) && solve(one, &one->system, false) && judge(one, drives, arena);
}

void yk_train_case_free(YkTrainCase *one)
{
    yk_exact_free(&one->system);
}

const YkFraction *yk_train_case_share(const YkTrainCase *one, int32_t column, int32_t input)
{
    return yk_exact_cell(&one->system, one->system.pivot_row[column], one->net->columns + input);
}

int yk_train_case_freedom(const YkTrainCase *one)
{
    return (int)(one->net->columns - one->system.rank);
}

bool yk_train_has_joint(const YkTrainNet *net, int32_t index, bool is_distance)
{
    const YkJoint *joint = &net->model->joints[index];
    for (size_t r = 0; is_distance && r < net->model->rack_count; r++)
        if (net->model->racks[r].slide == index) return true;
    bool is_member = net->column_of[joint->body[0]] > 0 || net->column_of[joint->body[1]] > 0;
    return !is_distance && is_member && net->column_of[joint->body[0]] >= 0 && net->column_of[joint->body[1]] >= 0;
}

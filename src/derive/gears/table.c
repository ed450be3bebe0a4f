// Writes the tabular method in symbols: the wheels on one carrier, turned while it stands, then all together.
#include "derive/gears/gears.h"
#include "derive/page.h"

enum { COLUMNS_SHOWN_MAX = 12, ROWS = 3 };

typedef struct Table {
    YkDerivation *d;
    YkPage *page;
    const YkTrainGroup *group;
    const YkPoisson *x, *y;
    const YkPoisson **turns; // per wheel, for one turn of the first
} Table;

// Steps across a mesh: turn * -(coefficient on this side) / (coefficient on the other).
static bool find_turns(Table *table)
{
    YkDerivation *d = table->d;
    const YkTrainGroup *group = table->group;
    table->turns = YK_NEW(table->page->arena, const YkPoisson *, (size_t)group->count);
    for (int32_t k = 0; table->turns && k < group->count; k++) {
        const struct YkTrainStep *step = &group->step[k];
        table->turns[k] = yk_ring_rational(d->ring, 1, 1);
        if (step->from < 0) continue;
        const YkTrainRow *row = yk_train_mesh_row(&d->train->train->net, step->mesh);
        const YkPoisson *from = yk_derive_coefficient(d, &row->terms[step->side]),
                        *to = yk_derive_coefficient(d, &row->terms[1 - step->side]);
        const YkPoisson *turn = yk_ring_multiply(d->ring, table->turns[step->from], from);
        table->turns[k] = yk_ring_negate(d->ring, yk_ring_divide(d->ring, turn, to));
    }
    return table->turns != NULL;
}

static const YkPoisson *speed_of(const Table *table, int32_t wheel)
{
    return yk_derive_speed(table->d, table->group->body[wheel]);
}

static const YkPoisson *turned(const Table *table, int32_t wheel)
{
    return yk_ring_multiply(table->d->ring, table->turns[wheel], table->x);
}

// Says which wheel is in which column.
static void put_columns(const Table *table)
{
    const YkModel *model = table->d->model;
    YkText text = {0};
    yk_text_format(&text, "Columns: %s", model->bodies[table->group->carrier].name);
    for (int32_t k = 0; k < table->group->count; k++)
        yk_text_format(&text, ", %s", model->bodies[table->group->body[k]].name);
    yk_text_format(&text, ". Rows: %s stands and %s turns once; times x; plus y.",
                   model->bodies[table->group->carrier].name, model->bodies[table->group->body[0]].name);
    yk_page_words(table->page, "%s", yk_text_get(&text));
    table->page->failed |= text.failed;
    yk_text_free(&text);
}

static void put_rows(const Table *table)
{
    YkDerivation *d = table->d;
    size_t width = (size_t)table->group->count + 1;
    put_columns(table);
    YkShownMatrix *matrix = yk_line_matrix(table->page, yk_page_formula(table->page, NULL), ROWS, width);
    if (!matrix) return;
    matrix->entries[2 * width] = table->y;
    for (int32_t k = 0; k < table->group->count; k++) {
        size_t column = (size_t)k + 1;
        matrix->entries[column] = table->turns[k];
        matrix->entries[width + column] = turned(table, k);
        matrix->entries[2 * width + column] = yk_ring_add(d->ring, turned(table, k), table->y);
    }
}

// Writes y and x in terms of the speeds, and every wheel in terms of y and x.
static void put_conditions(const Table *table)
{
    YkRing *ring = table->d->ring;
    yk_page_equation(table->page, NULL, yk_derive_speed(table->d, (size_t)table->group->carrier), table->y,
                     YK_RING_TEXTBOOK);
    for (int32_t k = 0; k < table->group->count; k++)
        yk_page_equation(table->page, NULL, speed_of(table, k), yk_ring_add(ring, turned(table, k), table->y),
                         YK_RING_TEXTBOOK);
}

// Enters the unknowns of the method: y is the carrier's speed, x that of the first wheel against it.
static const YkPoisson *enter(YkDerivation *d, const char *name, size_t number, const YkPoisson *meaning)
{
    YkText text = {0};
    yk_text_format(&text, d->train->train->group_count > 1 ? "%s%z" : "%s", name, number);
    int32_t symbol = yk_ring_find(d->ring, yk_text_get(&text));
    bool is_ours = false; // from an earlier page
    for (size_t k = d->change_count - d->definition_count; k < d->change_count; k++)
        is_ours |= symbol >= 0 && d->changes[k].symbol == symbol;
    if (!is_ours) symbol = yk_derive_symbol(d, yk_text_get(&text), YK_RING_RATE);
    yk_text_free(&text);
    if (!is_ours && !yk_derive_define(d, symbol, meaning)) return NULL;
    return yk_ring_of(d->ring, symbol);
}

static void put_table(YkDerivation *d, YkPage *page, size_t number)
{
    const YkTrainGroup *group = &d->train->train->groups[number];
    Table table = {.d = d, .page = page, .group = group};
    YkText title = {0};
    yk_text_format(&title, "Tabular method on %s", d->model->bodies[group->carrier].name);
    yk_page_heading(page, 2, yk_text_get(&title));
    yk_text_free(&title);
    const YkPoisson *carrier = yk_derive_speed(d, (size_t)group->carrier);
    table.x = enter(d, "x", number + 1, yk_ring_subtract(d->ring, yk_derive_speed(d, group->body[0]), carrier));
    table.y = enter(d, "y", number + 1, carrier);
    if (!table.x || !table.y || !find_turns(&table)) return;
    if (group->count <= COLUMNS_SHOWN_MAX) put_rows(&table);
    put_conditions(&table);
}

void yk_derive_put_tables(YkDerivation *d, YkPage *page)
{
    const YkTrain *train = d->train->train;
    for (size_t g = 0; g < train->group_count; g++)
        if (d->speeds[train->groups[g].carrier] >= 0) put_table(d, page, g);
}

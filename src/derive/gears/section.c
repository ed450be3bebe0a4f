// Section: gear trains - each mesh, the system, speeds as formulas in numbers of teeth, the tabular method.
#include "derive/gears/gears.h"
#include "derive/sections.h"

enum { SYSTEM_SHOWN_MAX = 12 };

// Writes the names of teeth and radii that are not parameters of the file.
static void put_names(YkDerivation *d, YkPage *page)
{
    const YkDeriveTrain *train = d->train;
    const YkTrainNet *net = &train->train->net;
    for (size_t b = 1; b < d->model->body_count; b++) {
        if (d->speeds[b] < 0) continue;
        const YkPoisson *speed = yk_derive_speed(d, b);
        bool is_new = true;
        for (size_t k = 1; k < b; k++) is_new &= d->speeds[k] != d->speeds[b];
        if (is_new)
            yk_page_equation(page, d->model->bodies[b].name, speed, yk_derive_in_joints(d, speed), YK_RING_TEXTBOOK);
    }
    for (int32_t s = 0; s < net->symbol_count; s++) {
        const YkPoisson *meaning = yk_derive_in_joints(d, train->symbols[s]);
        if (yk_ring_is_same(meaning, train->symbols[s])) continue;
        yk_page_equation(page, NULL, train->symbols[s], meaning, YK_RING_TEXTBOOK);
    }
}

// Collects the speeds that are not given, each symbol once.
static size_t unknown_symbols(YkDerivation *d, int32_t *unknowns)
{
    const YkTrainNet *net = &d->train->train->net;
    size_t count = 0;
    for (int32_t c = 1; c < net->columns; c++) {
        int32_t symbol = yk_derive_column_symbol(d, c);
        bool is_known = symbol < 0 || yk_derive_is_input(d, c);
        for (size_t k = 0; k < count && !is_known; k++) is_known = unknowns[k] == symbol;
        if (!is_known) unknowns[count++] = symbol;
    }
    return count;
}

// Collects all other rows: those of meshes, of slides that close loops, of inputs between two bodies.
static size_t collect_rows(YkDerivation *d, const YkPoisson **zeros)
{
    const YkTrainCase *motion = &d->train->motion;
    size_t count = 0;
    for (int32_t r = 0; r < motion->row_count; r++) {
        const YkTrainRow *row = &motion->rows[r];
        const YkPoisson *zero = yk_derive_row_zero(d, row);
        if (row->input >= 0) zero = yk_ring_subtract(d->ring, zero, d->train->input_rates[row->input]);
        if (!yk_ring_is_zero(zero)) zeros[count++] = zero;
    }
    return count;
}

// Writes the system with unknown speeds on the left and given ones on the right.
static void put_system(YkDerivation *d, YkPage *page)
{
    const YkTrainNet *net = &d->train->train->net;
    const YkPoisson **zeros = YK_NEW(page->arena, const YkPoisson *, (size_t)d->train->motion.row_count + 1);
    int32_t *unknowns = YK_NEW(page->arena, int32_t, (size_t)net->columns + 1);
    if (!zeros || !unknowns) return;
    size_t rows = collect_rows(d, zeros), columns = unknown_symbols(d, unknowns);
    if (rows == 0 || columns == 0 || rows > SYSTEM_SHOWN_MAX || columns > SYSTEM_SHOWN_MAX) return;
    yk_page_heading(page, 2, "The system");
    YkLine *line = yk_page_formula(page, NULL);
    YkShownMatrix *A = yk_line_matrix(page, line, rows, columns), *x = yk_line_matrix(page, line, columns, 1);
    yk_line_sign(page, line, "=");
    YkShownMatrix *b = yk_line_matrix(page, line, rows, 1);
    if (!A || !x || !b) return;
    for (size_t k = 0; k < columns; k++) x->entries[k] = yk_ring_of(d->ring, unknowns[k]);
    for (size_t r = 0; r < rows; r++) {
        const YkPoisson *rest = zeros[r];
        for (size_t k = 0; k < columns; k++) {
            const YkPoisson *entry = yk_ring_coefficient(d->ring, zeros[r], unknowns[k], 1);
            A->entries[r * columns + k] = entry;
            rest = yk_ring_subtract(d->ring, rest, yk_ring_multiply(d->ring, entry, x->entries[k]));
        }
        b->entries[r] = yk_ring_negate(d->ring, rest);
    }
}

bool yk_derive_section_gears(YkDerivation *d, YkPage *page)
{
    const YkDeriveTrain *train = yk_derive_train(d);
    if (!train) {
        bool has_train = d->model->gear_count + d->model->belt_count + d->model->rack_count > 0;
        yk_page_words(page, has_train ? "The train's exact ratios are too large to be written."
                                      : "The machine has no gears, racks or belts.");
        return !d->failed;
    }
    yk_page_words(page, "omega is a body's angular speed against the ground, counter-clockwise.");
    put_names(d, page);
    for (size_t m = 0; m < yk_train_mesh_count(train->train); m++) yk_derive_put_mesh(d, page, m);
    put_system(d, page);
    yk_derive_put_speeds(d, page);
    yk_derive_put_shifts(d, page);
    yk_derive_put_tables(d, page);
    return true;
}

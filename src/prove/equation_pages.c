// Finds names that only sections have, on their pages: p4 of Lagrange's lumped constants, k_s of the influence
// coefficients, h1, beta1, u1 of a motion program, x and y of the tabular method, so that equations can be copied from
// a page.
#include "derive/blocks.h"
#include "derive/forces/free_bodies.h"
#include "prove/equation.h"

enum { BODIES_MAX = 100 }; // pages of large machines take time

// A line of a page that holds only in a segment.
typedef struct Line {
    const YkPoisson *left, *right, *within;
    int32_t solved;
} Line;

struct YkDerivePages {
    size_t first; // the first symbol that pages added
    Line *lines;
    size_t line_count;
};

static size_t count_lines(const YkPage *page)
{
    size_t count = 0;
    for (const YkLine *line = page->first; line; line = line->next) count += line->within != NULL;
    return count;
}

static void keep_lines(struct YkDerivePages *pages, const YkPage *page, YkArena *arena)
{
    pages->lines = YK_NEW(arena, Line, count_lines(page) + 1);
    for (const YkLine *line = page->first; line && pages->lines; line = line->next)
        if (line->within)
            pages->lines[pages->line_count++] = (Line){line->left, line->right, line->within, line->solved};
}

static void write_pages(YkDerivation *d, struct YkDerivePages *pages)
{
    YkPage page = {.arena = yk_arena_new(), .ring = d->ring};
    bool good = page.arena != NULL;
    for (size_t k = 0; yk_derive_sections[k].name && good; k++)
        if (!yk_derive_sections[k].is_of || yk_derive_sections[k].is_of(d->model)) {
            yk_derive_write(d, k, &page);
            yk_ring_clear(d->ring); // what a section cannot write does not matter here
        }
    if (good) keep_lines(pages, &page, d->arena);
    yk_arena_free(page.arena);
}

static void enter_pages(YkDerivation *d)
{
    struct YkDerivePages *pages = d->pages ? NULL : YK_NEW(d->arena, struct YkDerivePages, 1);
    if (!pages || d->model->body_count > BODIES_MAX) return;
    d->pages = pages;
    pages->first = yk_ring_symbol_count(d->ring);
    write_pages(d, pages);
}

// --- The meaning of a page's name

static const YkForm *influence(YkDerivation *d, int32_t symbol)
{
    const YkDeriveBlocks *blocks = d->influence ? d->blocks : NULL;
    for (size_t k = 1; blocks && k < blocks->column_count; k++) {
        int32_t c = blocks->column_order[k];
        if (d->influence[c] != symbol) continue;
        const YkPoisson *of = yk_ring_of(d->ring, d->coordinates[c].rate);
        const YkPoisson *by = yk_ring_of(d->ring, d->coordinates[blocks->column_order[0]].rate);
        const YkForm *over = yk_form_of(d->ring, of);
        return yk_form_divide(d->ring, over, yk_form_of(d->ring, by));
    }
    return NULL;
}

static const YkForm *lump(YkDerivation *d, int32_t symbol)
{
    const YkDeriveForces *f = yk_derive_forces(d);
    for (const YkDeriveLump *l = f ? f->lumps[0] : NULL; l; l = l->next)
        if (l->symbol == symbol) return yk_form_of(d->ring, l->value);
    return NULL;
}

const YkForm *yk_equation_meaning(YkDerivation *d, int32_t symbol)
{
    const YkForm *meaning = influence(d, symbol);
    if (!meaning) meaning = lump(d, symbol);
    return meaning ? meaning : yk_form_of(d->ring, yk_ring_of(d->ring, symbol));
}

int32_t yk_equation_find(YkDerivation *d, const char *name)
{
    int32_t symbol = yk_ring_find(d->ring, name);
    if (symbol >= 0 || d->pages) return symbol;
    enter_pages(d);
    return yk_ring_find(d->ring, name);
}

// --- Where an equation of a segment holds

static bool is_same(const YkPoisson *a, const YkPoisson *b)
{
    return a == b || yk_ring_is_same(a, b);
}

bool yk_equation_speaks_of(const YkDerivation *d, const YkForm *form, int32_t symbol)
{
    const YkPoisson *a = yk_form_element(form);
    if (a) return yk_equation_mentions(d, a, symbol);
    for (size_t k = 0; k < yk_form_part_count(form); k++)
        if (yk_equation_speaks_of(d, yk_form_part(form, k), symbol)) return true;
    return false;
}

size_t yk_equation_segments(YkDerivation *d, const YkEquation *equation, const YkPoisson **within, size_t most)
{
    enum { TERMS_MAX = 500 };
    YkRing *ring = d->ring;
    size_t count = 0;
    if (!d->pages || d->pages->line_count == 0) return 0;
    const YkPoisson *left = yk_form_expand(ring, equation->left, TERMS_MAX),
                    *right = yk_form_expand(ring, equation->right, TERMS_MAX);
    yk_ring_clear(ring);
    for (size_t k = 0; k < d->pages->line_count && count < most; k++) {
        const Line *line = &d->pages->lines[k];
        bool is_it = line->left && left && right && is_same(line->left, left) && is_same(line->right, right);
        bool speaks = line->solved >= 0 && (yk_equation_speaks_of(d, equation->left, line->solved) ||
                                            yk_equation_speaks_of(d, equation->right, line->solved));
        if (is_it || speaks) within[count++] = line->within;
    }
    return count;
}

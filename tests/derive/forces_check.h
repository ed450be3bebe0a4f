// Shared by the tests of forces in symbols: a machine with the numeric engine's accelerations and reactions at random
// poses.
#ifndef TESTS_DERIVE_FORCES_CHECK_H
#define TESTS_DERIVE_FORCES_CHECK_H
#include "derive/forces/free_bodies.h"
#include "derive/forces/newton_euler.h"
#include "derive_check.h"

// Values at the pose of the state, forces included.
static inline bool take_forces(Machine *m, YkDynamics *dynamics, YkMethod method)
{
    YkStatus status = yk_dynamics_solve(dynamics, m->state, method);
    if ((status != YK_OK && status != YK_REDUNDANT) || !yk_state_has_rates(m->state)) return false;
    free(m->values);
    m->values = calloc(yk_ring_symbol_count(m->d->ring) + 64, sizeof *m->values);
    assert_non_null(m->values);
    yk_derive_values(m->d, m->state, dynamics, m->values);
    return true;
}

static inline YkDynamics *dynamics_of(Machine *m)
{
    YkDynamics *dynamics = yk_dynamics_new(m->mech, m->problems);
    assert_non_null(dynamics);
    return dynamics;
}

// What the element comes to when every symbol is a little off: the measure for rounding.
static inline double magnitude(Machine *m, const YkPoisson *a)
{
    size_t count = yk_ring_symbol_count(m->d->ring);
    double *values = calloc(count + 64, sizeof *values), most = 0;
    assert_non_null(values);
    for (int k = 0; k < 4; k++) {
        for (size_t s = 0; s < count; s++)
            values[s] = m->values[s] * check_uniform(&m->seed, 0.5, 1.5) +
                        (yk_ring_is_angle(m->d->ring, (int32_t)s) ? check_uniform(&m->seed, -1, 1) : 0);
        yk_ring_complete(m->d->ring, values);
        YkVec value = yk_ring_value(m->d->ring, a, values);
        if (isfinite(value.x) && isfinite(value.y)) most = fmax(most, hypot(value.x, value.y));
    }
    free(values);
    return most;
}

static inline double at_pose(const Machine *m, const YkPoisson *a)
{
    return yk_ring_value(m->d->ring, a, m->values).x;
}

static inline void check_vanishes(Machine *m, const YkPoisson *a, const char *what, double tolerance)
{
    YkVec value = yk_ring_value(m->d->ring, a, m->values);
    double size = hypot(value.x, value.y), allowed = tolerance * fmax(1e-3, magnitude(m, a));
    if (size <= allowed) return;
    YkText text = {0};
    yk_ring_write(m->d->ring, a, YK_RING_TEXT, YK_RING_TEXTBOOK, &text);
    print_error("%s: %.600s = %g, allowed %g\n", what, yk_text_get(&text), size, allowed);
    yk_text_free(&text);
    fail();
}

// Writes a section and returns how many of its lines state an equation; each is true at the pose.
static inline size_t check_page(Machine *m, const char *what, double tolerance)
{
    size_t count = 0;
    for (const YkLine *line = m->page.first; line; line = line->next) {
        if (!line->left) continue;
        check_vanishes(m, line_vanishes(m->d->ring, line), what, tolerance);
        count++;
    }
    return count;
}

static inline void write_section(Machine *m, const char *section)
{
    if (yk_derive_write(m->d, section_of(section), &m->page)) return;
    print_error("%s: %s\n", section, yk_ring_status_text(yk_ring_status(m->d->ring)));
    fail();
}

// All sections. False where products of the file's decimals are too large to be exact: that is told, not wrong.
static inline bool write_all_sections(Machine *m, uint64_t number)
{
    bool well = yk_derive_forces(m->d) != NULL;
    size_t k = 0;
    for (; yk_derive_sections[k].name && well; k++)
        if (!yk_derive_sections[k].is_of || yk_derive_sections[k].is_of(m->model))
            well = yk_derive_write(m->d, k, &m->page);
    if (well || yk_ring_status(m->d->ring) == YK_RING_OVERFLOW) return well;
    print_error("machine %d, %s: %s\n", (int)number, k ? yk_derive_sections[k - 1].name : "forces",
                yk_ring_status_text(yk_ring_status(m->d->ring)));
    fail();
    return false;
}

// Every element of every line, in every format that reads, comes back as the identical element.
static inline size_t check_read_back(Machine *m, const YkPoisson *a)
{
    static const YkRingFormat formats[] = {YK_RING_TEXT, YK_RING_BOOK, YK_RING_LATEX, YK_RING_C};
    YkRing *ring = m->d->ring;
    for (size_t f = 0; f < sizeof formats / sizeof *formats; f++)
        for (int style = 0; style < YK_RING_STYLES; style++) {
            YkText text = {0};
            assert_true(yk_ring_write(ring, a, formats[f], (YkRingStyle)style, &text));
            const YkPoisson *read =
                yk_ring_read(ring, formats[f], yk_text_get(&text), text.length, (YkPlace){1, 1, 0}, NULL);
            if (!yk_ring_is_same(read, a)) {
                print_error("%s\n", yk_text_get(&text));
                fail();
            }
            yk_text_free(&text);
        }
    return 1;
}

static inline size_t check_page_reads_back(Machine *m)
{
    size_t count = 0;
    for (const YkLine *line = m->page.first; line; line = line->next)
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
            const YkRingView shown = {piece->over, piece->changes, YK_RING_WHOLE};
            if (piece->kind == YK_PIECE_ELEMENT) count += check_read_back(m, yk_ring_view(m->d->ring, &shown));
            for (size_t k = 0; piece->matrix && k < piece->matrix->rows * piece->matrix->columns; k++) {
                const YkRingView entry = yk_shown_entry(piece->matrix, k);
                if (entry.of) count += check_read_back(m, yk_ring_view(m->d->ring, &entry));
            }
        }
    return count;
}

// The page as text holds this.
static inline void check_says(Machine *m, const char *expected)
{
    YkText text = {0};
    assert_true(yk_page_write(&m->page, YK_PAGE_TEXT, "test", NULL, &text));
    if (!strstr(yk_text_get(&text), expected)) {
        print_error("not found: %s\nin\n%s\n", expected, yk_text_get(&text));
        fail();
    }
    yk_text_free(&text);
}

// Machines whose dynamics are proved exactly in the ring.
static const char *const proved_examples[] = {"double-pendulum",
                                              "toggle",
                                              "slider-crank",
                                              "four-bar",
                                              "five-bar-motors",
                                              "cart-pendulum",
                                              "spring-slider-crank",
                                              "quick-return",
                                              "torsion-spring",
                                              "crank-press",
                                              "andrews",
                                              "inverted-slider-crank",
                                              "whitworth-kg",
                                              "rocking-four-bar",
                                              "steam-engine",
                                              "gas-engine",
                                              "watt-with-masses"};
enum { PROVED_EXAMPLES = sizeof proved_examples / sizeof *proved_examples };

static const char *section_read_back;
static size_t elements_read_back;

static inline void read_section_back(Machine *m, const char *name)
{
    (void)name;
    write_section(m, section_read_back);
    elements_read_back += check_page_reads_back(m);
}

// How many elements of this section, in all examples, read back identical in every format.
static inline size_t check_section_reads_back(const char *section)
{
    section_read_back = section;
    elements_read_back = 0;
    each_example(read_section_back);
    return elements_read_back;
}

static inline const YkDeriveForces *forces_of(Machine *m)
{
    const YkDeriveForces *f = yk_derive_forces(m->d);
    if (!f) print_error("%s\n", yk_ring_status_text(yk_ring_status(m->d->ring)));
    assert_non_null(f);
    assert_ptr_equal(f, yk_derive_forces(m->d)); // made once
    return f;
}

// A section's equations at the start and at random poses, by both methods of the engine in turn; counts what was seen.
static inline void check_section_at_poses(Machine *m, const char *section, const char *name, size_t *equations,
                                          size_t *poses)
{
    forces_of(m);
    write_section(m, section);
    YkDynamics *dynamics = dynamics_of(m);
    for (int k = 0; k < 6; k++) {
        if (!random_pose(m, k == 0)) continue;
        if (!take_forces(m, dynamics, k % 2 ? YK_METHOD_NEWTON_EULER : YK_METHOD_REDUCED)) continue;
        *equations += check_page(m, name, 1e-11);
        ++*poses;
    }
    yk_dynamics_free(dynamics);
}

#endif

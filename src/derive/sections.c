// The sections of a derivation. To add one: write it, declare it in sections.h, name it here.
#include "derive/sections.h"
#include <string.h>
#include "derive/printed_code.h"

static bool has_train(const YkModel *model)
{
    return model->gear_count + model->belt_count + model->rack_count > 0;
}

static bool has_laws(const YkModel *model)
{
    return model->law_count > 0;
}

// Sections that `all` leaves out: others have the same equations, in the order in which they are solved.
static bool is_on_request(const YkModel *model)
{
    (void)model;
    return false;
}

const YkDeriveSectionEntry yk_derive_sections[] = {
    {"loops", "Loop equations", yk_derive_section_loops, NULL, false},
    {"jacobian", "Jacobian", yk_derive_section_jacobian, NULL, false},
    {"velocity", "Velocities", yk_derive_section_velocity, NULL, false},
    {"acceleration", "Accelerations", yk_derive_section_acceleration, NULL, false},
    {"points", "Points and centres of mass", yk_derive_section_points, NULL, false},
    {"free-bodies", "Free bodies", yk_derive_section_free_bodies, NULL, true},
    {"newton-euler", "Newton-Euler equations", yk_derive_section_newton_euler, NULL, true},
    {"energy", "Energies", yk_derive_section_energy, NULL, true},
    {"lagrange", "Lagrange's equations", yk_derive_section_lagrange, NULL, true},
    {"gears", "Gear trains", yk_derive_section_gears, has_train, false},
    {"cam", "Motion programs and cams", yk_derive_section_cam, has_laws, false},
    {"centers", "Instant centres", yk_derive_section_centers, is_on_request, false},
    {"polygons", "Polygons", yk_derive_section_polygons, is_on_request, true},
    {NULL, NULL, NULL, NULL, false},
};

size_t yk_derivation_section_count(void)
{
    return sizeof yk_derive_sections / sizeof *yk_derive_sections - 1;
}

const char *yk_derivation_section_name(size_t section)
{
    return section < yk_derivation_section_count() ? yk_derive_sections[section].name : NULL;
}

const char *yk_derivation_section_title(size_t section)
{
    return section < yk_derivation_section_count() ? yk_derive_sections[section].title : NULL;
}

size_t yk_derivation_section_find(const char *name)
{
    for (size_t k = 0; yk_derive_sections[k].name; k++)
        if (strcmp(yk_derive_sections[k].name, name) == 0) return k;
    return YK_NOT_FOUND;
}

bool yk_derivation_has_section(const YkDerivation *d, size_t section)
{
    if (section >= yk_derivation_section_count()) return false;
    return !yk_derive_sections[section].is_of || yk_derive_sections[section].is_of(d->model);
}

bool yk_derive_write(YkDerivation *d, size_t section, YkPage *page)
{
    const YkDeriveSectionEntry *entry = &yk_derive_sections[section];
    if (yk_derivation_ran_out(d)) return false; // what is missing stays missing
    page->section = entry->name;
    page->define = yk_derive_define_bodies;
    page->define_context = d;
    yk_page_heading(page, 1, entry->title);
    bool is_written = entry->write(d, page);
    yk_derive_put_constants(d, page, false);
    if (entry->has_masses) yk_derive_put_constants(d, page, true);
    return is_written && !page->failed && !yk_arena_failed(page->arena) && yk_derivation_is_well(d);
}

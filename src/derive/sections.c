// The sections of a derivation. To add one: write it, declare it in sections.h, name it here.
#include "derive/sections.h"
#include "derive/code.h"

const YkDeriveSectionEntry yk_derive_sections[] = {
    {"loops", "Loop equations", yk_derive_section_loops},
    {"jacobian", "Jacobian", yk_derive_section_jacobian},
    {"velocity", "Velocities", yk_derive_section_velocity},
    {"acceleration", "Accelerations", yk_derive_section_acceleration},
    {"points", "Points and centres of mass", yk_derive_section_points},
    {"free-bodies", "Free bodies", yk_derive_section_free_bodies},
    {"newton-euler", "Newton-Euler equations", yk_derive_section_newton_euler},
    {"energy", "Energies", yk_derive_section_energy},
    {"lagrange", "Lagrange's equations", yk_derive_section_lagrange},
    {"gears", "Gear trains", yk_derive_section_gears},
    {"cam", "Cams", NULL},
    {NULL, NULL, NULL},
};

bool yk_derive_write(YkDerivation *d, size_t section, YkPage *page)
{
    const YkDeriveSectionEntry *entry = &yk_derive_sections[section];
    page->section = entry->name;
    page->define = yk_derive_define_bodies;
    page->define_context = d;
    yk_page_heading(page, 1, entry->title);
    if (!entry->write) {
        yk_page_words(page, "This part is not derived in this version yet.");
        return !page->failed;
    }
    return entry->write(d, page) && !page->failed && yk_derivation_is_well(d);
}

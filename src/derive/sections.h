// The sections, one file each; sections.c lists them.
#ifndef DERIVE_SECTIONS_H
#define DERIVE_SECTIONS_H
#include "derive/derive.h"

bool yk_derive_section_loops(YkDerivation *d, YkPage *page);
bool yk_derive_section_jacobian(YkDerivation *d, YkPage *page);
bool yk_derive_section_velocity(YkDerivation *d, YkPage *page);
bool yk_derive_section_acceleration(YkDerivation *d, YkPage *page);
bool yk_derive_section_points(YkDerivation *d, YkPage *page);
bool yk_derive_section_free_bodies(YkDerivation *d, YkPage *page);
bool yk_derive_section_newton_euler(YkDerivation *d, YkPage *page);
bool yk_derive_section_energy(YkDerivation *d, YkPage *page);
bool yk_derive_section_lagrange(YkDerivation *d, YkPage *page);
bool yk_derive_section_gears(YkDerivation *d, YkPage *page);
bool yk_derive_section_cam(YkDerivation *d, YkPage *page);
bool yk_derive_section_centers(YkDerivation *d, YkPage *page);
bool yk_derive_section_polygons(YkDerivation *d, YkPage *page);
bool yk_derive_put_force_polygons(YkDerivation *d, YkPage *page); // a part of it: forces/polygons.c

#endif

// Every part of the catalogue, one file each.
#ifndef PART_PARTS_H
#define PART_PARTS_H
#include "part/part.h"

extern const YkPart yk_part_pin, yk_part_slide, yk_part_pin_slot, yk_part_weld, yk_part_free;

#endif

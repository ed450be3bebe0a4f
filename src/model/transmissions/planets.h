// Planets that share a load, between the files that find them and that count the copies' masses.
#ifndef MODEL_TRANSMISSIONS_PLANETS_H
#define MODEL_TRANSMISSIONS_PLANETS_H
#include "model/load.h"

typedef struct YkPlanet { // of a body
    int32_t copies;       // 0: no planet
    int32_t joint, side;  // its pin, and which body of it the planet is
    int32_t axis;         // a point of the carrier on the axis, or YK_NONE for its origin; YK_REPORTED: not known
    const char *why;      // the planets cannot share; with %q for the body
} YkPlanet;

// Counts the inertia of all copies of a planet, the friction of their pins and, as a body that is welded to the
// carrier, the masses of the other copies. Sets loader->failed when out of memory.
void yk_load_copy_planet(YkLoader *loader, const YkPlanet *planet, int32_t body);

#endif

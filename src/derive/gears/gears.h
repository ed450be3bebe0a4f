// Gear trains in symbols: what the sections and the check share. The equations, shares and tables are those of
// design/train, in the derivation's ring with its own names for angular speeds and numbers of teeth.
#ifndef DERIVE_GEARS_GEARS_H
#define DERIVE_GEARS_GEARS_H
#include "derive/derive.h"
#include "design/trains/train.h"

typedef struct YkDeriveTrain {
    YkTrain *train;            // as in `yoke gears`
    const YkPoisson **symbols; // per symbol of the net: a number of teeth, or a radius
    YkTrainCase motion;        // solved for the inputs
    YkTrainDrive *inputs;      // rates of joints: those that the machine takes as given first, then as many as it needs
    const YkPoisson **input_rates;
    int32_t input_count;
} YkDeriveTrain;

// The train, made at first use, and the speeds omega1 or omega_planet of its bodies. Returns NULL if the machine has
// no gears, racks or belts, or if they are beyond exact numbers.
const YkDeriveTrain *yk_derive_train(YkDerivation *d);
void yk_derive_train_free(struct YkDeriveTrain *train);

// Returns a body's angular speed: omega4 if the train names it, otherwise its rate; 0 if it never turns.
const YkPoisson *yk_derive_speed(YkDerivation *d, size_t body);
// Does the same for a column of the net: a body's speed, or the rate of a rack's slide.
const YkPoisson *yk_derive_column(YkDerivation *d, int32_t column);
int32_t yk_derive_column_symbol(const YkDerivation *d, int32_t column); // -1: it stands
bool yk_derive_is_input(YkDerivation *d, int32_t column);
// Returns the sum of factor * speed of a row of the case, which is 0 (or an input).
const YkPoisson *yk_derive_row_zero(YkDerivation *d, const YkTrainRow *row);
// Returns a term's factor: sign * teeth.
const YkPoisson *yk_derive_coefficient(YkDerivation *d, const YkTrainTerm *term);

// Parts of the section: the meshes one by one (pitch.c), speeds as formulas (speeds.c), the tabular method (table.c).
void yk_derive_put_mesh(YkDerivation *d, YkPage *page, size_t mesh);
void yk_derive_put_speeds(YkDerivation *d, YkPage *page);
void yk_derive_put_shifts(YkDerivation *d, YkPage *page);
void yk_derive_put_tables(YkDerivation *d, YkPage *page);

#endif

// The equations of Alt's problem in discs, with twice the precision.
#include "synthesis/nine_points/alt_disc.h"
#include "synthesis/nine_points/alt.h"

enum { N = YK_ALT_SIZE };

typedef struct Line {
    YkDisc u, v, w;
} Line;

static Line line_of(YkDisc d, YkDisc hat, const YkDisc *x)
{
    YkDisc off = yk_disc_sub(x[YK_ALT_X], x[YK_ALT_A]), off_hat = yk_disc_sub(x[YK_ALT_X_HAT], x[YK_ALT_A_HAT]);
    Line line;
    line.u = yk_disc_mul(yk_disc_sub(hat, x[YK_ALT_A_HAT]), x[YK_ALT_X]);
    line.v = yk_disc_mul(yk_disc_sub(d, x[YK_ALT_A]), x[YK_ALT_X_HAT]);
    line.w = yk_disc_add_product(yk_disc_add_product(yk_disc_mul(d, off_hat), hat, off), d, hat);
    return line;
}

// As in alt_system.c.
static Line gradient(const Line *other, YkDisc by_D, YkDisc by_G, YkDisc by_H)
{
    Line g;
    g.u = yk_disc_determinant(by_D, by_H, other->w, other->v);
    g.v = yk_disc_determinant(by_G, by_D, other->u, other->w);
    g.w = yk_disc_determinant(by_H, by_G, other->v, other->u);
    return g;
}

static void fill_row(YkDisc d, YkDisc hat, const YkDisc *x, const Line *by, bool is_second, YkDisc *row)
{
    YkDisc along = yk_disc_mul(by->w, hat), along_hat = yk_disc_mul(by->w, d);
    row[YK_ALT_X] = yk_disc_add_product(along, by->u, yk_disc_sub(hat, x[YK_ALT_A_HAT]));
    row[YK_ALT_X_HAT] = yk_disc_add_product(along_hat, by->v, yk_disc_sub(d, x[YK_ALT_A]));
    row[YK_ALT_A] = yk_disc_negate(yk_disc_add_product(along, by->v, x[YK_ALT_X_HAT]));
    row[YK_ALT_A_HAT] = yk_disc_negate(yk_disc_add_product(along_hat, by->u, x[YK_ALT_X]));
    for (size_t k = 0; k < YK_ALT_DYAD && is_second; k++) row[k] = yk_disc_negate(row[k]);
}

YkDisc yk_alt_enclose(YkDisc d, YkDisc hat, const YkDisc *x, YkDisc *row)
{
    Line one = line_of(d, hat, x), two = line_of(d, hat, x + YK_ALT_DYAD);
    YkDisc D = yk_disc_determinant(one.u, one.v, two.u, two.v), G = yk_disc_determinant(one.v, one.w, two.v, two.w);
    YkDisc H = yk_disc_determinant(one.w, one.u, two.w, two.u), by_D = yk_disc_add(G, H);
    YkDisc value = yk_disc_add_product(yk_disc_mul(D, by_D), G, H);
    if (!row) return value;
    YkDisc by_G = yk_disc_add(D, H), by_H = yk_disc_add(D, G);
    Line by_one = gradient(&two, by_D, by_G, by_H), by_two = gradient(&one, by_D, by_G, by_H);
    fill_row(d, hat, x, &by_one, false, row);
    fill_row(d, hat, x + YK_ALT_DYAD, &by_two, true, row + YK_ALT_DYAD);
    return value;
}

void yk_alt_residual(const YkVec *places, const YkVec *x, YkVec *F)
{
    YkDisc at[N];
    for (size_t k = 0; k < N; k++) at[k] = yk_disc(x[k], 0);
    for (size_t j = 0; j < N; j++) F[j] = yk_alt_enclose(yk_disc(places[j], 0), yk_disc(places[N + j], 0), at, NULL).at;
}

// The equations of Alt's problem, with derivatives.
#include "synthesis/nine_points/alt.h"

// u, v, w of one dyad at one place.
typedef struct Line {
    YkVec u, v, w;
} Line;

static Line line_of(YkVec d, YkVec hat, const YkVec *x)
{
    YkVec off = yk_sub(x[YK_ALT_X], x[YK_ALT_A]), off_hat = yk_sub(x[YK_ALT_X_HAT], x[YK_ALT_A_HAT]);
    Line line;
    line.u = yk_mul(yk_sub(hat, x[YK_ALT_A_HAT]), x[YK_ALT_X]);
    line.v = yk_mul(yk_sub(d, x[YK_ALT_A]), x[YK_ALT_X_HAT]);
    line.w = yk_add_product(yk_add_product(yk_mul(d, off_hat), hat, off), d, hat);
    return line;
}

static YkVec determinant(YkVec a, YkVec b, YkVec c, YkVec d)
{
    return yk_sub(yk_mul(a, d), yk_mul(b, c));
}

// Cramer's rule for two lines: D, G and H.
typedef struct Cramer {
    YkVec D, G, H;
} Cramer;

static Cramer cramer_of(const Line *one, const Line *two)
{
    Cramer c;
    c.D = determinant(one->u, one->v, two->u, two->v);
    c.G = determinant(one->v, one->w, two->v, two->w);
    c.H = determinant(one->w, one->u, two->w, two->u);
    return c;
}

// Differentiates the equation by u, v and w of one line; `sign` is -1 for the second one.
static Line gradient(const Line *other, double sign, YkVec by_D, YkVec by_G, YkVec by_H)
{
    Line g;
    g.u = yk_scale(sign, determinant(by_D, by_H, other->w, other->v));
    g.v = yk_scale(sign, determinant(by_G, by_D, other->u, other->w));
    g.w = yk_scale(sign, determinant(by_H, by_G, other->v, other->u));
    return g;
}

static void fill_row(YkVec d, YkVec hat, const YkVec *x, const Line *by, YkVec *row)
{
    YkVec from = yk_sub(d, x[YK_ALT_A]), from_hat = yk_sub(hat, x[YK_ALT_A_HAT]);
    YkVec along = yk_mul(by->w, hat), along_hat = yk_mul(by->w, d);
    row[YK_ALT_X] = yk_add_product(along, by->u, from_hat);
    row[YK_ALT_X_HAT] = yk_add_product(along_hat, by->v, from);
    row[YK_ALT_A] = yk_scale(-1, yk_add_product(along, by->v, x[YK_ALT_X_HAT]));
    row[YK_ALT_A_HAT] = yk_scale(-1, yk_add_product(along_hat, by->u, x[YK_ALT_X]));
}

// Differentiates the equation as the place moves at a rate.
static YkVec moved(YkVec d, YkVec hat, YkVec rate, YkVec rate_hat, const YkVec *x, const Line *by)
{
    YkVec to = yk_add(yk_sub(x[YK_ALT_X], x[YK_ALT_A]), d);
    YkVec to_hat = yk_add(yk_sub(x[YK_ALT_X_HAT], x[YK_ALT_A_HAT]), hat);
    YkVec by_d = yk_add_product(yk_mul(by->w, to_hat), by->v, x[YK_ALT_X_HAT]);
    YkVec by_hat = yk_add_product(yk_mul(by->w, to), by->u, x[YK_ALT_X]);
    return yk_add_product(yk_mul(by_d, rate), by_hat, rate_hat);
}

void yk_alt_evaluate(const YkVec *places, const YkVec *x, YkVec *F, YkVec *J, const YkVec *rate, YkVec *by_rate)
{
    enum { N = YK_ALT_SIZE };
    for (size_t j = 0; j < N; j++) {
        YkVec d = places[j], hat = places[N + j];
        Line one = line_of(d, hat, x), two = line_of(d, hat, x + YK_ALT_DYAD);
        Cramer c = cramer_of(&one, &two);
        F[j] = yk_add_product(yk_mul(c.D, yk_add(c.G, c.H)), c.G, c.H);
        if (!J && !rate) continue;
        YkVec by_D = yk_add(c.G, c.H), by_G = yk_add(c.D, c.H), by_H = yk_add(c.D, c.G);
        Line by_one = gradient(&two, 1, by_D, by_G, by_H), by_two = gradient(&one, -1, by_D, by_G, by_H);
        if (J) {
            fill_row(d, hat, x, &by_one, J + j * N);
            fill_row(d, hat, x + YK_ALT_DYAD, &by_two, J + j * N + YK_ALT_DYAD);
        }
        if (rate)
            by_rate[j] = yk_add(moved(d, hat, rate[j], rate[N + j], x, &by_one),
                                moved(d, hat, rate[j], rate[N + j], x + YK_ALT_DYAD, &by_two));
    }
}

bool yk_alt_turn(const YkVec *places, const YkVec *x, size_t j, YkVec *turn)
{
    YkVec d = places[j], hat = places[YK_ALT_SIZE + j];
    Line one = line_of(d, hat, x), two = line_of(d, hat, x + YK_ALT_DYAD);
    Cramer c = cramer_of(&one, &two);
    *turn = yk_mul(yk_add(c.D, c.G), yk_inverse(c.D));
    return isfinite(turn->x) && isfinite(turn->y);
}

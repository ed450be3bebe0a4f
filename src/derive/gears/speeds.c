// Writes speeds as formulas in numbers of teeth: one sum over the inputs for each body, and the ratios of a shift
// table.
#include <string.h>
#include "derive/gears/gears.h"
#include "derive/page.h"

enum { FACTORS_MAX = YK_TRAIN_FACTORS_MAX + 2 };

// The meaning of a line: target = over / under.
typedef struct Sum {
    const YkPoisson *over, *under;
    bool any;
} Sum;

static void add_to(YkRing *ring, Sum *sum, const YkPoisson *over, const YkPoisson *under)
{
    if (yk_ring_is_same(sum->under, under)) {
        sum->over = yk_ring_add(ring, sum->over, over);
        return;
    }
    const YkPoisson *before = yk_ring_multiply(ring, sum->over, under);
    sum->over = yk_ring_add(ring, before, yk_ring_multiply(ring, over, sum->under));
    sum->under = yk_ring_multiply(ring, sum->under, under);
}

static void put_sign(YkPage *page, YkLine *line, Sum *sum, bool is_negative)
{
    if (sum->any || is_negative) yk_line_sign(page, line, is_negative ? "-" : "+");
    sum->any = true;
}

static bool is_one(const YkPoisson *a)
{
    int64_t over, under;
    return yk_ring_is_rational(a, &over, &under) && over == 1 && under == 1;
}

// Writes N1 (N2 + N3) / (N4 (N5 + N6)) as factors, without those that are 1.
static void put_factored(YkPage *page, YkLine *line, const YkTrainQuotient *q, bool is_negative)
{
    const YkTrainFactors *sides[] = {&q->over, &q->under};
    const YkPoisson *lists[2][FACTORS_MAX];
    size_t counts[2] = {0, 0};
    for (int side = 0; side < 2; side++) {
        const YkPoisson *term = yk_train_quotient_term(q, side == 0);
        if (side == 0 && is_negative) term = yk_ring_negate(q->ring, term);
        if (!is_one(term)) lists[side][counts[side]++] = term;
        for (int32_t k = 0; k < sides[side]->count; k++) lists[side][counts[side]++] = sides[side]->items[k];
        if (counts[side] == 0) lists[side][counts[side]++] = term;
    }
    if (counts[1] == 1 && is_one(lists[1][0])) {
        for (size_t k = 0; k < counts[0]; k++) yk_line_factor(page, line, lists[0][k]);
        return;
    }
    yk_line_fraction(page, line, lists[0], counts[0], lists[1], counts[1]);
}

// One summand of a speed: rate * over / under, or only the quotient if rate is NULL.
typedef struct Share {
    const YkPoisson *rate, *over, *under;
    YkTrainQuotient quotient;
    bool is_negative;
} Share;

static bool make_share(YkRing *ring, const YkPoisson *rate, const YkPoisson *over, const YkPoisson *under, Share *share)
{
    *share = (Share){.rate = rate, .over = over, .under = under};
    if (!yk_train_quotient(ring, over, under, &share->quotient)) return false;
    const YkPoisson *whole = yk_train_quotient_sum(&share->quotient);
    share->is_negative = yk_page_is_negative(ring, whole ? whole : yk_train_quotient_term(&share->quotient, true));
    return yk_ring_status(ring) == YK_RING_OK;
}

static const YkPoisson *product_of(const YkTrainQuotient *q, bool is_above)
{
    const YkTrainFactors *factors = is_above ? &q->over : &q->under;
    const YkPoisson *product = factors->count > 0 ? yk_ring_product(q->ring, factors->items, (size_t)factors->count)
                                                  : yk_ring_rational(q->ring, 1, 1);
    return yk_ring_multiply(q->ring, product, yk_train_quotient_term(q, is_above));
}

static void add_share(YkRing *ring, Sum *sum, const Share *share)
{
    const YkPoisson *whole = yk_train_quotient_sum(&share->quotient);
    const YkPoisson *over = whole ? whole : product_of(&share->quotient, true);
    if (share->rate) over = yk_ring_multiply(ring, share->rate, over);
    add_to(ring, sum, over, whole ? yk_ring_rational(ring, 1, 1) : product_of(&share->quotient, false));
}

// Writes `omegaC (1 + N1 N3/(N2 N4))`, `- omega1 N1 N3/(N2 N4)`.
static void put_share(YkDerivation *d, YkPage *page, YkLine *line, const Share *share, Sum *sum)
{
    YkRing *ring = d->ring;
    const YkPoisson *whole = yk_train_quotient_sum(&share->quotient);
    const YkPoisson *term = yk_train_quotient_term(&share->quotient, true),
                    *below = yk_train_quotient_term(&share->quotient, false);
    if (share->is_negative) term = yk_ring_negate(ring, term);
    bool is_divided = share->rate && yk_ring_terms(whole) == 1 && is_one(term) && !is_one(below); // d'/r, not d' 1/r
    put_sign(page, line, sum, share->is_negative);
    if (is_divided)
        yk_line_quotient(page, line, share->rate, below);
    else if (share->rate)
        yk_line_element(page, line, share->rate, YK_RING_TEXTBOOK);
    if (whole && share->is_negative) whole = yk_ring_negate(ring, whole);
    if (!whole)
        put_factored(page, line, &share->quotient, share->is_negative);
    else if (!share->rate)
        yk_line_element(page, line, whole, YK_RING_TEXTBOOK);
    else if (!is_divided && !is_one(whole))
        yk_line_factor(page, line, whole);
    add_share(ring, sum, share);
}

// Gives the line its statement: under * symbol = over.
static void finish(YkLine *line, const YkPoisson *left, const Sum *sum, int32_t symbol)
{
    if (!line) return;
    line->left = left;
    line->value = line->over = line->right = sum->over;
    line->value_under = line->under = line->factor = sum->under;
    line->solved = symbol;
}

// Leaves out a formula that grew beyond the ring's limits, with a sentence in its place; the numbers stay.
static bool give_up(YkDerivation *d, YkPage *page, YkLine *line, const char *name)
{
    YkRingStatus status = yk_ring_status(d->ring);
    YkText text = {0};
    if (status != YK_RING_OK && status != YK_RING_SIZE && status != YK_RING_OVERFLOW) return false;
    yk_ring_clear(d->ring);
    page->failed = false; // set by elements that were not made
    yk_text_format(&text, "%s: no formula of a readable size; `yoke gears` gives the number.", name);
    if (line)
        *line = (YkLine){.kind = YK_LINE_WORDS,
                         .text = yk_arena_copy(page->arena, yk_text_get(&text), text.length),
                         .section = line->section,
                         .next = line->next};
    page->failed |= text.failed || yk_arena_failed(page->arena) || (page->passing && yk_arena_failed(page->passing));
    yk_text_free(&text);
    return !page->failed;
}

// Writes the same with the file's numbers of teeth, exactly, `omega4 = 35/29 omegaC - 6/29 omega1`, and at drive
// speeds.
static void put_numbers(YkDerivation *d, YkPage *page, int32_t column, const YkPoisson *left)
{
    const YkDeriveTrain *train = d->train;
    Sum sum = {.over = yk_ring_rational(d->ring, 0, 1), .under = yk_ring_rational(d->ring, 1, 1)};
    for (int32_t k = 0; k < train->input_count; k++)
        if (!yk_derive_fraction(d, yk_train_case_share(&train->motion, column, k))) return;
    YkLine *line = yk_page_formula(page, NULL);
    yk_line_element(page, line, left, YK_RING_TEXTBOOK);
    yk_line_sign(page, line, "=");
    for (int pass = 0; pass < 2; pass++) {
        for (int32_t k = 0; k < train->input_count; k++) {
            YkFraction share = *yk_train_case_share(&train->motion, column, k);
            if (yk_fraction_is_zero(&share) || share.is_negative != (pass == 1)) continue;
            put_sign(page, line, &sum, share.is_negative);
            const YkPoisson *by = yk_derive_fraction(d, &share), *rate = train->input_rates[k];
            add_to(d->ring, &sum, yk_ring_multiply(d->ring, by, rate), sum.under);
            if (share.is_negative) by = yk_ring_negate(d->ring, by);
            if (!is_one(by)) yk_line_element(page, line, by, YK_RING_TEXTBOOK);
            yk_line_element(page, line, rate, YK_RING_TEXTBOOK);
        }
    }
    if (!sum.any) yk_line_sign(page, line, "0");
    finish(line, left, &sum, YK_NONE);
    if (line) line->is_in_numbers = true;
    const YkTrain *whole = train->train;
    if (column >= whole->net.bodies || whole->motion.status == YK_TRAIN_STATUS_LOCKED) return;
    YkTrainBody body = yk_train_body(whole, (size_t)column - 1);
    if (body.is_determined && body.exact && whole->drive_count > 0 && !whole->drives[0].shown.is_unit)
        yk_page_words(page, "%s = %s at the speeds of the file's drives.",
                      yk_ring_symbol_name(d->ring, yk_derive_column_symbol(d, column)), body.exact);
}

static const char *name_of(const YkDerivation *d, int32_t column)
{
    const YkTrainNet *net = &d->train->train->net;
    return column < net->bodies ? d->model->bodies[net->body_of[column]].name
                                : d->model->racks[column - net->bodies].name;
}

// Finds each input's share in the speed, without those that are 0. Returns false if there is no formula.
static bool find_shares(YkDerivation *d, int32_t column, Share *shares, int32_t *count)
{
    const YkDeriveTrain *train = d->train;
    *count = 0;
    for (int32_t k = 0; k < train->input_count; k++) {
        const YkPoisson *over, *under;
        if (!yk_train_share_in(&train->motion, column, k, d->ring, train->symbols, &over, &under)) return false;
        if (yk_ring_is_zero(over)) continue;
        if (!make_share(d->ring, train->input_rates[k], over, under, &shares[(*count)++])) return false;
    }
    return true;
}

// Writes omega4 = ..., or that there is no such formula.
static bool put_in_teeth(YkDerivation *d, YkPage *page, int32_t column, const YkPoisson *left)
{
    Sum sum = {.over = yk_ring_rational(d->ring, 0, 1), .under = yk_ring_rational(d->ring, 1, 1)};
    Share *shares = YK_NEW(page->arena, Share, (size_t)d->train->input_count + 1);
    int32_t count;
    YkLine *line = yk_page_formula(page, name_of(d, column));
    if (!shares || !line) return false;
    if (!find_shares(d, column, shares, &count)) return give_up(d, page, line, name_of(d, column));
    yk_line_element(page, line, left, YK_RING_TEXTBOOK);
    yk_line_sign(page, line, "=");
    for (int pass = 0; pass < 2; pass++) // sums first
        for (int32_t k = 0; k < count; k++)
            if (shares[k].is_negative == (pass == 1)) put_share(d, page, line, &shares[k], &sum);
    if (!sum.any) yk_line_sign(page, line, "0");
    finish(line, left, &sum, yk_derive_column_symbol(d, column));
    return yk_ring_status(d->ring) == YK_RING_OK || give_up(d, page, line, name_of(d, column));
}

static bool put_speed(YkDerivation *d, YkPage *page, int32_t column)
{
    const YkPoisson *left = yk_derive_column(d, column);
    if (!put_in_teeth(d, page, column, left)) return false;
    if (page->has_numbers) put_numbers(d, page, column, left);
    return true;
}

// Writes the inputs' other names, from which C computes the rest.
static void put_inputs(YkDerivation *d, YkPage *page)
{
    const YkDeriveTrain *train = d->train;
    for (int32_t k = 0; k < train->input_count; k++) {
        const YkPoisson *rate = yk_derive_in_joints(d, train->input_rates[k]);
        if (yk_ring_is_same(rate, train->input_rates[k])) continue;
        YkLine *line = yk_page_equation(page, "given", train->input_rates[k], rate, YK_RING_TEXTBOOK);
        for (size_t s = 0; line && s < yk_ring_symbol_count(d->ring); s++)
            if (yk_ring_is_same(yk_ring_of(d->ring, (int32_t)s), train->input_rates[k])) line->solved = (int32_t)s;
        if (line) line->over = rate;
    }
}

void yk_derive_put_speeds(YkDerivation *d, YkPage *page)
{
    const YkDeriveTrain *train = d->train;
    const YkTrainNet *net = &train->train->net;
    yk_page_heading(page, 2, "Speeds");
    put_inputs(d, page);
    for (int32_t c = 1; c < net->columns; c++) {
        int32_t symbol = yk_derive_column_symbol(d, c);
        bool is_known = symbol < 0 || yk_derive_is_input(d, c);
        for (int32_t k = 1; k < c && !is_known; k++) is_known = yk_derive_column_symbol(d, k) == symbol;
        if (is_known) continue;
        if (!yk_exact_is_determined(&train->motion.system, c)) {
            yk_page_words(page, "%s: its speed follows from the loops, not from the gears.", name_of(d, c));
            continue;
        }
        if (!put_speed(d, page, c)) return;
    }
}

// --- Ratios under locks

// Writes the turns of `in` per turn of `out`; `exact` is the same as a number.
static bool put_ratio(YkDerivation *d, YkPage *page, const YkTrainCase *one, int32_t in, int32_t out,
                      const char *remark)
{
    Sum sum = {.over = yk_ring_rational(d->ring, 0, 1), .under = yk_ring_rational(d->ring, 1, 1)};
    const YkPoisson *over, *under;
    Share *share = YK_NEW(page->arena, Share, 1);
    YkLine *line = yk_page_formula(page, remark);
    const YkPoisson *input = yk_derive_column(d, in);
    yk_line_quotient(page, line, input, yk_derive_column(d, out));
    yk_line_sign(page, line, "=");
    if (!share || !yk_train_share_in(one, out, 0, d->ring, d->train->symbols, &over, &under) || yk_ring_is_zero(over) ||
        !make_share(d->ring, NULL, under, over, share))
        return give_up(d, page, line, remark);
    put_share(d, page, line, share, &sum);
    if (!page->has_numbers) return true;
    YkFraction ratio = yk_fraction_inverse(yk_train_case_share(one, out, 0));
    const YkPoisson *number = yk_derive_fraction(d, &ratio);
    if (!number) return true;
    yk_line_sign(page, line, "=");
    yk_line_element(page, line, number, YK_RING_TEXTBOOK);
    return true;
}

void yk_derive_put_shifts(YkDerivation *d, YkPage *page)
{
    const YkTrain *train = d->train->train;
    const YkTrainNet *net = &train->net;
    if (train->gear_count == 0) return;
    int32_t in = net->column_of[train->ratio.in], out = net->column_of[train->ratio.out];
    yk_page_heading(page, 2, "Ratios under each lock");
    for (size_t k = 0; k < train->gear_count; k++) {
        const YkTrainGear *gear = &train->gears[k];
        const YkTrainDrive unit = {.coordinate = YK_NONE, .body = net->body_of[in]};
        YkTrainCase one;
        if (!gear->ratio.is_known || gear->ratio.out_stands) {
            yk_page_words(page, "%s: %s", gear->lock, gear->ratio.out_stands ? "the output stands" : gear->message);
            continue;
        }
        bool good = yk_train_case_solve(&one, net, &d->model->locks[k], &unit, 1, d->arena);
        d->failed |= !good;
        if (good) good = put_ratio(d, page, &one, in, out, gear->lock);
        yk_train_case_free(&one);
        if (!good) return;
    }
}

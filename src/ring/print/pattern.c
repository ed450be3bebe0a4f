// Finds the signs of elements (signatures), keeps patterns by their signs, and fills them.
#include "ring/print/pattern.h"
#include <stdlib.h>
#include <string.h>
#include "base/mix.h"

// A machine of few symbols has few elements that are alike. Some large ones, such as long arms, have none: once
// IN_VAIN_MAX more signs have found nothing than have found a pattern, no more are made. Long elements get no pattern.
enum { RING_SYMBOLS_MIN = 128, IN_VAIN_MAX = 100 };
enum { WORDS_MAX = 128, SYMBOLS_MAX = 16, PLACES = 1024, PATTERNS_MAX = PLACES / 2, PADDING = 16 };

// A signature: all that decides how an element is written but for names: its terms, its symbols numbered as they occur,
// their classes and order, and their replacements.
typedef struct Sign {
    uint64_t words[WORDS_MAX], hash;
    size_t word_count, symbol_count;
    int32_t symbols[SYMBOLS_MAX];
    uint8_t place[64]; // by a symbol's mark: its number, or that of another symbol with this mark
    bool is_good;      // otherwise too long, or with angles such as pi/7, whose names are of another kind
} Sign;

// A name, and the text before it.
typedef struct Slot {
    uint32_t length, symbol; // of the text; number in the sign
} Slot;

typedef struct Pattern {
    uint64_t hash;
    const uint64_t *words;
    const Slot *slots;
    const char *text;                          // all that stands between the names, and PADDING bytes
    size_t word_count, slot_count, tail, kind; // tail: length of the text after the last name
} Pattern;

struct YkPatterns {
    Pattern *places[PLACES]; // open addressing
    size_t count, found, in_vain;
    Sign sign; // of the element signed last
    const YkPoisson *of;
    const YkRingChanges *changes;
};

// --- Signs

static uint64_t number_of(Sign *sign, int32_t symbol)
{
    uint8_t *place = &sign->place[symbol & 63];
    size_t k = *place;
    if (k < sign->symbol_count && sign->symbols[k] == symbol) return k;
    for (k = 0; k < sign->symbol_count && sign->symbols[k] != symbol; k++) {}
    if (k == SYMBOLS_MAX) {
        sign->is_good = false;
        return 0;
    }
    if (k == sign->symbol_count) sign->symbols[sign->symbol_count++] = symbol;
    *place = (uint8_t)k;
    return k;
}

// Adds the powers behind the words so far; returns their end.
static uint64_t *put_powers(Sign *sign, uint64_t *end, const YkPower *powers, uint32_t count)
{
    for (uint32_t i = 0; i < count && sign->is_good; i++)
        *end++ = number_of(sign, powers[i].symbol) << 32 | (uint32_t)powers[i].exponent;
    return end;
}

static void put_element(const YkRing *ring, Sign *sign, const YkPoisson *a)
{
    uint64_t *end = sign->words + sign->word_count, *const last = sign->words + WORDS_MAX;
    size_t least = 2 + (a ? 2 * a->count : 0);
    sign->is_good = sign->is_good && least < (size_t)(last - end);
    if (!sign->is_good) return;
    *end++ = a ? a->count : UINT64_MAX;
    *end++ = a ? (uint64_t)a->denominator : 0;
    for (size_t i = 0; a && i < a->count; i++) {
        uint64_t key = a->terms[i].key;
        uint32_t phase_count, monomial_count;
        const YkPower *phase = yk_powers_of(&ring->phases, yk_key_phase(key), &phase_count);
        const YkPower *monomial = yk_powers_of(&ring->monomials, yk_key_monomial(key), &monomial_count);
        size_t words = 2 + (size_t)phase_count + monomial_count;
        sign->is_good = sign->is_good && words < (size_t)(last - end);
        if (!sign->is_good) return;
        *end++ = (uint64_t)a->terms[i].number;
        *end++ = (uint64_t)phase_count << 40 | (uint64_t)monomial_count << 8 | yk_key_unit(key);
        end = put_powers(sign, end, phase, phase_count);
        end = put_powers(sign, end, monomial, monomial_count);
    }
    sign->word_count = (size_t)(end - sign->words);
}

// Adds the classes of the symbols, and their order.
static void put_symbols(const YkRing *ring, Sign *sign)
{
    uint8_t order[SYMBOLS_MAX];
    uint64_t classes[2] = {0}, ranks = 0;
    for (size_t k = 0; k < sign->symbol_count; k++) {
        const YkRingSymbol *symbol = &ring->symbols[sign->symbols[k]];
        sign->is_good = sign->is_good && symbol->meaning->pi_over == 0;
        classes[k / 8] |= ((uint64_t)symbol->kind << 1 | symbol->is_angle) << 8 * (k % 8);
        size_t at = k;
        for (; at > 0 && sign->symbols[order[at - 1]] > sign->symbols[k]; at--) order[at] = order[at - 1];
        order[at] = (uint8_t)k;
    }
    for (size_t k = 0; k < sign->symbol_count; k++) ranks |= (uint64_t)order[k] << 4 * k;
    const uint64_t words[] = {ranks, classes[0], classes[1]};
    sign->is_good = sign->is_good && sign->word_count + 3 <= WORDS_MAX;
    for (size_t k = 0; k < 3 && sign->is_good; k++) sign->words[sign->word_count++] = words[k];
}

static void sign_element(const YkRing *ring, const YkRingView *view, Sign *sign)
{
    uint64_t hash = 0;
    sign->word_count = sign->symbol_count = 0;
    sign->is_good = true;
    put_element(ring, sign, view->of);
    for (size_t k = 0, own = sign->symbol_count; view->changes && k < own; k++) {
        const YkRingChange *change = yk_ring_change_of(view->changes, sign->symbols[k]);
        put_element(ring, sign, change ? change->value : NULL);
        put_element(ring, sign, change ? change->unit : NULL);
    }
    if (!sign->is_good) return;
    put_symbols(ring, sign);
    for (size_t k = 0; k < sign->word_count; k++) hash = (hash ^ sign->words[k]) * YK_MIX_STEP;
    sign->hash = yk_mix(hash);
}

// --- Patterns

static size_t kind_of(const YkRingView *view, YkRingFormat format, YkRingStyle style)
{
    return ((size_t)view->side * YK_RING_STYLES + style) * YK_RING_FORMATS + format;
}

// Returns the place of the pattern of what was signed last, or the free one where it belongs.
static Pattern **place_of(YkPatterns *patterns, size_t kind)
{
    const Sign *sign = &patterns->sign;
    size_t at = (size_t)(sign->hash + kind) & (PLACES - 1);
    for (; patterns->places[at]; at = (at + 1) & (PLACES - 1)) {
        const Pattern *pattern = patterns->places[at];
        if (pattern->hash == sign->hash && pattern->kind == kind && pattern->word_count == sign->word_count &&
            memcmp(pattern->words, sign->words, sign->word_count * sizeof *sign->words) == 0)
            break;
    }
    return &patterns->places[at];
}

// Writes the pattern with the names of the element signed last.
static void fill(YkRing *ring, const Pattern *pattern, YkRingFormat format, YkText *text)
{
    const char *from = pattern->text;
    for (size_t k = 0; k < pattern->slot_count; k++) {
        yk_text_add_padded(text, from, pattern->slots[k].length);
        yk_write_name(ring, ring->patterns->sign.symbols[pattern->slots[k].symbol], format, text);
        from += pattern->slots[k].length;
    }
    yk_text_add_padded(text, from, pattern->tail);
}

bool yk_pattern_write(YkRing *ring, const YkRingView *view, YkRingFormat format, YkRingStyle style, YkText *text)
{
    ring->marks.is_wanted = false;
    if (ring->symbol_count < RING_SYMBOLS_MIN || ring->depth > 0) return false; // none that pass are kept
    // Without memory for patterns everything is merely as slow as the first time.
    YkPatterns *patterns = ring->patterns ? ring->patterns : (ring->patterns = calloc(1, sizeof *patterns));
    if (!patterns || patterns->in_vain > IN_VAIN_MAX + patterns->found) return false;
    if (patterns->of != view->of || patterns->changes != view->changes) sign_element(ring, view, &patterns->sign);
    patterns->of = view->of;
    patterns->changes = view->changes;
    const Pattern *pattern = patterns->sign.is_good ? *place_of(patterns, kind_of(view, format, style)) : NULL;
    patterns->found += pattern != NULL;
    patterns->in_vain += pattern == NULL;
    ring->marks.is_wanted = !pattern && patterns->sign.is_good && patterns->count < PATTERNS_MAX;
    if (pattern) fill(ring, pattern, format, text);
    return pattern != NULL;
}

// Copies the text without the names, and lists the names. Returns NULL when out of memory.
static Pattern *make(YkRing *ring, const YkText *text, size_t start)
{
    Sign *sign = &ring->patterns->sign;
    const YkMarks *marks = &ring->marks;
    Pattern *pattern = YK_NEW(ring->arena, Pattern, 1);
    uint64_t *words = yk_arena_take(ring->arena, sign->word_count * sizeof *words);
    Slot *slots = yk_arena_take(ring->arena, (marks->count + 1) * sizeof *slots);
    char *copy = yk_arena_take(ring->arena, text->length - start + PADDING), *end = copy;
    if (!pattern || !words || !slots || !copy) return NULL;
    memcpy(words, sign->words, sign->word_count * sizeof *words);
    for (size_t k = 0; k < marks->count; k++) {
        const YkMark *mark = &marks->items[k];
        slots[k] = (Slot){(uint32_t)(mark->at - start), (uint32_t)number_of(sign, mark->symbol)};
        memcpy(end, yk_text_get(text) + start, slots[k].length);
        end += slots[k].length;
        start = mark->at + mark->length;
    }
    memcpy(end, yk_text_get(text) + start, text->length - start);
    *pattern = (Pattern){.hash = sign->hash,
                         .words = words,
                         .slots = slots,
                         .text = copy,
                         .word_count = sign->word_count,
                         .slot_count = marks->count,
                         .tail = text->length - start};
    return pattern;
}

void yk_pattern_keep(YkRing *ring, const YkRingView *view, YkRingFormat format, YkRingStyle style, const YkText *text,
                     size_t start)
{
    YkPatterns *patterns = ring->patterns;
    if (ring->marks.failed) return;
    size_t kind = kind_of(view, format, style);
    Pattern **place = place_of(patterns, kind), *pattern = make(ring, text, start);
    if (!pattern) return;
    pattern->kind = kind;
    *place = pattern;
    patterns->count++;
}

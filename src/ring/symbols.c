// Symbols: names, classes, and what they depend on.
#include <string.h>
#include "base/text.h"
#include "ring/inside.h"

enum { NAME_MAX_LENGTH = 200, SYMBOLS_MAX = 1 << 28 };

static bool is_letter(char c)
{
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
}

static bool is_reserved(const char *name)
{
    static const char *const words[] = {"cos", "sin", "sqrt", "exp", "pow", "pi"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcmp(name, words[i]) == 0) return true;
    return strncmp(name, "pi_", 3) == 0 && name[3] != '\0' && strspn(name + 3, "0123456789") == strlen(name + 3);
}

static bool is_name(const char *name)
{
    const char *c = name;
    if (!is_letter(*c)) return false;
    while (is_letter(*c) || (*c >= '0' && *c <= '9') || *c == '.') c++;
    while (*c == '\'') c++;
    return *c == '\0' && c - name <= NAME_MAX_LENGTH && c[-1] != '.' && !is_reserved(name);
}

// Enters a name for a symbol; false with the status when it is taken.
static bool enter_name(YkRing *ring, const char *name, int32_t symbol)
{
    int32_t existing;
    if (!yk_names_add(&ring->names, name, symbol, &existing)) return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
    return existing == YK_NONE || yk_ring_fail(ring, YK_RING_NAME) != NULL;
}

static int32_t add_symbol(YkRing *ring, const char *name, YkRingSymbol symbol)
{
    if (ring->symbol_count >= SYMBOLS_MAX) return yk_ring_fail(ring, YK_RING_SIZE) ? 0 : -1;
    symbol.name_length = strlen(name);
    symbol.name = yk_arena_copy(ring->arena, name, symbol.name_length);
    if (!symbol.name || !YK_ROOM(ring->symbols, ring->symbol_count, ring->symbol_capacity)) {
        yk_ring_fail(ring, YK_RING_MEMORY);
        return -1;
    }
    int32_t index = (int32_t)ring->symbol_count;
    if (!enter_name(ring, symbol.name, index)) return -1;
    ring->symbols[ring->symbol_count++] = symbol;
    return index;
}

int32_t yk_ring_symbol(YkRing *ring, const char *name, YkRingClass kind)
{
    if (is_name(name)) return add_symbol(ring, name, (YkRingSymbol){.kind = kind});
    yk_ring_fail(ring, YK_RING_NAME);
    return -1;
}

int32_t yk_ring_angle(YkRing *ring, const char *name)
{
    if (is_name(name)) return add_symbol(ring, name, (YkRingSymbol){.kind = YK_RING_COORDINATE, .is_angle = true});
    yk_ring_fail(ring, YK_RING_NAME);
    return -1;
}

int32_t yk_ring_constant_angle(YkRing *ring, int64_t pi_over)
{
    YkText name = {0};
    yk_text_puts(&name, "pi");
    char digits[24];
    size_t at = sizeof digits;
    digits[--at] = '\0';
    for (int64_t rest = pi_over; rest > 0; rest /= 10) digits[--at] = (char)('0' + rest % 10);
    if (pi_over > 1) yk_text_format(&name, "_%s", digits + at);
    int32_t symbol = name.failed ? -1 : yk_names_find(&ring->names, yk_text_get(&name));
    if (name.failed)
        yk_ring_fail(ring, YK_RING_MEMORY);
    else if (symbol < 0)
        symbol = add_symbol(ring, yk_text_get(&name),
                            (YkRingSymbol){.kind = YK_RING_CONSTANT, .is_angle = pi_over > 1, .pi_over = pi_over});
    yk_text_free(&name);
    return symbol;
}

bool yk_ring_alias(YkRing *ring, int32_t symbol, const char *name)
{
    if (!is_name(name) || symbol < 0 || (size_t)symbol >= ring->symbol_count)
        return yk_ring_fail(ring, YK_RING_NAME) != NULL;
    const char *copy = yk_arena_copy(ring->arena, name, strlen(name));
    if (!copy) return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
    return enter_name(ring, copy, symbol);
}

// A symbol named coordinate + suffix, with coordinate + alias as its other name.
static int32_t add_derived(YkRing *ring, int32_t coordinate, const char *suffix, const char *alias, YkRingClass kind)
{
    YkText name = {0};
    yk_text_format(&name, "%s%s", ring->symbols[coordinate].name, suffix);
    int32_t symbol = name.failed ? -1 : yk_ring_symbol(ring, yk_text_get(&name), kind);
    yk_text_clear(&name);
    yk_text_format(&name, "%s%s", ring->symbols[coordinate].name, alias);
    if (name.failed) yk_ring_fail(ring, YK_RING_MEMORY);
    bool well = symbol >= 0 && !name.failed && yk_ring_alias(ring, symbol, yk_text_get(&name));
    yk_text_free(&name);
    return well ? symbol : -1;
}

int32_t yk_ring_rates(YkRing *ring, int32_t coordinate)
{
    if (coordinate < 0 || (size_t)coordinate >= ring->symbol_count) return yk_ring_fail(ring, YK_RING_NAME) ? 0 : -1;
    int32_t rate = add_derived(ring, coordinate, "'", ".rate", YK_RING_RATE);
    int32_t acceleration = rate < 0 ? -1 : add_derived(ring, coordinate, "''", ".accel", YK_RING_ACCELERATION);
    if (acceleration < 0) return -1;
    bool well = yk_ring_set_rate(ring, coordinate, yk_ring_of(ring, rate)) &&
                yk_ring_set_rate(ring, rate, yk_ring_of(ring, acceleration));
    return well ? rate : -1;
}

bool yk_ring_set_rate(YkRing *ring, int32_t symbol, const YkPoisson *rate)
{
    if (!rate) return false;
    if (symbol < 0 || (size_t)symbol >= ring->symbol_count) return yk_ring_fail(ring, YK_RING_NAME) != NULL;
    ring->symbols[symbol].rate = rate;
    ring->rule_count++;
    ring->moving_marks |= yk_mark(symbol);
    if (rate->denominator != 1) ring->dependent_marks |= yk_mark(symbol);
    return true;
}

// derivative NULL: it is not known.
static bool add_partial(YkRing *ring, int32_t symbol, int32_t variable, const YkPoisson *derivative)
{
    YkPartial *partial = YK_NEW(ring->arena, YkPartial, 1);
    if (!partial) return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
    *partial = (YkPartial){ring->symbols[symbol].partials, variable, derivative};
    ring->symbols[symbol].partials = partial;
    ring->rule_count++;
    ring->dependent_marks |= yk_mark(symbol);
    return true;
}

bool yk_ring_set_partial(YkRing *ring, int32_t symbol, int32_t variable, const YkPoisson *derivative)
{
    if (!derivative) return false;
    int32_t count = (int32_t)ring->symbol_count;
    if (symbol < 0 || symbol >= count || variable < 0 || variable >= count)
        return yk_ring_fail(ring, YK_RING_NAME) != NULL;
    return add_partial(ring, symbol, variable, derivative);
}

int32_t yk_ring_function(YkRing *ring, const char *const names[], size_t count, int32_t variable)
{
    int32_t first = (int32_t)ring->symbol_count;
    if (variable < 0 || variable >= first || count == 0) return yk_ring_fail(ring, YK_RING_NAME) ? 0 : -1;
    for (size_t i = 0; i < count; i++)
        if (yk_ring_symbol(ring, names[i], YK_RING_FUNCTION) < 0) return -1;
    for (int32_t i = 0; i < (int32_t)count; i++) {
        bool is_last = i + 1 == (int32_t)count;
        const YkPoisson *next = is_last ? NULL : yk_ring_of(ring, first + i + 1);
        if ((!is_last && !next) || !add_partial(ring, first + i, variable, next)) return -1;
    }
    return first;
}

int32_t yk_ring_root(YkRing *ring, const char *name, const YkPoisson *square)
{
    if (!square) return -1;
    if (!yk_ring_is_real(ring, square)) return yk_ring_fail(ring, YK_RING_NOT_REAL) ? 0 : -1;
    int32_t symbol = yk_ring_symbol(ring, name, YK_RING_FUNCTION);
    ring->rule_count++;
    if (symbol < 0) return -1;
    ring->symbols[symbol].square = square;
    ring->dependent_marks |= yk_mark(symbol);
    return symbol;
}

int32_t yk_ring_find(const YkRing *ring, const char *name)
{
    return yk_names_find(&ring->names, name);
}

size_t yk_ring_symbol_count(const YkRing *ring)
{
    return ring->symbol_count;
}

const char *yk_ring_symbol_name(const YkRing *ring, int32_t symbol)
{
    return ring->symbols[symbol].name;
}

YkRingClass yk_ring_symbol_class(const YkRing *ring, int32_t symbol)
{
    return ring->symbols[symbol].kind;
}

bool yk_ring_is_angle(const YkRing *ring, int32_t symbol)
{
    return ring->symbols[symbol].is_angle;
}

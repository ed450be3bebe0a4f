// Symbols: their names, classes and dependences.
#include <string.h>
#include "base/letters.h"
#include "base/text.h"
#include "ring/inside.h"

enum { NAME_MAX_LENGTH = 200, SYMBOLS_MAX = 1 << 28 };

static bool is_reserved(const char *name)
{
    static const char *const words[] = {"cos", "sin", "sqrt", "exp", "pow", "pi"};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (*name == *words[i] && strcmp(name, words[i]) == 0) return true;
    return strncmp(name, "pi_", 3) == 0 && name[3] != '\0' && strspn(name + 3, "0123456789") == strlen(name + 3);
}

static bool is_name(const char *name)
{
    const char *c = name;
    if (!yk_begins_name(*c)) return false;
    while (yk_begins_name(*c) || yk_is_digit(*c) || *c == '.') c++;
    while (*c == '\'') c++;
    return *c == '\0' && c - name <= NAME_MAX_LENGTH && c[-1] != '.' && !is_reserved(name);
}

// Returns the symbol that NAME.rate or NAME.accel means, or -1: they name NAME' and NAME'' without being entered.
static int32_t find_derivative(const YkRing *ring, const char *name)
{
    static const char *const endings[] = {".rate", ".accel"};
    char stem[NAME_MAX_LENGTH + 1];
    const char *dot = strrchr(name, '.');
    if (!dot || (size_t)(dot - name) >= sizeof stem) return -1;
    memcpy(stem, name, (size_t)(dot - name));
    stem[dot - name] = '\0';
    for (int k = 0; k < 2; k++)
        if (strcmp(dot, endings[k]) == 0) {
            int32_t of = yk_names_find(&ring->names, stem);
            bool has_rates = of >= 0 && ring->symbols[of].rate_symbol > 0 && strcmp(ring->symbols[of].name, stem) == 0;
            return has_rates ? ring->symbols[of].rate_symbol + k : -1;
        }
    return -1;
}

// Enters a name for a symbol; returns false with the status when it is taken.
static bool enter_name(YkRing *ring, const char *name, int32_t symbol)
{
    int32_t existing;
    const char *dot = strrchr(name, '.');
    bool is_derivative = dot && (strcmp(dot, ".rate") == 0 || strcmp(dot, ".accel") == 0);
    if (is_derivative && find_derivative(ring, name) >= 0) return yk_ring_fail(ring, YK_RING_NAME) != NULL;
    ring->derivative_names += is_derivative;
    if (!yk_names_add(&ring->names, name, symbol, &existing)) return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
    return existing == YK_NONE || yk_ring_fail(ring, YK_RING_NAME) != NULL;
}

static const YkRingMeaning no_meaning;

YkRingMeaning *yk_ring_meaning(YkRing *ring, int32_t symbol)
{
    const YkRingMeaning **meaning = &ring->symbols[symbol].meaning;
    if (*meaning != &no_meaning) return (YkRingMeaning *)*meaning;
    YkRingMeaning *own = YK_NEW(ring->arena, YkRingMeaning, 1);
    if (!own) yk_ring_fail(ring, YK_RING_MEMORY);
    if (own) *meaning = own;
    return own;
}

// Adds a symbol. `name`, the last memory taken from the ring's arena, is given back if no symbol is made.
static int32_t add_symbol(YkRing *ring, char *name, YkRingSymbol symbol)
{
    if (!yk_ring_spend(ring, YK_WORK_SYMBOL)) return -1;
    if (!name || !YK_ROOM(ring->symbols, ring->symbol_count, ring->symbol_capacity)) {
        yk_ring_fail(ring, YK_RING_MEMORY);
        return -1;
    }
    symbol.name = name;
    symbol.name_length = (uint8_t)strlen(name);
    symbol.meaning = &no_meaning;
    int32_t index = (int32_t)ring->symbol_count;
    if (ring->symbol_count >= SYMBOLS_MAX) yk_ring_fail(ring, YK_RING_SIZE);
    if (ring->symbol_count >= SYMBOLS_MAX || !enter_name(ring, name, index)) {
        yk_arena_give_back(ring->arena, name, 0);
        return -1;
    }
    ring->symbols[ring->symbol_count++] = symbol;
    return index;
}

static int32_t add_named(YkRing *ring, const char *name, YkRingSymbol symbol)
{
    return add_symbol(ring, yk_arena_copy(ring->arena, name, strlen(name)), symbol);
}

// A name that could not be written for lack of memory is not a malformed one.
static int32_t refuse_name(YkRing *ring, const char *name)
{
    yk_ring_fail(ring, name == yk_text_lost ? YK_RING_MEMORY : YK_RING_NAME);
    return -1;
}

int32_t yk_ring_symbol(YkRing *ring, const char *name, YkRingClass kind)
{
    if (is_name(name)) return add_named(ring, name, (YkRingSymbol){.kind = (uint8_t)kind});
    return refuse_name(ring, name);
}

int32_t yk_ring_angle(YkRing *ring, const char *name)
{
    if (is_name(name)) return add_named(ring, name, (YkRingSymbol){.kind = YK_RING_COORDINATE, .is_angle = true});
    return refuse_name(ring, name);
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
    else if (symbol < 0) {
        symbol = add_named(ring, yk_text_get(&name), (YkRingSymbol){.kind = YK_RING_CONSTANT, .is_angle = pi_over > 1});
        YkRingMeaning *meaning = symbol < 0 ? NULL : yk_ring_meaning(ring, symbol);
        if (meaning) meaning->pi_over = pi_over;
    }
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

// Adds a symbol named as the coordinate with this many primes.
static int32_t add_derived(YkRing *ring, int32_t coordinate, size_t primes, YkRingClass kind)
{
    const char *of = ring->symbols[coordinate].name;
    size_t length = strlen(of);
    char *name = yk_arena_take(ring->arena, length + primes + 1);
    if (!name) return yk_ring_fail(ring, YK_RING_MEMORY) ? 0 : -1;
    memcpy(name, of, length);
    memset(name + length, '\'', primes);
    name[length + primes] = '\0';
    if (length + primes <= NAME_MAX_LENGTH) return add_symbol(ring, name, (YkRingSymbol){.kind = (uint8_t)kind});
    yk_ring_fail(ring, YK_RING_NAME);
    return -1;
}

// Returns whether NAME.rate or NAME.accel is itself a name. Few are, so names with such endings are counted.
static bool is_derivative_taken(const YkRing *ring, int32_t coordinate)
{
    static const char *const endings[] = {".rate", ".accel"};
    char name[NAME_MAX_LENGTH + 8];
    const char *of = ring->symbols[coordinate].name;
    for (int k = 0; k < 2 && ring->derivative_names > 0; k++) {
        memcpy(name, of, strlen(of));
        strcpy(name + strlen(of), endings[k]);
        if (yk_names_find(&ring->names, name) >= 0) return true;
    }
    return false;
}

int32_t yk_ring_rates(YkRing *ring, int32_t coordinate)
{
    if (coordinate < 0 || (size_t)coordinate >= ring->symbol_count || is_derivative_taken(ring, coordinate))
        return yk_ring_fail(ring, YK_RING_NAME) ? 0 : -1;
    int32_t rate = add_derived(ring, coordinate, 1, YK_RING_RATE);
    int32_t acceleration = rate < 0 ? -1 : add_derived(ring, coordinate, 2, YK_RING_ACCELERATION);
    if (acceleration < 0) return -1;
    ring->symbols[coordinate].rate_symbol = rate;
    bool well = yk_ring_set_rate(ring, coordinate, yk_ring_of(ring, rate)) &&
                yk_ring_set_rate(ring, rate, yk_ring_of(ring, acceleration));
    return well ? rate : -1;
}

bool yk_ring_set_rate(YkRing *ring, int32_t symbol, const YkPoisson *rate)
{
    if (!rate) return false;
    if (symbol < 0 || (size_t)symbol >= ring->symbol_count) return yk_ring_fail(ring, YK_RING_NAME) != NULL;
    ring->symbols[symbol].rate = yk_ring_keep(ring, rate);
    ring->rule_count++;
    ring->moving_marks |= yk_mark(symbol);
    if (rate->denominator != 1) ring->dependent_marks |= yk_mark(symbol);
    return true;
}

// Adds a dependence; derivative NULL: it is unknown.
static bool add_partial(YkRing *ring, int32_t symbol, int32_t variable, const YkPoisson *derivative)
{
    YkPartial *partial = YK_NEW(ring->arena, YkPartial, 1);
    YkRingMeaning *meaning = yk_ring_meaning(ring, symbol);
    if (!partial || !meaning) return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
    *partial = (YkPartial){meaning->partials, variable, yk_ring_keep(ring, derivative)};
    meaning->partials = partial;
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
    YkRingMeaning *meaning = symbol < 0 ? NULL : yk_ring_meaning(ring, symbol);
    if (!meaning) return -1;
    meaning->square = yk_ring_keep(ring, square);
    ring->dependent_marks |= yk_mark(symbol);
    return symbol;
}

void yk_ring_set_number(YkRing *ring, int32_t symbol, const YkPoisson *number)
{
    YkRingMeaning *meaning = symbol >= 0 && number ? yk_ring_meaning(ring, symbol) : NULL;
    if (meaning) meaning->number = yk_ring_keep(ring, number);
}

int32_t yk_ring_find(const YkRing *ring, const char *name)
{
    int32_t symbol = yk_names_find(&ring->names, name);
    return symbol >= 0 ? symbol : find_derivative(ring, name);
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
    return (YkRingClass)ring->symbols[symbol].kind;
}

bool yk_ring_is_angle(const YkRing *ring, int32_t symbol)
{
    return ring->symbols[symbol].is_angle;
}

bool yk_ring_has_symbol(YkRing *ring, int32_t symbol)
{
    if (symbol >= 0 && (size_t)symbol < ring->symbol_count) return true;
    yk_ring_fail(ring, YK_RING_NAME);
    return false;
}

const YkPoisson *yk_ring_of(YkRing *ring, int32_t symbol)
{
    if (!yk_ring_has_symbol(ring, symbol)) return NULL;
    if (ring->symbols[symbol].element) return ring->symbols[symbol].element;
    uint32_t monomial = yk_ring_monomial_of(ring, symbol, 1);
    if (monomial == YK_NO_PRODUCT) return NULL;
    return ring->symbols[symbol].element = yk_ring_keep(ring, yk_poisson_term(ring, yk_key(0, monomial, 0), 1, 1));
}

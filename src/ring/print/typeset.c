// Typesets a symbol's name: theta1'' is a base theta, a subscript 1 and two dots.
#include <string.h>
#include "base/letters.h"
#include "base/text.h"
#include "ring/inside.h"
#include "ring/print/write.h"

typedef struct Greek {
    const char *name, *utf8;
} Greek;
// No capital that looks like a Latin letter, and no omicron.
static const Greek letters[] = {
    {"alpha", "α"}, {"beta", "β"},  {"gamma", "γ"}, {"delta", "δ"},  {"epsilon", "ε"}, {"zeta", "ζ"}, {"eta", "η"},
    {"theta", "θ"}, {"iota", "ι"},  {"kappa", "κ"}, {"lambda", "λ"}, {"mu", "μ"},      {"nu", "ν"},   {"xi", "ξ"},
    {"pi", "π"},    {"rho", "ρ"},   {"sigma", "σ"}, {"tau", "τ"},    {"phi", "φ"},     {"chi", "χ"},  {"psi", "ψ"},
    {"omega", "ω"}, {"Gamma", "Γ"}, {"Delta", "Δ"}, {"Theta", "Θ"},  {"Lambda", "Λ"},  {"Xi", "Ξ"},   {"Sigma", "Σ"},
    {"Phi", "Φ"},   {"Psi", "Ψ"},   {"Omega", "Ω"}};

typedef struct Parts {
    size_t stem, base, dots; // lengths: the name without primes, its base; the number of primes
    const Greek *greek;      // or NULL
    bool is_word;            // set as one word: no subscript, or a base of three or more letters
} Parts;

static bool is_lower(char c)
{
    return c >= 'a' && c <= 'z';
}

// Finds a Greek letter's name at the start, not followed by more of a lower-case word.
static const Greek *find_greek(const char *name)
{
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++) {
        size_t length = strlen(letters[i].name);
        if (strncmp(name, letters[i].name, length) == 0 && !is_lower(name[length])) return &letters[i];
    }
    return NULL;
}

static Parts take_apart(const char *name)
{
    Parts parts = {.stem = strcspn(name, "'"), .greek = find_greek(name)};
    parts.dots = strlen(name) - parts.stem;
    size_t lower = 0;
    while (is_lower(name[lower])) lower++;
    bool dotted = memchr(name, '.', parts.stem) != NULL || !yk_is_letter(name[0]);
    parts.base = dotted ? parts.stem : parts.greek ? strlen(parts.greek->name) : lower > 2 ? lower : 1;
    if (dotted) parts.greek = NULL;
    parts.is_word = dotted || (!parts.greek && parts.base > 1);
    return parts;
}

// Writes the subscript without underscores at its ends; those within become commas.
static void put_subscript(YkText *text, const char *name, size_t from, size_t end)
{
    while (from < end && name[from] == '_') from++;
    for (size_t i = from; i < end; i++) yk_text_format(text, "%c", name[i] == '_' ? ',' : name[i]);
}

static bool has_subscript(const char *name, const Parts *parts)
{
    return strspn(name + parts->base, "_") < parts->stem - parts->base;
}

static void put_escaped(YkText *text, const char *name, size_t length)
{
    for (size_t i = 0; i < length; i++) yk_text_format(text, name[i] == '_' ? "\\%c" : "%c", name[i]);
}

static void put_latex(YkText *text, const char *name, const Parts *parts)
{
    for (size_t i = 0; i < parts->dots; i++) yk_text_puts(text, i == 0 ? "\\" : "d");
    if (parts->dots > 0)
        yk_text_puts(text, "dot{"); // \dot, \ddot, \dddot: the first backslash, then one d for each more
    if (parts->greek) yk_text_format(text, "\\%s", parts->greek->name);
    if (parts->is_word) yk_text_puts(text, "\\mathit{");
    if (!parts->greek) put_escaped(text, name, parts->base);
    if (parts->is_word) yk_text_puts(text, "}");
    if (parts->dots > 0) yk_text_puts(text, "}");
    if (!has_subscript(name, parts)) return;
    yk_text_puts(text, "_{");
    put_subscript(text, name, parts->base, parts->stem);
    yk_text_puts(text, "}");
}

static void put_mathml(YkText *text, const char *name, const Parts *parts)
{
    bool subscript = has_subscript(name, parts);
    if (subscript) yk_text_puts(text, "<msub>");
    if (parts->dots > 0) yk_text_puts(text, "<mover>");
    yk_text_puts(text, "<mi>");
    if (parts->greek)
        yk_text_puts(text, parts->greek->utf8);
    else
        yk_text_add(text, name, parts->base);
    yk_text_puts(text, "</mi>");
    if (parts->dots > 0) {
        yk_text_puts(text, "<mo>");
        for (size_t i = 0; i < parts->dots; i += 2) yk_text_puts(text, i + 1 < parts->dots ? "¨" : "˙");
        yk_text_puts(text, "</mo></mover>");
    }
    if (!subscript) return;
    yk_text_puts(text, "<mi>");
    put_subscript(text, name, parts->base, parts->stem);
    yk_text_puts(text, "</mi></msub>");
}

static void put_c(YkText *text, const YkRingSymbol *symbol, const Parts *parts)
{
    static const char *const keywords[] = {
        "auto",   "break",    "case",     "char",     "const", "continue", "default", "do",     "double",
        "else",   "enum",     "extern",   "float",    "for",   "goto",     "if",      "inline", "int",
        "long",   "register", "restrict", "return",   "short", "signed",   "sizeof",  "static", "struct",
        "switch", "typedef",  "union",    "unsigned", "void",  "volatile", "while"};
    for (size_t i = 0; i < parts->stem; i++) {
        char c = symbol->name[i];
        yk_text_format(text, "%c", c == '.' ? '_' : c);
    }
    if (parts->dots > 0 && symbol->kind == YK_RING_RATE)
        yk_text_puts(text, "_rate");
    else if (parts->dots > 0 && symbol->kind == YK_RING_ACCELERATION)
        yk_text_puts(text, "_accel");
    else if (parts->dots > 0)
        yk_text_format(text, "_d%z", parts->dots);
    for (size_t i = 0; i < sizeof keywords / sizeof *keywords; i++)
        if (strcmp(yk_text_get(text), keywords[i]) == 0) yk_text_puts(text, "_");
}

// Keeps a copy of the text in the arena and enters it in `names` unless it is taken (*taken). With names NULL any text
// is accepted.
static const char *keep(YkRing *ring, YkNames *names, const YkText *text, bool *taken)
{
    int32_t existing = YK_NONE, index = (int32_t)ring->typeset_count;
    *taken = false;
    const char *copy = yk_arena_copy(ring->arena, yk_text_get(text), text->length);
    if (copy && names && !yk_names_add(names, copy, index, &existing)) return NULL;
    *taken = existing != YK_NONE;
    return copy;
}

static const char *latex_name(YkRing *ring, const char *name, const Parts *parts, YkText *text)
{
    bool taken;
    yk_text_clear(text);
    put_latex(text, name, parts);
    const char *latex = keep(ring, &ring->latex_names, text, &taken);
    if (!latex || !taken) return latex;
    yk_text_clear(text); // lc1 and l_c1 look alike: the later one is set as a word
    for (size_t i = 0; i < parts->dots; i++) yk_text_puts(text, i == 0 ? "\\" : "d");
    yk_text_puts(text, parts->dots > 0 ? "dot{\\mathtt{" : "\\mathtt{");
    put_escaped(text, name, parts->stem);
    yk_text_puts(text, parts->dots > 0 ? "}}" : "}");
    return keep(ring, &ring->latex_names, text, &taken);
}

static const char *c_name(YkRing *ring, const YkRingSymbol *symbol, const Parts *parts, YkText *text)
{
    bool taken = true;
    const char *c = NULL;
    yk_text_clear(text);
    put_c(text, symbol, parts);
    for (int i = 0; taken; i++) {
        if (i > 0) yk_text_puts(text, "_");
        c = keep(ring, &ring->c_names, text, &taken);
    }
    return c;
}

static bool typeset(YkRing *ring, const YkRingSymbol *symbol, YkTypesetName *names)
{
    YkText text = {0};
    bool any;
    const Parts parts = take_apart(symbol->name);
    names->latex = symbol->meaning->pi_over == 1 ? "\\pi" : latex_name(ring, symbol->name, &parts, &text);
    names->c = c_name(ring, symbol, &parts, &text);
    yk_text_clear(&text);
    put_mathml(&text, symbol->name, &parts);
    names->mathml = symbol->meaning->pi_over == 1 ? "<mi>π</mi>" : keep(ring, NULL, &text, &any);
    yk_text_free(&text);
    return names->latex && names->c && names->mathml;
}

bool yk_ring_typeset(YkRing *ring)
{
    for (; ring->typeset_count < ring->symbol_count; ring->typeset_count++)
        if (!YK_ROOM(ring->typeset, ring->typeset_count, ring->typeset_capacity) ||
            !typeset(ring, &ring->symbols[ring->typeset_count], &ring->typeset[ring->typeset_count]))
            return yk_ring_fail(ring, YK_RING_MEMORY) != NULL;
    return true;
}

const char *yk_ring_name_in(YkRing *ring, int32_t symbol, YkRingFormat format)
{
    bool is_plain = format == YK_RING_TEXT || format == YK_RING_BOOK || !yk_ring_typeset(ring);
    if (is_plain) return ring->symbols[symbol].name;
    const YkTypesetName *named = &ring->typeset[symbol];
    return format == YK_RING_LATEX ? named->latex : format == YK_RING_MATHML ? named->mathml : named->c;
}

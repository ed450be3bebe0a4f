// Prints pages as C: a struct of everything in the formulas, and one function per section, which computes what the
// section states. All sections become values of one graph, which computes shared parts once; then they are printed.
#include <stdlib.h>
#include <string.h>
#include "base/letters.h"
#include "base/number.h"
#include "graph/print.h"
#include "page/print.h"
#include "ring/graph/element.h"

// A result of a function: an array, a number, or a field of the struct.
typedef struct Result {
    const char *name; // NULL: a field
    int32_t field;
    size_t rows, columns; // of an array; 0: one number
    size_t first;         // of its values
} Result;

typedef struct Function { // a section
    const YkLine *first;
    size_t first_result, result_count;
} Function;

typedef struct Code {
    YkPrinting *printing;
    const YkPage *page;
    YkRingGraph graph;
    YkPrinter printer;
    YkText words;   // a body, until it is put
    bool *is_field; // per symbol: in the struct
    size_t symbol_count;
    Function *functions;
    size_t function_count, function_capacity;
    size_t first_result; // of the present function
    Result *results;
    size_t result_count, result_capacity;
    YkRef *values;
    size_t value_count, value_capacity;
    YkArena *arena; // of names
    bool failed;
} Code;

// --- Results

static Result *add_result(Code *code, const char *name, int32_t field, size_t rows, size_t columns)
{
    if (!YK_ROOM(code->results, code->result_count, code->result_capacity)) {
        code->failed = true;
        return NULL;
    }
    Result *result = &code->results[code->result_count++];
    *result = (Result){name, field, rows, columns, code->value_count};
    return result;
}

static void add_value(Code *code, YkRef value)
{
    if (!YK_ROOM(code->values, code->value_count, code->value_capacity)) {
        code->failed = true;
        return;
    }
    code->values[code->value_count++] = value;
}

static YkRef value_of(Code *code, const YkPoisson *over, const YkPoisson *under)
{
    YkRef value = yk_ring_graph_of(&code->graph, over);
    return under ? yk_graph_divide(&code->graph.graph, value, yk_ring_graph_of(&code->graph, under)) : value;
}

static void add_matrix(Code *code, const YkShownMatrix *matrix)
{
    size_t count = matrix->rows * matrix->columns;
    // A machine without freedom has empty ones, which are nothing that a function could write.
    if (count == 0 || !add_result(code, matrix->target, -1, matrix->rows, matrix->columns)) return;
    YkRef *entries = calloc(count + 1, sizeof *entries);
    if (!entries) {
        code->failed = true;
        return;
    }
    if (matrix->build) code->failed |= !matrix->build(matrix->build_context, &code->graph, entries);
    for (size_t k = 0; k < count; k++) {
        const YkPoisson *entry = matrix->entries[k];
        bool is_built = matrix->build || !entry;
        add_value(code, matrix->build ? entries[k]
                        : is_built    ? yk_graph_number(&code->graph.graph, 0)
                                      : value_of(code, entry, NULL));
    }
    free(entries);
}

static bool is_constant(const Code *code, int32_t symbol)
{
    YkRingClass kind = yk_ring_symbol_class(code->page->ring, symbol);
    return kind <= YK_RING_CONSTANT || kind == YK_RING_GRAVITY;
}

// Adds a symbol that the line solves for: a field of the struct, known from now on. Names of constants are for readers.
static void add_field(Code *code, const YkLine *line)
{
    if (is_constant(code, line->solved) || !add_result(code, NULL, line->solved, 0, 0)) return;
    YkRef value = value_of(code, line->over, line->under);
    add_value(code, value);
    code->is_field[line->solved] = true;
    yk_ring_graph_define(&code->graph, line->solved, value);
}

static Result *find_result(const Code *code, const char *name)
{
    for (size_t k = code->first_result; k < code->result_count; k++)
        if (code->results[k].name && strcmp(code->results[k].name, name) == 0) return &code->results[k];
    return NULL;
}

// Adds the equation of a loop or a relation. One array holds them all: the values of what came between make room.
static void add_row(Code *code, const YkLine *line)
{
    Result *rows = find_result(code, "Phi");
    if (!rows) rows = add_result(code, "Phi", -1, 0, 1);
    add_value(code, value_of(code, line->over, line->under));
    if (!rows || code->failed) return;
    size_t at = rows->first + rows->rows++, last = code->value_count - 1;
    YkRef value = code->values[last];
    memmove(code->values + at + 1, code->values + at, (last - at) * sizeof value);
    code->values[at] = value;
    for (size_t k = (size_t)(rows - code->results) + 1; k < code->result_count; k++) code->results[k].first++;
}

// --- Names: p^{A/O} is p_A_O; a name that two lines share gets a number

static const char *name_of(Code *code, const YkPagePiece *piece)
{
    const char *const parts[] = {piece->text, piece->super, piece->sub};
    YkText name = {0};
    for (int k = 0; k < 3; k++) {
        if (!parts[k] || !*parts[k]) continue;
        if (k > 0) yk_text_puts(&name, "_");
        for (const char *c = parts[k]; *c; c++) {
            yk_text_format(&name, "%c", yk_is_letter(*c) || yk_is_digit(*c) ? *c : '_');
        }
    }
    size_t length = name.length;
    for (unsigned number = 2; !name.failed && find_result(code, yk_text_get(&name)); number++) {
        name.length = length;
        yk_text_format(&name, "_%u", number);
    }
    const char *copy = yk_arena_copy(code->arena, yk_text_get(&name), name.length);
    yk_text_free(&name);
    if (!copy) code->failed = true;
    return copy ? copy : "";
}

// Returns whether it is "F_12 = ..." with a value, a definition.
static bool is_named_value(const YkLine *line)
{
    const YkPagePiece *first = line->first, *second = first ? first->next : NULL;
    if (line->value && line->target) return true;
    return line->value && first->kind == YK_PIECE_VECTOR && second && second->kind == YK_PIECE_SIGN &&
           strcmp(second->text, "=") == 0;
}

static void add_named(Code *code, const YkLine *line)
{
    YkRing *ring = code->page->ring;
    const char *name = line->target ? line->target : name_of(code, line->first);
    if (!add_result(code, name, -1, line->is_vector ? 2 : 0, 1)) return;
    const YkPoisson *value = yk_line_value(ring, line);
    if (!line->is_vector) {
        add_value(code, value_of(code, value, line->value_under));
        return;
    }
    add_value(code, value_of(code, yk_ring_real(ring, value), NULL));
    add_value(code, value_of(code, yk_ring_imaginary(ring, value), NULL));
}

static bool add_matrices(Code *code, const YkLine *line)
{
    bool found = false;
    for (const YkPagePiece *piece = line->first; piece; piece = piece->next) {
        if (piece->kind != YK_PIECE_MATRIX || !piece->matrix->target) continue;
        add_matrix(code, piece->matrix);
        found = true;
    }
    return found;
}

static void add_line(Code *code, const YkLine *line)
{
    if (line->kind != YK_LINE_FORMULA || add_matrices(code, line)) return;
    if (line->solved >= 0)
        add_field(code, line);
    else if (line->target && line->over && strcmp(line->target, "Phi") == 0)
        add_row(code, line);
    else if (is_named_value(line))
        add_named(code, line);
}

// --- Functions

static void put_comment(YkText *text, const char *indent, const char *words)
{
    yk_text_format(text, "%s// ", indent);
    size_t column = strlen(indent) + 3;
    if (words == yk_text_lost) yk_text_fail(text);
    for (const char *c = words; *c; c++, column++) {
        bool is_break = *c == ' ' && column + strcspn(c + 1, " ") > 116;
        if (is_break) column = strlen(indent) + 2;
        if (is_break)
            yk_text_format(text, "\n%s// ", indent);
        else
            yk_text_format(text, "%c", *c == '\\' || *c == '\n' ? '/' : *c);
    }
    yk_text_puts(text, "\n");
}

static void put_parameters(const Code *code, const Function *f, YkText *text)
{
    const Result *results = &code->results[f->first_result];
    bool writes = false;
    for (size_t k = 0; k < f->result_count; k++) writes = writes || !results[k].name;
    yk_text_puts(text, writes ? "(Machine *m" : "(const Machine *restrict m");
    for (size_t k = 0; k < f->result_count; k++) {
        const Result *r = &results[k];
        if (!r->name) continue;
        yk_text_format(text, r->rows > 0 ? ", double %s[%z]" : ", double *%s", r->name, r->rows);
        if (r->columns > 1) yk_text_format(text, "[%z]", r->columns);
    }
    yk_text_puts(text, ")");
}

static void put_target(Code *code, const Result *r, size_t k)
{
    YkText *text = &code->words;
    if (!r->name) {
        yk_text_format(text, "    m->%s = ", yk_ring_name_in(code->page->ring, r->field, YK_RING_C));
        return;
    }
    yk_text_format(text, r->rows > 0 ? "    %s" : "    *%s", r->name);
    if (r->rows > 0) yk_text_format(text, "[%z]", k / r->columns);
    if (r->columns > 1) yk_text_format(text, "[%z]", k % r->columns);
    yk_text_puts(text, " = ");
}

static size_t size_of(const Result *r)
{
    return r->rows > 0 ? r->rows * r->columns : 1;
}

static void put_result(Code *code, const Result *r)
{
    for (size_t k = 0; k < size_of(r); k++) {
        size_t from = code->words.length;
        put_target(code, r, k);
        yk_printer_value(&code->printer, code->values[r->first + k]);
        yk_text_puts(&code->words, ";");
        yk_printer_wrap(&code->printer, from);
        yk_text_puts(&code->words, "\n");
    }
}

// Writes the statements in `words`.
static void put_body(Code *code, const Function *f)
{
    const Result *results = &code->results[f->first_result], *last = &results[f->result_count - 1];
    yk_text_clear(&code->words);
    size_t count = last->first + size_of(last) - results->first;
    YkRef *roots = YK_NEW(code->arena, YkRef, count);
    for (size_t k = 0; roots && k < count; k++) { // x and -x are one value that is used twice
        roots[k] = code->values[results->first + k];
        const YkValue *v = &code->graph.graph.values[roots[k]];
        if (v->op == YK_VALUE_MINUS) roots[k] = v->a;
    }
    YkRef *written = YK_NEW(code->arena, YkRef, f->result_count);
    if (!roots || !written) return;
    code->printer.written = written;
    code->printer.written_count = 0;
    for (size_t k = 0; k < f->result_count; k++) {
        YkRef leaf = results[k].name ? YK_NONE : code->graph.leaf[results[k].field];
        if (leaf != YK_NONE) written[code->printer.written_count++] = leaf;
    }
    yk_printer_body(&code->printer, roots, count);
    for (size_t k = 0; k < f->result_count; k++) put_result(code, &results[k]);
}

static void put_head(const Code *code, const Function *f, YkText *text)
{
    yk_text_puts(text, "void machine_");
    for (const char *c = f->first->section; *c; c++) yk_text_format(text, "%c", *c == '-' ? '_' : *c);
    put_parameters(code, f, text);
}

static void put_remarks(const YkLine *first, YkText *text)
{
    for (const YkLine *line = first; line && line->section == first->section; line = line->next)
        for (const YkPagePiece *piece = line->first; piece; piece = piece->next)
            if (piece->kind == YK_PIECE_MATRIX && piece->matrix->target && piece->matrix->code_remark)
                put_comment(text, "", piece->matrix->code_remark);
}

static void put_function(Code *code, const Function *f, YkText *text)
{
    code->first_result = f->first_result;
    code->result_count = f->first_result + f->result_count; // for names of variables
    put_body(code, f);
    yk_text_puts(text, "\n");
    put_comment(text, "", f->first->kind == YK_LINE_HEADING ? f->first->text : f->first->section);
    put_remarks(f->first, text);
    put_head(code, f, text);
    bool reads = strstr(yk_text_get(&code->words), "m->") != NULL;
    yk_text_format(text, "\n{\n%s%s}\n", reads ? "" : "    (void)m;\n", yk_text_get(&code->words));
}

// Adds one section as values; returns the line after it.
static const YkLine *add_section(Code *code, const YkLine *first)
{
    size_t known = code->graph.definition_count, from = code->first_result = code->result_count;
    const YkLine *line = first;
    for (; line && line->section == first->section && !code->failed; line = line->next) add_line(code, line);
    yk_ring_graph_forget(&code->graph, known);
    if (code->result_count == from) return line;
    if (YK_ROOM(code->functions, code->function_count, code->function_capacity))
        code->functions[code->function_count++] = (Function){first, from, code->result_count - from};
    else
        code->failed = true;
    return line;
}

// --- The whole

// Finds what the values need of the struct: symbols, and constants under names of their own.
static void need_fields(Code *code)
{
    YkPrinter *pr = &code->printer;
    yk_printer_need(pr, code->values, code->value_count);
    for (size_t k = 0; k < pr->field_count; k++) pr->field[pr->fields[k]] = yk_graph_text(pr->graph, "constant[%z]", k);
    for (size_t k = 0; k < 2; k++) {
        for (size_t s = 0; s < code->graph.symbol_count && s < code->symbol_count; s++)
            code->is_field[s] |= code->graph.leaf[s] != YK_NONE && pr->count[code->graph.leaf[s]] > 0;
        if (k == 0) yk_printer_machine(pr); // into `words`; it reads parameters
    }
}

// Writes the fields: constants first, then the rest.
static void put_struct(Code *code, YkText *text)
{
    size_t count = 0;
    yk_text_puts(text, "typedef struct Machine {\n");
    for (int rest = 0; rest < 2; rest++)
        for (size_t s = 0; s < code->symbol_count; s++) {
            if (!code->is_field[s] || is_constant(code, (int32_t)s) == (rest == 1)) continue;
            const char *name = yk_ring_symbol_name(code->page->ring, (int32_t)s);
            const char *field = yk_ring_name_in(code->page->ring, (int32_t)s, YK_RING_C);
            bool is_same = strcmp(name, field) == 0;
            yk_text_format(text, "    double %s;%s%s\n", field, is_same ? "" : " // ", is_same ? "" : name);
            count++;
        }
    size_t constants = code->printer.field_count;
    if (constants > 0) yk_text_format(text, "    double constant[%z]; // by machine_constants\n", constants);
    if (constants + count == 0) yk_text_puts(text, "    double unused;\n");
    yk_text_puts(text, "} Machine;\n");
}

static void put_pose(Code *code, YkText *text)
{
    bool is_first = true;
    yk_text_puts(text, "\n// The pose.\nconst Machine machine_at_pose = {");
    for (size_t s = 0; s < code->symbol_count; s++) {
        char digits[YK_NUMBER_SIZE];
        double value = code->printing->values[s];
        if (!code->is_field[s] || !(value - value == 0)) continue;
        yk_number_write(value, digits);
        yk_text_format(text, "%s.%s = %s", is_first ? "" : ",\n                               ",
                       yk_ring_name_in(code->page->ring, (int32_t)s, YK_RING_C), digits);
        is_first = false;
    }
    yk_text_puts(text, is_first ? "0};\n" : "};\n");
}

static void put_all(Code *code, YkText *text)
{
    const char *title = code->printing->title;
    if (title) put_comment(text, "", title);
    yk_text_puts(
        text, "// Set the fields, in SI and radians; then machine_constants, again after every change of a parameter; "
              "then the rest.\n// Needs libm.\n#include <math.h>\n\n");
    put_struct(code, text);
    if (code->printing->values) put_pose(code, text);
    yk_text_puts(text, "\nvoid machine_constants(Machine *m);\n");
    for (size_t k = 0; k < code->function_count; k++) {
        put_head(code, &code->functions[k], text);
        yk_text_puts(text, ";\n");
    }
    yk_text_puts(text, "\n// What depends on parameters alone.\nvoid machine_constants(Machine *m)\n{\n");
    yk_text_format(text, "%s%s}\n", yk_text_has_some(&code->words) ? "" : "    (void)m;\n", yk_text_get(&code->words));
    for (size_t k = 0; k < code->function_count; k++) put_function(code, &code->functions[k], text);
}

// A variable is not called like what the function gives.
static const char *name_of_variable(void *code, const char *wish)
{
    return find_result(code, wish) ? yk_graph_text(&((Code *)code)->graph.graph, "%s_", wish) : wish;
}

static bool start(Code *code)
{
    const YkPage *page = code->page;
    code->arena = yk_arena_new();
    if (!code->arena || !yk_ring_graph_start(&code->graph, page->ring, code->arena)) return false;
    return !page->define || page->define(page->define_context, &code->graph);
}

static void print(Code *code)
{
    const YkPrinterFile file = {
        .context = code, .parameter = "m->", .own_parameter = "m->", .machine = "m->", .name = name_of_variable};
    code->first_result = code->result_count; // the constants give nothing
    code->failed |= code->graph.graph.failed ||
                    !yk_printer_start(&code->printer, &code->graph.graph, &file, "machine", false, &code->words);
    if (code->failed) return;
    need_fields(code);
    put_all(code, code->printing->text);
    code->failed =
        yk_arena_failed(code->arena) || code->words.failed || code->printer.failed || code->graph.graph.failed;
}

void yk_print_c(YkPrinting *printing, const YkPage *page)
{
    Code code = {.printing = printing, .page = page};
    code.symbol_count = yk_ring_symbol_count(page->ring);
    code.is_field = calloc(code.symbol_count + 1, sizeof *code.is_field);
    code.failed = !code.is_field || !start(&code);
    for (const YkLine *line = page->first; line && !code.failed;) line = add_section(&code, line);
    if (!code.failed) print(&code);
    printing->failed |= code.failed;
    yk_printer_end(&code.printer);
    yk_ring_graph_end(&code.graph);
    yk_text_free(&code.words);
    free(code.functions);
    free(code.results);
    free(code.values);
    free(code.is_field);
    yk_arena_free(code.arena);
}

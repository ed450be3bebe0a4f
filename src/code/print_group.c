// Prints Newton's method for one group as a function of its own.
#include "code/file.h"

typedef struct Gather {
    YkPrinter *pr;
    YkRef *known;
    size_t count, capacity;
    signed char *hangs; // per value: whether it depends on the unknowns. 0: not checked; 1: no; 2: yes
} Gather;

// Returns the operands; for a law's result, the law's argument. Results of other calls depend on no unknown.
static size_t operands_of(const Gather *g, const YkValue *v, YkRef *operands)
{
    const YkRef all[] = {v->a, v->b, v->c};
    size_t count = 0;
    if (v->op == YK_VALUE_LEAF) return 0;
    if (v->op == YK_VALUE_RESULT) {
        const YkCall *call = &g->pr->graph->calls[v->a];
        if (call->kind == YK_CALL_LAW) operands[count++] = call->arguments[0];
        return count;
    }
    for (size_t k = 0; k < 3; k++)
        if (all[k] >= 0) operands[count++] = all[k];
    return count;
}

static bool hangs(Gather *g, YkRef value)
{
    const YkValue *v = yk_printer_at(g->pr, value);
    if (g->hangs[value]) return g->hangs[value] == 2;
    bool found = v->op == YK_VALUE_LEAF && !v->of_parameters && v->leaf_class == YK_LEAF_UNKNOWN;
    YkRef operands[3];
    size_t count = operands_of(g, v, operands);
    for (size_t k = 0; k < count; k++)
        if (hangs(g, operands[k])) found = true;
    g->hangs[value] = found ? 2 : 1;
    return found;
}

// Collects from outside what depends neither on the unknowns nor on parameters alone.
static void gather(Gather *g, YkRef value)
{
    const YkValue *v = yk_printer_at(g->pr, value);
    if (v->of_parameters || (v->op == YK_VALUE_LEAF && hangs(g, value))) return;
    if (hangs(g, value)) {
        YkRef operands[3];
        size_t count = operands_of(g, v, operands);
        for (size_t k = 0; k < count; k++) gather(g, operands[k]);
        return;
    }
    for (size_t k = 0; k < g->count && k < g->capacity; k++)
        if (g->known[k] == value) return;
    if (g->count < g->capacity) g->known[g->count] = value;
    g->count++;
}

size_t yk_call_known(YkPrinter *pr, const YkCall *call, YkRef *known, size_t capacity)
{
    if (call->kind != YK_CALL_GROUP) return 0;
    const YkProgram *p = pr->file->context;
    const YkPlaced *placed = &p->placed[call->index];
    size_t n = p->mech->blocks[call->index].column_count;
    Gather g = {pr, known, 0, capacity, YK_NEW(p->arena, signed char, pr->room)};
    if (!g.hangs) {
        pr->failed = true;
        return 0;
    }
    for (size_t k = 0; k < n; k++) gather(&g, placed->residual[k]);
    for (size_t k = 0; k < n * n; k++) gather(&g, placed->jacobian[k]);
    if (g.count <= capacity) return g.count;
    pr->failed = true;
    return capacity;
}

// Returns the rows of the system with their right side; NULL when out of memory.
static const YkRef *system_of(YkProgram *p, const YkPlaced *placed, int n)
{
    YkRef *roots = YK_NEW(p->arena, YkRef, (size_t)(n + n * n));
    for (int i = 0; roots && i < n; i++) {
        for (int j = 0; j < n; j++) roots[i * (n + 1) + j] = placed->jacobian[i * n + j];
        roots[i * (n + 1) + n] = yk_graph_minus(&p->graph, placed->residual[i]);
    }
    return roots;
}

static void write_loops(YkFile *file, const YkBlock *b, const YkPlaced *placed, const YkRef *roots)
{
    YkProgram *p = &file->program;
    YkPrinter *pr = &file->printer;
    const char *real = yk_printer_real(pr), *name = placed->name;
    int n = (int)b->column_count;
    YkRef known[YK_PRINTER_KNOWN_MAX];
    size_t count = yk_call_known(pr, &p->graph.calls[placed->call], known, YK_PRINTER_KNOWN_MAX);
    if (pr->failed) return;
    yk_text_format(
        pr->out,
        "/* The loops of group %s at the unknowns x[%d]: each row of `system` is a row of their Jacobian and\n"
        "   minus the loop's error; returns the sum of the errors, m. */\n",
        b->label, n);
    yk_text_format(pr->out,
                   "static %s %s_loops_%s(const %s_machine *m, const %s *known, const %s *x_%s, %s *system)\n{\n", real,
                   pr->prefix, name, pr->prefix, real, real, name, real);
    yk_text_format(pr->out, "    %s miss = 0;\n    (void)m;\n    (void)known;\n", real);
    pr->cut = known;
    pr->cut_count = count;
    pr->unknowns = yk_graph_text(&p->graph, "x_%s", name);
    yk_printer_body(pr, roots, (size_t)(n * (n + 1)));
    for (int k = 0; k < n * (n + 1); k++) {
        yk_text_format(pr->out, "    system[%d] = ", k);
        yk_printer_value(pr, roots[k]);
        yk_text_puts(pr->out, ";\n");
    }
    pr->cut = NULL;
    pr->cut_count = 0;
    pr->unknowns = NULL;
    yk_text_format(pr->out,
                   "    for (int k = 0; k < %d; k++) {\n"
                   "        miss += fabs%s(system[k * %d + %d]);\n"
                   "    }\n    return miss;\n}\n\n",
                   n, pr->single ? "f" : "", n + 1, n);
}

static void write_newton(YkFile *file, const YkBlock *b, const YkPlaced *placed)
{
    YkProgram *p = &file->program;
    YkPrinter *pr = &file->printer;
    const char *real = yk_printer_real(pr), *name = placed->name;
    int n = (int)b->column_count, places = n * (n + 1);
    bool is_large = n > YK_FILE_SMALL_SYSTEM;
    yk_text_format(
        pr->out,
        "/* Newton's method from the guess in x[0..%d]; then x[%d]: the error over the tolerance, x[%d]: the\n"
        "   determinant over the lengths of the columns%s. It stops when the error no longer shrinks. */\n",
        n - 1, n, n + 1, is_large ? ",\n   or the least sine" : "");
    yk_text_format(pr->out, "static void %s_solve_%s(const %s_machine *m, const %s *known, %s *x)\n{\n", pr->prefix,
                   name, pr->prefix, real, real);
    yk_text_format(pr->out, "    %s system[%d], last = -1, determinant = 0;\n", real, places + (is_large ? n : 0));
    yk_text_format(pr->out, "    %s miss = %s_loops_%s(m, known, x, system);\n", real, pr->prefix, name);
    yk_text_format(pr->out,
                   "    for (int round = 0; round < 30; round++) {\n"
                   "        determinant = %s_equations(%d, 1, system);\n"
                   "        if (miss == 0 || (last >= 0 && !(miss < last)) || determinant == 0) ",
                   pr->prefix, n);
    if (is_large)
        yk_text_format(pr->out,
                       "{\n            determinant = %s_sine(%d, %d, system, system + %d, determinant);\n            "
                       "break;\n        }\n",
                       pr->prefix, n, n + 1, places);
    else
        yk_text_puts(pr->out, "break;\n");
    yk_text_format(pr->out,
                   "        for (int k = 0; k < %d; k++) x[k] += system[k * %d + %d];\n"
                   "        last = miss;\n"
                   "        miss = %s_loops_%s(m, known, x, system);\n"
                   "    }\n",
                   n, n + 1, n, pr->prefix, name);
    yk_text_format(pr->out, "    x[%d] = miss / ", n);
    yk_printer_number(pr, (pr->single ? 1e-5 : 1e-12) * yk_program_size(p));
    yk_text_format(pr->out, ";\n    x[%d] = determinant;\n}\n\n", n + 1);
}

void yk_file_write_group(YkFile *file, size_t block)
{
    YkProgram *p = &file->program;
    const YkBlock *b = &p->mech->blocks[block];
    const YkPlaced *placed = &p->placed[block];
    const YkRef *roots = system_of(p, placed, (int)b->column_count);
    if (!roots) return;
    write_loops(file, b, placed, roots);
    write_newton(file, b, placed);
}

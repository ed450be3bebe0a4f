// Starts the printer, and finds the values of the graph that a function needs.
#include "graph/print.h"
#include <stdlib.h>
#include <string.h>

bool yk_printer_start(YkPrinter *pr, YkGraph *graph, const YkPrinterFile *file, const char *prefix, bool single,
                      YkText *out)
{
    *pr = (YkPrinter){.graph = graph, .file = file, .prefix = prefix, .single = single, .out = out};
    size_t n = pr->room = graph->count + 1;
    pr->field = calloc(n, sizeof *pr->field);
    pr->marked = calloc(n, sizeof *pr->marked);
    pr->count = calloc(n, sizeof *pr->count);
    pr->local = calloc(n, sizeof *pr->local);
    pr->call_done = calloc(graph->call_count + 1, sizeof *pr->call_done);
    return pr->field && pr->marked && pr->count && pr->local && pr->call_done;
}

void yk_printer_end(YkPrinter *pr)
{
    free(pr->field);
    free(pr->fields);
    free(pr->marked);
    free(pr->count);
    free(pr->local);
    free(pr->call_done);
    yk_names_free(&pr->taken);
}

// --- what is needed

static void mark_call(YkPrinter *pr, int32_t index);

static void mark(YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    pr->count[value]++;
    if (yk_printer_is_given(pr, value) || (pr->marked[value] && v->op != YK_VALUE_MINUS)) return;
    pr->marked[value] = true; // a sign is written wherever it is used, and so uses its operand each time
    if (v->op == YK_VALUE_RESULT) {
        mark_call(pr, v->a);
        return;
    }
    const YkRef operands[] = {v->a, v->b, v->c};
    for (size_t k = 0; k < 3; k++)
        if (operands[k] >= 0) mark(pr, operands[k]);
}

static void mark_call(YkPrinter *pr, int32_t index)
{
    if (pr->call_done[index]) return;
    pr->call_done[index] = true;
    YkCall call = pr->graph->calls[index];
    for (size_t k = 0; k < call.argument_count; k++) mark(pr, call.arguments[k]);
    YkRef known[YK_PRINTER_KNOWN_MAX];
    size_t count = pr->file->call_known(pr, &call, known, YK_PRINTER_KNOWN_MAX);
    for (size_t k = 0; k < count; k++) {
        mark(pr, known[k]);
        pr->count[known[k]]++; // an element of an array: a variable of its own
    }
}

void yk_printer_begin(YkPrinter *pr, const YkRef *roots, size_t count)
{
    memset(pr->marked, 0, pr->room * sizeof *pr->marked);
    memset(pr->count, 0, pr->room * sizeof *pr->count);
    memset(pr->local, 0, pr->room * sizeof *pr->local);
    memset(pr->call_done, 0, (pr->graph->call_count + 1) * sizeof *pr->call_done);
    yk_names_free(&pr->taken);
    pr->section = -1;
    yk_pace_spend(pr->graph->pace, pr->room);
    for (size_t k = 0; k < count; k++) mark(pr, roots[k]);
}

// Notes the machine's value itself, or the one that it is the opposite of.
static void need_field(YkPrinter *pr, YkRef value)
{
    const YkValue *v = yk_printer_at(pr, value);
    if (!v->of_parameters || v->op == YK_VALUE_NUMBER || v->op == YK_VALUE_LEAF) return;
    if (v->op == YK_VALUE_MINUS) {
        need_field(pr, v->a);
        return;
    }
    if (pr->field[value]) return;
    pr->field[value] = ""; // named below, in order
    if (YK_ROOM(pr->fields, pr->field_count, pr->field_capacity))
        pr->fields[pr->field_count++] = value;
    else
        pr->failed = true;
}

void yk_printer_need(YkPrinter *pr, const YkRef *roots, size_t count)
{
    yk_printer_begin(pr, roots, count);
    for (size_t k = 0; k < pr->room - 1; k++)
        if (pr->count[k] > 0) need_field(pr, (YkRef)k);
}

// Evaluates parameters once each, after those they need: depth first, without recursion since a chain of definitions
// may be as long as the file. Reports a cycle with the names along it. Cost linear in names mentioned.
#include <stdlib.h>
#include "model/load.h"

enum { CYCLE_SHOWN = 12 };
typedef enum Visit { NEW, OPEN, DONE } Visit;

typedef struct Order {
    YkLoader *loader;
    int32_t *needs; // needs[first[i]] .. needs[first[i + 1]]: the parameters that parameter i mentions
    size_t *first;  // [parameters + 1]
    size_t count, capacity;
    unsigned char *visit; // Visit per parameter
    size_t *next;         // the need to visit next
    int32_t *stack;       // open parameters, outermost first
    size_t depth;
    bool failed;
} Order;

static void add_need(void *context, const YkExpr *name)
{
    Order *order = context;
    int32_t index = yk_names_find(&order->loader->model->parameter_names, name->name);
    if (index == YK_NONE || order->failed) return;
    if (!YK_ROOM(order->needs, order->count, order->capacity)) {
        order->failed = true;
        return;
    }
    order->needs[order->count++] = index;
}

static void gather_needs(Order *order, const YkModel *model)
{
    for (size_t i = 0; i < model->parameter_count; i++) {
        order->first[i] = order->next[i] = order->count;
        if (model->parameters[i].expr) yk_expr_names(model->parameters[i].expr, add_need, order);
    }
    order->first[model->parameter_count] = order->count;
}

// Reports that the open parameters from `back` on define each other in a cycle.
static void report_cycle(Order *order, int32_t back)
{
    YkLoader *loader = order->loader;
    const YkParameter *parameters = loader->model->parameters;
    YkText *text = &loader->text;
    size_t start = order->depth;
    if (yk_problems_count(loader->problems) >= YK_PROBLEMS_MAX) return;
    while (start > 0 && order->stack[start - 1] != back) start--;
    yk_text_clear(text);
    for (size_t i = start - 1; i < order->depth; i++) {
        if (i - start + 1 == CYCLE_SHOWN) {
            yk_text_puts(text, "... -> ");
            break;
        }
        yk_text_format(text, "%s -> ", parameters[order->stack[i]].name);
    }
    yk_text_puts(text, parameters[back].name);
    YkPlace place = parameters[back].place;
    yk_problem(loader->problems, YK_CODE_PARAMETER_CYCLE, place, "parameters defined by each other: %s",
               yk_text_get(text));
}

static void evaluate(YkLoader *loader, YkParameter *parameter)
{
    YkJet jet;
    if (!parameter->expr || !yk_load_eval(loader->model, parameter->expr, 0, &jet, loader->problems)) return;
    if (yk_load_in_range(loader, parameter->expr->place, jet.d[0])) parameter->value = jet.d[0];
}

static void open_parameter(Order *order, int32_t index)
{
    order->visit[index] = OPEN;
    order->stack[order->depth++] = index;
}

// Visits the next need of the innermost open parameter, or closes and evaluates it.
static void advance(Order *order)
{
    int32_t index = order->stack[order->depth - 1];
    if (order->next[index] == order->first[index + 1]) {
        evaluate(order->loader, &order->loader->model->parameters[index]);
        order->visit[index] = DONE;
        order->depth--;
        return;
    }
    int32_t need = order->needs[order->next[index]++];
    if (order->visit[need] == OPEN) report_cycle(order, need);
    if (order->visit[need] == NEW) open_parameter(order, need);
}

void yk_load_eval_parameters(YkLoader *loader)
{
    size_t count = loader->model->parameter_count;
    Order order = {.loader = loader,
                   .first = YK_NEW(loader->arena, size_t, count + 1),
                   .visit = YK_NEW(loader->arena, unsigned char, count + 1),
                   .next = YK_NEW(loader->arena, size_t, count + 1),
                   .stack = YK_NEW(loader->arena, int32_t, count + 1)};
    if (order.first && order.visit && order.next && order.stack) {
        gather_needs(&order, loader->model);
        for (size_t i = 0; i < count && !order.failed; i++) {
            if (order.visit[i] == NEW) open_parameter(&order, (int32_t)i);
            while (order.depth > 0) advance(&order);
        }
    }
    loader->failed |= order.failed;
    free(order.needs);
}

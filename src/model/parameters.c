// Reads `parameters:`, names for constants, each a number or an expression of the others.
#include <math.h>
#include "model/load.h"

static void read_parameter(YkLoader *loader, YkParameter *parameter, const YkNodePair *pair, int32_t index)
{
    *parameter = (YkParameter){.name = pair->key->text, .place = pair->key->place, .value = NAN};
    YkSubject subject = {.noun = "parameter", .part = pair->key->text};
    bool is_named = yk_load_symbol_name(loader, pair->key, "parameter");
    if (is_named) {
        int32_t existing;
        loader->failed |= !yk_names_add(&loader->model->parameter_names, parameter->name, index, &existing);
    }
    if (!yk_load_expect(loader, pair->value, YK_NODE_SCALAR, &subject)) return;
    YkExpr *expr = yk_expr_parse(pair->value->text, pair->value->length, yk_load_text_place(pair->value), loader->arena,
                                 loader->problems);
    parameter->expr = is_named ? expr : NULL;
}

void yk_load_parameters(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "parameters");
    if (!section || section->count == 0) return;
    YkModel *model = loader->model;
    model->parameters = YK_NEW(loader->arena, YkParameter, section->count);
    loader->replaced = YK_NEW(loader->arena, const YkExpr *, section->count);
    if (!model->parameters || !loader->replaced) return;
    model->parameter_count = section->count;
    for (size_t i = 0; i < section->count; i++) {
        read_parameter(loader, &model->parameters[i], &section->pairs[i], (int32_t)i);
    }
}

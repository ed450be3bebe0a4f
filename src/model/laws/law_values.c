// Reads the values of a law's parts.
#include "model/laws/laws.h"
#include "model/laws/read.h"
#include "model/load.h"

void yk_load_law_number(YkLawReader *reader, const YkNode *node, const char *noun, YkDimension dimension,
                        YkLawNumber *number)
{
    YkWant want = {.dimension = dimension, .subject = {.noun = noun, .owner = reader->law->name}};
    number->place = node->place;
    number->expr = yk_load_value(reader->loader, node, &want, &number->value);
    if (!number->expr) reader->source->is_bad = true;
}

bool yk_load_law_optional(YkLawReader *reader, const YkNode *map, const char *key, YkDimension dimension,
                          YkLawNumber *number)
{
    const YkNode *node = yk_node_get(map, key);
    if (node) yk_load_law_number(reader, node, key, dimension, number);
    return node != NULL;
}

void yk_load_law_required(YkLawReader *reader, const YkNode *map, const char *key, YkDimension dimension,
                          YkLawNumber *number)
{
    if (yk_load_law_optional(reader, map, key, dimension, number)) return;
    yk_problem(reader->loader->problems, YK_CODE_MISSING_KEY, map->place, "this part of law %q needs `%s`",
               reader->law->name, key);
    reader->source->is_bad = true;
}

bool yk_load_law_expect(YkLawReader *reader, const YkNode *node, YkNodeKind kind, const char *noun)
{
    YkSubject subject = {.noun = noun, .owner = reader->law->name};
    bool fits = yk_load_expect(reader->loader, node, kind, &subject);
    if (!fits) reader->source->is_bad = true;
    return fits;
}

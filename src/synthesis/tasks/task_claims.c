// Reads the channels of a machine task: measures over the motion, and claims about them.
#include <math.h>
#include <string.h>
#include "synthesis/tasks/task.h"

bool yk_task_out_of_memory(YkTaskReader *reader, const YkProblems *own)
{
    for (size_t k = 0; k < yk_problems_count(own); k++)
        if (yk_problems_get(own, k)->code == YK_CODE_OUT_OF_MEMORY) reader->loader->failed = true;
    return reader->loader->failed;
}

size_t yk_task_channel(YkTaskReader *reader, const YkNode *node, const char *name)
{
    YkMachineTask *machine = &reader->task->machine;
    YkProblems *problems = reader->loader->problems, *own = yk_problems_new();
    YkChannel channel;
    if (!own) reader->loader->failed = true;
    if (!machine->mech || !own) {
        yk_problems_free(own);
        return YK_NOT_FOUND;
    }
    bool good = yk_channel_parse(machine->mech, name, &channel, own) == YK_OK;
    if (!good && yk_task_out_of_memory(reader, own)) {
        good = false;
    } else if (!good) {
        const YkProblem *why = yk_problems_count(own) > 0 ? yk_problems_get(own, 0) : NULL;
        yk_problem(problems, YK_CODE_UNKNOWN_NAME, node->place, "%s", why ? why->message : "there is no such channel");
        if (why && why->hint) yk_problem_hint(problems, "%s", why->hint);
    } else if (machine->channel_count == YK_TASK_CHANNELS) {
        good = false;
        yk_problem(problems, YK_CODE_TASK_POSITIONS, node->place, "goals and claims name more than %d channels",
                   (int)YK_TASK_CHANNELS);
    }
    yk_problems_free(own);
    if (!good) return YK_NOT_FOUND;
    machine->channel[machine->channel_count] = channel;
    return machine->channel_count++;
}

static const char *skip(const char *text)
{
    return text + strspn(text, " ");
}

const char *yk_task_measure(YkTaskReader *reader, const YkNode *node, YkMeasure *measure, size_t *channel)
{
    static const struct {
        const char *before, *after;
        YkMeasure measure;
    } forms[] = {{"max(abs(", "))", YK_MEASURE_MAX_ABS}, {"max(", ")", YK_MEASURE_MAX}, {"min(", ")", YK_MEASURE_MIN}};
    *channel = YK_NOT_FOUND;
    for (size_t k = 0; k < sizeof forms / sizeof *forms; k++) {
        size_t begin = strlen(forms[k].before);
        const char *end = strstr(node->text, forms[k].after);
        if (strncmp(node->text, forms[k].before, begin) != 0 || !end || end < node->text + begin) continue;
        YkText name = {0};
        yk_text_add(&name, node->text + begin, (size_t)(end - node->text) - begin);
        *measure = forms[k].measure;
        *channel = yk_task_channel(reader, node, yk_text_get(&name));
        if (name.failed) reader->loader->failed = true;
        yk_text_free(&name);
        return *channel == YK_NOT_FOUND ? NULL : skip(end + strlen(forms[k].after));
    }
    yk_problem(reader->loader->problems, YK_CODE_TASK_FUNCTION, node->place,
               "%q begins with no measure over the motion", node->text);
    yk_problem_hint(reader->loader->problems, "write min(CHANNEL), max(CHANNEL) or max(abs(CHANNEL))");
    return NULL;
}

bool yk_task_claim(YkTaskReader *reader, const YkNode *node, YkClaim *claim)
{
    YkLoader *loader = reader->loader;
    *claim = (YkClaim){.limit = NAN};
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "claim", .owner = "require"})) return false;
    const char *rest = yk_task_measure(reader, node, &claim->measure, &claim->channel);
    if (!rest) return false;
    if (*rest != '<' && *rest != '>') {
        yk_problem(loader->problems, YK_CODE_TASK_FUNCTION, node->place, "claim %q has no < or > after its measure",
                   node->text);
        return false;
    }
    claim->is_below = *rest == '<';
    rest = skip(rest + 1 + (rest[1] == '='));
    YkNode *value = YK_NEW(loader->arena, YkNode, 1);
    if (!value) return false;
    *value = (YkNode){.kind = YK_NODE_SCALAR, .place = node->place};
    value->length = strlen(rest);
    value->text = yk_arena_copy(loader->arena, rest, value->length);
    YkWant want = {.subject = {.noun = "limit", .owner = "require"}};
    want.dimension = yk_quantity_dimension(reader->task->machine.channel[claim->channel].quantity);
    return value->text && yk_load_value(loader, value, &want, &claim->limit) != NULL;
}

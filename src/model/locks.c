// Reads `locks:`, sets of bodies and coordinates that are held, and of bodies that are joined, each set by its name:
// NAME: [body, coordinate, ...], or NAME: {hold: [...], join: [[a, b], ...]}.
#include "model/load.h"

static bool read_hold(YkLoader *loader, const YkNode *node, YkHold *hold)
{
    if (!yk_load_expect(loader, node, YK_NODE_SCALAR, &(YkSubject){.noun = "name of what is held"})) return false;
    *hold = (YkHold){.body = yk_names_find(&loader->model->body_names, node->text), .coordinate = YK_NONE};
    if (hold->body > 0) return true;
    if (hold->body == 0) {
        yk_problem(loader->problems, YK_CODE_BAD_LOCK, node->place, "`ground` is held already");
        return false;
    }
    bool is_rate = false;
    int32_t found = yk_load_coordinate(loader, node->text, node->place, &is_rate);
    if (found >= 0 && is_rate) found = yk_load_coordinate_key(loader, node, NULL); // refuses it
    if (found == YK_NONE) yk_load_body(loader, node); // reports the name, with the nearest one
    hold->coordinate = found;
    return found >= 0;
}

static void read_holds(YkLoader *loader, YkLock *lock, const YkNode *list)
{
    if (!yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "hold", .owner = lock->name})) return;
    lock->holds = YK_NEW(loader->arena, YkHold, list->count + 1);
    for (size_t i = 0; lock->holds && i < list->count; i++)
        if (read_hold(loader, list->items[i], &lock->holds[lock->hold_count])) lock->hold_count++;
}

static void read_join(YkLoader *loader, YkLock *lock, const YkNode *pair)
{
    int32_t *body = lock->joins[lock->join_count];
    const YkSubject subject = {.noun = "join", .owner = lock->name};
    if (!yk_load_expect(loader, pair, YK_NODE_LIST, &subject)) return;
    if (pair->count != 2) {
        yk_problem(loader->problems, YK_CODE_COMPONENTS, pair->place, "%s is a list of pairs, [[a, b]]; here are %z",
                   yk_load_subject(loader, &subject), pair->count);
        return;
    }
    for (int k = 0; k < 2; k++) body[k] = yk_load_body(loader, pair->items[k]);
    if (body[0] == YK_NONE || body[1] == YK_NONE) return;
    if (body[0] == body[1]) {
        yk_problem(loader->problems, YK_CODE_BAD_LOCK, pair->place, "lock %q joins %q to itself", lock->name,
                   loader->model->bodies[body[0]].name);
        return;
    }
    lock->join_count++;
}

static void read_joins(YkLoader *loader, YkLock *lock, const YkNode *list)
{
    if (!yk_load_expect(loader, list, YK_NODE_LIST, &(YkSubject){.noun = "join", .owner = lock->name})) return;
    lock->joins = yk_arena_alloc(loader->arena, list->count + 1, sizeof *lock->joins);
    for (size_t i = 0; lock->joins && i < list->count; i++) read_join(loader, lock, list->items[i]);
}

static void read_lock(YkLoader *loader, YkLock *lock, const YkNode *node)
{
    static const char *const keys[] = {"hold", "join", NULL};
    const YkSubject subject = {.noun = "lock", .part = lock->name};
    const YkNode *hold = node, *join = NULL;
    if (node->kind != YK_NODE_LIST) {
        if (!yk_load_expect(loader, node, YK_NODE_MAP, &subject)) {
            yk_problem_hint(loader->problems,
                            "write a list, [ring, sun], or a map, {hold: [ring], join: [[sun, arm]]}");
            return;
        }
        yk_load_check_keys(loader, node, keys, &subject);
        hold = yk_node_get(node, "hold");
        join = yk_node_get(node, "join");
    }
    if (hold) read_holds(loader, lock, hold);
    if (join) read_joins(loader, lock, join);
}

void yk_load_locks(YkLoader *loader)
{
    const YkNode *section = yk_load_section(loader, "locks");
    YkModel *model = loader->model;
    if (!section) return;
    model->locks = YK_NEW(loader->arena, YkLock, section->count);
    if (!model->locks) return;
    for (size_t i = 0; i < section->count; i++) {
        const YkNodePair *pair = &section->pairs[i];
        YkLock *lock = &model->locks[model->lock_count++];
        lock->name = pair->key->text;
        lock->place = pair->key->place;
        yk_load_name(loader, pair->key, "lock");
        read_lock(loader, lock, pair->value);
    }
}

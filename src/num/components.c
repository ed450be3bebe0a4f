// Tarjan's search for strong components, with stacks in place of recursion.
#include "num/components.h"

typedef struct Search {
    const uint32_t *first;
    const int32_t *target;
    int32_t *component, *index, *low, *edge, *path, *open; // index: order of entry; open: nodes not yet in a component
    size_t path_count, open_count, components;
    int32_t order;
} Search;

static void enter(Search *s, int32_t v)
{
    s->index[v] = s->low[v] = s->order++;
    s->edge[v] = (int32_t)s->first[v];
    s->path[s->path_count++] = v;
    s->open[s->open_count++] = v;
}

// Leaves v once all its edges are done: if nothing below reaches above it, the open nodes from v on are a component.
static void leave(Search *s, int32_t v)
{
    s->path_count--;
    if (s->low[v] == s->index[v]) {
        int32_t w;
        do {
            w = s->open[--s->open_count];
            s->component[w] = (int32_t)s->components;
        } while (w != v);
        s->components++;
    } else {
        int32_t parent = s->path[s->path_count - 1];
        if (s->low[v] < s->low[parent]) s->low[parent] = s->low[v];
    }
}

// Follows the next edge of v; returns the node to enter, or -1.
static int32_t follow(Search *s, int32_t v)
{
    while ((uint32_t)s->edge[v] < s->first[v + 1]) {
        int32_t w = s->target[s->edge[v]++];
        if (s->index[w] < 0) return w;
        if (s->component[w] < 0 && s->index[w] < s->low[v]) s->low[v] = s->index[w];
    }
    return -1;
}

size_t yk_components(size_t n, const uint32_t *first, const int32_t *target, int32_t *component, int32_t *work)
{
    Search s = {.first = first,
                .target = target,
                .component = component,
                .index = work,
                .low = work + n,
                .edge = work + 2 * n,
                .path = work + 3 * n,
                .open = work + 4 * n};
    for (size_t v = 0; v < n; v++) s.index[v] = component[v] = -1;
    for (size_t root = 0; root < n; root++) {
        if (s.index[root] >= 0) continue;
        enter(&s, (int32_t)root);
        while (s.path_count > 0) {
            int32_t v = s.path[s.path_count - 1], w = follow(&s, v);
            if (w >= 0)
                enter(&s, w);
            else
                leave(&s, v);
        }
    }
    return s.components;
}

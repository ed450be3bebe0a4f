// Postorder of the column elimination tree. Source: Davis 2006, Direct Methods for Sparse Linear Systems, 4.1 and 4.3.
#include <stdlib.h>
#include <string.h>
#include "num/sparse_inside.h"

typedef struct Tree {
    int32_t *parent, *ancestor; // [n] of pivots; ancestor: shortcuts towards the root
    int32_t *last;              // [n] per row: the last pivot whose column holds it
    int32_t *child, *sibling;   // [n]
    int32_t *stack, *out;
} Tree;

// Climbs from pivot i by shortcuts to its root below k, and makes the root a child of k.
static void climb(Tree *t, int32_t i, int32_t k)
{
    while (i != -1 && i != k) {
        int32_t up = t->ancestor[i];
        t->ancestor[i] = k;
        if (up == -1) t->parent[i] = k;
        i = up;
    }
}

static void find_parents(Tree *t, size_t n, const int32_t *start, const int32_t *row, const int32_t *order)
{
    for (size_t i = 0; i < n; i++) t->last[i] = t->parent[i] = t->ancestor[i] = t->child[i] = -1;
    for (size_t k = 0; k < n; k++)
        for (int32_t p = start[order[k]]; p < start[order[k] + 1]; p++) {
            climb(t, t->last[row[p]], (int32_t)k);
            t->last[row[p]] = (int32_t)k;
        }
}

// Visits the tree depth first, children before parents.
static size_t walk(Tree *t, int32_t root, size_t count)
{
    size_t depth = 0;
    t->stack[depth++] = root;
    while (depth > 0) {
        int32_t node = t->stack[depth - 1], child = t->child[node];
        if (child >= 0) {
            t->child[node] = t->sibling[child];
            t->stack[depth++] = child;
        } else {
            t->out[count++] = node;
            depth--;
        }
    }
    return count;
}

bool yk_sparse_postorder(size_t n, const int32_t *start, const int32_t *row, int32_t *order)
{
    int32_t *memory = malloc((7 * n + 1) * sizeof *memory);
    if (!memory) return false;
    Tree t = {memory, memory + n, memory + 2 * n, memory + 3 * n, memory + 4 * n, memory + 5 * n, memory + 6 * n};
    find_parents(&t, n, start, row, order);
    for (size_t k = n; k-- > 0;) {
        if (t.parent[k] < 0) continue;
        t.sibling[k] = t.child[t.parent[k]];
        t.child[t.parent[k]] = (int32_t)k;
    }
    size_t count = 0;
    for (size_t k = 0; k < n; k++)
        if (t.parent[k] < 0) count = walk(&t, (int32_t)k, count);
    for (size_t k = 0; k < n; k++) t.last[k] = order[t.out[k]];
    memcpy(order, t.last, n * sizeof *order);
    free(memory);
    return true;
}

// Grows a bipartite matching by augmenting paths, with an explicit stack.
#include "num/matching.h"

bool yk_matching_start(YkMatching *m, YkArena *arena, size_t columns, size_t rows, size_t entries)
{
    *m = (YkMatching){.columns = columns, .row_capacity = rows, .entry_capacity = entries};
    m->first = YK_NEW(arena, uint32_t, rows + 1);
    m->entries = YK_NEW(arena, int32_t, entries + 1);
    m->row_of = YK_NEW(arena, int32_t, columns + 1);
    m->column_of = YK_NEW(arena, int32_t, rows + 1);
    m->seen = YK_NEW(arena, uint32_t, rows + 1);
    m->next = YK_NEW(arena, uint32_t, rows + 1);
    m->stack = YK_NEW(arena, int32_t, rows + 1);
    if (yk_arena_failed(arena)) return false;
    for (size_t c = 0; c < columns; c++) m->row_of[c] = -1;
    return true;
}

// Returns a free column of the row, or -1.
static int32_t free_column(const YkMatching *m, int32_t row)
{
    for (uint32_t e = m->first[row]; e < m->first[row + 1]; e++)
        if (m->row_of[m->entries[e]] < 0) return m->entries[e];
    return -1;
}

// Gives `column` to the row on top of the stack, whose old column goes to the row below it, and so on.
static void flip_path(YkMatching *m, size_t depth, int32_t column)
{
    while (depth > 0) {
        int32_t row = m->stack[--depth];
        int32_t old = m->column_of[row];
        m->column_of[row] = column;
        m->row_of[column] = row;
        column = old;
    }
}

static void visit(YkMatching *m, int32_t row)
{
    m->seen[row] = m->stamp;
    m->next[row] = m->first[row];
}

static bool augment(YkMatching *m, int32_t start)
{
    size_t depth = 0;
    m->stamp++;
    m->stack[depth++] = start;
    visit(m, start);
    while (depth > 0) {
        int32_t row = m->stack[depth - 1];
        int32_t column = m->next[row] == m->first[row] ? free_column(m, row) : -1;
        if (column >= 0) {
            flip_path(m, depth, column);
            return true;
        }
        int32_t deeper = -1;
        while (deeper < 0 && m->next[row] < m->first[row + 1]) {
            int32_t other = m->row_of[m->entries[m->next[row]++]];
            if (m->seen[other] != m->stamp) deeper = other;
        }
        if (deeper < 0) {
            depth--;
        } else {
            visit(m, deeper);
            m->stack[depth++] = deeper;
        }
    }
    return false;
}

bool yk_matching_add(YkMatching *m, const int32_t *columns, size_t count, bool keep)
{
    size_t row = m->rows;
    if (row >= m->row_capacity || m->first[row] + count > m->entry_capacity) return false;
    for (size_t k = 0; k < count; k++) m->entries[m->first[row] + k] = columns[k];
    m->first[row + 1] = m->first[row] + (uint32_t)count;
    m->column_of[row] = -1;
    m->seen[row] = 0;
    m->rows++;
    bool matched = augment(m, (int32_t)row);
    if (!matched && !keep) m->rows--;
    return matched;
}

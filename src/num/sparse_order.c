// Orders columns by approximate minimum degree of A^T A without forming it: a row is a set of columns, and eliminating
// a column joins all rows that contain it into one. Source: Davis, Gilbert, Larimore & Ng 2004 (COLAMD); the degrees
// are its bound |front| + sum of |row \ front|.
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "num/sparse_inside.h"

typedef struct Order {
    size_t n;
    // rows: sets of columns in a pool that is compacted when full
    size_t *row_first;
    int32_t *row_length; // 0: dead
    int32_t *pool, *spare;
    size_t pool_end, pool_capacity;
    // columns: rows that hold them
    const int32_t *column_first;
    int32_t *column_rows, *column_length; // length -1: eliminated
    // buckets of columns by degree
    int32_t *head, *next, *previous, *degree;
    size_t least;
    int32_t *front;      // columns of the row being made
    int32_t *in_front;   // per column: stamp
    int32_t *is_joined;  // per row: stamp
    int32_t *outside;    // per row: how many columns beyond the front,
    int32_t *outside_at; // ... valid at this stamp
    int32_t *order;
    size_t ordered;
    void *memory;
} Order;

static bool allocate(Order *o, size_t n, size_t entries)
{
    o->pool_capacity = 2 * entries + 1;
    size_t integers = 12 * n + entries + 2 * o->pool_capacity;
    char *memory = o->memory = calloc(1, n * sizeof(size_t) + integers * sizeof(int32_t) + 1);
    if (!memory) return false;
    o->row_first = (size_t *)(void *)memory;
    int32_t *p = (int32_t *)(void *)(o->row_first + n);
    int32_t **arrays[] = {&o->row_length, &o->column_length, &o->head,      &o->next,    &o->previous,  &o->degree,
                          &o->front,      &o->in_front,      &o->is_joined, &o->outside, &o->outside_at};
    for (size_t k = 0; k < sizeof arrays / sizeof *arrays; k++, p += n) *arrays[k] = p;
    o->column_rows = p;
    o->pool = p + entries;
    o->spare = o->pool + o->pool_capacity;
    return true;
}

static void bucket_add(Order *o, int32_t column, size_t degree)
{
    if (degree >= o->n) degree = o->n - 1;
    int32_t first = o->head[degree];
    o->degree[column] = (int32_t)degree;
    o->next[column] = first;
    o->previous[column] = -1;
    if (first >= 0) o->previous[first] = column;
    o->head[degree] = column;
    if (degree < o->least) o->least = degree;
}

static void bucket_remove(Order *o, int32_t column)
{
    int32_t before = o->previous[column], after = o->next[column];
    if (before >= 0)
        o->next[before] = after;
    else
        o->head[o->degree[column]] = after;
    if (after >= 0) o->previous[after] = before;
}

// Rows and columns with more entries are left out; they would join everything to everything.
static int32_t dense_limit(size_t n)
{
    double limit = 10 * sqrt((double)n);
    return (int32_t)fmax(16, limit);
}

// Stores the rows as sets of columns; leaves out rows and columns with very many entries.
static void start_sets(Order *o, const int32_t *start, const int32_t *row)
{
    int32_t limit = dense_limit(o->n), *count = o->outside;
    for (size_t j = 0; j < o->n; j++)
        for (int32_t k = start[j]; k < start[j + 1]; k++) count[row[k]]++;
    for (size_t j = 0; j < o->n; j++) {
        bool is_dense = start[j + 1] - start[j] > limit;
        for (int32_t k = start[j]; k < start[j + 1] && !is_dense; k++) {
            if (count[row[k]] > limit) continue;
            o->column_rows[start[j] + o->column_length[j]++] = row[k];
            o->row_length[row[k]]++;
        }
        if (is_dense) o->column_length[j] = -1;
    }
    for (size_t i = 0; i < o->n; i++) {
        o->row_first[i] = o->pool_end;
        o->pool_end += (size_t)o->row_length[i];
        o->row_length[i] = 0;
    }
    for (size_t j = 0; j < o->n; j++)
        for (int32_t k = 0; k < o->column_length[j]; k++) {
            int32_t i = o->column_rows[start[j] + k];
            o->pool[o->row_first[i] + (size_t)o->row_length[i]++] = (int32_t)j;
        }
    memset(count, 0, o->n * sizeof *count);
}

static void start_buckets(Order *o)
{
    o->least = o->n;
    for (size_t d = 0; d < o->n; d++) o->head[d] = -1;
    for (size_t j = o->n; j-- > 0;) {
        size_t degree = 0;
        for (int32_t k = 0; k < o->column_length[j]; k++)
            degree += (size_t)o->row_length[o->column_rows[o->column_first[j] + k]] - 1;
        if (o->column_length[j] >= 0) bucket_add(o, (int32_t)j, degree);
    }
}

static void compact(Order *o)
{
    size_t end = 0;
    for (size_t i = 0; i < o->n; i++) {
        size_t length = (size_t)o->row_length[i];
        memcpy(o->spare + end, o->pool + o->row_first[i], length * sizeof *o->pool);
        o->row_first[i] = end;
        end += length;
    }
    int32_t *pool = o->pool;
    o->pool = o->spare;
    o->spare = pool;
    o->pool_end = end;
}

static void eliminate(Order *o, int32_t column)
{
    bucket_remove(o, column);
    o->column_length[column] = -1;
    o->order[o->ordered++] = column;
}

// Joins the rows of a column into o->front, without the column. The rows die. Returns how many columns the front has.
static size_t join_rows(Order *o, int32_t column, int32_t length, int32_t stamp)
{
    size_t count = 0;
    o->in_front[column] = stamp;
    for (int32_t k = 0; k < length; k++) {
        int32_t i = o->column_rows[o->column_first[column] + k];
        const int32_t *members = o->pool + o->row_first[i];
        for (int32_t m = 0; m < o->row_length[i]; m++) {
            if (o->in_front[members[m]] == stamp) continue;
            o->in_front[members[m]] = stamp;
            o->front[count++] = members[m];
        }
        o->is_joined[i] = stamp;
        o->row_length[i] = 0;
    }
    return count;
}

// Takes the joined rows out of a column and counts how much the others have beyond the front.
static void leave_rows(Order *o, int32_t column, int32_t stamp)
{
    int32_t *rows = o->column_rows + o->column_first[column], left = 0;
    for (int32_t k = 0; k < o->column_length[column]; k++) {
        int32_t i = rows[k];
        if (o->is_joined[i] == stamp) continue;
        if (o->outside_at[i] != stamp) {
            o->outside_at[i] = stamp;
            o->outside[i] = o->row_length[i];
        }
        o->outside[i]--;
        rows[left++] = i;
    }
    o->column_length[column] = left;
}

// Computes the new degree of a column of the front; drops rows that lie within the front. Returns false when only the
// front contains it.
static bool measure(Order *o, int32_t column, size_t front, size_t *degree)
{
    int32_t *rows = o->column_rows + o->column_first[column], left = 0;
    *degree = front - 1;
    for (int32_t k = 0; k < o->column_length[column]; k++) {
        int32_t i = rows[k];
        if (o->outside[i] == 0) {
            o->row_length[i] = 0;
            continue;
        }
        *degree += (size_t)o->outside[i];
        rows[left++] = i;
    }
    o->column_length[column] = left;
    return left > 0;
}

static void eliminate_and_join(Order *o, int32_t column, int32_t stamp)
{
    int32_t length = o->column_length[column], made = length > 0 ? o->column_rows[o->column_first[column]] : -1;
    eliminate(o, column);
    size_t count = join_rows(o, column, length, stamp), left = 0;
    for (size_t k = 0; k < count; k++) leave_rows(o, o->front[k], stamp);
    for (size_t k = 0; k < count; k++) {
        int32_t j = o->front[k];
        size_t degree;
        if (!measure(o, j, count, &degree)) { // eliminating it next adds no fill
            eliminate(o, j);
            continue;
        }
        o->column_rows[o->column_first[j] + o->column_length[j]++] = made;
        bucket_remove(o, j);
        bucket_add(o, j, degree);
        o->front[left++] = j;
    }
    if (left == 0) return;
    if (o->pool_end + left > o->pool_capacity) compact(o);
    memcpy(o->pool + o->pool_end, o->front, left * sizeof *o->front);
    o->row_first[made] = o->pool_end;
    o->row_length[made] = (int32_t)left;
    o->pool_end += left;
}

bool yk_sparse_order(size_t n, const int32_t *start, const int32_t *row, int32_t *order)
{
    Order o = {.n = n, .column_first = start, .order = order};
    if (n == 0) return true;
    if (!allocate(&o, n, (size_t)start[n])) return false;
    start_sets(&o, start, row);
    start_buckets(&o);
    for (int32_t stamp = 1; o.least < n; stamp++) {
        while (o.least < n && o.head[o.least] < 0) o.least++;
        if (o.least < n) eliminate_and_join(&o, o.head[o.least], stamp);
    }
    for (size_t j = 0; j < n && o.ordered < n; j++) // dense columns come last
        if (start[j + 1] - start[j] > dense_limit(n)) order[o.ordered++] = (int32_t)j;
    free(o.memory);
    return true;
}

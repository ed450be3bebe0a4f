// Sorting by qsort.
#ifndef BASE_SORT_H
#define BASE_SORT_H

// Compares two doubles, which are numbers: the smaller comes first.
static inline int yk_by_size(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

#endif

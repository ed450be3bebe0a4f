// Medians over rounds, and the rows of docs/speed.md.
#include "rows.h"
#include <stdio.h>
#include <stdlib.h>

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double median(double *values, size_t count)
{
    qsort(values, count, sizeof *values, ascending);
    return values[count / 2];
}

bool row(const char *task, double by_hand, double ours, const char *unit, double asked, double difference)
{
    double ratio = ours / by_hand;
    bool keeps = asked <= 0 || ratio <= asked;
    printf("row\t%s\t%.4g %s\t%.4g %s\t%.2f\t", task, by_hand, unit, ours, unit, ratio);
    if (asked > 0)
        printf("%s%.2f", keeps ? "" : "missed: ", asked);
    else
        printf("-");
    printf("\t%.1e\n", difference);
    fflush(stdout);
    return keeps;
}

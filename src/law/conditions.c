// Checks lists of conditions and puts them in the order s, v, a, j, p, each by ascending place.
#include <math.h>
#include "law/inside.h"

#define SAME 1e-9

static bool comes_before(const YkLawCondition *a, const YkLawCondition *b)
{
    return a->order < b->order || (a->order == b->order && a->at < b->at);
}

// Sorts by insertion: lists are short.
static void sort(YkLawCondition *conditions, size_t count)
{
    for (size_t i = 1; i < count; i++) {
        YkLawCondition condition = conditions[i];
        size_t k = i;
        for (; k > 0 && comes_before(&condition, &conditions[k - 1]); k--) conditions[k] = conditions[k - 1];
        conditions[k] = condition;
    }
}

static void find_range(const YkLawCondition *conditions, size_t count, double *from, double *to)
{
    *from = *to = conditions[0].at;
    for (size_t i = 1; i < count; i++) {
        *from = fmin(*from, conditions[i].at);
        *to = fmax(*to, conditions[i].at);
    }
}

// Returns whether two conditions have the same order at the same place.
static bool has_repeated(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count, double length)
{
    for (size_t i = 1; i < count; i++) {
        for (size_t k = 0; k < i; k++) {
            bool is_near = fabs(conditions[i].at - conditions[k].at) <= SAME * length;
            if (conditions[i].order != conditions[k].order || !is_near) continue;
            builder->culprit = i;
            return true;
        }
    }
    return false;
}

static bool append(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count)
{
    size_t first = builder->condition_count;
    for (size_t i = 0; i < count; i++) {
        if (!YK_ROOM(builder->conditions, builder->condition_count, builder->condition_capacity)) {
            builder->condition_count = first;
            return false;
        }
        builder->conditions[builder->condition_count++] = conditions[i];
    }
    sort(builder->conditions + first, count);
    return true;
}

YkLawFault yk_law_take_conditions(YkLawBuilder *builder, const YkLawCondition *conditions, size_t count, double *from,
                                  double *to)
{
    if (count > YK_LAW_CONDITIONS_MAX) return YK_LAW_TOO_MANY;
    if (count < 2) return YK_LAW_TOO_FEW;
    find_range(conditions, count, from, to);
    double length = *to - *from, off = *from - builder->at, slack = SAME * (length + fabs(builder->at));
    if (!(length > SAME * fabs(*from))) return YK_LAW_TOO_FEW;
    if (off > slack) return YK_LAW_GAP;
    if (off < -slack) return YK_LAW_OVERLAP;
    if (has_repeated(builder, conditions, count, length)) return YK_LAW_REPEATED;
    return append(builder, conditions, count) ? YK_LAW_OK : YK_LAW_NO_MEMORY;
}

void yk_law_name_culprit(YkLawBuilder *builder, const YkLawCondition *given, size_t count)
{
    const YkLawCondition *sorted = builder->conditions + (builder->condition_count - count);
    if (builder->culprit >= count) return;
    const YkLawCondition culprit = sorted[builder->culprit];
    for (size_t i = 0; i < count; i++) {
        if (given[i].at == culprit.at && given[i].order == culprit.order) builder->culprit = i;
    }
}

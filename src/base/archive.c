// Writes values to bytes and reads them back: one function for both directions.
#include "base/archive.h"
#include <string.h>

// Returns where the next bytes are written or read; NULL if they are only counted or missing.
static unsigned char *next(YkArchive *a, size_t count)
{
    if (a->bytes && count > a->capacity - a->at) a->failed = true;
    if (a->failed) return NULL;
    unsigned char *bytes = a->bytes ? a->bytes + a->at : NULL;
    a->at += count;
    return bytes;
}

void yk_archive_whole(YkArchive *a, uint64_t *value)
{
    unsigned char *bytes = next(a, 8);
    uint64_t sum = 0;
    for (int k = 0; bytes && k < 8; k++) {
        if (!a->is_reading) bytes[k] = (unsigned char)(*value >> 8 * k);
        sum |= (uint64_t)bytes[k] << 8 * k;
    }
    if (a->is_reading) *value = sum;
}

void yk_archive_sizes(YkArchive *a, size_t *const *values, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        uint64_t whole = *values[k];
        yk_archive_whole(a, &whole);
        *values[k] = (size_t)whole;
    }
}

void yk_archive_numbers(YkArchive *a, double *values, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        uint64_t bits;
        memcpy(&bits, &values[k], sizeof bits);
        yk_archive_whole(a, &bits);
        memcpy(&values[k], &bits, sizeof bits);
    }
}

void yk_archive_flags(YkArchive *a, bool *values, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        int64_t value = values[k];
        yk_archive_choice(a, &value, 0, 1);
        values[k] = value != 0;
    }
}

void yk_archive_signs(YkArchive *a, signed char *values, size_t count)
{
    for (size_t k = 0; k < count; k++) {
        int64_t value = values[k];
        yk_archive_choice(a, &value, -1, 1);
        values[k] = (signed char)value;
    }
}

void yk_archive_bytes(YkArchive *a, void *bytes, size_t count)
{
    unsigned char *here = next(a, count);
    if (!here || count == 0) return;
    if (a->is_reading)
        memcpy(bytes, here, count);
    else
        memcpy(here, bytes, count);
}

void yk_archive_choice(YkArchive *a, int64_t *value, int64_t low, int64_t high)
{
    uint64_t bits = (uint64_t)*value;
    yk_archive_whole(a, &bits);
    int64_t read = bits <= INT64_MAX ? (int64_t)bits : -(int64_t)(~bits) - 1;
    if (a->is_reading && (read < low || read > high)) {
        a->failed = true;
        read = low;
    }
    *value = read;
}

// Sums bytes. Every step is one to one in the sum, so a byte that differs leaves a different sum.
uint64_t yk_archive_sum(const unsigned char *bytes, size_t count)
{
    uint64_t sum = UINT64_C(0xcbf29ce484222325);
    for (size_t k = 0; k < count; k++) {
        sum = (sum ^ bytes[k]) * UINT64_C(0x100000001b3);
        sum ^= sum >> 29;
    }
    return sum;
}

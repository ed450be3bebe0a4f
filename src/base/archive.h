// Archives: values as bytes, written and read by one function; little-endian, the same on every machine.
#ifndef BASE_ARCHIVE_H
#define BASE_ARCHIVE_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

typedef struct YkArchive {
    unsigned char *bytes; // NULL: bytes are only counted
    size_t capacity, at;
    bool is_reading;
    bool failed; // the bytes ended too early, or made no sense; later reads give 0
} YkArchive;

// Each of these writes the value, or reads it.
void yk_archive_whole(YkArchive *archive, uint64_t *value);
void yk_archive_sizes(YkArchive *archive, size_t *const *values, size_t count);
void yk_archive_numbers(YkArchive *archive, double *values, size_t count);
void yk_archive_flags(YkArchive *archive, bool *values, size_t count);
void yk_archive_signs(YkArchive *archive, signed char *values, size_t count); // -1, 0, 1
void yk_archive_bytes(YkArchive *archive, void *bytes, size_t count);
// Writes or reads a whole number from low to high; reading anything else fails.
void yk_archive_choice(YkArchive *archive, int64_t *value, int64_t low, int64_t high);
// Returns a sum of bytes that reveals damage: any change of one byte changes it.
uint64_t yk_archive_sum(const unsigned char *bytes, size_t count);

#endif

// Reads and writes numbers exactly, the same in every locale and on every machine.
#ifndef BASE_NUMBER_H
#define BASE_NUMBER_H
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { YK_NUMBER_SIZE = 40 };
// Writes the shortest decimal that reads back to the same double ("0.1", "1e-07" is written "1e-7", "12", "-0.0" as
// "-0", "nan", "inf"). Returns the length; the text is NUL-terminated. Source: Giulietti 2020 (Schubfach).
size_t yk_number_write(double value, char text[YK_NUMBER_SIZE]);
// Writes `digits` (1..17) significant digits, correctly rounded, without trailing zeros; exponent form outside
// 1e-5..1e15.
size_t yk_number_write_digits(double value, int digits, char text[YK_NUMBER_SIZE]);
// Writes `decimals` (0..17) digits after the point, correctly rounded; magnitudes >= 1e15 use the shortest form.
size_t yk_number_write_fixed(double value, int decimals, char text[YK_NUMBER_SIZE]);
// Reads a decimal number at the start of text[0..length): digits, '.', exponent; no sign, no inf, no nan, no hex.
// Rounds correctly (Lemire 2021, with an exact fallback). Returns the number of bytes read, 0 if there is no number. A
// value beyond the range of double reads as infinity; the caller reports it.
size_t yk_number_read(const char *text, size_t length, double *value);
// Reads the exact decimal value = mantissa * 10^exponent, the mantissa without trailing zeros ("60" is 6 * 10^1).
// Returns false if the mantissa does not fit int64. Same syntax.
bool yk_number_read_exact(const char *text, size_t length, int64_t *mantissa, int32_t *exponent);

#endif

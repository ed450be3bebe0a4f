// The reduction of huge angles to an eighth of a turn, with as much of 2/pi as the angle asks for.
//
// Source: Payne & Hanek 1983, "Radian reduction for trigonometric functions", SIGNUM Newsletter 18. Whole multiples of
// four quarter turns are never computed: x = M 2^e, and of 2/pi only the bits count whose product with 2^e is below 4.
#include "elementary/coefficients.h"
#include "elementary/double_double.h"
#include "elementary/tables.h"
#include "elementary/turn.h"

typedef struct Wide {
    uint64_t high, low;
} Wide;

static Wide multiply(uint64_t a, uint64_t b)
{
    uint64_t a1 = a >> 32, a0 = a & UINT32_MAX, b1 = b >> 32, b0 = b & UINT32_MAX;
    uint64_t low = a0 * b0, cross = a1 * b0 + (low >> 32), other = a0 * b1 + (cross & UINT32_MAX);
    return (Wide){a1 * b1 + (cross >> 32) + (other >> 32), other << 32 | (low & UINT32_MAX)};
}

// 64 bits of 2/pi from this one on; the first 64 of the table are zeros.
static uint64_t window(uint64_t from)
{
    uint64_t word = from >> 6, shift = from & 63;
    uint64_t upper = yk_two_over_pi[word] << shift;
    return shift == 0 ? upper : upper | yk_two_over_pi[word + 1] >> (64 - shift);
}

// f 2^-128 as a double and what it lacks.
static DoubleDouble fraction(Wide f)
{
    DoubleDouble high = {(double)(f.high >> 32) * 0x1p-32, (double)(f.high & UINT32_MAX) * 0x1p-64};
    DoubleDouble low = {(double)(f.low >> 32) * 0x1p-96, (double)(f.low & UINT32_MAX) * 0x1p-128};
    DoubleDouble sum = dd_ordered_sum(high.high, high.low), rest = dd_ordered_sum(low.high, low.low);
    sum = dd_sum(sum.high, sum.low + rest.high);
    return sum;
}

Reduced yk_reduce_far(double x)
{
    if (!isfinite(x)) return (Reduced){NAN, 0, 0};
    uint64_t bits = bits_of(x) & ~YK_SIGN_BIT, M = (bits & (((uint64_t)1 << 52) - 1)) | (uint64_t)1 << 52;
    uint64_t from = (bits >> 52) - 1075 - 2 + 64; // the bit of 2/pi that makes M 2^e times it a multiple of 2
    // M times 192 bits, modulo 2^192: two bits of quarter turns and 190 of a fraction.
    Wide last = multiply(M, window(from + 128)), middle = multiply(M, window(from + 64));
    uint64_t second = middle.low + last.high, first = M * window(from) + middle.high + (second < last.high);
    // The fraction in 128 bits, from -1/2 to 1/2.
    uint64_t q = first >> 62;
    Wide f = {first << 2 | second >> 62, second << 2 | last.low >> 62};
    bool is_upper = f.high >> 63 != 0;
    if (is_upper) f = (Wide){~f.high, ~f.low}, q++; // all but 2^-128 of the difference to 1
    DoubleDouble turns = fraction(f);
    DoubleDouble y = dd_times(turns, (DoubleDouble){HALF_PI_HIGH, HALF_PI_LOW});
    uint64_t sign = is_upper ? YK_SIGN_BIT : 0;
    sign ^= bits_of(x) & YK_SIGN_BIT;
    if (signbit(x)) q = 0 - q;
    return (Reduced){flipped(y.high, sign), -flipped(y.low, sign), q};
}

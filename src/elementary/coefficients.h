// Coefficients of the elementary functions. Written by tools/make-elementary: change that.
#ifndef ELEMENTARY_COEFFICIENTS_H
#define ELEMENTARY_COEFFICIENTS_H
// clang-format off

#define PI_HIGH 0x1.921fb54442d18p+1 // pi
#define PI_LOW 0x1.1a62633145c07p-53 // the rest
#define HALF_PI_HIGH 0x1.921fb54442d18p+0 // pi / 2
#define HALF_PI_LOW 0x1.1a62633145c07p-54 // the rest
#define PER_STEP 0x1.71547652b82fep+7 // 128 / ln 2
#define STEP_HIGH 0x1.62e42fefc0000p-8 // ln 2 / 128, its multiples to 2^18 exact
#define STEP_LOW -0x1.c610ca86c3899p-44 // the rest
#define LN_2_HIGH 0x1.62e42fefa3800p-1 // ln 2, its multiples to 2^11 exact
#define LN_2_LOW 0x1.ef35793c76730p-45 // the rest
#define PER_LN_2_HIGH 0x1.71547652b82fep+0 // 1 / ln 2
#define PER_LN_2_LOW 0x1.777d0ffda0d24p-56 // the rest
#define PER_LN_10_HIGH 0x1.bcb7b1526e50ep-2 // 1 / ln 10
#define PER_LN_10_LOW 0x1.95355baaafad3p-57 // the rest
#define PLAIN_LN_2 0x1.62e42fefa39efp-1 // ln 2

// (e^r - 1 - r) / r^2 for |r| <= ln 2 / 256: 2^-64 of the answer.
#define EXP_0 0x1.fffffffffff51p-2
#define EXP_1 0x1.5555555555523p-3
#define EXP_2 0x1.55555ae8e1f80p-5
#define EXP_3 0x1.11111440cf238p-7

// (log(1 + r) - r + r^2 / 2) / r^3 for |r| <= 2^-7: 2^-69 of the answer.
#define LOG_0 0x1.5555555555555p-2
#define LOG_1 -0x1.000000000002dp-2
#define LOG_2 0x1.9999999999debp-3
#define LOG_3 -0x1.5555554a21e57p-3
#define LOG_4 0x1.249248fa63858p-3
#define LOG_5 -0x1.000599b0ef46fp-3
#define LOG_6 0x1.c72fc5101cd49p-4

// (asin(s) / s - 1) / t for t = s^2 <= 1/4: 2^-57 of the answer.
#define ASIN_0 0x1.5555555555556p-3
#define ASIN_1 0x1.3333333332ecap-4
#define ASIN_2 0x1.6db6db6e31f13p-5
#define ASIN_3 0x1.f1c71c1db0623p-6
#define ASIN_4 0x1.6e8bb1c8209a2p-6
#define ASIN_5 0x1.1c4d35cf95421p-6
#define ASIN_6 0x1.c9cf07674736ap-7
#define ASIN_7 0x1.782651caa6547p-7
#define ASIN_8 0x1.52420b04b37bep-7
#define ASIN_9 0x1.65a9c4dfcf8b2p-8
#define ASIN_10 0x1.1d189408314eep-6
#define ASIN_11 -0x1.e6aaa8a0a04ccp-7
#define ASIN_12 0x1.d72b2bc8155f8p-6

// (sinh(x) / x - 1) / t for t = x^2 <= 1/4: 2^-58 of the answer.
#define SINH_0 0x1.5555555555555p-3
#define SINH_1 0x1.1111111111120p-7
#define SINH_2 0x1.a01a01a00ef0fp-13
#define SINH_3 0x1.71de3a84a10c3p-19
#define SINH_4 0x1.ae63a07779c78p-26
#define SINH_5 0x1.6267cf434f12cp-33

// (tanh(x) / x - 1) / t for t = x^2 <= 1/16: 2^-56 of the answer.
#define TANH_0 -0x1.5555555555551p-2
#define TANH_1 0x1.111111110dad2p-3
#define TANH_2 -0x1.ba1ba1ac8748ap-5
#define TANH_3 0x1.664f3e4c9bb5cp-6
#define TANH_4 -0x1.226a8b66370d4p-7
#define TANH_5 0x1.d578fd2c2365bp-9
#define TANH_6 -0x1.5d8ce3a0d6b4bp-10

#define TWO_PER_ROOT_PI_HIGH 0x1.20dd750429b6dp+0 // 2 / sqrt(pi)
#define TWO_PER_ROOT_PI_LOW 0x1.1ae3a914fed80p-56 // the rest

// (erf(x) / x - 2 / sqrt(pi)) / t for t = x^2 <= 1/4: 2^-58 of the answer.
#define ERF_0 -0x1.812746b0379e7p-2
#define ERF_1 0x1.ce2f21a042bcfp-4
#define ERF_2 -0x1.b82ce31286cbcp-6
#define ERF_3 0x1.565bcd0d2ff6ep-8
#define ERF_4 -0x1.c02db335c071dp-11
#define ERF_5 0x1.f9a2dd9e25187p-14
#define ERF_6 -0x1.f4c2b861c2c9cp-17
#define ERF_7 0x1.b7f36af42c55ep-20
#define ERF_8 -0x1.3d8e8315e4ddep-23

#endif

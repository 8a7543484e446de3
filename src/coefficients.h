/* Written by tools/coefficients/generate.py; do not edit.
 * Polynomials by Estrin's scheme, those in two halves with CHS_HIGH for the power between; constants as unevaluated
 * sums A + B, pi also as SHORT + REST. */
#ifndef CHASLES_COEFFICIENTS_H
#define CHASLES_COEFFICIENTS_H

/* clang-format off */
#define CHS_POWER_2(x) ((x) * (x))
#define CHS_POWER_4(x) (CHS_POWER_2(x) * CHS_POWER_2(x))
#define CHS_POWER_8(x) (CHS_POWER_4(x) * CHS_POWER_4(x))
#ifndef CHS_SINGLE
#define CHS_HIGH(x) CHS_POWER_4(x)
/* sin(x/2) / (x/2) at x = sqrt t = 1 + t P, P = CHS_SINC_LOW + CHS_HIGH CHS_SINC_HIGH
   on [0, 9.8795], absolute error 0.001 eps */
#define CHS_SINC_LOW(t) \
  ((-0x1.5555555555555p-5 + (t) * 0x1.11111111110cbp-11) + \
   CHS_POWER_2(t) * (-0x1.a01a01a015163p-19 + (t) * 0x1.71de3a52c030bp-27))
#define CHS_SINC_HIGH(t) \
  ((-0x1.ae6454e3f92a7p-36 + (t) * 0x1.6123d11459589p-45) + \
   CHS_POWER_2(t) * (-0x1.ae449777fd908p-55 + (t) * 0x1.884fd63aca799p-65))
/* cos(x/2) at x = sqrt t = 1 - 13 t/128 + t P, P = CHS_COSINE_LOW + CHS_HIGH CHS_COSINE_HIGH
   on [0, 9.8795], absolute error 0.026 eps */
#define CHS_COSINE_LOW(t) \
  ((-0x1.8p-6 + (t) * 0x1.55555555554dcp-9) + \
   CHS_POWER_2(t) * (-0x1.6c16c16c10134p-16 + (t) * 0x1.a01a019b9f4dp-24))
#define CHS_COSINE_HIGH(t) \
  ((-0x1.27e4f9f11414ap-32 + (t) * 0x1.1eecfa4e75998p-41) + \
   CHS_POWER_2(t) * (-0x1.9357123473809p-51 + (t) * 0x1.9fc3a43747942p-61))
/* sin(x) / x at x = sqrt t = 1 + t P, P = CHS_QUARTER_SINE
   on [0, 0.61747], relative error 0.017 eps */
#define CHS_QUARTER_SINE(t) \
  (((-0x1.5555555555548p-3 + (t) * 0x1.111111110f73p-7) + \
   CHS_POWER_2(t) * (-0x1.a01a019be9211p-13 + (t) * 0x1.71de35552ab63p-19)) + \
   CHS_POWER_4(t) * (-0x1.ae5e4b833b663p-26 + (t) * 0x1.5d8b5558933a9p-33))
/* cos(x) at x = sqrt t = 1 - t/2 + t^2 P, P = CHS_QUARTER_COSINE
   on [0, 0.61747], absolute error 0.00022 eps */
#define CHS_QUARTER_COSINE(t) \
  (((0x1.555555555554cp-5 + (t) * -0x1.6c16c16c15217p-10) + \
   CHS_POWER_2(t) * (0x1.a01a019cbe0a4p-16 + (t) * -0x1.27e4f8116c818p-22)) + \
   CHS_POWER_4(t) * (0x1.1ee9f0451ca2p-29 + (t) * -0x1.8fb0919618418p-37))
/* -d/dt (1 - cos x)/x^2 at x = sqrt t = P, P = CHS_COSINE_SLOPE
   on [0, 9.8795], relative error 0.25 eps */
#define CHS_COSINE_SLOPE(t) \
  ((((0x1.5555555555555p-5 + (t) * -0x1.6c16c16c16bcp-9) + \
   CHS_POWER_2(t) * (0x1.3813813811a92p-14 + (t) * -0x1.27e4fb770c614p-20)) + \
   CHS_POWER_4(t) * ((0x1.66a8f29d5ff29p-27 + (t) * -0x1.2eb17299776e6p-34) + \
   CHS_POWER_2(t) * (0x1.78ae554e0a74ap-42 + (t) * -0x1.68098fdc281c8p-50))) + \
   CHS_POWER_8(t) * (0x1.0ededbad66033p-58 + (t) * -0x1.2743c4519684ep-67))
/* -d/dt (x - sin x)/x^3 at x = sqrt t = P, P = CHS_CUBIC_SLOPE
   on [0, 9.8795], relative error 0.063 eps */
#define CHS_CUBIC_SLOPE(t) \
  ((((0x1.1111111111111p-7 + (t) * -0x1.a01a01a019ff7p-12) + \
   CHS_POWER_2(t) * (0x1.1566abc010979p-17 + (t) * -0x1.ae64567eef031p-24)) + \
   CHS_POWER_4(t) * ((0x1.b96d796ddbdap-31 + (t) * -0x1.42df6aa0ebdd5p-38) + \
   CHS_POWER_2(t) * (0x1.62861f8e1195ap-46 + (t) * -0x1.2f32e8ce551cep-54))) + \
   CHS_POWER_8(t) * (0x1.9cdeb50394df6p-63 + (t) * -0x1.9abde0cdc9bdcp-72))
/* 4 (1 - cos x)/x^2 d/dt (1 - (x/2) cot(x/2))/x^2 at x = sqrt t = P, P = CHS_COTANGENT_SLOPE
   on [0, 9.8795], relative error 0.17 eps */
#define CHS_COTANGENT_SLOPE(t) \
  ((((0x1.6c16c16c16c17p-9 + (t) * -0x1.a01a01a01a095p-14) + \
   CHS_POWER_2(t) * (0x1.bbd7793353f39p-20 + (t) * -0x1.1eed8f00d1218p-26)) + \
   CHS_POWER_4(t) * ((0x1.f87d1dd3159e7p-34 + (t) * -0x1.42df86395c1aap-41) + \
   CHS_POWER_2(t) * (0x1.3b267f0da9fc2p-49 + (t) * -0x1.e604f83a0ba81p-58))) + \
   CHS_POWER_8(t) * (0x1.38797b5625f1cp-66 + (t) * -0x1.9bf378403eaacp-75))
/* (1 - (x/2) cot(x/2))/x^2 at x = sqrt t = P, P = CHS_COTANGENT
   on [0, 9.8795], relative error 0.58 eps */
#define CHS_COTANGENT(t) \
  ((((0x1.5555555555555p-4 + (t) * 0x1.6c16c16c1722ap-10) + \
   CHS_POWER_2(t) * (0x1.1566abbfba83ap-15 + (t) * 0x1.bbd7796d13f54p-21)) + \
   CHS_POWER_4(t) * ((0x1.66a8e8e9bc869p-26 + (t) * 0x1.22815b65966a1p-31) + \
   CHS_POWER_2(t) * (0x1.d6ba3cf9229d8p-37 + (t) * 0x1.7f15039fb2496p-42))) + \
   CHS_POWER_8(t) * (((0x1.2a3e9de7ed774p-47 + (t) * 0x1.3666e1bd822b9p-52) + \
   CHS_POWER_2(t) * (-0x1.1d439577aa3e6p-61 + (t) * 0x1.63a503c5bc2fbp-61)) + \
   CHS_POWER_4(t) * (-0x1.5ead129abe68fp-66 + (t) * 0x1.7a146c5b10418p-71)))
/* atan(sqrt u) / sqrt u at u = 39/16 z / (1 - z) = 1 + z P, P = CHS_ARC_RATIO
   on [0, 0.31095], relative error 0.0075 eps */
#define CHS_ARC_RATIO(z) \
  ((((-0x1.9fffffffffffp-1 + (z) * 0x1.80ccccccca296p-2) + \
   CHS_POWER_2(z) * (-0x1.0277c57bbb03ap-1 + (z) * 0x1.df2ef8658928dp-2)) + \
   CHS_POWER_4(z) * ((-0x1.3634cbfbb0d9ep-1 + (z) * 0x1.5ea4863babebfp-1) + \
   CHS_POWER_2(z) * (-0x1.c5944a6a44136p-1 + (z) * 0x1.169d4803350b6p+0))) + \
   CHS_POWER_8(z) * (((-0x1.6a7a425a8df0dp+0 + (z) * 0x1.c8b2ebfff8bd2p+0) + \
   CHS_POWER_2(z) * (-0x1.1babf0fe60ccp+1 + (z) * 0x1.3ada825f8be1fp+1)) + \
   CHS_POWER_4(z) * ((-0x1.213052131ac52p+1 + (z) * 0x1.6fbcfde027147p+0) + \
   CHS_POWER_2(z) * -0x1.eb9c8ea078c1p-2)))
/* atan(sqrt u) / sqrt u = 1 + u P, P = CHS_ATAN_REST
   on [0, 0.25025], relative error 0.0011 eps */
#define CHS_ATAN_REST(u) \
  ((((-0x1.5555555555551p-2 + (u) * 0x1.9999999998ee6p-3) + \
   CHS_POWER_2(u) * (-0x1.2492492448454p-3 + (u) * 0x1.c71c71a6d1b2dp-4)) + \
   CHS_POWER_4(u) * ((-0x1.745d131b55e9ep-4 + (u) * 0x1.3b13588090fb8p-4) + \
   CHS_POWER_2(u) * (-0x1.110c0e0c4c13dp-4 + (u) * 0x1.e17c6f88ba72p-5))) + \
   CHS_POWER_8(u) * (((-0x1.ac4e55cf29514p-5 + (u) * 0x1.77710d4423171p-5) + \
   CHS_POWER_2(u) * (-0x1.2ec642fb960d2p-5 + (u) * 0x1.7fd13f4190e4p-6)) + \
   CHS_POWER_4(u) * -0x1.0d5e2cf1020bdp-7))
/* 1/4 - (x/(2 sin x) - 1/2) / (3 - trace) at trace = 1 + 2 cos x = CHS_TURN_TOP / CHS_TURN_BOTTOM
   on [0.49, 3.03], 0.13 eps of x/(2 sin x) */
#define CHS_TURN_TOP(trace) \
  (((0x1.bda64112bd292p-7 + (trace) * 0x1.ab64f85f22cb3p-3) + \
   CHS_POWER_2(trace) * (0x1.b94b4829401a6p-2 + (trace) * 0x1.62efcba2d211cp-2)) + \
   CHS_POWER_4(trace) * ((0x1.0713cae2426a1p-3 + (trace) * 0x1.6891d13c97abcp-6) + \
   CHS_POWER_2(trace) * (0x1.99bc5ed9ba846p-10 + (trace) * 0x1.1779d408d7581p-15)))
#define CHS_TURN_BOTTOM(trace) \
  (((0x1p+0 + (trace) * 0x1.8b7f47ceab328p+1) + \
   CHS_POWER_2(trace) * (0x1.d9bff755b50f5p+1 + (trace) * 0x1.16c9c1cfb4809p+1)) + \
   CHS_POWER_4(trace) * ((0x1.52218d5b03c6cp-1 + (trace) * 0x1.96c4f7fa3babap-4) + \
   CHS_POWER_2(trace) * (0x1.aad044af5532ep-8 + (trace) * 0x1.1789d65013438p-13)))
#define CHS_ARC_SPREAD 0x1.38p+1
#define CHS_PI_A 0x1.921fb54442d18p+1
#define CHS_PI_B 0x1.1a62633145c07p-53
#define CHS_HALF_PI_A 0x1.921fb54442d18p+0
#define CHS_HALF_PI_B 0x1.1a62633145c07p-54
#define CHS_QUARTER_PI_A 0x1.921fb54442d18p-1
#define CHS_QUARTER_PI_B 0x1.1a62633145c07p-55
#define CHS_RIGHT_ANGLE_A 0x1.921fb5444p+0
#define CHS_RIGHT_ANGLE_B 0x1.68c234c4c6629p-39
#define CHS_RIGHT_ANGLE_LIMIT 0x1p+16
#define CHS_PI_SHORT 0x1.921f8p+1
#define CHS_PI_REST 0x1.aa22168c234c5p-18
#else
#define CHS_HIGH(x) CHS_POWER_2(x)
/* sin(x/2) / (x/2) at x = sqrt t = 1 + t P, P = CHS_SINC_LOW + CHS_HIGH CHS_SINC_HIGH
   on [0, 9.8795], absolute error 0.047 eps */
#define CHS_SINC_LOW(t) \
  (-0x1.55554cp-5F + (t) * 0x1.110ed4p-11F)
#define CHS_SINC_HIGH(t) \
  (-0x1.9f6ed2p-19F + (t) * 0x1.5d9ebep-27F)
/* cos(x/2) at x = sqrt t = 1 - 13 t/128 + t P, P = CHS_COSINE_LOW + CHS_HIGH CHS_COSINE_HIGH
   on [0, 9.8795], absolute error 0.0036 eps */
#define CHS_COSINE_LOW(t) \
  (-0x1.8p-6F + (t) * 0x1.55555p-9F)
#define CHS_COSINE_HIGH(t) \
  ((-0x1.6c14b8p-16F + (t) * 0x1.9f931cp-24F) + \
   CHS_POWER_2(t) * -0x1.196acep-32F)
/* sin(x) / x at x = sqrt t = 1 + t P, P = CHS_QUARTER_SINE
   on [0, 0.61747], relative error 0.033 eps */
#define CHS_QUARTER_SINE(t) \
  ((-0x1.555546p-3F + (t) * 0x1.110776p-7F) + \
   CHS_POWER_2(t) * -0x1.9952fap-13F)
/* cos(x) at x = sqrt t = 1 - t/2 + t^2 P, P = CHS_QUARTER_COSINE
   on [0, 0.61747], absolute error 0.00089 eps */
#define CHS_QUARTER_COSINE(t) \
  ((0x1.55554ap-5F + (t) * -0x1.6c0c1ap-10F) + \
   CHS_POWER_2(t) * 0x1.99e0eep-16F)
/* -d/dt (1 - cos x)/x^2 at x = sqrt t = P, P = CHS_COSINE_SLOPE
   on [0, 9.8795], relative error 0.25 eps */
#define CHS_COSINE_SLOPE(t) \
  (((0x1.555556p-5F + (t) * -0x1.6c16eap-9F) + \
   CHS_POWER_2(t) * (0x1.3816a2p-14F + (t) * -0x1.280ae4p-20F)) + \
   CHS_POWER_4(t) * (0x1.6727ecp-27F + (t) * -0x1.19708ep-34F))
/* -d/dt (x - sin x)/x^3 at x = sqrt t = P, P = CHS_CUBIC_SLOPE
   on [0, 9.8795], relative error 0.44 eps */
#define CHS_CUBIC_SLOPE(t) \
  (((0x1.111112p-7F + (t) * -0x1.a01a8ap-12F) + \
   CHS_POWER_2(t) * (0x1.15736ep-17F + (t) * -0x1.b01292p-24F)) + \
   CHS_POWER_4(t) * (0x1.d01316p-31F + (t) * -0x1.9f3336p-38F))
/* 4 (1 - cos x)/x^2 d/dt (1 - (x/2) cot(x/2))/x^2 at x = sqrt t = P, P = CHS_COTANGENT_SLOPE
   on [0, 9.8795], relative error 0.2 eps */
#define CHS_COTANGENT_SLOPE(t) \
  (((0x1.6c16c2p-9F + (t) * -0x1.a01a58p-14F) + \
   CHS_POWER_2(t) * (0x1.bbe7f4p-20F + (t) * -0x1.2008d6p-26F)) + \
   CHS_POWER_4(t) * (0x1.0b939ap-33F + (t) * -0x1.caf58cp-41F))
/* (1 - (x/2) cot(x/2))/x^2 at x = sqrt t = P, P = CHS_COTANGENT
   on [0, 9.8795], relative error 0.25 eps */
#define CHS_COTANGENT(t) \
  (((0x1.555556p-4F + (t) * 0x1.6c154ap-10F) + \
   CHS_POWER_2(t) * (0x1.15a98ap-15F + (t) * 0x1.b304f8p-21F)) + \
   CHS_POWER_4(t) * ((0x1.ac2aa8p-26F + (t) * 0x1.457862p-35F) + \
   CHS_POWER_2(t) * 0x1.611a84p-35F))
/* atan(sqrt u) / sqrt u at u = 39/16 z / (1 - z) = 1 + z P, P = CHS_ARC_RATIO
   on [0, 0.31095], relative error 0.0058 eps */
#define CHS_ARC_RATIO(z) \
  (((-0x1.9ffffap-1F + (z) * 0x1.80c8d8p-2F) + \
   CHS_POWER_2(z) * (-0x1.023e82p-1F + (z) * 0x1.d8e7b2p-2F)) + \
   CHS_POWER_4(z) * ((-0x1.1dbc56p-1F + (z) * 0x1.dc0486p-2F) + \
   CHS_POWER_2(z) * -0x1.1521c4p-2F))
/* atan(sqrt u) / sqrt u = 1 + u P, P = CHS_ATAN_REST
   on [0, 0.25025], relative error 0.0024 eps */
#define CHS_ATAN_REST(u) \
  (((-0x1.555552p-2F + (u) * 0x1.999742p-3F) + \
   CHS_POWER_2(u) * (-0x1.244ff6p-3F + (u) * 0x1.c06dccp-4F)) + \
   CHS_POWER_4(u) * (-0x1.47f982p-4F + (u) * 0x1.3f98aap-5F))
/* 1/4 - (x/(2 sin x) - 1/2) / (3 - trace) at trace = 1 + 2 cos x = CHS_TURN_TOP / CHS_TURN_BOTTOM
   on [0.49, 3.03], 0.18 eps of x/(2 sin x) */
#define CHS_TURN_TOP(trace) \
  ((0x1.bdde9p-7F + (trace) * 0x1.7f9c28p-3F) + \
   CHS_POWER_2(trace) * (0x1.060a46p-3F + (trace) * 0x1.fb8ea4p-7F))
#define CHS_TURN_BOTTOM(trace) \
  ((0x1p+0F + (trace) * 0x1.858cf8p+0F) + \
   CHS_POWER_2(trace) * (0x1.4036cep-1F + (trace) * 0x1.fd1a3ep-5F))
#define CHS_ARC_SPREAD 0x1.38p+1F
#define CHS_PI_A 0x1.921fb6p+1F
#define CHS_PI_B -0x1.777a5cp-24F
#define CHS_HALF_PI_A 0x1.921fb6p+0F
#define CHS_HALF_PI_B -0x1.777a5cp-25F
#define CHS_QUARTER_PI_A 0x1.921fb6p-1F
#define CHS_QUARTER_PI_B -0x1.777a5cp-26F
#define CHS_RIGHT_ANGLE_A 0x1.922p+0F
#define CHS_RIGHT_ANGLE_B -0x1.2aeef4p-18F
#define CHS_RIGHT_ANGLE_LIMIT 0x1p+8F
#define CHS_PI_SHORT 0x1.92p+1F
#define CHS_PI_REST 0x1.fb5444p-11F
#endif
/* clang-format on */

#endif

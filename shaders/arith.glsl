// SPDX-License-Identifier: Apache-2.0
// Arithmetic with the same bits as core/base/arith.h: float +, -, * in one written order, every
// result `precise`, so that nothing is contracted to a fused multiply-add; no division, no square
// root.

// C++ twin: core/base/rsqrt-inl.h
float rsqrt(int steps, float x) {
    precise float half_x = 0.5 * x;
    precise float y = intBitsToFloat(rsqrt_magic - (floatBitsToInt(x) >> 1));
    for (int i = 0; i < steps; ++i)
        y = y * (1.5 - (half_x * y) * y);
    return y;
}

vec4 rsqrt(int steps, vec4 x) {
    precise vec4 half_x = 0.5 * x;
    precise vec4 y = intBitsToFloat(rsqrt_magic - (floatBitsToInt(x) >> 1));
    for (int i = 0; i < steps; ++i)
        y = y * (1.5 - (half_x * y) * y);
    return y;
}

// a < b ? yes : no and a <= b ? yes : no, a lane: as selections, which leave NaN and the sign of
// zero alone. Twins: core/base/vectors/lanes-inl.h
//
// What is selected by a comparison of floats is `precise` here and elsewhere: compilers (Mesa's
// NIR) make a minimum or a maximum of a selection that need not be exact, and those drop NaN. A
// function returns a variable for it, since what it returns itself cannot be declared so.
vec4 if_less(vec4 a, vec4 b, vec4 yes, vec4 no) {
    precise vec4 r = mix(no, yes, lessThan(a, b));
    return r;
}
vec4 if_less_equal(vec4 a, vec4 b, vec4 yes, vec4 no) {
    precise vec4 r = mix(no, yes, lessThanEqual(a, b));
    return r;
}
// b where it is less, or more, than a, else a; a lane.
float lower(float a, float b) {
    precise float r = b < a ? b : a;
    return r;
}
float upper(float a, float b) {
    precise float r = a < b ? b : a;
    return r;
}
vec4 lower(vec4 a, vec4 b) {
    return if_less(b, a, b, a);
}
vec4 upper(vec4 a, vec4 b) {
    return if_less(a, b, b, a);
}

// Denormal floats as 0, which the CPU makes of them by itself (DenormalsAreZero in
// core/base/float_mode.h). For products of what may be of any size: elsewhere least_value of
// core/tiles/tile_io.h keeps what is computed away from them.
vec4 without_denormals(vec4 v) {
    return if_less(abs(v), vec4(uintBitsToFloat(0x00800000u)), vec4(0.0), v);
}

// c ? yes : no, a lane.
uvec4 if_true(bvec4 c, uvec4 yes, uvec4 no) {
    return uvec4(c.x ? yes.x : no.x, c.y ? yes.y : no.y, c.z ? yes.z : no.z, c.w ? yes.w : no.w);
}

// SPDX-License-Identifier: Apache-2.0
// Costs of an edge. C++ twin and sources: core/cost/cost-inl.h. COST_... says which is compiled.
// With ANY_AREAS between() takes twice the areas of the triangles, which else are all 1/2.
#include "arith.glsl"

#ifdef ANY_AREAS
#define AREAS , float area_a, float area_b
#define PASS_AREAS , area_a, area_b
#else
#define AREAS
#define PASS_AREAS
#endif

// (D1 x + D2 y) for the doubled areas of the triangles.
float weighted(float x, float y AREAS) {
#ifdef ANY_AREAS
    precise float sum = (area_a * x) + (area_b * y);
#else
    precise float sum = x + y;
#endif
    return sum;
}
// x (D1 + D2) / 2
float times_mean(float x AREAS) {
#ifdef ANY_AREAS
    precise float product = x * (0.5 * (area_a + area_b));
    return product;
#else
    return x;
#endif
}
// |g1 - g2|
float jump(float ax, float ay, float bx, float by) {
    precise float dx = ax - bx, dy = ay - by;
    precise float square = (dx * dx) + (dy * dy);
    precise float size = square * rsqrt(3, square);
    return size;
}
// x / |e|
float over_length(float x, float ex, float ey) {
    precise float square = (ex * ex) + (ey * ey);
    precise float quotient = x * rsqrt(3, square);
    return quotient;
}

#if defined(COST_abn)

struct Face {
    float x, y, z;
};
Face face(float gx, float gy) {
    precise float square = ((gx * gx) + (gy * gy)) + cost_slope_square;
    precise float r = rsqrt(3, square);
    precise float x = gx * r, y = gy * r, z = cost_slope * r;
    return Face(x, y, z);
}
float between(Face a, Face b, float ex, float ey AREAS) {
    precise float cost = 1.0 - (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
    return cost;
}

#elif defined(COST_scf)

struct Face {
    float x, y, norm; // the twin's `length` is a function of arrays here
};
Face face(float gx, float gy) {
    precise float square = (gx * gx) + (gy * gy);
    precise float norm = square * rsqrt(3, square);
    return Face(gx, gy, norm);
}
float between(Face a, Face b, float ex, float ey AREAS) {
    precise float cost = (a.norm * b.norm) - ((a.x * b.x) + (a.y * b.y));
    return cost;
}

#elif defined(COST_jnd)

struct Face {
    float x, y;
};
Face face(float gx, float gy) {
    return Face(gx, gy);
}
float between(Face a, Face b, float ex, float ey AREAS) {
    return jump(a.x, a.y, b.x, b.y);
}

#elif defined(COST_dlp)

struct Face {
    float x, y;
};
Face face(float gx, float gy) {
    return Face(gx, gy);
}
float between(Face a, Face b, float ex, float ey AREAS) {
    return times_mean(over_length(jump(a.x, a.y, b.x, b.y), ex, ey) PASS_AREAS);
}

#elif defined(COST_dp)

struct Face {
    float x, y, r;
};
Face face(float gx, float gy) {
    precise float square = ((gx * gx) + (gy * gy)) + cost_slope_square;
    return Face(gx, gy, rsqrt(3, square));
}
float between(Face a, Face b, float ex, float ey AREAS) {
    precise float cost = over_length(jump(a.x, a.y, b.x, b.y), ex, ey) *
                         weighted(b.r, a.r PASS_AREAS);
    return cost;
}

#endif

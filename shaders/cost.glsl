// SPDX-License-Identifier: Apache-2.0
// Costs of an edge. C++ twin and sources: core/cost/cost-inl.h. COST_... says which is compiled.
// With ANY_AREAS between() takes twice the areas of the triangles, which else are all 1/2.
#include "arith.glsl"

#ifdef ANY_AREAS
#define AREAS , float area_a, float area_b
#else
#define AREAS
#endif

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

#elif defined(COST_jnd) || defined(COST_dlp)

struct Face {
    float x, y;
};
Face face(float gx, float gy) {
    return Face(gx, gy);
}
float between(Face a, Face b, float ex, float ey AREAS) {
    precise float dx = a.x - b.x, dy = a.y - b.y;
    precise float square = (dx * dx) + (dy * dy);
    precise float cost = square * rsqrt(3, square);
#ifdef COST_dlp
    precise float along = (ex * ex) + (ey * ey);
    cost = cost * rsqrt(3, along);
#ifdef ANY_AREAS
    cost = cost * (0.5 * (area_a + area_b));
#endif
#endif
    return cost;
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
    precise float dx = a.x - b.x, dy = a.y - b.y;
    precise float square = (dx * dx) + (dy * dy), along = (ex * ex) + (ey * ey);
    precise float vertical = (square * rsqrt(3, square)) * rsqrt(3, along);
#ifdef ANY_AREAS
    precise float cost = vertical * ((area_a * b.r) + (area_b * a.r));
#else
    precise float cost = vertical * (b.r + a.r);
#endif
    return cost;
}

#endif

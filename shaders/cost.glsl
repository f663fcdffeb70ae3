// Costs of an edge. C++ twin and sources: core/cost/cost-inl.h. COST_... says which is compiled.
#include "arith.glsl"

#if defined(COST_abn)

struct Face {
    float x, y, z;
};
Face face(float gx, float gy) {
    precise float square = ((gx * gx) + (gy * gy)) + 0.04;
    precise float r = rsqrt(3, square);
    precise float x = gx * r, y = gy * r, z = 0.2 * r;
    return Face(x, y, z);
}
float between(Face a, Face b) {
    precise float cost = 1.0 - (((a.x * b.x) + (a.y * b.y)) + (a.z * b.z));
    return cost;
}

#elif defined(COST_scf)

struct Face {
    float x, y, length;
};
Face face(float gx, float gy) {
    precise float square = (gx * gx) + (gy * gy);
    precise float length = square * rsqrt(3, square);
    return Face(gx, gy, length);
}
float between(Face a, Face b) {
    precise float cost = (a.length * b.length) - ((a.x * b.x) + (a.y * b.y));
    return cost;
}

#endif

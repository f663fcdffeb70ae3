#include "core/sample/evaluate.h"

#include <cmath>
#include <limits>

#include "core/arith/arith.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/sample/evaluate.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace ddt {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

constexpr float quiet_nan = std::numeric_limits<float>::quiet_NaN();

#include "core/arith/lanes4-inl.h"
#include "core/sample/surface-inl.h"

template <bool quadratic>
HWY_INLINE void evaluate_spans(const Net& net, const LocatedRow& row, int channels, int first,
                               bool whole_store, int count, float* out) {
    for (const Span& span : row.spans) {
        Patch<Lanes4> patch;
        patch.z0 = Lanes4::load(net.at(span.vertex[0]));
        patch.z1 = Lanes4::load(net.at(span.vertex[1]));
        patch.z2 = Lanes4::load(net.at(span.vertex[2]));
        if (quadratic) {
            patch.e01 = Lanes4::load(net.at(span.edge[0]));
            patch.e12 = Lanes4::load(net.at(span.edge[1]));
            patch.e20 = Lanes4::load(net.at(span.edge[2]));
        }
        patch.find_range();
        const float* w = row.weights.data() + size_t(span.begin) * 3;
        float* to = out + size_t(span.begin) * size_t(channels) + first;
        for (int i = span.begin; i < span.end; ++i, w += 3, to += channels) {
            const Lanes4 f = patch.template at<quadratic>(w[0], w[1], w[2]);
            if (whole_store) {
                f.store(to);
            } else {
                float lane[group_size];
                f.store(lane);
                for (int c = 0; c < count; ++c)
                    to[c] = lane[c];
            }
        }
    }
}

HWY_ATTR void evaluate(const Net& net, Surface surface, const LocatedRow& row, int channels,
                       int first, int count, float* out) {
    // With a single group whole vectors can be stored: what spills is overwritten by the next.
    const bool whole = count == group_size || channels == count;
    if (surface == Surface::linear)
        evaluate_spans<false>(net, row, channels, first, whole, count, out);
    else
        evaluate_spans<true>(net, row, channels, first, whole, count, out);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(evaluate);

namespace {

/// Copy Channel::nearest values over what evaluate() made of them.
void copy_nearest(const Net& net, NearestMask nearest, const LocatedRow& row, int channels,
                  int first, int count, float* out) {
    for (const Span& span : row.spans)
        for (int i = span.begin; i < span.end; ++i) {
            const float* w = row.weights.data() + size_t(i) * 3;
            const int largest = w[1] > w[0] ? (w[2] > w[1] ? 2 : 1) : (w[2] > w[0] ? 2 : 0);
            const float* z = net.at(span.vertex[largest]);
            float* to = out + size_t(i) * size_t(channels) + first;
            for (int c = 0; c < count; ++c)
                if (nearest & (1u << c))
                    std::memcpy(to + c, z + c, sizeof(float));
        }
}

} // namespace

void evaluate_row(const Net& net, Surface surface, NearestMask nearest, const LocatedRow& row,
                  int channels, int first, int count, float* out) {
    HWY_DYNAMIC_DISPATCH(evaluate)(net, surface, row, channels, first, count, out);
    if (nearest)
        copy_nearest(net, nearest, row, channels, first, count, out);
}

} // namespace ddt
#endif

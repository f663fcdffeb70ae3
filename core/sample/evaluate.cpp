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

#include "core/arith/lanes-inl.h"
#include "core/sample/surface-inl.h"

// Blocks of group_size lanes, a lane a channel; as many neighbouring positions at once as vectors
// of the target hold blocks.
using D = hn::CappedTag<float, row_padding>;
using Blocks = Lanes<D>;

/// The group's numbers at a site, in every block.
HWY_INLINE Blocks at_site(const Net& net, int site) {
    return hn::LoadDup128(D(), net.at(site));
}
HWY_INLINE Blocks soft_at_site(const Net& net, int site) {
    return hn::LoadDup128(D(), net.soft.data() + size_t(site) * group_size);
}

/// Block k filled with p[k].
HWY_INLINE Blocks spread(const float* p) {
    const D d;
    const hn::RebindToSigned<D> di;
    HWY_ALIGN int32_t block[row_padding];
    for (size_t i = 0; i < hn::Lanes(d); ++i)
        block[i] = int32_t(i / group_size);
    return hn::TableLookupLanes(hn::LoadU(d, p), hn::IndicesFromVec(d, hn::Load(di, block)));
}

/// Where results go.
struct Output {
    float* to; ///< the row's first position, first channel of the group
    int channels, count;
    bool whole; ///< all lanes may be stored: what is too much is overwritten by what follows

    /// Blocks of positions i, i + 1, ... before end.
    HWY_INLINE void store(Blocks f, int i, int end) const {
        const hn::CappedTag<float, group_size> d4;
        const int blocks = int(hn::Lanes(D())) / group_size;
        HWY_ALIGN float lanes[row_padding];
        float* p = to + size_t(i) * size_t(channels);
        if (whole && channels == group_size) {
            f.store(p);
            return;
        }
        f.store(lanes);
        if (whole) {
            for (int k = 0; k < blocks; ++k)
                hn::StoreU(hn::Load(d4, lanes + k * group_size), d4, p + k * channels);
            return;
        }
        for (int k = 0; k < blocks && i + k < end; ++k)
            for (int c = 0; c < count; ++c)
                p[k * channels + c] = lanes[k * group_size + c];
    }
};

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_triangle(const Net& net, const LocatedRow& row, const Span& span,
                                  const Output& out) {
    Patch<Blocks> patch;
    patch.z0 = at_site(net, span.vertex[0]);
    patch.z1 = at_site(net, span.vertex[1]);
    patch.z2 = at_site(net, span.vertex[2]);
    if (quadratic) {
        patch.e01 = at_site(net, span.edge[0]);
        patch.e12 = at_site(net, span.edge[1]);
        patch.e20 = at_site(net, span.edge[2]);
    }
    if (soft) {
        patch.q01 = soft_at_site(net, span.edge[0]);
        patch.q12 = soft_at_site(net, span.edge[1]);
        patch.q20 = soft_at_site(net, span.edge[2]);
    }
    patch.template find_range<soft>(hn::LoadDup128(D(), net.strict));
    for (int i = span.begin; i < span.end; i += int(hn::Lanes(D())) / group_size)
        out.store(patch.template at<quadratic, soft>(spread(row.weight[0].data() + i),
                                                     spread(row.weight[1].data() + i),
                                                     spread(row.weight[2].data() + i)),
                  i, span.end);
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_cell(const Net& net, int stride, const LocatedRow& row, const Span& span,
                              const Output& out) {
    const int s = span.vertex[0];
    PlainCell<Blocks> cell;
    cell.z0 = at_site(net, s);
    cell.z1 = at_site(net, s + 2);
    cell.z2 = at_site(net, s + 2 * stride);
    cell.z3 = at_site(net, s + 2 * stride + 2);
    if (quadratic) {
        cell.e01 = at_site(net, s + 1);
        cell.e02 = at_site(net, s + stride);
        cell.diagonal = at_site(net, s + stride + 1);
        cell.e13 = at_site(net, s + stride + 2);
        cell.e23 = at_site(net, s + 2 * stride + 1);
    }
    if (soft) {
        cell.q01 = soft_at_site(net, s + 1);
        cell.q02 = soft_at_site(net, s + stride);
        cell.soft_diagonal = soft_at_site(net, s + stride + 1);
        cell.q13 = soft_at_site(net, s + stride + 2);
        cell.q23 = soft_at_site(net, s + 2 * stride + 1);
    }
    const Blocks strict = hn::LoadDup128(D(), net.strict);
    const int step = int(hn::Lanes(D())) / group_size;
    const float *x = row.weight[0].data(), *y = row.weight[1].data();
    if (span.kind == Span::cell_down) {
        cell.template divide_down<soft>(strict);
        for (int i = span.begin; i < span.end; i += step)
            out.store(cell.template at_down<quadratic, soft>(spread(x + i), spread(y + i)), i,
                      span.end);
    } else {
        cell.template divide_up<soft>(strict);
        for (int i = span.begin; i < span.end; i += step)
            out.store(cell.template at_up<quadratic, soft>(spread(x + i), spread(y + i)), i,
                      span.end);
    }
}

template <bool quadratic, bool soft>
HWY_INLINE void evaluate_spans(const Net& net, int stride, const LocatedRow& row,
                               const Output& out) {
    for (const Span& span : row.spans)
        if (span.kind == Span::triangle)
            evaluate_triangle<quadratic, soft>(net, row, span, out);
        else
            evaluate_cell<quadratic, soft>(net, stride, row, span, out);
}

HWY_ATTR void evaluate(const Net& net, Surface surface, int stride, const LocatedRow& row,
                       int channels, int first, int count, float* to) {
    const Output out{to + first, channels, count, channels <= group_size};
    const bool soft = !net.soft.empty();
    if (surface == Surface::linear && soft)
        evaluate_spans<false, true>(net, stride, row, out);
    else if (surface == Surface::linear)
        evaluate_spans<false, false>(net, stride, row, out);
    else if (soft)
        evaluate_spans<true, true>(net, stride, row, out);
    else
        evaluate_spans<true, false>(net, stride, row, out);
}

} // namespace HWY_NAMESPACE
} // namespace ddt
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace ddt {

HWY_EXPORT(evaluate);

namespace {

/// The vertex with the largest weight at position i, the first of equals.
int largest_vertex(const LocatedRow& row, const Span& span, int stride, int i) {
    float w[3];
    int vertex[3] = {span.vertex[0], span.vertex[1], span.vertex[2]};
    const float x = row.weight[0][size_t(i)], y = row.weight[1][size_t(i)];
    const int s = span.vertex[0];
    const auto set = [&](int v0, int v1, int v2, float w0, float w1, float w2) {
        vertex[0] = v0, vertex[1] = v1, vertex[2] = v2;
        w[0] = w0, w[1] = w1, w[2] = w2;
    };
    // The cases of PlainCell.
    const int s1 = s + 2, s2 = s + 2 * stride, s3 = s2 + 2;
    if (span.kind == Span::cell_down && x < y)
        set(s, s3, s2, 1 - y, x, y - x);
    else if (span.kind == Span::cell_down)
        set(s, s1, s3, 1 - x, x - y, y);
    else if (span.kind == Span::cell_up && x + y < 1)
        set(s, s1, s2, 1 - (x + y), x, y);
    else if (span.kind == Span::cell_up)
        set(s1, s3, s2, 1 - y, (x + y) - 1, 1 - x);
    else
        for (int k = 0; k < 3; ++k)
            w[k] = row.weight[k][size_t(i)];
    return vertex[w[1] > w[0] ? (w[2] > w[1] ? 2 : 1) : (w[2] > w[0] ? 2 : 0)];
}

/// Copy Channel::nearest values over what evaluate() made of them.
void copy_nearest(const Net& net, NearestMask nearest, int stride, const LocatedRow& row,
                  int channels, int first, int count, float* out) {
    for (const Span& span : row.spans)
        for (int i = span.begin; i < span.end; ++i) {
            const float* z = net.at(largest_vertex(row, span, stride, i));
            float* to = out + size_t(i) * size_t(channels) + first;
            for (int c = 0; c < count; ++c)
                if (nearest & (1u << c))
                    std::memcpy(to + c, z + c, sizeof(float));
        }
}

} // namespace

void evaluate_row(const Net& net, Surface surface, NearestMask nearest, const LocatedRow& row,
                  int channels, int first, int count, float* out) {
    HWY_DYNAMIC_DISPATCH(evaluate)(net, surface, net.stride, row, channels, first, count, out);
    if (nearest)
        copy_nearest(net, nearest, net.stride, row, channels, first, count, out);
}

} // namespace ddt
#endif

// SPDX-License-Identifier: Apache-2.0
// Warps by any matrix of any picture: a result, or one line.
#include <cmath>

#include <OpenImageIO/imagebufalgo.h>

#include "ddt/resize.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/matrix.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

using namespace ddt;
using namespace ddt::fuzz;

namespace {

/// What takes long is not what is looked for: OpenImageIO's own warp, which serves where the
/// picture shrinks, goes through all that a position sees, up to the number from which on it is
/// refused. An undefined `roi` stands for the picture's image.
bool takes_long(const float (&matrix)[3][3], const OIIO::ImageBuf& src, OIIO::ROI roi) {
    Projective to_output, exact;
    for (int i = 0; i < 9; ++i)
        to_output.m[size_t(i)] = double(matrix[i / 3][i % 3]);
    const Rect window = rect_of(src.roi());
    if (!to_output.invert(exact) || !shrinks(to_output, window))
        return false;
    const Projective to_source = to_output.float_inverse();
    const bool image_of = !roi.defined(); // no larger than this, if its corners are within
    if (image_of) {
        roi = OIIO::ROI(-130, 130, -130, 130);
        for (const double x : {window.x0 + 0.5, window.x1 - 0.5})
            for (const double y : {window.y0 + 0.5, window.y1 - 0.5}) {
                const auto p = to_output(x, y);
                if (!(std::fabs(p.x / p.w) < 128 && std::fabs(p.y / p.w) < 128))
                    return true;
            }
    }
    const double pixels = filtered_pixels(to_source, rect_of(roi), 6); // lanczos3's width
    return pixels > std::ldexp(1.0, 22) && (image_of || pixels < std::ldexp(1.0, 38));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Bytes bytes(data, size);
    OIIO::ImageBuf src(OIIO::ImageSpec(bytes.between(1, 20), bytes.between(1, 20),
                                       bytes.between(1, 5), OIIO::TypeDesc::FLOAT));
    // Near the identity, where something is to be seen, or any floats.
    const bool near = bytes.coin();
    float matrix[3][3];
    for (int i = 0; i < 9; ++i)
        matrix[i / 3][i % 3] =
            near ? float(i % 4 == 0) + float(bytes.take<int8_t>()) / (i % 3 == 2 ? 4096 : 64)
                 : bytes.take<float>();
    const bool recompute = bytes.coin();
    OIIO::ROI roi;
    if (bytes.coin())
        roi = OIIO::ROI(bytes.take<int8_t>(), 130, bytes.take<int8_t>(), 130);
    if (recompute && !near)
        roi = OIIO::ROI(0, 16, 0, 16); // its image may be of any size
    if (takes_long(matrix, src, roi.defined() || recompute ? roi : src.roi()))
        return 0;
    auto* pixels = static_cast<float*>(src.localpixels());
    for (size_t i = 0; i < src.spec().image_pixels() * size_t(src.nchannels()); ++i)
        pixels[i] = bytes.take<float>();
    OIIO::ImageBuf dst;
    const OIIO::M33fParam m(matrix);
    if (!warp(dst, src, m, {}, recompute, OIIO::ImageBuf::WrapDefault, roi, 1)) {
        require(!dst.initialized(), "a failure leaves no image");
        require_error_line(dst.geterror());
    }
    return 0;
}

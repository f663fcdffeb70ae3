// SPDX-License-Identifier: Apache-2.0
// ImageBufs of any description: windows, channel names, pixel types, metadata, any pixels. A resize
// succeeds and gives what was asked for, or fails with one line and leaves nothing.
#include <OpenImageIO/imagebufalgo.h>

#include "ddt/resize.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

using namespace ddt;
using namespace ddt::fuzz;

namespace {

constexpr OIIO::TypeDesc::BASETYPE types[] = {
    OIIO::TypeDesc::UINT8, OIIO::TypeDesc::UINT16, OIIO::TypeDesc::HALF,   OIIO::TypeDesc::FLOAT,
    OIIO::TypeDesc::INT32, OIIO::TypeDesc::UINT32, OIIO::TypeDesc::DOUBLE, OIIO::TypeDesc::INT8};

OIIO::ImageSpec draw_spec(Bytes& bytes) {
    OIIO::ImageSpec spec(bytes.between(1, 20), bytes.between(1, 20), bytes.between(1, 6),
                         types[bytes.below(8)]);
    spec.x = bytes.take<int8_t>();
    spec.y = bytes.take<int8_t>();
    spec.full_x = spec.x + bytes.between(-20, 20);
    spec.full_y = spec.y + bytes.between(-20, 20);
    spec.full_width = bytes.below(40);
    spec.full_height = bytes.below(40);
    for (std::string& name : spec.channelnames)
        if (bytes.coin())
            name = bytes.line(12);
    spec.alpha_channel = bytes.between(-1, spec.nchannels - 1);
    spec.z_channel = bytes.between(-1, spec.nchannels - 1);
    if (bytes.coin())
        spec.attribute("oiio:ColorSpace", bytes.line(24));
    if (bytes.coin())
        spec.attribute("oiio:UnassociatedAlpha", 1);
    if (bytes.coin())
        spec.attribute("oiio:Gamma", bytes.take<float>());
    if (bytes.coin())
        spec.attribute(bytes.line(30), bytes.line(30));
    return spec;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Bytes bytes(data, size);
    const OIIO::ImageSpec spec = draw_spec(bytes);
    OIIO::ROI to(0, bytes.between(1, 60), 0, bytes.between(1, 60));
    if (bytes.coin())
        to.chbegin = bytes.below(spec.nchannels), to.chend = bytes.between(to.chbegin, 8);
    Options options;
    std::string error;
    if (!parse_filter(bytes.line(80), options, error))
        require_error_line(error);
    OIIO::ImageBuf src(spec);
    auto* pixels = static_cast<uint8_t*>(src.localpixels());
    for (size_t i = 0; i < spec.image_bytes() && !bytes.empty(); ++i)
        pixels[i] = bytes.take<uint8_t>();
    OIIO::ImageBuf dst;
    if (resize(dst, src, options, to, 1)) {
        require(dst.initialized() && dst.roi().width() == to.width() &&
                    dst.roi().height() == to.height(),
                "the result is what was asked for");
        return 0;
    }
    require(!dst.initialized(), "a failure leaves no image");
    require_error_line(dst.geterror());
    return 0;
}

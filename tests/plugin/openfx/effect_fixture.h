// SPDX-License-Identifier: Apache-2.0
// The effect loaded into a small host, with an instance that has a source.
#pragma once

#include <cstring>
#include <memory>

#include "ddt/resize.h"
#include "tests/plugin/images.h"
#include "tests/plugin/openfx/kinds.h"

namespace mini {

using ddt::ofx::RectD;
using OIIO::ImageBuf;
using OIIO::TypeDesc;

inline TypeDesc type_of(const std::string& depth) {
    return depth == "OfxBitDepthFloat"   ? TypeDesc::FLOAT
           : depth == "OfxBitDepthHalf"  ? TypeDesc::HALF
           : depth == "OfxBitDepthShort" ? TypeDesc::UINT16
                                         : TypeDesc::UINT8;
}

inline ImageBuf photograph(int width, int height, int channels, TypeDesc type) {
    ImageBuf image = images::make(width, height, channels, type);
    images::fill(image, [&](int x, int y, int c) {
        const float alpha = channels == 4 ? float(x % 50) / 49.0f : 1.0f;
        return c == 3 ? alpha : images::disc(x, y, 80) * (1 - 0.2f * float(c)) * alpha;
    });
    return image;
}

/// Put an image, whose rows run downwards, into a host's picture with the corner (x0, y0).
inline Picture picture_of(const ImageBuf& image, const std::string& depth, int x0, int y0,
                          bool reversed) {
    Picture p;
    p.box = {x0, y0, x0 + image.spec().width, y0 + image.spec().height};
    p.channels = image.nchannels();
    p.depth = depth;
    p.rows_reversed = reversed;
    p.allocate();
    for (int y = 0; y < image.spec().height; ++y)
        std::memcpy(p.row(p.box.y1 - 1 - y), image.pixeladdr(0, y), p.row_bytes());
    return p;
}

inline bool same_pixels(Picture& p, const ImageBuf& wanted) {
    for (int y = 0; y < wanted.spec().height; ++y)
        if (std::memcmp(p.row(p.box.y1 - 1 - y), wanted.pixeladdr(0, y), p.row_bytes()) != 0)
            return false;
    return true;
}

/// The part of a picture that lies in the box.
inline Picture cut(Picture& whole, const Rect& box) {
    Picture part = whole;
    part.box = ddt::intersection(whole.box, box);
    part.allocate();
    const size_t pixel = size_t(whole.channels) * whole.number_bytes();
    for (int y = part.box.y0; y < part.box.y1; ++y)
        std::memcpy(part.row(y), whole.row(y) + size_t(part.box.x0 - whole.box.x0) * pixel,
                    part.row_bytes());
    return part;
}

class OpenFx : public testing::Test {
protected:
    /// A loaded host with an instance whose source is `image` with the corner (x0, y0).
    void open(const Kind& kind, const ImageBuf& image,
              const std::string& depth = "OfxBitDepthFloat", int x0 = 0, int y0 = 0,
              bool reversed = false) {
        effect.reset();
        host = std::make_unique<Host>(kind, DDT_OFX_BUNDLE);
        host->plugin().set_host(host->abi());
        ASSERT_EQ(host->act("OfxActionLoad"), ddt::ofx::ok);
        effect = std::make_unique<Effect>(*host);
        effect->describe();
        effect->source = picture_of(image, depth, x0, y0, reversed);
        const Rect& b = effect->source.box;
        effect->source_region = {double(b.x0), double(b.y0), double(b.x1), double(b.y1)};
    }
    /// Render the whole of the region of definition, in parts of `step` pixels.
    void render_whole(int step = 100000) {
        RectD r{};
        ASSERT_EQ(effect->region_of_definition(r), ddt::ofx::ok);
        effect->output = effect->source;
        effect->output.box = {int(r.x1), int(r.y1), int(r.x2), int(r.y2)};
        effect->output.allocate();
        const Rect& b = effect->output.box;
        for (int y = b.y0; y < b.y1; y += step)
            for (int x = b.x0; x < b.x1; x += step)
                ASSERT_EQ(
                    effect->render({x, y, std::min(x + step, b.x1), std::min(y + step, b.y1)}),
                    ddt::ofx::ok);
        EXPECT_EQ(effect->images_held, 0);
        EXPECT_EQ(effect->foreign_calls, 0);
    }
    std::unique_ptr<Host> host;
    std::unique_ptr<Effect> effect;
};

inline ddt::Options with_light(const char* light) {
    ddt::Options options;
    options.light = light;
    return options;
}

} // namespace mini

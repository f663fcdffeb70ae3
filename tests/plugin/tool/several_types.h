// SPDX-License-Identifier: Apache-2.0
// A file whose channels have several types, object IDs of 32 bits among them.
#pragma once

#include <algorithm>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include "tests/temporary.h"

namespace ddt::tool {

/// Images of RGB of halfs, depth of floats and an ID of 32 bits: 5 on the left, on the right what
/// is given for each, where one pixel has no depth.
inline std::string file_of_several_types(const std::vector<uint32_t>& right = {70000}) {
    OIIO::ImageSpec spec(16, 8, 5, OIIO::TypeFloat);
    spec.channelnames = {"R", "G", "B", "Z", "obj"};
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeHalf, OIIO::TypeFloat,
                           OIIO::TypeUInt32};
    const std::string path = temporary("several_types.exr");
    const auto out = OIIO::ImageOutput::create(path);
    const std::vector<OIIO::ImageSpec> specs(right.size(), spec);
    EXPECT_TRUE(out->open(path, int(specs.size()), specs.data()));
    for (size_t image = 0; image < right.size(); ++image) {
        std::string bytes;
        for (int i = 0; i < 16 * 8; ++i) {
            const auto append = [&](auto v) {
                bytes.append(reinterpret_cast<const char*>(&v), sizeof v);
            };
            for (int c = 0; c < 3; ++c)
                append(uint16_t(0x3800)); // a half
            append(i == 40 ? std::numeric_limits<float>::quiet_NaN() : float(i));
            append(i % 16 < 8 ? 5 : right[image]);
        }
        EXPECT_TRUE(image == 0 || out->open(path, spec, OIIO::ImageOutput::AppendSubimage));
        EXPECT_TRUE(out->write_image(OIIO::TypeUnknown, bytes.data()));
    }
    EXPECT_TRUE(out->close());
    return path;
}

/// The smallest and largest ID of an image of such a file, which has no others.
inline std::pair<uint32_t, uint32_t> ids_of(const std::string& path, int image = 0) {
    const auto in = OIIO::ImageInput::open(path);
    const OIIO::ImageSpec spec = in->spec(image);
    std::vector<uint32_t> ids(spec.image_pixels());
    EXPECT_TRUE(in->read_image(image, 0, 4, 5, OIIO::TypeUInt32, ids.data()));
    const auto [least, most] = std::minmax_element(ids.begin(), ids.end());
    for (const uint32_t id : ids)
        EXPECT_TRUE(id == *least || id == *most) << id;
    return {*least, *most};
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/ids/id_file.h"

#include <cstdint>
#include <vector>

#include <gtest/gtest.h>

#include "plugin/image/pixels.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

constexpr int width = 40, height = 300;

uint32_t id_at(int x, int y, int channel) {
    return 4000000000u + uint32_t(1000 * y + 10 * x + channel);
}

/// In rows where `tile` is 0, else in tiles of that height.
std::string write_ids(int tile) {
    OIIO::ImageSpec spec(width, height, 2, OIIO::TypeUInt32);
    spec.tile_width = tile > 0 ? 16 : 0;
    spec.tile_height = tile;
    std::vector<uint32_t> ids;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 2; ++c)
                ids.push_back(id_at(x, y, c));
    const std::string path = temporary("ids.tif");
    const auto file = OIIO::ImageOutput::create(path);
    EXPECT_TRUE(file && file->open(path, spec) && file->write_image(OIIO::TypeUInt32, ids.data()) &&
                file->close());
    return path;
}

// The rows that it reads at once are 64.
TEST(IdFile, ReadsTilesOfAnyHeight) {
    for (const int tile : {0, 16, 48, 128}) {
        const std::string path = write_ids(tile);
        for (const std::vector<int>& channels : {std::vector<int>{0, 1}, {1}}) {
            IdFile file(path, 0, OIIO::ImageBuf(path), channels);
            OIIO::ImageBuf ids;
            std::string error;
            ASSERT_TRUE(file.read({0, 0, width, height}, ids, error)) << error;
            ASSERT_EQ(ids.nchannels(), int(channels.size()));
            for (int y = 0; y < height; ++y)
                for (int x = 0; x < width; ++x)
                    for (size_t k = 0; k < channels.size(); ++k)
                        ASSERT_EQ(*static_cast<uint32_t*>(address(ids, x, y, int(k))),
                                  id_at(x, y, channels[k]))
                            << tile << ": " << x << ' ' << y;
        }
    }
}

} // namespace
} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "core/tin/draw.h"
#include "core/base/float_mode.h"
#include "core/base/guarded.h"

namespace ddt {

bool draw(const PointMesh& mesh, const float* values, int channels, const PixelGrid& grid,
          float* pixels, uint8_t* inside, std::string* error) noexcept {
    return succeeds(error, [&](std::string& why) {
        const DenormalsAreZero as_on_gpus;
        if (channels < 1) {
            why = "ddt: there must be at least 1 channel";
            return false;
        }
        return each_pixel(mesh, grid, inside, why,
                          [&](const std::array<int32_t, 3>& triangle, const Covered& covered) {
                              float* to = pixels + covered.pixel * size_t(channels);
                              for (int c = 0; c < channels; ++c)
                                  to[c] = value_at(values, channels, c, triangle, covered);
                          });
    });
}

} // namespace ddt

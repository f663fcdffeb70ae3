// SPDX-License-Identifier: Apache-2.0
// Descriptions of images by their channels' names.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

namespace ddt::test {

/// Alpha and depth are the first channels of A and of Z, of any layer, as OpenImageIO's reader of
/// EXR has it.
inline OIIO::ImageSpec named(std::vector<std::string> names,
                             OIIO::TypeDesc type = OIIO::TypeFloat) {
    OIIO::ImageSpec spec(4, 4, int(names.size()), type);
    spec.alpha_channel = -1;
    spec.z_channel = -1;
    const auto note = [&](int i, const char* component, int& place) {
        const std::string& name = names[size_t(i)];
        if (place < 0 && name.substr(name.rfind('.') + 1) == component)
            place = i;
    };
    for (int i = 0; i < spec.nchannels; ++i) {
        note(i, "A", spec.alpha_channel);
        note(i, "Z", spec.z_channel);
    }
    spec.channelnames = std::move(names);
    return spec;
}

} // namespace ddt::test

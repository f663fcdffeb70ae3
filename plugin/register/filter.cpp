// SPDX-License-Identifier: Apache-2.0
#include "plugin/register/filter.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <vector>

#include "core/base/one_line.h"
#include "plugin/message/format.h"

namespace ddt {

float Filter::tent(float x, float width) {
    static const bool told = std::fputs("ddt: a filter of ddt is evaluated pixel by pixel, as a "
                                        "tent: nothing is triangulated here\n",
                                        stderr) >= 0;
    (void)told;
    return width > 0.0f ? std::max(0.0f, 1.0f - std::fabs(x) * 2.0f / width) : 0.0f;
}

const Filter* as_ours(const OIIO::Filter2D* filter) {
    return dynamic_cast<const Filter*>(filter);
}

static const std::vector<OIIO::FilterDesc>& descriptions() {
    // Never freed: OpenImageIO hands out references, until the last moment of the process.
    static const auto* list = [] {
        static const auto* names = new std::vector<std::string>(filter_names());
        auto* made = new std::vector<OIIO::FilterDesc>;
        // Like OIIO's "triangle": two pixels wide, scalable, separable.
        for (const std::string& name : *names)
            made->push_back({name.c_str(), 2, 2.0f, false, true, true});
        return made;
    }();
    return *list;
}

int filter_count() {
    return int(descriptions().size());
}

const OIIO::FilterDesc& filter_description(int index) {
    return descriptions()[size_t(index)];
}

bool parse_filter_for(OIIO::ImageBuf& dst, OIIO::string_view spec, Options& options) {
    std::string error;
    if (parse_filter(spec, options, error))
        return true;
    set_error(dst, one_line(error));
    return false;
}

} // namespace ddt

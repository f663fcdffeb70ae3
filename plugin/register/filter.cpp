#include "filter.h"

#include <algorithm>
#include <cmath>

namespace ddt {

float Filter::tent(float x, float width) {
    return width > 0.0f ? std::max(0.0f, 1.0f - std::fabs(x) * 2.0f / width) : 0.0f;
}

const Filter* as_ours(const OIIO::Filter2D* filter) {
    return dynamic_cast<const Filter*>(filter);
}

const OIIO::FilterDesc& filter_description(int index) {
    // Like OIIO's "triangle": two pixels wide, scalable, separable.
    static const OIIO::FilterDesc list[filter_names] = {
        {"ddt-linear", 2, 2.0f, false, true, true},
        {"ddt", 2, 2.0f, false, true, true},
    };
    return list[index];
}

bool parse_filter_for(OIIO::ImageBuf& dst, OIIO::string_view spec, Options& options) {
    std::string error;
    if (parse_filter(spec, options, error))
        return true;
    dst.errorfmt("{}", error);
    return false;
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/picture.h"

#include <algorithm>

#include "core/guide/guide.h"
#include "plugin/image/channels.h"
#include "plugin/image/reading.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"

namespace ddt::tool {

namespace {

/// Whether there is nothing that can be looked at: numbers that name things, at most with alpha.
bool only_ids(const Channels& channels) {
    return channels.colour.count == 0 && channels.guide.empty() &&
           std::count(channels.kinds.begin(), channels.kinds.end(), Channel::nearest) > 0;
}

/// How a pixel's values become a Colour.
class Display {
public:
    explicit Display(const Reading& reading)
        : m_layout(shown_colour(reading.channels)), m_linear(reading.guide.linear),
          m_alpha(reading.channels.alpha) {}
    Colour operator()(const float* pixel) const {
        const float alpha = m_alpha >= 0 ? pixel[m_alpha] : 1.0f;
        const bool divide = m_layout.alpha >= 0 && alpha != 0.0f;
        float shown[3];
        for (int k = 0; k < 3; ++k) {
            const int channel = m_layout.channel[m_layout.count == 3 ? k : 0];
            float v = channel >= 0 ? pixel[channel] : 0.0f;
            v = divide ? v / alpha : v;
            shown[k] = m_linear ? srgb_curve(v) : v;
        }
        return {shown[0], shown[1], shown[2], alpha};
    }

private:
    ColourLayout m_layout;
    bool m_linear;
    int m_alpha;
};

} // namespace

bool read_picture(const OIIO::ImageBuf& image, const Options& options, Picture& picture,
                  std::string& error) {
    if (image.nchannels() < 1 || image.spec().deep) {
        error = "\"" + std::string(image.name()) + "\" has no flat pixels";
        return false;
    }
    Reading reading;
    if (!plan_reading(image, options, image.roi(), reading, error))
        return false;
    if (only_ids(reading.channels)) {
        error = "\"" + std::string(image.name()) +
                "\" has nothing to look at: its channels are whole numbers that name things";
        return false;
    }
    ImageSource source(image, reading);
    const Rect window = rect_of(image.roi());
    const size_t channels = reading.selected.size();
    std::vector<float> values(window.area() * channels);
    picture.width = window.width();
    picture.height = window.height();
    picture.has_alpha = reading.channels.alpha >= 0;
    picture.guide.resize(window.area());
    if (!source.read(window, values.data(), picture.guide.data())) {
        error = source.error();
        return false;
    }
    const Display display(reading);
    picture.colours.resize(window.area());
    for (size_t i = 0; i < picture.colours.size(); ++i)
        picture.colours[i] = display(&values[i * channels]);
    return true;
}

} // namespace ddt::tool

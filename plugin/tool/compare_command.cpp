// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/strutil.h>

#include "metrics/correlation.h"
#include "metrics/gmsd.h"
#include "metrics/mse.h"
#include "metrics/psnr.h"
#include "metrics/snr.h"
#include "metrics/ssim.h"
#include "metrics/uiqi.h"
#include "plugin/image/channels.h"
#include "plugin/image/memory.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/progress.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/file/picture.h"

namespace ddt::tool {

namespace {

/// What both pictures and the planes of all metrics take, about.
constexpr double bytes_a_pixel = 200;

/// Display values 0 to 255, over white where there is alpha.
metrics::Image image_of(const Picture& picture) {
    metrics::Image image;
    for (auto& plane : image.channels)
        plane = metrics::Plane(picture.width, picture.height);
    for (size_t i = 0; i < picture.colours.size(); ++i) {
        const Colour& c = picture.colours[i];
        const double alpha = picture.has_alpha ? double(c.alpha) : 1.0;
        const float parts[3] = {c.red, c.green, c.blue};
        for (size_t k = 0; k < 3; ++k)
            image.channels[k].values[i] = 255 * (double(parts[k]) * alpha + 1 - alpha);
    }
    return image;
}

/// The channels that a Picture is made of.
std::vector<int> shown_channels(const Channels& channels) {
    const ColourLayout colour = shown_colour(channels);
    std::vector<int> shown(colour.channel, colour.channel + colour.count);
    if (channels.alpha >= 0)
        shown.push_back(channels.alpha);
    return shown;
}

/// Of each pixel whether colour or alpha is an infinity or no number, which no display shows.
std::vector<uint8_t> find_not_finite(const OIIO::ImageBuf& image) {
    const Channels channels = channels_of(image.spec(), image.nativespec());
    const std::vector<int> shown = shown_channels(channels);
    const auto width = size_t(image.spec().width), count = size_t(image.nchannels());
    std::vector<uint8_t> found;
    found.reserve(image.spec().image_pixels());
    std::vector<float> pixels(width * count);
    OIIO::ROI row = image.roi();
    for (int y = image.ybegin(); y < image.yend(); ++y) {
        row.ybegin = y;
        row.yend = y + 1;
        image.get_pixels(row, OIIO::TypeFloat, pixels.data());
        for (size_t x = 0; x < width; ++x)
            found.push_back(std::any_of(shown.begin(), shown.end(), [&](int c) {
                return !std::isfinite(pixels[x * count + size_t(c)]);
            }));
    }
    return found;
}

/// Say on stderr which channels, of those that hold no IDs or depth, no metric is of.
void note_not_compared(const OIIO::ImageBuf& image, const std::string& path) {
    const Channels channels = channels_of(image.spec(), image.nativespec());
    const std::vector<int> shown = shown_channels(channels);
    std::vector<std::string> others;
    for (int c = 0; c < image.nchannels(); ++c)
        if (channels.kinds[size_t(c)] != Channel::nearest && c != image.spec().z_channel &&
            std::find(shown.begin(), shown.end(), c) == shown.end())
            others.push_back(image.spec().channel_name(c));
    if (!others.empty())
        note(format("not compared of \"{}\": {}", path, OIIO::Strutil::join(others, ", ")));
}

/// Of the data window within the display window: pixels there are compared with one another.
std::pair<int64_t, int64_t> place_of(const OIIO::ImageSpec& spec) {
    return {int64_t(spec.x) - spec.full_x, int64_t(spec.y) - spec.full_y};
}

/// "40x30+5-3 in 64x48+0+0", as oiiotool writes windows.
std::string windows_of(const OIIO::ImageSpec& spec) {
    const auto window = [](int width, int height, int x, int y) {
        return format("{}x{}{:+}{:+}", width, height, x, y);
    };
    return window(spec.width, spec.height, spec.x, spec.y) + " in " +
           window(spec.full_width, spec.full_height, spec.full_x, spec.full_y);
}

/// One of the two images.
struct Looked {
    Picture picture;
    std::vector<uint8_t> not_finite; ///< of each pixel
    OIIO::ImageSpec spec;
};

bool look_at(const std::string& path, Looked& looked, Failure& failure) {
    OIIO::ImageBuf image;
    std::string error;
    if (!open_image(path, image, error)) {
        failure = unreadable(path, error);
        return false;
    }
    if (!check_memory(format("comparing {} x {} pixels", image.spec().width, image.spec().height),
                      bytes_a_pixel * double(image.spec().image_pixels()), error) ||
        !read_picture(image, {}, looked.picture, error)) {
        failure = {error, code_of_message(error)};
        return false;
    }
    looked.spec = image.spec();
    looked.not_finite = find_not_finite(image);
    note_not_compared(image, path);
    note_others(path);
    return true;
}

std::string size_of(const Picture& p) {
    return std::to_string(p.width) + " x " + std::to_string(p.height);
}

/// Whether there is a pixel of one image for each of the other.
bool check_windows(const Looked& a, const Looked& b, Failure& failure) {
    if (a.picture.width != b.picture.width || a.picture.height != b.picture.height)
        failure = {"the images are of different size: " + size_of(a.picture) + " and " +
                   size_of(b.picture)};
    else if (place_of(a.spec) != place_of(b.spec))
        failure = {"the images lie at different places, data window in display window: " +
                   windows_of(a.spec) + " and " + windows_of(b.spec)};
    else
        return true;
    return false;
}

/// Make pixels black in both images that are not finite in one. Returns how many those are.
size_t blacken(const Looked& a, const Looked& b, metrics::Image& image_a, metrics::Image& image_b) {
    size_t count = 0;
    for (size_t i = 0; i < a.not_finite.size(); ++i)
        if (a.not_finite[i] || b.not_finite[i]) {
            ++count;
            for (size_t k = 0; k < 3; ++k)
                image_a.channels[k].values[i] = image_b.channels[k].values[i] = 0;
        }
    return count;
}

struct Metric {
    const char* name;
    double (*value)(const metrics::Image& a, const metrics::Image& b, const metrics::Plane& ya,
                    const metrics::Plane& yb);
};

using metrics::Image;
using metrics::Plane;
constexpr Metric all_metrics[] = {
    {"psnr", [](const Image& a, const Image& b, const Plane&, const Plane&) { return psnr(a, b); }},
    {"mse", [](const Image&, const Image&, const Plane& a, const Plane& b) { return mse(a, b); }},
    {"snr", [](const Image&, const Image&, const Plane& a, const Plane& b) { return snr(a, b); }},
    {"correlation",
     [](const Image&, const Image&, const Plane& a, const Plane& b) { return correlation(a, b); }},
    {"cross-correlation", [](const Image&, const Image&, const Plane& a,
                             const Plane& b) { return cross_correlation(a, b); }},
    {"uiqi", [](const Image&, const Image&, const Plane& a, const Plane& b) { return uiqi(a, b); }},
    {"ssim", [](const Image&, const Image&, const Plane& a, const Plane& b) { return ssim(a, b); }},
    {"ms-ssim",
     [](const Image&, const Image&, const Plane& a, const Plane& b) { return ms_ssim(a, b); }},
    {"gmsd", [](const Image&, const Image&, const Plane& a, const Plane& b) { return gmsd(a, b); }},
};

class CompareCommand final : public Command {
public:
    CompareCommand() {
        name = "compare";
        summary = "Print how alike two images are";
        paragraphs = {
            "Values as displayed (sRGB), 0 to 255; transparent pixels over white. PSNR is over "
            "red, green and blue, the others are of luma. Equal images of one format and colour "
            "space have psnr and snr inf, mse and gmsd 0, the others 1. Colours are compared, not "
            "codes: they are brought from the space that an image names (PNM's is Rec709) to "
            "sRGB, and taken as they are where it names none, so the same codes in another format "
            "may be other colours, or be rounded otherwise. The first image is the reference. "
            "Data windows of one size are compared, which must lie at the same place of their "
            "display windows. A pixel that is not finite in one of them counts as black in both. "
            "Images of IDs (32-bit integers) alone are refused; beside colour IDs and depth are "
            "not looked at, nor are other layers; without colour the first channel is. What has "
            "colour but an alpha of 0 is transparent. OpenImageIO's idiff tells whether numbers "
            "are equal."};
        operands = {{"A", "the reference"}, {"B", "an image of the same size and place"}};
        flags = {switch_flag("--csv", "print as comma-separated values", m_csv)};
    }

    ExitCode run(const std::vector<std::string>& values) override {
        Looked a, b;
        Failure failure;
        if (!look_at(values[0], a, failure) || !look_at(values[1], b, failure) ||
            !check_windows(a, b, failure))
            return fail(failure);
        Image image_a = image_of(a.picture), image_b = image_of(b.picture);
        if (const size_t left_out = blacken(a, b, image_a, image_b); left_out > 0)
            note(format("{} of the pixels are not finite in one image, and taken for black in both",
                        left_out));
        print(image_a, image_b);
        return exit_done;
    }

private:
    void print(const Image& a, const Image& b) const {
        const Plane ya = luma(a), yb = luma(b);
        constexpr size_t count = std::size(all_metrics);
        double value[count];
        {
            Progress progress("comparing");
            for (size_t i = 0; i < count; ++i) {
                progress(float(i) / float(count));
                value[i] = all_metrics[i].value(a, b, ya, yb);
            }
        }
        for (size_t i = 0; i < count && m_csv; ++i)
            std::printf("%s%s", all_metrics[i].name, i + 1 < count ? "," : "\n");
        for (size_t i = 0; i < count; ++i) {
            if (m_csv)
                std::printf("%.9g%s", value[i], i + 1 < count ? "," : "\n");
            else
                std::printf("%-18s %12.6f\n", all_metrics[i].name, value[i]);
        }
    }

    bool m_csv = false;
};

} // namespace

std::unique_ptr<Command> make_compare_command() {
    return std::make_unique<CompareCommand>();
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
// How steady the filters are: every image of a folder is reduced, repeated with other noise in each
// frame, and enlarged frame by frame with each of the filters.
//
//   flicker FOLDER [--scale N] [--light linear|encoded] [--frames N]
//
// The noise is Gaussian, 2 of 255 in display values. A value's deviation is its root mean square
// distance, over the frames, from its mean over the frames; the table tells the output's, as
// multiples of the input's: root mean square and 99.9th percentile over all pixels and channels of
// all images.
//
// The second pair of figures is of a slow pan: each frame shows the original an output pixel
// further to the right, so that the reduced picture moves by 1 / N of its pixels. The motion is
// undone, a whole pixel of the output, and the differences of neighbouring frames are told in the
// same way, as multiples of what noise alone differs by.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include <OpenImageIO/argparse.h>

#include "arguments.h"
#include "reference.h"
#include "rows.h"

namespace {

constexpr double noise_level = 2;

metrics::Image noisy(const metrics::Image& image, unsigned seed) {
    std::mt19937 bits(seed);
    std::normal_distribution<double> noise(0, noise_level);
    metrics::Image out = image;
    for (metrics::Plane& plane : out.channels)
        for (double& v : plane.values)
            v += noise(bits);
    return out;
}

/// Deviations of all values over frames, one image added after the other.
class Deviations {
public:
    void add(double square) {
        m_total += square;
        m_all.push_back(float(std::sqrt(square)));
    }
    void begin(size_t values) {
        m_sum.assign(values, 0);
        m_squares.assign(values, 0);
        m_frames = 0;
    }
    void frame(const metrics::Image& image) {
        size_t at = 0;
        for (const metrics::Plane& plane : image.channels)
            for (double v : plane.values) {
                m_sum[at] += v;
                m_squares[at++] += v * v;
            }
        ++m_frames;
    }
    void end() {
        for (size_t i = 0; i < m_sum.size(); ++i) {
            double mean = m_sum[i] / m_frames;
            double variance = std::max(m_squares[i] / m_frames - mean * mean, 0.0);
            add(variance);
        }
    }
    double rms() const { return std::sqrt(m_total / double(m_all.size())); }
    /// Changes the order of what was gathered.
    double percentile(double share) {
        auto nth = m_all.begin() + std::ptrdiff_t(share * double(m_all.size() - 1));
        std::nth_element(m_all.begin(), nth, m_all.end());
        return double(*nth);
    }

private:
    std::vector<double> m_sum, m_squares;
    int m_frames = 0;
    std::vector<float> m_all;
    double m_total = 0;
};

/// The original from this column on, as wide as all frames of a pan can be and as is a multiple of
/// the scale.
metrics::Image part_from(const metrics::Image& original, int column, int frames, int scale) {
    const int width = (original.width() - (frames - 1)) / scale * scale;
    metrics::Image part;
    for (int c = 0; c < 3; ++c) {
        part.channels[c] = metrics::Plane(width, original.height());
        for (int y = 0; y < original.height(); ++y)
            for (int x = 0; x < width; ++x)
                part.channels[c].at(x, y) = original.channels[c].at(x + column, y);
    }
    return part;
}

/// Squares of the differences of two neighbouring frames of a pan, `border` pixels away from the
/// rim.
void add_differences(const metrics::Image& before, const metrics::Image& after, int border,
                     Deviations& sum) {
    for (int c = 0; c < 3; ++c)
        for (int y = border; y < after.height() - border; ++y)
            for (int x = border; x + 1 < after.width() - border; ++x) {
                const double d = after.channels[c].at(x, y) - before.channels[c].at(x + 1, y);
                sum.add(d * d);
            }
}

struct Settings {
    int scale = 4, frames = 8;
    bench::Light light = bench::Light::linear;
};

/// Whether something is left of all frames of a pan within their borders.
bool is_wide_enough(const metrics::Image& original, const Settings& settings, std::string& error) {
    const int least = settings.frames - 1 + 3 * settings.scale;
    if (original.width() >= least && original.height() >= 3 * settings.scale)
        return true;
    error = "so many frames need " + std::to_string(least) + " x " +
            std::to_string(3 * settings.scale) + " pixels";
    return false;
}

/// Enlarge a frame under noise; false, with a line on stderr, if that fails.
bool enlarge(const bench::Row& row, const metrics::Image& frame, const Settings& settings,
             metrics::Image& out) {
    OIIO::ImageBuf enlarged = row.enlarge(bench::to_light(frame, settings.light), settings.scale);
    if (enlarged.has_error()) {
        std::fprintf(stderr, "%s: %s\n", row.name.c_str(), enlarged.geterror().c_str());
        return false;
    }
    out = bench::to_display(enlarged, settings.light);
    return true;
}

bool pan(const bench::Row& row, const std::vector<metrics::Image>& originals,
         const Settings& settings, Deviations& differences) {
    for (size_t k = 0; k < originals.size(); ++k) {
        metrics::Image before, after;
        for (int f = 0; f < settings.frames; ++f) {
            metrics::Image frame =
                noisy(bench::reduced(part_from(originals[k], f, settings.frames, settings.scale),
                                     settings.scale, settings.light, bench::Reduce::box),
                      unsigned(k * 1000 + size_t(f)));
            if (!enlarge(row, frame, settings, after))
                return false;
            if (f > 0)
                add_differences(before, after, settings.scale, differences);
            std::swap(before, after);
        }
    }
    return true;
}

bool measure(const bench::Row& row, const std::vector<metrics::Image>& originals,
             const Settings& settings) {
    Deviations in, out;
    for (size_t k = 0; k < originals.size(); ++k) {
        const metrics::Image image =
            bench::reduced(originals[k], settings.scale, settings.light, bench::Reduce::box);
        size_t values = image.channels[0].values.size() * 3;
        in.begin(values);
        out.begin(values * size_t(settings.scale * settings.scale));
        for (int f = 0; f < settings.frames; ++f) {
            metrics::Image frame = noisy(image, unsigned(k * 1000 + size_t(f)));
            metrics::Image enlarged;
            if (!enlarge(row, frame, settings, enlarged))
                return false;
            in.frame(frame);
            out.frame(enlarged);
        }
        in.end();
        out.end();
    }
    Deviations differences;
    if (!pan(row, originals, settings, differences))
        return false;
    const double by_noise = noise_level * std::sqrt(2.0);
    std::printf("%-24s %6.2f %6.2f  %6.2f %6.2f\n", row.name.c_str(), out.rms() / in.rms(),
                out.percentile(0.999) / in.rms(), differences.rms() / by_noise,
                differences.percentile(0.999) / by_noise);
    std::fflush(stdout);
    return true;
}

} // namespace

int main(int argc, char** argv) {
    Settings settings;
    std::string light_name = "linear", scale = "4", frames = "8", only;
    std::vector<std::string> folders, more;
    OIIO::ArgParse args;
    args.intro("flicker: how steady the filters are under noise\n")
        .usage("flicker FOLDER [options]");
    args.arg("folder").hidden().action(
        [&](OIIO::cspan<const char*> a) { folders.push_back(a[0]); });
    args.arg("--scale %s:N", &scale).help("factor, 2 to 16 (default: 4)");
    args.arg("--light %s:LIGHT", &light_name).help("linear (default) or encoded");
    args.arg("--frames %s:N", &frames).help("2 to 1000 (default: 8)");
    args.arg("--only %s:NAME", &only).help("only the rows whose name contains NAME");
    args.arg("--also %s:SPEC")
        .help("one more row, such as ddt,soft=0.5 (repeatable)")
        .action([&](OIIO::cspan<const char*> a) { more.push_back(a[1]); });
    if (args.parse_args(argc, const_cast<const char**>(argv)) < 0 || folders.size() != 1) {
        args.print_help();
        return 2;
    }
    bool known_light =
        bench::find_light(light_name, settings.light) && settings.light != bench::Light::scene;
    if (!bench::parse_argument("--scale", scale, 2, 16, settings.scale) ||
        !bench::parse_argument("--frames", frames, 2, 1000, settings.frames))
        return 2;
    if (!known_light) {
        std::fprintf(stderr, "flicker: --light takes linear or encoded\n");
        return 2;
    }
    std::vector<metrics::Image> images;
    for (const std::string& file : bench::image_files(folders[0])) {
        metrics::Image original;
        std::string error;
        if (bench::read_original(file, settings.scale, settings.light, original, error) &&
            is_wide_enough(original, settings, error))
            images.push_back(std::move(original));
        else
            std::fprintf(stderr, "%s is left out: %s\n", file.c_str(), error.c_str());
    }
    if (images.empty()) {
        std::fprintf(stderr, "flicker: no images in %s\n", folders[0].c_str());
        return 1;
    }

    const std::vector<bench::Row> rows = bench::rows_with(only, settings.light, more);
    if (rows.empty()) {
        std::fprintf(stderr, "flicker: no row has \"%s\" in its name\n", only.c_str());
        return 2;
    }
    std::printf(
        "%zu images, %dx, %s light, %d frames\n\n%-24s %6s %6s  %6s %6s\n%-24s %6s %6s  %6s %6s\n",
        images.size(), settings.scale, light_name.c_str(), settings.frames, "", "still", "still",
        "pan", "pan", "", "rms", "99.9%", "rms", "99.9%");
    bool all_well = true;
    for (const bench::Row& row : rows)
        all_well &= measure(row, images, settings);
    return all_well ? 0 : 1;
}

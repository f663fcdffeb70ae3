// How fast the filters are, as ratios to OpenImageIO's own on the same image in the same process.
//
//   speed [IMAGE] [--megapixels N] [--scales 1.5,2,4,8] [--rounds N]
//
// Without IMAGE a picture with soft and hard edges is made. Each round runs every filter once, one
// after the other, so that a slow moment of the machine strikes all alike; a ratio is the median
// over the rounds of the ratio within one round.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>

#include <OpenImageIO/argparse.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>
#include <OpenImageIO/sysutil.h>

#include "ddt/resize.h"
#include "noise.h"

namespace {

const char* const stock_filters[] = {"triangle", "blackman-harris", "lanczos3"};

/// Clouds, and in front of them the outlines of other clouds: flat parts, texture, hard edges.
OIIO::ImageBuf made_picture(double megapixels) {
    int side = int(std::lround(std::sqrt(megapixels * 1e6)));
    OIIO::ImageBuf image(OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::FLOAT));
    for (OIIO::ImageBuf::Iterator<float> it(image); !it.done(); ++it) {
        using testimages::cloud;
        double x = it.x(), y = it.y();
        double texture = cloud(x / 90, y / 90, 1, 7), shade = cloud(x / 300, y / 300, 20, 3);
        bool front = cloud(x / 120, y / 120, 40, 5) > 0.55,
             thing = cloud(x / 50, y / 60, 60, 2) > 0.7;
        for (int c = 0; c < 3; ++c) {
            double tint = 0.6 + 0.4 * testimages::hash01(c, front + 2 * thing, 80);
            it[c] = float(tint * (front ? texture * texture : 0.3 + 0.5 * shade) + 0.2 * thing);
        }
    }
    return image;
}

OIIO::ImageBuf cropped(const OIIO::ImageBuf& image, double megapixels) {
    int side = int(std::lround(std::sqrt(megapixels * 1e6)));
    const OIIO::ImageSpec& spec = image.spec();
    // Repeated if it is smaller: an image of the size asked for, whatever was given.
    OIIO::ImageBuf out(OIIO::ImageSpec(side, side, 3, OIIO::TypeDesc::FLOAT));
    for (int y = 0; y < side; y += spec.height)
        for (int x = 0; x < side; x += spec.width)
            OIIO::ImageBufAlgo::paste(out, x, y, 0, 0, image);
    return out;
}

/// The picture as floats in linear light or as 8 bits in sRGB. What the numbers mean makes no
/// difference to the filters' time, but which conversions they call for does.
OIIO::ImageBuf in_format(const OIIO::ImageBuf& picture, bool eight_bit) {
    OIIO::ImageBuf image = OIIO::ImageBufAlgo::copy(picture, eight_bit ? OIIO::TypeDesc::UINT8
                                                                       : OIIO::TypeDesc::FLOAT);
    image.specmod().attribute("oiio:ColorSpace", eight_bit ? "sRGB" : "Linear");
    return image;
}

double seconds(const std::string& filter, const OIIO::ImageBuf& image, double scale, int threads) {
    auto size = [&](int length) { return int(std::lround(length * scale)); };
    OIIO::ROI roi(0, size(image.spec().width), 0, size(image.spec().height), 0, 1, 0, 3);
    OIIO::ImageBuf result;
    ddt::Options options;
    std::string error;
    bool ours = ddt::parse_filter(filter, options, error);
    auto start = std::chrono::steady_clock::now();
    bool done = ours ? ddt::resize(result, image, options, roi, threads)
                     : OIIO::ImageBufAlgo::resize(result, image, filter, 0, roi, threads);
    std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
    if (!done) {
        std::fprintf(stderr, "%s: %s\n", filter.c_str(), result.geterror().c_str());
        std::exit(1);
    }
    return time.count();
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    size_t n = values.size();
    return n % 2 ? values[n / 2] : (values[n / 2 - 1] + values[n / 2]) / 2;
}

void compare(const OIIO::ImageBuf& image, double scale, int threads, int rounds) {
    std::map<std::string, std::vector<double>> times;
    for (int round = 0; round < rounds; ++round) {
        for (const std::string& filter : ddt::filter_names())
            times[filter].push_back(seconds(filter, image, scale, threads));
        for (const char* filter : stock_filters)
            times[filter].push_back(seconds(filter, image, scale, threads));
    }
    double output_pixels = double(image.spec().image_pixels()) * scale * scale;
    for (const std::string& filter : ddt::filter_names()) {
        std::printf("%-12s %5gx", filter.c_str(), scale);
        for (const char* other : stock_filters) {
            std::vector<double> ratios;
            for (size_t i = 0; i < size_t(rounds); ++i)
                ratios.push_back(times[other][i] / times[filter][i]);
            std::printf(" %15.2f", median(ratios));
        }
        std::printf(" %13.2f\n", median(times[filter]) * 1e9 / output_pixels);
        std::fflush(stdout);
    }
}

} // namespace

int main(int argc, char** argv) {
    float megapixels = 1;
    int rounds = 3;
    std::string scales = "1.5,2,4,8", path;
    OIIO::ArgParse args;
    args.intro("speed: ddt against OpenImageIO's filters\n").usage("speed [IMAGE] [options]");
    args.arg("image").hidden().action([&](OIIO::cspan<const char*> a) { path = a[0]; });
    args.arg("--megapixels %f:N", &megapixels).help("size of the source (default: 1)");
    args.arg("--scales %s:LIST", &scales).help("factors (default: 1.5,2,4,8)");
    args.arg("--rounds %d:N", &rounds).help("runs of each filter (default: 3)");
    if (args.parse(argc, const_cast<const char**>(argv)) < 0 || rounds < 1 || !(megapixels > 0)) {
        std::fprintf(stderr, "%s\n", args.geterror().c_str());
        args.print_help();
        return 2;
    }
    std::vector<double> factors;
    for (const std::string& scale : OIIO::Strutil::splits(scales, ",")) {
        factors.push_back(OIIO::Strutil::string_is_float(scale) ? OIIO::Strutil::stof(scale) : 0);
        if (!(factors.back() > 1 && factors.back() <= 64)) {
            std::fprintf(stderr, "speed: --scales takes factors above 1, up to 64; not \"%s\"\n",
                         scale.c_str());
            return 2;
        }
    }
    OIIO::ImageBuf picture;
    if (path.empty()) {
        picture = made_picture(megapixels);
    } else {
        OIIO::ImageBuf file(path);
        if (!file.read(0, 0, true)) {
            std::fprintf(stderr, "%s\n", file.geterror().c_str());
            return 1;
        }
        picture = cropped(file, megapixels);
    }
    int all = int(OIIO::Sysutil::hardware_concurrency());
    for (bool eight_bit : {false, true})
        for (int threads : {1, all}) {
            OIIO::ImageBuf image = in_format(picture, eight_bit);
            std::printf("%s%dx%d RGB, %s, %d thread%s\n", eight_bit || threads > 1 ? "\n" : "",
                        image.spec().width, image.spec().height,
                        eight_bit ? "8-bit sRGB" : "linear float", threads, threads > 1 ? "s" : "");
            std::printf("%-18s %15s %15s %15s %13s\n", "times as fast as:", stock_filters[0],
                        stock_filters[1], stock_filters[2], "ns/pixel out");
            for (double scale : factors)
                compare(image, scale, threads, rounds);
        }
    return 0;
}

// SPDX-License-Identifier: Apache-2.0
// How good the filters are: every image of a folder is reduced, enlarged again with each of them,
// and compared with what it was.
//
//   quality FOLDER [--scale N] [--light linear|encoded|scene] [--reduce box|cubic]
//
// Reducing and enlarging happen in the chosen light, on floats; the reduced image and the result
// are rounded to 8 bits, and compared in encoded RGB without a border of N pixels. With `scene` the
// images are scene-linear floating point ones, nothing is rounded, and they are compared by their
// logarithm (bench::encode_log). Figures are means over the images.
//
// Overshoot is what leaves the range of the source pixels within `overshoot_reach` of the output's
// place. It is that wide because a triangle may be long: with all its pixels in that square, a
// surface that keeps to its triangles' values has none.
#include <algorithm>
#include <chrono>
#include <cstdio>

#include <OpenImageIO/argparse.h>

#include "arguments.h"
#include "metrics/gmsd.h"
#include "metrics/overshoot.h"
#include "metrics/psnr.h"
#include "metrics/ssim.h"
#include "metrics/staircase.h"
#include "reference.h"
#include "rows.h"

namespace {

constexpr int overshoot_reach = 8;

struct Figures {
    double psnr = 0, ssim = 0, ms_ssim = 0, gmsd = 0;
    double largest_overshoot = 0, mean_overshoot = 0, negative_share = 0;
    double nanoseconds = 0; ///< an output pixel
    int images = 0;
};

struct Case {
    std::string name;
    metrics::Image original, small;
    OIIO::ImageBuf input; ///< `small` in the light of the comparison
};

bool measure(const bench::Row& row, const Case& c, int scale, bench::Light light, Figures& sum) {
    using Clock = std::chrono::steady_clock;
    if (sum.images == 0)
        row.enlarge(c.input, scale); // what is had once, and caches that others have filled
    auto start = Clock::now();
    OIIO::ImageBuf enlarged = row.enlarge(c.input, scale);
    std::chrono::duration<double, std::nano> time = Clock::now() - start;
    if (enlarged.has_error()) {
        std::fprintf(stderr, "%s: %s: %s\n", c.name.c_str(), row.name.c_str(),
                     enlarged.geterror().c_str());
        return false;
    }
    metrics::Image result = bench::to_display(enlarged, light);
    metrics::Overshoot beyond = metrics::overshoot(c.small, result, scale, overshoot_reach);
    metrics::Image a = metrics::without_border(c.original, scale);
    metrics::Image b = metrics::without_border(bench::stored(result, light), scale);
    metrics::Plane ya = metrics::luma(a), yb = metrics::luma(b);

    sum.psnr += metrics::psnr(a, b);
    sum.ssim += metrics::ssim(ya, yb);
    sum.ms_ssim += metrics::ms_ssim(ya, yb);
    sum.gmsd += metrics::gmsd(ya, yb);
    sum.largest_overshoot = std::max(sum.largest_overshoot, beyond.largest);
    sum.mean_overshoot += beyond.mean;
    sum.negative_share += beyond.negative_share;
    sum.nanoseconds += time.count() / double(enlarged.spec().image_pixels());
    ++sum.images;
    return true;
}

metrics::Staircase staircase_of(const bench::Row& row, int scale, bench::Light light) {
    auto enlarge = [&](const metrics::Plane& plane) {
        metrics::Image image{{plane, plane, plane}};
        return bench::to_display(row.enlarge(bench::to_light(image, light), scale), light)
            .channels[0];
    };
    return metrics::staircase(enlarge, scale);
}

void print_head() {
    std::printf("%-22s %7s %7s %7s %7s %6s %6s %6s %7s %7s %7s\n", "", "PSNR", "SSIM", "MS-SSIM",
                "GMSD", "over", "over", "neg.", "stair", "worst", "time");
    std::printf("%-22s %7s %7s %7s %7s %6s %6s %6s %7s %7s %7s\n", "", "dB", "", "", "", "max",
                "mean", "%", "px", "px", "ns/px");
}

void print(const std::string& name, const Figures& f, const metrics::Staircase& stairs) {
    double n = f.images;
    std::printf("%-22s %7.2f %7.4f %7.4f %7.4f %6.1f %6.3f %6.3f %7.4f %7.4f %7.0f\n", name.c_str(),
                f.psnr / n, f.ssim / n, f.ms_ssim / n, f.gmsd / n, f.largest_overshoot,
                f.mean_overshoot / n, 100 * f.negative_share / n, stairs.mean, stairs.worst,
                f.nanoseconds / n);
    std::fflush(stdout);
}

} // namespace

int main(int argc, char** argv) {
    int scale = 2;
    std::string scale_text = "2", light_name = "linear", reduce_name = "box", only;
    std::vector<std::string> folders, more;
    OIIO::ArgParse args;
    args.intro("quality: reduce, enlarge, compare\n").usage("quality FOLDER [options]");
    args.arg("folder").hidden().action(
        [&](OIIO::cspan<const char*> a) { folders.push_back(a[0]); });
    args.arg("--scale %s:N", &scale_text).help("factor, 2 to 16 (default: 2)");
    args.arg("--light %s:LIGHT", &light_name).help("linear (default), encoded or scene");
    args.arg("--reduce %s:HOW", &reduce_name).help("box (default) or cubic");
    args.arg("--only %s:NAME", &only).help("only the rows whose name contains NAME");
    args.arg("--also %s:SPEC")
        .help("one more row, such as ddt,cost=scf or \"ddt to integers\" (repeatable)")
        .action([&](OIIO::cspan<const char*> a) { more.push_back(a[1]); });
    if (args.parse_args(argc, const_cast<const char**>(argv)) < 0 || folders.size() != 1) {
        args.print_help();
        return 2;
    }
    bench::Light light = bench::Light::linear;
    bool known_light = bench::find_light(light_name, light);
    bool known_reduce = reduce_name == "box" || reduce_name == "cubic";
    if (!bench::parse_argument("--scale", scale_text, 2, 16, scale))
        return 2;
    if (!known_light || !known_reduce) {
        std::fprintf(stderr, "quality: --light takes linear, encoded or scene, --reduce box or "
                             "cubic\n");
        return 2;
    }
    auto reduce = reduce_name == "box" ? bench::Reduce::box : bench::Reduce::cubic;

    std::vector<Case> cases;
    for (const std::string& file : bench::image_files(folders[0])) {
        Case c;
        std::string error;
        c.name = file;
        if (!bench::read_original(file, scale, light, c.original, error)) {
            std::fprintf(stderr, "%s is left out: %s\n", file.c_str(), error.c_str());
            continue;
        }
        c.small = bench::reduced(c.original, scale, light, reduce);
        c.input = bench::to_light(c.small, light);
        cases.push_back(std::move(c));
    }
    if (cases.empty()) {
        std::fprintf(stderr, "quality: no images in %s\n", folders[0].c_str());
        return 1;
    }

    const std::vector<bench::Row> rows = bench::rows_with(only, light, more);
    if (rows.empty()) {
        std::fprintf(stderr, "quality: no row has \"%s\" in its name\n", only.c_str());
        return 2;
    }
    std::printf("%zu images, %dx, %s light, reduced by %s\n\n", cases.size(), scale,
                light_name.c_str(), reduce_name.c_str());
    print_head();
    bool all_well = true;
    for (const bench::Row& row : rows) {
        Figures sum;
        // A row that fails ends at once: its mean would not compare with the others.
        bool measured = std::all_of(cases.begin(), cases.end(), [&](const Case& c) {
            return measure(row, c, scale, light, sum);
        });
        if (measured)
            print(row.name, sum, staircase_of(row, scale, light));
        all_well &= measured;
    }
    return all_well ? 0 : 1;
}

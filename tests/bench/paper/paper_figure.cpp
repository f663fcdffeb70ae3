// SPDX-License-Identifier: Apache-2.0
// The paper's figure 10: a close-up at 1200 % of the original and of what the schemes make of its
// reduction by 2; below each its difference from the original and its mesh.
//
//   paper_figure IMAGE OUT_FOLDER [--x X] [--y Y] [--size N]
//
// X, Y and N, in pixels of the original, say which square is shown; they are rounded to even
// numbers. OUT_FOLDER gets SCHEME.png, SCHEME-difference.png and SCHEME-mesh.png for each scheme,
// and original.png. A difference of 0 is mid-grey, differences are doubled. Everything is in
// encoded light, with planes over the triangles, SCF, and parallel diagonals to start from.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include <OpenImageIO/argparse.h>
#include <OpenImageIO/imagebufalgo.h>

#include "ddt/mesh.h"
#include "ddt/names.h"
#include "ddt/resize.h"
#include "light.h"
#include "paper/subject.h"
#include "reference.h"
#include "tests/core/plain.h"

namespace {

using metrics::Image;
using metrics::Plane;

constexpr int zoom = 12, factor = 2;

struct Square {
    int x, y, size; ///< in pixels of the original
};

/// The square of an image, every pixel `zoom` times as large.
Image magnified(const Image& image, const Square& square) {
    Image out;
    for (size_t c = 0; c < 3; ++c) {
        out.channels[c] = Plane(square.size * zoom, square.size * zoom);
        for (int y = 0; y < square.size * zoom; ++y)
            for (int x = 0; x < square.size * zoom; ++x)
                out.channels[c].at(x, y) =
                    image.channels[c].at(square.x + x / zoom, square.y + y / zoom);
    }
    return out;
}

/// The part `roi` of `small` enlarged by `by`; all of it without roi.
Image enlarged(const Image& small, int by, const ddt::MeshOptions& mesh, OIIO::ROI roi = {}) {
    ddt::Options options;
    options.mesh = mesh;
    options.surface = ddt::test::plain_surface(ddt::Surface::linear);
    options.light = "encoded";
    const OIIO::ImageBuf source = bench::to_light(small, bench::Light::encoded);
    OIIO::ImageSpec spec(small.width() * by, small.height() * by, 3, OIIO::TypeFloat);
    if (roi.defined())
        OIIO::set_roi(spec, roi);
    OIIO::ImageBuf large(spec);
    if (!ddt::resize(large, source, options, large.roi())) {
        std::fprintf(stderr, "paper_figure: %s\n", large.geterror().c_str());
        std::exit(1);
    }
    // The corner of the part at the origin, where to_display() starts.
    large.set_origin(0, 0);
    large.set_full(0, spec.width, 0, spec.height, 0, 1);
    return bench::to_display(large, bench::Light::encoded);
}

Image difference(const Image& original, const Image& test) {
    const Plane a = luma(original), b = luma(test);
    Plane d(a.width, a.height);
    for (size_t i = 0; i < d.values.size(); ++i)
        d.values[i] = 128 + 2 * (b.values[i] - a.values[i]);
    return {{d, d, d}};
}

/// Draws the mesh of the reduced image over a faded picture of the square.
class MeshDrawing {
public:
    MeshDrawing(const Image& picture, const Square& square) : m_image(picture), m_square(square) {
        for (Plane& plane : m_image.channels)
            for (double& v : plane.values)
                v = 255 - (255 - v) / 3;
    }

    /// A line between pixels of the reduced image.
    void line(double x0, double y0, double x1, double y1) {
        const double ax = place(x0, m_square.x), ay = place(y0, m_square.y);
        const double bx = place(x1, m_square.x), by = place(y1, m_square.y);
        const int steps = int(std::ceil(std::max({std::fabs(bx - ax), std::fabs(by - ay), 1.0})));
        for (int i = 0; i <= steps; ++i)
            dot(ax + (bx - ax) * i / steps, ay + (by - ay) * i / steps);
    }
    const Image& image() const { return m_image; }

private:
    /// Where in the drawing the centre of a reduced pixel is.
    static double place(double pixel, int square_begin) {
        return ((pixel + 0.5) * factor - square_begin) * zoom - 0.5;
    }
    void dot(double x, double y) {
        const int px = int(std::lround(x)), py = int(std::lround(y));
        if (px < 0 || py < 0 || px >= m_image.width() || py >= m_image.height())
            return;
        for (Plane& plane : m_image.channels)
            plane.at(px, py) = 0;
    }

    Image m_image;
    Square m_square;
};

Image mesh_drawing(const Image& picture, const Image& reduced, const Square& square,
                   const ddt::MeshOptions& options) {
    MeshDrawing drawing(picture, square);
    ddt::Mesh mesh;
    const auto guide = paper::guide_of(reduced);
    ddt::build_mesh(guide.data(), reduced.width(), reduced.height(), options, mesh);
    for (const auto& t : mesh.triangles)
        for (size_t k = 0; k < 3; ++k) {
            const int32_t a = t[k], b = t[(k + 1) % 3];
            drawing.line(a % mesh.width, a / mesh.width, b % mesh.width, b / mesh.width);
        }
    return drawing.image();
}

bool write(const std::string& path, const Image& image) {
    OIIO::ImageBuf out = bench::to_light(image, bench::Light::encoded);
    out.specmod().attribute("png:compressionLevel", 9);
    out.set_write_format(OIIO::TypeUInt8);
    if (out.write(path))
        return true;
    std::fprintf(stderr, "paper_figure: %s\n", out.geterror().c_str());
    return false;
}

bool make(const std::string& path, const std::string& folder, Square square) {
    Image original;
    std::string error;
    if (!bench::read_original(path, factor, bench::Light::encoded, original, error)) {
        std::fprintf(stderr, "paper_figure: %s: %s\n", path.c_str(), error.c_str());
        return false;
    }
    square.size = std::min({square.size, original.width(), original.height()});
    square.x = std::clamp(square.x, 0, original.width() - square.size);
    square.y = std::clamp(square.y, 0, original.height() - square.size);
    std::error_code ignored; // write() tells
    std::filesystem::create_directories(folder, ignored);
    const Image reduced = paper::reduce(original, factor, paper::Reduce::bilinear);
    bool fine = write(folder + "/original.png", magnified(original, square));
    const OIIO::ROI close_up(square.x * zoom, (square.x + square.size) * zoom, square.y * zoom,
                             (square.y + square.size) * zoom, 0, 1, 0, 3);
    for (const char* name :
         {"lawson", "basic", "exproi", "maxgain", "exproi-maxgain", "one-round"}) {
        ddt::MeshOptions options;
        ddt::find_scheme(name, options);
        options.cost = ddt::Cost::scf;
        options.start = ddt::Start::diagonal;
        options.max_iterations = ddt::most_iterations;
        options.min_gain = -1;
        options.blur = 0;
        options.contour = 0;
        const std::string stem = folder + "/" + name;
        const Image picture = enlarged(reduced, factor * zoom, options, close_up);
        const Image back = bench::stored(enlarged(reduced, factor, options), bench::Light::encoded);
        fine = write(stem + ".png", picture) &&
               write(stem + "-difference.png", magnified(difference(original, back), square)) &&
               write(stem + "-mesh.png", mesh_drawing(picture, reduced, square, options)) && fine;
    }
    return fine;
}

} // namespace

int main(int argc, char** argv) {
    Square square{0, 0, 20};
    std::vector<std::string> operands;
    OIIO::ArgParse args;
    args.intro("paper_figure: the paper's figure 10\n")
        .usage("paper_figure IMAGE OUT_FOLDER [options]");
    args.arg("operand").hidden().action(
        [&](OIIO::cspan<const char*> a) { operands.push_back(a[0]); });
    args.arg("--x %d:X", &square.x).help("left edge of the square");
    args.arg("--y %d:Y", &square.y).help("upper edge of the square");
    args.arg("--size %d:N", &square.size).help("pixels a side (default: 20)");
    if (args.parse_args(argc, const_cast<const char**>(argv)) < 0 || operands.size() != 2 ||
        square.size < factor) {
        std::fprintf(stderr, "%s\n", args.geterror().c_str());
        args.print_help();
        return 2;
    }
    square = {square.x / factor * factor, square.y / factor * factor,
              square.size / factor * factor};
    return make(operands[0], operands[1], square) ? 0 : 1;
}

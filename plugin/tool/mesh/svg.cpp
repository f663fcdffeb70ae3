// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "ddt/guide.h"
#include "plugin/tool/mesh/mesh_file.h"
#include "plugin/tool/mesh/writing_progress.h"

namespace ddt::tool {

namespace {

struct Point {
    double x, y;
};

/// A triangle of the picture with its colours as vectors of four.
class Painter {
public:
    Painter(std::FILE* file, const Mesh& mesh, const Picture& picture, const MeshStyle& style)
        : m_file(file), m_mesh(mesh), m_picture(picture), m_style(style) {}

    void paint(size_t index) {
        const auto& t = m_mesh.triangles[index];
        for (size_t k = 0; k < 3; ++k) {
            const auto v = size_t(t[k]);
            m_at[k] = {double(t[k] % m_mesh.width), double(t[k] / m_mesh.width)};
            const Colour& c = m_picture.colours[v];
            const float parts[4] = {c.red, c.green, c.blue, m_picture.has_alpha ? c.alpha : 1.0f};
            // What a file can hold.
            for (size_t i = 0; i < 4; ++i)
                m_colour[k][i] = parts[i] > 0.0f ? std::min(double(parts[i]), 1.0) : 0.0;
        }
        Point way;
        if (m_style.fill == Fill::gradient && find_way(way))
            gradient(index, way);
        else if (m_style.fill != Fill::none) {
            double mean[4];
            for (size_t i = 0; i < 4; ++i)
                mean[i] = (m_colour[0][i] + m_colour[1][i] + m_colour[2][i]) / 3;
            std::fprintf(m_file, "<path");
            colour("fill", "fill-opacity", mean);
        } else {
            std::fprintf(m_file, "<path");
        }
        std::fprintf(m_file, " d=\"M%g %gL%g %gL%g %gZ\"/>\n", m_at[0].x, m_at[0].y, m_at[1].x,
                     m_at[1].y, m_at[2].x, m_at[2].y);
    }

private:
    void colour(const char* name, const char* opacity, const double* c) {
        std::fprintf(m_file, " %s=\"#%02x%02x%02x\"", name, byte_of(float(c[0])),
                     byte_of(float(c[1])), byte_of(float(c[2])));
        if (byte_of(float(c[3])) != 255)
            std::fprintf(m_file, " %s=\"%.3g\"", opacity, c[3]);
    }

    /// Slope of a quantity given at the corners; the triangle's area is 1/2.
    Point slope(const double (&z)[3]) const {
        const Point e{m_at[1].x - m_at[0].x, m_at[1].y - m_at[0].y};
        const Point o{m_at[2].x - m_at[0].x, m_at[2].y - m_at[0].y};
        const double de = z[1] - z[0], d = z[2] - z[0];
        return {de * o.y - d * e.y, d * e.x - de * o.x};
    }

    /// The direction of luminance's steepest way, or else of the first colour's, or of opacity's.
    /// False where none changes by what could be seen.
    bool find_way(Point& way) const {
        constexpr double visible = 1e-6; // a pixel
        double luminance[3];
        for (size_t k = 0; k < 3; ++k)
            luminance[k] = luminance_weights[0] * m_colour[k][0] +
                           luminance_weights[1] * m_colour[k][1] +
                           luminance_weights[2] * m_colour[k][2];
        way = slope(luminance);
        double length = std::hypot(way.x, way.y);
        for (size_t i = 0; i < 4 && length < visible; ++i) {
            const double part[3] = {m_colour[0][i], m_colour[1][i], m_colour[2][i]};
            way = slope(part);
            length = std::hypot(way.x, way.y);
        }
        if (length < visible)
            return false;
        way = {way.x / length, way.y / length};
        return true;
    }

    /// Along the direction d, from the first corner to the last that it reaches.
    void gradient(size_t index, const Point& d) {
        const Point centre{(m_at[0].x + m_at[1].x + m_at[2].x) / 3,
                           (m_at[0].y + m_at[1].y + m_at[2].y) / 3};
        double low = 0, high = 0;
        for (const Point& p : m_at) {
            const double s = (p.x - centre.x) * d.x + (p.y - centre.y) * d.y;
            low = std::min(low, s);
            high = std::max(high, s);
        }
        double from[4], to[4];
        for (size_t i = 0; i < 4; ++i) {
            const double part[3] = {m_colour[0][i], m_colour[1][i], m_colour[2][i]};
            const Point g = slope(part);
            const double rise = g.x * d.x + g.y * d.y, mean = (part[0] + part[1] + part[2]) / 3;
            from[i] = std::clamp(mean + rise * low, 0.0, 1.0);
            to[i] = std::clamp(mean + rise * high, 0.0, 1.0);
        }
        std::fprintf(m_file,
                     "<linearGradient id=\"g%zu\" gradientUnits=\"userSpaceOnUse\" x1=\"%.3f\" "
                     "y1=\"%.3f\" x2=\"%.3f\" y2=\"%.3f\"><stop",
                     index, centre.x + d.x * low, centre.y + d.y * low, centre.x + d.x * high,
                     centre.y + d.y * high);
        colour("stop-color", "stop-opacity", from);
        std::fprintf(m_file, "/><stop offset=\"1\"");
        colour("stop-color", "stop-opacity", to);
        std::fprintf(m_file, "/></linearGradient><path fill=\"url(#g%zu)\"", index);
    }

    std::FILE* m_file;
    const Mesh& m_mesh;
    const Picture& m_picture;
    const MeshStyle& m_style;
    Point m_at[3];
    double m_colour[3][4];
};

} // namespace

bool write_svg(std::FILE* file, const Mesh& mesh, const Picture& picture, const MeshStyle& style,
               const ProgressCallback& progress) {
    const int w = mesh.width - 1, h = mesh.height - 1;
    // Crisp edges: smoothed ones of neighbours would let the background through between them.
    std::fprintf(file,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" "
                 "viewBox=\"0 0 %d %d\">\n<g%s",
                 w, h, w, h, style.fill == Fill::none ? " fill=\"none\"" : "");
    if (style.lines > 0)
        std::fprintf(file, " stroke=\"black\" stroke-width=\"%g\" stroke-linejoin=\"round\"",
                     style.lines);
    else
        std::fprintf(file, " shape-rendering=\"crispEdges\"");
    std::fprintf(file, ">\n");
    Painter painter(file, mesh, picture, style);
    for (size_t i = 0; i < mesh.triangles.size(); ++i) {
        painter.paint(i);
        if (i % triangles_told == 0 && !progress(float(i) / float(mesh.triangles.size())))
            return false;
    }
    std::fprintf(file, "</g>\n</svg>\n");
    return true;
}

} // namespace ddt::tool

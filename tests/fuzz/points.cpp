// SPDX-License-Identifier: Apache-2.0
// Files of points and meshes: what is read has a value a point in every column, can be
// triangulated, flipped and drawn, or fails with one line. The first byte chooses the reader.
#include <cmath>

#include "plugin/tool/points/point_file.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

using namespace ddt;
using namespace ddt::fuzz;

namespace {

constexpr size_t most_worked_on = 500;

void require_line(const std::string& error) {
    require(!error.empty(), "a failure says why");
    require(error.find('\n') == std::string::npos, "an error is one line: " + error);
    require(error.size() < 4096 + 512, "an error is short");
}

/// Triangles, flips and an image of them.
void work_on(tool::PointFile& points) {
    std::string error;
    if (points.mesh.triangles.empty() && !delaunay(points.mesh, &error))
        return require_error_line(error);
    const std::vector<float> guide = tool::guide_of(points, tool::usual_columns(points));
    require(guide.size() == points.mesh.x.size(), "a guide a point");
    MeshOptions options;
    options.max_iterations = 8;
    if (!optimise(points.mesh, guide.data(), options, nullptr, &error))
        return require_error_line(error);
    constexpr int side = 16;
    std::vector<float> pixels(side * side);
    std::vector<uint8_t> inside(side * side);
    const PixelGrid grid{points.mesh.x[0], points.mesh.y[0], 0.5, -0.25, side, side};
    if (!draw(points.mesh, guide.data(), 1, grid, pixels.data(), inside.data(), &error))
        require_error_line(error);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Bytes bytes(data, size);
    const bool ply = bytes.coin();
    const std::string text = bytes.rest();
    tool::PointFile points;
    std::string error;
    if (!(ply ? tool::read_ply : tool::read_table)(text, points, error)) {
        require_line(error);
        return 0;
    }
    const size_t count = points.mesh.x.size();
    require(count > 0 && points.mesh.y.size() == count, "as many x as y");
    for (const tool::Column& column : points.columns)
        require(column.values.size() == count, "a value a point in " + column.name);
    if (count <= most_worked_on)
        work_on(points);
    return 0;
}

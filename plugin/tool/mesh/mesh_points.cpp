// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/mesh/mesh_points.h"

#include <OpenImageIO/strutil.h>

#include "plugin/tool/command/command.h"
#include "plugin/tool/points/coarse_axis.h"
#include "plugin/tool/points/point_file.h"
#include "plugin/tool/points/write_points.h"

namespace ddt::tool {

bool is_point_mesh(const std::string& path) {
    return OIIO::Strutil::iends_with(path, ".ply");
}

bool optimise_file(const std::string& in, const std::string& out, const MeshOptions& options,
                   Device device, MeshReport& report, const ProgressCallback& progress,
                   Failure& failure) {
    if (!is_point_mesh(out)) {
        failure = {"\"" + out + "\" is not allowed; of a mesh, allowed are names that end in .ply",
                   exit_usage};
        return false;
    }
    PointFile points;
    if (!read_points(in, points, failure))
        return false;
    const std::vector<const Column*> columns = usual_columns(points);
    if (columns.empty()) {
        failure.why = "\"" + in + "\" has no values";
        return false;
    }
    if (points.mesh.triangles.empty()) {
        failure.why = "\"" + in +
                      "\" has no triangles; of points alone, ddt scatter POINTS image.exr --mesh "
                      "OUT makes them";
        return false;
    }
    if (const std::string said = note_on_coarse_axis(points.mesh); !said.empty())
        note(said);
    const std::vector<float> guide = guide_of(points, columns);
    if (!optimise(points.mesh, guide.data(), options, &report, &failure.why, progress, device)) {
        failure = {fault_in(in, points, failure.why), code_of_message(failure.why)};
        return false;
    }
    return write_points(out, points, failure);
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>

#include <OpenImageIO/strutil.h>

#include "core/base/parse_number.h"
#include "core/base/progress.h"
#include "core/tin/tin.h"
#include "ddt/rect.h"
#include "ddt/resize.h"
#include "plugin/image/largest_side.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/command/filter_keys.h"
#include "plugin/tool/command/progress.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/points/coarse_axis.h"
#include "plugin/tool/points/drop_unknown.h"
#include "plugin/tool/points/plan_grid.h"
#include "plugin/tool/points/point_file.h"
#include "plugin/tool/points/point_image.h"
#include "plugin/tool/points/window.h"
#include "plugin/tool/points/write_points.h"

namespace ddt::tool {

namespace {

/// "X0,Y0,X1,Y1", the corners of a window that is not empty.
bool parse_corners(const std::string& text, Window& window) {
    const std::vector<std::string> parts = OIIO::Strutil::splits(text, ",");
    Window w;
    double* const numbers[] = {&w.x0, &w.y0, &w.x1, &w.y1};
    if (parts.size() != 4)
        return false;
    for (size_t k = 0; k < 4; ++k)
        if (!parse_number(parts[k], -1e300, 1e300, *numbers[k]))
            return false;
    if (!(w.x1 > w.x0 && w.y1 > w.y0))
        return false;
    window = w;
    return true;
}

/// "WxH"; one of them may be 0, for what is left open.
bool parse_image_size(const std::string& text, int& width, int& height) {
    int w = 0, h = 0;
    if (!parse_sides(text, 0, largest_side, w, h) || (w == 0 && h == 0))
        return false;
    width = w;
    height = h;
    return true;
}

std::string joined_names(const std::vector<const Column*>& columns, const char* between) {
    std::vector<std::string> names;
    for (const Column* column : columns)
        names.push_back(column->name);
    return OIIO::Strutil::join(names, between);
}

class ScatterCommand final : public Command {
public:
    ScatterCommand() {
        name = "scatter";
        summary = "Make an image of scattered points with values";
        paragraphs = {
            "The points are triangulated (Delaunay), unless the file brings triangles; edges are "
            "flipped until they run along the values' own edges; values are interpolated linearly "
            "over the triangles. Outside them pixels are empty: 0, alpha 0.",
            "POINTS is a PLY file or text (CSV, XYZ) whose first line names the columns, x and y "
            "among them, perhaps after # or //; there red, green, blue and alpha may be called R, "
            "G, B and A, and the cell of a value may be empty. Of points at one place, or closer "
            "together than 2^-29 of what all span along the longer axis, the first is taken. "
            "Points with a value that is no number (nan, or empty) are left out, and triangles "
            "that have such a corner. The image spans the triangles' box, the y axis upwards.",
            "Its channels are red, green, blue and alpha where the file has them, else z, else all "
            "columns. An alpha channel is added where there is none; channels that OUT's format "
            "has no room for are left out. Red, green and blue of points are taken as not "
            "multiplied by alpha, as ddt mesh writes them, and are multiplied by it. Whole-number "
            "colours are taken as displayed (sRGB): in PLY those of the types uchar and ushort, in "
            "text those that are all from 0 to 255 with one above 1, whose alpha may be such a "
            "number or a share. EXR and HDR files get linear light of them."};
        operands = {{"POINTS", "PLY, or text with a line of names"},
                    {"OUT", "any image OpenImageIO writes"}};
        flags = {
            {"--size", "WxH", "size of the image; a 0 keeps the shape (default: 1024x0)",
             [this](const std::string& text) { return parse_image_size(text, m_width, m_height); },
             "WxH, Wx0 and 0xH", ""},
            {"--window", "X0,Y0,X1,Y1",
             "the part of the plane to show (default: the triangles' box)",
             [this](const std::string& text) {
                 return m_has_window = parse_corners(text, m_window);
             },
             "two corners, the smaller coordinates first", ""},
            switch_flag("--y-down", "the y axis runs downwards", m_y_down),
            {"--channels", "NAMES", "columns that become the image's channels: red,green,blue",
             [this](const std::string& text) {
                 m_channels = OIIO::Strutil::splits(text, ",");
                 return !text.empty();
             },
             "names of columns", ""},
            filter_flag(
                "how to flip edges, as the filter's name and options: ddt,scheme=lawson,cost=jnd",
                m_options, m_filter_error, nullptr, scatter_keys()),
            {"--mesh", "FILE", "write the triangles too, a PLY file",
             [this](const std::string& text) {
                 m_mesh_path = text;
                 return OIIO::Strutil::iends_with(text, ".ply");
             },
             "names that end in .ply", ""},
            progress_flag(m_progress),
        };
    }

    ExitCode run(const std::vector<std::string>& values) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        if (std::string wrong; !check_light_name(m_options, wrong))
            return fail(wrong, code_of_message(wrong));
        Progress progress("triangulating", progress_mode(m_progress));
        PointFile points;
        Failure failure;
        if (read_points(values[0], points, failure) && prepare(points, failure) &&
            triangulate(points, values[0], progress, failure) &&
            write_both(points, values[1], failure))
            return exit_done;
        progress.hide();
        return fail(failure);
    }

private:
    /// Those that become channels, each another one.
    bool choose_columns(const PointFile& points, Failure& failure) {
        m_columns = m_channels.empty() ? usual_columns(points) : std::vector<const Column*>();
        if (m_channels.empty() && m_columns.empty()) {
            failure = {"the points have no values beside x and y", exit_failed};
            return false;
        }
        for (const std::string& channel : m_channels) {
            m_columns.push_back(points.find_meant(channel));
            if (!m_columns.back()) {
                failure = {format("there is no column \"{}\"; there are {}", channel,
                                  joined_names(all_columns(points), ", ")),
                           exit_usage};
                return false;
            }
        }
        return check_channel_names(failure);
    }

    /// Whether each is another, the alpha that is added where there is none included.
    bool check_channel_names(Failure& failure) const {
        std::vector<std::string> names = channel_names(m_columns);
        std::sort(names.begin(), names.end());
        const auto twin = std::adjacent_find(names.begin(), names.end());
        if (twin == names.end())
            return true;
        failure = {format("\"{}\" would be two channels; allowed are --channels that name each "
                          "once",
                          *twin),
                   m_channels.empty() ? exit_failed : exit_usage};
        return false;
    }

    bool prepare(PointFile& points, Failure& failure) {
        if (!choose_columns(points, failure))
            return false;
        const bool has_triangles = !points.mesh.triangles.empty();
        const size_t count = points.mesh.x.size(), dropped = drop_unknown(points, m_columns);
        if (points.mesh.x.empty()) {
            failure.why = "no point has a number in " + joined_names(m_columns, " and in ");
            return false;
        }
        if (dropped > 0)
            note(format("{} of {} points are left out: they have no number in {}", dropped, count,
                        joined_names(m_columns, " or in ")));
        if (has_triangles && points.mesh.triangles.empty()) {
            failure.why = "no triangle has numbers at its three points";
            return false;
        }
        return fit_floats(failure);
    }

    /// Whether floats hold the values: none that is finite may become infinite.
    bool fit_floats(Failure& failure) const {
        for (const Column* column : m_columns)
            for (const double v : column->values)
                if (std::isfinite(v) && std::fabs(v) > double(std::numeric_limits<float>::max())) {
                    failure.why = format("\"{}\" has a value beyond the range of a float, {}",
                                         column->name, v);
                    return false;
                }
        return true;
    }

    bool triangulate(PointFile& points, const std::string& path, Progress& progress,
                     Failure& failure) const {
        const std::vector<float> guide = guide_of(points, m_columns);
        const bool has_triangles = !points.mesh.triangles.empty();
        const ProgressCallback whole = std::ref(progress);
        // Of points that are triangulated first, about the share of the time that this takes.
        const float first = has_triangles ? 0.0f : 0.25f;
        if (!has_triangles && delaunay(points.mesh, &failure.why, part_of(whole, 0, first)))
            note_merged(points.mesh, progress);
        if (!points.mesh.triangles.empty())
            note_coarse_axis(points.mesh, progress);
        if (!points.mesh.triangles.empty() &&
            optimise(points.mesh, guide.data(), m_options.mesh, nullptr, &failure.why,
                     part_of(whole, first, 1), m_options.device)) {
            progress(1);
            return true;
        }
        failure = {fault_in(path, points, failure.why), code_of_message(failure.why)};
        return false;
    }

    /// Say how many points are no corner of a triangle that they were to be triangulated to.
    static void note_merged(const PointMesh& mesh, Progress& progress) {
        const std::vector<uint8_t> is_corner = corners_of(mesh.triangles, mesh.x.size());
        const auto merged = std::count(is_corner.begin(), is_corner.end(), uint8_t(0));
        if (merged == 0)
            return;
        progress.hide();
        note(format("{} of {} points are left out: they lie where others do, or too close to "
                    "them beside what all span",
                    merged, mesh.x.size()));
    }

    static void note_coarse_axis(const PointMesh& mesh, Progress& progress) {
        const std::string said = note_on_coarse_axis(mesh);
        if (said.empty())
            return;
        progress.hide();
        note(said);
    }

    /// The image and the mesh, if it is wanted. Neither replaces what was there before all of the
    /// mesh has been written.
    bool write_both(const PointFile& points, const std::string& path, Failure& failure) const {
        if (m_mesh_path.empty())
            return write(points, path, failure);
        WholeFile mesh;
        return mesh.open(m_mesh_path, failure) && write_points(mesh, points, failure) &&
               write(points, path, failure) && mesh.commit(failure);
    }

    bool write(const PointFile& points, const std::string& path, Failure& failure) const {
        const Window window = m_has_window ? m_window : window_of(points.mesh);
        PixelGrid grid;
        return plan_grid(window, m_width, m_height, m_y_down, grid, failure) &&
               write_point_image(points, m_columns, grid, path, failure);
    }

    Options m_options;
    int m_width = 1024, m_height = 0; ///< 0: left open
    std::string m_filter_error, m_mesh_path, m_progress = "auto";
    std::vector<std::string> m_channels;
    std::vector<const Column*> m_columns; ///< of the points that are worked on
    Window m_window;
    bool m_has_window = false, m_y_down = false;
};

} // namespace

std::unique_ptr<Command> make_scatter_command() {
    return std::make_unique<ScatterCommand>();
}

} // namespace ddt::tool

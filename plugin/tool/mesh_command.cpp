// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include <OpenImageIO/strutil.h>

#include "core/options/values.h"
#include "plugin/image/memory.h"
#include "plugin/imagebuf/holes.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/command/filter_keys.h"
#include "plugin/tool/command/progress.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/mesh/heights.h"
#include "plugin/tool/mesh/mesh_file.h"
#include "plugin/tool/mesh/mesh_points.h"

namespace ddt::tool {

namespace {

class MeshCommand final : public Command {
public:
    MeshCommand() {
        name = "mesh";
        summary = "Write the triangles of an image to an SVG, PLY or OBJ file";
        paragraphs = {
            "The image's pixels are the vertices; there are two triangles for every four "
            "neighbouring pixels. The whole image is triangulated at once, on the CPU whatever "
            "device the filter names; with its holes=fill missing pixels are filled first.",
            "SVG is a vector picture of the image. PLY (binary) and OBJ are for 3D programs: a "
            "pixel a unit, y upwards, colours as displayed, flat unless --height is given. Heights "
            "are the file's own numbers, without a curve and whatever alpha is, rounded to floats: "
            "Z times those of a terrain in floats, and Z for white, 255 or 65535, of whole "
            "numbers. What is not finite is 0.",
            "A mesh that is there already, a PLY file of any points with faces, keeps its points; "
            "its edges are flipped so that they follow its colours, or else its z, or else the sum "
            "of all its numbers (of more than three each as a share of its range). The mesh "
            "written has every number that the points had, in its type (x and y are double); what "
            "faces had beside their corners, other elements and comments are left out, and "
            "polygons are triangles. Points without faces are triangulated by ddt scatter IN "
            "image.exr --mesh OUT."};
        operands = {
            {"IN", "any image OpenImageIO reads, or a mesh: a name that ends in .ply"},
            {"OUT", "the mesh: a name that ends in .svg, .ply or .obj; of a mesh, in .ply"}};
        flags = {
            filter_flag("how to triangulate, as the filter's name and options: "
                        "ddt,scheme=lawson,cost=scf",
                        m_options, m_filter_error, &m_filter, mesh_keys()),
            choice_flag("--cost", cost_names(), "the cost of an edge, as in --filter ddt,cost=...",
                        m_cost),
            {"--scheme", "NAME", "which edges flip, as in --filter ddt,scheme=...",
             [this](const std::string& text) {
                 MeshOptions parsed;
                 m_scheme = text;
                 return find_scheme(text, parsed);
             },
             OIIO::Strutil::join(scheme_names(), ", ") + ", " + other_schemes(), ""},
            only_for({".svg"},
                     choice_flag("--fill", {"gradient", "flat", "none"},
                                 "SVG: how triangles are filled (default: gradient)", m_fill)),
            only_for({".svg"},
                     number_flag("--lines", "WIDTH", "SVG: draw the edges too, so many pixels wide",
                                 0, 1000, m_style.lines)),
            only_for({".ply", ".obj"},
                     number_flag(
                         "--height", "Z",
                         "PLY, OBJ: lift an image's vertices, by Z times the number that the file "
                         "has there: of one channel its own, of colour the luminance",
                         -1e6, 1e6, m_style.height)),
            switch_flag("--verbose", "print the mesh's cost (without contours) and what was done",
                        m_verbose),
        };
    }

    ExitCode run(const std::vector<std::string>& values) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        std::string wrong;
        if (!with_flags(wrong))
            return fail(wrong, exit_usage);
        const bool of_points = is_point_mesh(values[0]);
        if (!(of_points ? check_points_flags(values[0], wrong)
                        : check_image_flags(values[1], wrong)))
            return fail(wrong, exit_usage);
        if (!check_light_name(m_options, wrong))
            return fail(wrong, code_of_message(wrong));
        return of_points ? run_on_points(values) : run_on_image(values);
    }

private:
    /// A flag that was given, and the extensions of the OUTs that it is for.
    struct Given {
        std::string flag;
        std::vector<std::string> kinds;
    };
    /// The flag, which means nothing for files of other kinds: run() is told when it is given.
    Flag only_for(const std::vector<std::string>& kinds, Flag flag) {
        flag.set = [this, kinds, name = flag.name, set = flag.set](const std::string& text) {
            m_given.push_back({name, kinds});
            return set(text);
        };
        return flag;
    }
    static bool is_of(const std::vector<std::string>& kinds, const std::string& path) {
        return std::any_of(kinds.begin(), kinds.end(), [&](const std::string& extension) {
            return OIIO::Strutil::iends_with(path, extension);
        });
    }
    /// --cost and --scheme are items of the specification.
    bool with_flags(std::string& wrong) {
        std::string items;
        if (!m_cost.empty())
            items += ",cost=" + m_cost;
        if (!m_scheme.empty())
            items += ",scheme=" + m_scheme;
        return items.empty() || parse_filter(m_filter + items, m_options, wrong);
    }
    /// Whether those that were given are for what `in` is, a mesh.
    bool check_points_flags(const std::string& in, std::string& wrong) const {
        if (m_given.empty())
            return true;
        wrong = format("{} is for images; \"{}\" is a mesh already, which stays as it is but for "
                       "its edges",
                       m_given.front().flag, in);
        return false;
    }
    /// Whether an image's mesh can be written under that name, with what was given.
    bool check_image_flags(const std::string& out, std::string& wrong) const {
        if (!writer_for(out)) {
            wrong = wrong_mesh_name(out);
            return false;
        }
        for (const Given& given : m_given)
            if (!is_of(given.kinds, out)) {
                wrong = format("{} is for names that end in {}; \"{}\" is none", given.flag,
                               OIIO::Strutil::join(given.kinds, " or "), out);
                return false;
            }
        return true;
    }
    ExitCode run_on_points(const std::vector<std::string>& values) const {
        MeshReport report;
        Failure failure;
        {
            Progress progress("triangulating");
            if (!optimise_file(values[0], values[1], m_options.mesh, m_options.device, report,
                               std::ref(progress), failure)) {
                progress.hide();
                return fail(failure);
            }
        }
        if (m_verbose)
            print(report);
        return exit_done;
    }
    ExitCode run_on_image(const std::vector<std::string>& values) const {
        Picture picture;
        Mesh mesh;
        MeshReport report;
        Failure failure;
        if (!read(values[0], picture, failure))
            return fail(failure);
        if (std::string error; !triangulate(picture, mesh, report, error))
            return fail(error, code_of_message(error));
        if (m_verbose)
            print(report);
        Progress progress("writing");
        if (!write_mesh(values[1], mesh, picture, style(), std::ref(progress), failure))
            return fail(failure);
        note_others(values[0]);
        return exit_done;
    }
    /// With the edges where nothing else is drawn.
    MeshStyle style() const {
        MeshStyle drawn = m_style;
        drawn.fill = m_fill == "flat" ? Fill::flat : m_fill == "none" ? Fill::none : Fill::gradient;
        if (drawn.fill == Fill::none && drawn.lines == 0)
            drawn.lines = 0.1;
        return drawn;
    }
    /// The image of a file without its holes, and its heights, if it is lifted.
    bool read(const std::string& in, Picture& picture, Failure& failure) const {
        OIIO::ImageBuf image, filled;
        std::string error;
        if (!open_image(in, image, error)) {
            failure = unreadable(in, error);
            return false;
        }
        constexpr double bytes_a_pixel = 100; // about
        const bool is_read =
            check_memory(
                format("triangulating {} x {} pixels", image.spec().width, image.spec().height),
                bytes_a_pixel * double(image.spec().image_pixels()), error) &&
            fill_missing_pixels(image, filled, error) && look_at(in, image, filled, picture, error);
        if (!is_read)
            failure = {error, code_of_message(error)};
        return is_read;
    }
    /// `filled`: the image with pixels changed, or uninitialised. An image that nothing more is
    /// asked of is cleared first: a picture takes memory, too.
    bool look_at(const std::string& in, OIIO::ImageBuf& image, const OIIO::ImageBuf& filled,
                 Picture& picture, std::string& error) const {
        const bool lifted = m_style.height != 0;
        if (filled.initialized() && !lifted)
            image.clear();
        const OIIO::ImageBuf& shown = filled.initialized() ? filled : image;
        return read_picture(shown, m_options, picture, error) &&
               (!lifted || read_heights(in, image, shown, picture.heights, error));
    }
    /// By the filter's holes=; leaves `filled` uninitialised where nothing is missing.
    bool fill_missing_pixels(const OIIO::ImageBuf& image, OIIO::ImageBuf& filled,
                             std::string& error) const {
        Options options = m_options;
        options.device = Device::cpu;
        Progress progress("filling");
        options.progress = std::ref(progress);
        constexpr int all_threads = 0;
        return fill_image(image, options, m_options.holes, image.spec().format, filled, all_threads,
                          error);
    }
    bool triangulate(const Picture& picture, Mesh& mesh, MeshReport& report,
                     std::string& error) const {
        Progress progress("triangulating");
        return build_mesh(picture.guide.data(), picture.width, picture.height, m_options.mesh, mesh,
                          m_verbose ? &report : nullptr, &error, std::ref(progress));
    }
    static void print(const MeshReport& report) {
        const Statistics& s = report.statistics;
        const double pixels = double(s.pixels);
        tell(format("cost a pixel {:.6g} before, {:.6g} after; {:.3f} flips and {:.2f} evaluations "
                    "a pixel, {} iterations",
                    report.cost_start / pixels, report.cost / pixels, double(s.flips) / pixels,
                    double(s.evaluations) / pixels, s.iterations));
    }

    Options m_options;
    MeshStyle m_style;
    std::vector<Given> m_given;
    std::string m_fill = "gradient", m_filter = "ddt", m_cost, m_scheme, m_filter_error;
    bool m_verbose = false;
};

} // namespace

std::unique_ptr<Command> make_mesh_command() {
    return std::make_unique<MeshCommand>();
}

} // namespace ddt::tool

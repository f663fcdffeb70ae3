// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/resize_part.h"

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <numeric>
#include <set>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "core/tiles/grid.h"
#include "plugin/image/channels.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/memory.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/picture.h"
#include "plugin/tool/file/unfinished.h"
#include "plugin/tool/ids/id_file.h"
#include "plugin/tool/ids/lost_ids.h"
#include "plugin/tool/ids/mixed_ids.h"
#include "plugin/tool/part/fingerprint.h"
#include "plugin/tool/part/part_header.h"
#include "plugin/tool/resize/tile_pixels.h"

namespace ddt::tool {

namespace {

constexpr int cache_megabytes = 192;

/// Tiles of a whole as wide as this are less high, so that a row of them stays small for joining.
constexpr int64_t largest_row = int64_t(64) << 20;

/// Enlarges a part in strips and hands on whole rows of the file's tiles.
class StripWriter {
public:
    /// `ids`: those of the source, if any.
    StripWriter(const OIIO::ImageSpec& whole, const Rect& part, int tile_height,
                OIIO::ImageOutput& output, MixedIds& ids)
        : m_spec(whole), m_part(part), m_tile_height(tile_height), m_output(output), m_ids(ids),
          m_done(part.y0) {
        m_spec.x = part.x0;
        m_spec.width = part.width();
        m_spec.channelformats.clear(); // strips in memory have one type
    }

    /// The part's rows up to `end`, of a source that has what they show, in these of its pixels.
    bool strip(int end, const OIIO::ImageBuf& source, const Rect& shown, const Options& options,
               int threads, std::string& error) {
        OIIO::ImageSpec spec = m_spec;
        spec.y = m_done;
        spec.height = end - m_done;
        if (!check_size(OIIO::get_roi(spec), spec.nchannels, spec.format, error))
            return false;
        OIIO::ImageBuf strip;
        if (!take_memory(strip, spec, error))
            return false;
        const size_t row = spec.scanline_bytes();
        if (m_made > m_done)
            std::memcpy(strip.localpixels(), m_left.data(), row * size_t(m_made - m_done));
        OIIO::ROI roi = strip.roi();
        roi.ybegin = m_made;
        const bool done = m_ids && options.holes == Holes::keep
                              ? m_ids.resize(strip, source, shown, options, roi, threads)
                              : resize(strip, source, options, roi, threads);
        if (!done) {
            error = strip.geterror();
            return false;
        }
        const int rows =
            end == m_part.y1 ? end - m_done : (end - m_done) / m_tile_height * m_tile_height;
        const auto* pixels = static_cast<const char*>(strip.localpixels());
        if (rows > 0 && !write(rows, spec.format, pixels))
            return false;
        m_left.assign(pixels + row * size_t(rows), pixels + row * size_t(end - m_done));
        m_done += rows;
        m_made = end;
        return true;
    }

private:
    bool write(int rows, OIIO::TypeDesc type, const char* pixels) {
        const size_t n = size_t(rows) * size_t(m_part.width());
        return m_output.write_tiles(
            m_part.x0, m_part.x1, m_done, m_done + rows, 0, 1,
            m_ids ? OIIO::TypeDesc(OIIO::TypeUnknown) : type,
            m_ids ? m_ids.pack(reinterpret_cast<const float*>(pixels), n, m_output.spec())
                  : pixels);
    }

    OIIO::ImageSpec m_spec;
    const Rect m_part;
    const int m_tile_height;
    OIIO::ImageOutput& m_output;
    MixedIds& m_ids;
    int m_done;               ///< rows before are written
    int m_made = m_part.y0;   ///< rows before are enlarged
    std::vector<char> m_left; ///< those between
};

/// By device and inode, whatever the names: links, too.
bool check_place(const std::string& in, const std::string& out, Failure& failure) {
    std::error_code not_there;
    if (!std::filesystem::equivalent(in, out, not_there))
        return true;
    failure = {"cannot write \"" + out +
                   "\": a part cannot take the place of its source, of which the other parts are "
                   "made; allowed are names of other files",
               exit_usage};
    return false;
}

bool check_part(const OIIO::ImageSpec& from, const OIIO::ImageSpec& to, const Grid& grid,
                const Part& part, Failure& failure) {
    const std::vector<std::string>& names = from.channelnames;
    if (to.full_width < from.full_width || to.full_height < from.full_height)
        failure = {"--part is for enlarging; allowed are sizes of " +
                       format("{} x {} and more", from.full_width, from.full_height),
                   exit_usage};
    else if (part.count > grid.count())
        failure = {format("--part {}/{} is not allowed; allowed are at most {} parts of this image",
                          part.index, part.count, grid.count()),
                   exit_usage};
    else if (stored_type(to.format) == OIIO::TypeUnknown)
        failure = {format("pixels of {} cannot be kept in parts; choose another --type",
                          to.format.c_str()),
                   exit_usage};
    else if (std::set<std::string>(names.begin(), names.end()).size() < names.size())
        failure = {"several channels have one name, which cannot be kept in parts"};
    else if (const auto name = std::find_if_not(names.begin(), names.end(), is_kept_name);
             name != names.end())
        failure = {"the name of the channel \"" + *name +
                   "\" has a line break, which cannot be kept in parts; allowed are names in one "
                   "line"};
    else
        return true;
    return false;
}

/// The tiles of a part, row by row, and the result's pixels that are made from them.
class PartTiles {
public:
    PartTiles(const Grid& grid, const OIIO::ImageSpec& from, const OIIO::ImageSpec& whole,
              const Part& part)
        : m_grid(grid), m_x(x_axis(from, whole, OIIO::get_roi(whole))),
          m_y(y_axis(from, whole, OIIO::get_roi(whole))),
          m_tiles(tiles_of_part(grid.columns(), grid.rows(), part)), m_pixels(made_from(m_tiles)) {}

    int rows() const { return m_tiles.height(); }
    const Rect& pixels() const { return m_pixels; }
    /// Rows of pixels before this are made from rows of tiles up to this one.
    int end(int row) const { return made_from(row_of(row)).y1; }
    /// The source's pixels that a row of tiles is made from.
    Rect source(int row) const {
        const Rect tiles = row_of(row);
        const Rect first = m_grid.tile(tiles.y0 * m_grid.columns() + tiles.x0).pixels;
        const Rect last = m_grid.tile(tiles.y0 * m_grid.columns() + tiles.x1 - 1).pixels;
        return {first.x0, first.y0, last.x1, last.y1};
    }

private:
    Rect row_of(int row) const {
        return {m_tiles.x0, m_tiles.y0 + row, m_tiles.x1, m_tiles.y0 + row + 1};
    }
    Rect made_from(const Rect& tiles) const {
        return pixels_of_tiles(tiles, m_grid.columns(), m_grid.rows(), m_x, m_y);
    }

    const Grid& m_grid;
    const ResizeMapping::Axis m_x, m_y;
    const Rect m_tiles, m_pixels;
};

/// The image that strips are made from.
class PartSource {
public:
    /// `image`: of the file `path`, through the cache; `from`: its spec.
    PartSource(const std::string& path, const OIIO::ImageBuf& image, const OIIO::ImageSpec& from)
        : m_path(path), m_image(image), m_only_ids(is_id_type(from.format)) {
        if (!m_only_ids)
            return;
        std::vector<int> all(size_t(from.nchannels));
        std::iota(all.begin(), all.end(), 0);
        m_id_file = IdFile(path, 0, image, all);
    }

    /// Have all of it in memory, with the bits of its object IDs.
    bool open_whole(MixedIds& ids, Failure& failure) {
        std::string error;
        if (open_image(m_path, m_whole, error) && ids.put_into(m_whole, error))
            return true;
        failure = {error, code_of_message(error)};
        return false;
    }

    /// One that has those pixels, until the next call; null if they cannot be read.
    const OIIO::ImageBuf* strip(const Rect& shown, Failure& failure) {
        if (!m_only_ids)
            return m_whole.initialized() ? &m_whole : &m_image;
        std::string error;
        if (m_id_file.read(shown, m_ids, error))
            return &m_ids;
        failure = {error, code_of_message(error)};
        return nullptr;
    }

private:
    const std::string m_path;
    const OIIO::ImageBuf& m_image;
    const bool m_only_ids; ///< of which the cache would make floats
    IdFile m_id_file;
    OIIO::ImageBuf m_ids, m_whole;
};

/// The spec of a part's file.
OIIO::ImageSpec file_spec(const OIIO::ImageSpec& whole, const Rect& part) {
    OIIO::ImageSpec spec = whole;
    spec.x = part.x0;
    spec.y = part.y0;
    spec.width = part.width();
    spec.height = part.height();
    // Which takes the channels' own types away.
    if (const OIIO::TypeDesc stored = stored_type(whole.format); stored != whole.format)
        spec.set_format(stored);
    spec.tile_width = 64;
    spec.tile_height =
        int64_t(whole.width) * int64_t(whole.pixel_bytes()) * 64 > largest_row ? 16 : 64;
    spec.tile_depth = 1;
    spec.attribute("compression", "zip");
    return spec;
}

/// Whether there is memory for what a part takes at once: its highest strip, and beside that where
/// each tile lies in the file, which OpenEXR's writer keeps.
bool check_memory_of(const PartTiles& tiles, const OIIO::ImageSpec& whole,
                     const OIIO::ImageSpec& file, Failure& failure) {
    int rows = 0;
    for (int row = 0, begin = file.y; row < tiles.rows(); begin = tiles.end(row++))
        rows = std::max(rows, tiles.end(row) - begin);
    const auto count = [](int size, int tile) { return double((size - 1) / tile + 1); };
    const double places =
                     8 * count(file.width, file.tile_width) * count(file.height, file.tile_height),
                 strip = double(rows) * file.width * double(whole.nchannels) *
                         double(whole.format.size());
    if (check_memory(format("a part of {} x {} pixels, in strips of {} rows,", file.width,
                            file.height, rows),
                     places + strip, failure.why))
        return true;
    failure.code = code_of_message(failure.why);
    return false;
}

bool open_part(const std::string& path, const OIIO::ImageSpec& spec, ImageFile& file,
               Failure& failure) {
    if (!file.create(path, failure))
        return false;
    for (const char* needed : {"tiles", "displaywindow", "negativeorigin", "arbitrary_metadata"})
        if (!file.output().supports(needed)) {
            failure = {"\"" + path + "\" cannot hold a part; allowed are names that end in .exr",
                       exit_usage};
            return false;
        }
    return file.open(spec, failure);
}

/// What a part is made from and belongs to. check_reader() is to be asked of the source before.
struct PartJob {
    explicit PartJob(const std::string& in)
        : path(in), state(in), file(in, 0, {cache_megabytes, true}) {}
    const OIIO::ImageBuf& image() const { return file.image(); }
    Grid grid() const { return Grid(rect_of(image().roi())); }

    bool plan(const ResizeSettings& settings, const Part& part, Failure& failure) {
        if (!begin_image(path, 0, file.image(), failure.why)) {
            failure.code = code_of_message(failure.why);
            return false;
        }
        // Of whose image neither the bytes nor the time of its last change are looked at.
        if (image().file_format_name() == "ddt") {
            failure = {"\"" + path + "\" asks for another image, enlarged; --part needs that image",
                       exit_usage};
            return false;
        }
        if (!check_image(image(), image_name(path), settings.options, failure))
            return false;
        if (!file.make_room(settings.threads, failure.why)) {
            failure.code = code_of_message(failure.why);
            return false;
        }
        from = spec_of_file(image());
        if (!plan_result(from, settings, whole, failure))
            return false;
        if (!check_part(from, whole, grid(), part, failure))
            return false;
        const std::string job = fingerprint(path, from, whole, settings);
        if (job.empty()) {
            const std::string why = why_not_opened(path);
            failure = {"\"" + path + "\"" +
                           (why.empty()
                                ? " is no file that can be read as bytes, which --part needs"
                                : ": " + why),
                       code_of_reading(path)};
            return false;
        }
        header = header_of(job, part, whole);
        return true;
    }

    const std::string path;
    const FileState state; ///< before anything was read
    LazyFile file;
    OIIO::ImageSpec from, whole; ///< the source and the result
    PartHeader header;
};

/// Write a part of what was planned into `file`, all but its name.
bool write_part(const PartJob& job, const std::string& out, const ResizeSettings& settings,
                const Part& part, ImageFile& file, const ProgressCallback& progress,
                Failure& failure) {
    const OIIO::ImageBuf& image = job.image();
    const Grid grid = job.grid();
    const PartTiles tiles(grid, job.from, job.whole, part);
    OIIO::ImageSpec spec = file_spec(job.whole, tiles.pixels());
    job.header.write_to(spec);
    if (!check_memory_of(tiles, job.whole, spec, failure) || !open_part(out, spec, file, failure))
        return false;
    MixedIds mixed(job.path, 0, image, file.output().spec());
    PartSource source(job.path, image, job.from);
    if (mixed && settings.options.holes != Holes::keep && !source.open_whole(mixed, failure))
        return false;
    StripWriter writer(job.whole, tiles.pixels(), spec.tile_height, file.output(), mixed);
    for (int row = 0; row < tiles.rows(); ++row) {
        Options options = settings.options;
        options.progress = [&](float share) {
            return progress((float(row) + share) / float(tiles.rows()));
        };
        const Rect shown = tiles.source(row);
        const OIIO::ImageBuf* const pixels = source.strip(shown, failure);
        if (!pixels)
            return false;
        std::string error;
        if (!writer.strip(tiles.end(row), *pixels, shown, options, settings.threads, error)) {
            failure = error.empty() ? file.failed() : Failure{error, code_of_message(error)};
            return false;
        }
    }
    return true;
}

/// Whether the tile that was written last can be read, which it cannot where a file was cut off.
bool has_last_tile(OIIO::ImageInput& file) {
    const OIIO::ImageSpec& spec = file.spec();
    if (spec.tile_width <= 0 || spec.width <= 0 || spec.height <= 0)
        return false;
    const auto last = [](int first, int size, int tile) {
        return first + (size - 1) / tile * tile;
    };
    std::vector<char> pixels(spec.tile_bytes(true));
    const bool read =
        file.read_native_tile(0, 0, last(spec.x, spec.width, spec.tile_width),
                              last(spec.y, spec.height, spec.tile_height), spec.z, pixels.data());
    file.geterror(); // 3.x prints what nobody asked for
    return read;
}

} // namespace

bool is_part_there(const std::string& in, const std::string& out, const ResizeSettings& settings,
                   Part part) {
    const EndsWithoutMemory or_the_cache_waits;
    PartHeader there;
    Failure ignored; // whoever makes the part tells
    if (!check_reader(out, 0, ignored))
        return false;
    const auto file = OIIO::ImageInput::open(out);
    if (!file) {
        OIIO::geterror(); // 3.x prints what nobody asked for
        return false;
    }
    if (!there.read_from(file->spec()))
        return false;
    if (!check_reader(in, 0, ignored))
        return false;
    PartJob job(in);
    return job.plan(settings, part, ignored) && job.header.job == there.job &&
           part.index == there.part.index && part.count == there.part.count && has_last_tile(*file);
}

bool resize_part(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 Part part, const ProgressCallback& progress, Failure& failure) {
    const EndsWithoutMemory or_the_cache_waits;
    if (!check_place(in, out, failure) || !check_reader(in, 0, failure))
        return false;
    PartJob job(in);
    ImageFile file;
    const bool made = job.plan(settings, part, failure) &&
                      write_part(job, out, settings, part, file, progress, failure);
    // Or it would be of a source that there never was, and pass for one of the fingerprint's.
    if (!job.state.confirm(made, failure) || !file.commit(failure))
        return false;
    note_lost_ids(job.image().nativespec(), job.whole, out);
    note_others(in);
    return true;
}

} // namespace ddt::tool

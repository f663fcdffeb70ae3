// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/resize_part.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include "core/tiles/grid.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/memory.h"
#include "plugin/message/format.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/file/unfinished.h"
#include "plugin/tool/ids/lost_ids.h"
#include "plugin/tool/ids/mixed_ids.h"
#include "plugin/tool/part/part_header.h"
#include "plugin/tool/part/part_job.h"
#include "plugin/tool/part/part_source.h"
#include "plugin/tool/part/part_tiles.h"
#include "plugin/tool/part/strip_writer.h"

namespace ddt::tool {

namespace {

/// Tiles of a whole as wide as this are less high, so that a row of them stays small for joining.
constexpr int64_t largest_row = int64_t(64) << 20;

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

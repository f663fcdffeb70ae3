// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part_file.h"

#include <cstdio>
#include <cstring>
#include <numeric>
#include <set>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/strutil.h>

#include "core/base/parse_number.h"
#include "core/tiles/grid.h"
#include "plugin/image/channels.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"
#include "plugin/tool/fingerprint.h"
#include "plugin/tool/id_file.h"
#include "plugin/tool/image_file.h"
#include "plugin/tool/lost_ids.h"
#include "plugin/tool/mixed_ids.h"
#include "plugin/tool/picture.h"
#include "plugin/tool/unfinished.h"

namespace ddt::tool {

namespace {

// Not "ddt:": OpenImageIO writes no metadata that begin with the name of another format, which
// "ddt" is where the plugin's reader is.
constexpr const char* job_key = "ddt_part:job";
constexpr const char* part_key = "ddt_part:part";
constexpr const char* whole_key = "ddt_part:whole";
constexpr const char* type_key = "ddt_part:type";
constexpr const char* space_key = "ddt_part:colorspace";
constexpr const char* compression_key = "ddt_part:compression";
constexpr const char* channels_key = "ddt_part:channels"; // a line each
constexpr const char* date_key = "ddt_part:date";
constexpr const char* profile_key = "ddt_part:profile"; // as text: EXR files hold no bytes
constexpr const char* bits_key = "ddt_part:bits";
constexpr const char* aspect_key = "ddt_part:noaspect";

constexpr int cache_megabytes = 192;

/// Tiles of a whole as wide as this are less high, so that a row of them stays small for joining.
constexpr int64_t largest_row = int64_t(64) << 20;

/// The type in which a part keeps numbers of `type` so that they come back; unknown if there is
/// none.
OIIO::TypeDesc stored_type(OIIO::TypeDesc type) {
    switch (type.basetype) {
    case OIIO::TypeDesc::HALF:
    case OIIO::TypeDesc::FLOAT:
    case OIIO::TypeDesc::UINT32:
        return type;
    case OIIO::TypeDesc::UINT8:
    case OIIO::TypeDesc::INT8:
        return OIIO::TypeHalf;
    case OIIO::TypeDesc::UINT16:
    case OIIO::TypeDesc::INT16:
        return OIIO::TypeFloat;
    default:
        return OIIO::TypeUnknown;
    }
}

/// Whether it is the name of a kind of number.
bool is_number_type(const std::string& name) {
    const OIIO::TypeDesc type(name);
    return stored_type(type) != OIIO::TypeUnknown &&
           type == OIIO::TypeDesc(OIIO::TypeDesc::BASETYPE(type.basetype));
}

std::string hex(const std::vector<unsigned char>& bytes) {
    constexpr char digits[] = "0123456789abcdef";
    std::string text;
    for (const unsigned char byte : bytes) {
        text += digits[byte >> 4];
        text += digits[byte & 15];
    }
    return text;
}

/// Nothing for a text that is not of hex().
std::vector<unsigned char> bytes_of(const std::string& hex) {
    if (hex.size() % 2 != 0 || hex.find_first_not_of("0123456789abcdef") != std::string::npos)
        return {};
    std::vector<unsigned char> bytes;
    for (size_t i = 0; i < hex.size(); i += 2)
        bytes.push_back((unsigned char)(std::stoi(hex.substr(i, 2), nullptr, 16)));
    return bytes;
}

std::vector<unsigned char> profile_of(const OIIO::ImageSpec& spec) {
    const OIIO::ParamValue* const found = spec.find_attribute("ICCProfile");
    if (!found || found->type().basetype != OIIO::TypeDesc::UINT8)
        return {};
    const auto* const data = static_cast<const unsigned char*>(found->data());
    return {data, data + found->datasize()};
}

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

bool check_part(const OIIO::ImageSpec& from, const OIIO::ImageSpec& to, const Grid& grid,
                const Part& part, Failure& failure) {
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
    else if (const auto& names = from.channelnames;
             std::set<std::string>(names.begin(), names.end()).size() < names.size())
        failure = {"several channels have one name, which cannot be kept in parts"};
    else
        return true;
    return false;
}

/// The pixels that tiles are made from.
Rect source_of(const Rect& tiles, const Grid& grid) {
    const Rect first = grid.tile(tiles.y0 * grid.columns() + tiles.x0).pixels;
    const Rect last = grid.tile((tiles.y1 - 1) * grid.columns() + tiles.x1 - 1).pixels;
    return {first.x0, first.y0, last.x1, last.y1};
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

} // namespace

void PartHeader::write_to(OIIO::ImageSpec& spec) const {
    spec.attribute(job_key, job);
    spec.attribute(part_key, format("{}/{}", part.index, part.count));
    spec.attribute(whole_key, format("{} {} {} {}", whole.x0, whole.y0, whole.x1, whole.y1));
    spec.attribute(type_key, type);
    spec.attribute(space_key, colour_space);
    spec.attribute(compression_key, compression);
    spec.attribute(channels_key, OIIO::Strutil::join(channels, "\n"));
    spec.attribute(date_key, date);
    spec.attribute(profile_key, hex(profile));
    spec.attribute(bits_key, std::to_string(bits));
    if (no_aspect)
        spec.attribute(aspect_key, "1");
}

bool PartHeader::take_from(OIIO::ImageSpec& spec) {
    job = spec.get_string_attribute(job_key);
    type = spec.get_string_attribute(type_key);
    colour_space = spec.get_string_attribute(space_key);
    compression = spec.get_string_attribute(compression_key);
    const std::string names = spec.get_string_attribute(channels_key);
    channels = names.empty() ? std::vector<std::string>() : OIIO::Strutil::splits(names, "\n");
    date = spec.get_string_attribute(date_key);
    profile = bytes_of(spec.get_string_attribute(profile_key));
    bits = 0;
    parse_number(std::string(spec.get_string_attribute(bits_key)), 0, 64, bits);
    no_aspect = spec.get_string_attribute(aspect_key) == "1";
    const std::string window = spec.get_string_attribute(whole_key);
    if (job.empty() || spec.tile_width < 1 ||
        !parse_part(spec.get_string_attribute(part_key), part) ||
        std::sscanf(window.c_str(), "%d %d %d %d", &whole.x0, &whole.y0, &whole.x1, &whole.y1) !=
            4 ||
        whole.empty() || !is_number_type(type))
        return false;
    for (const char* key : {job_key, part_key, whole_key, type_key, space_key, compression_key,
                            channels_key, date_key, profile_key, bits_key, aspect_key})
        spec.erase_attribute(key);
    return true;
}

bool resize_part(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 Part part, const std::function<bool(float)>& progress, Failure& failure) {
    const EndsWithoutMemory or_the_cache_waits;
    LazyFile file_in(in, 0, {cache_megabytes, true});
    if (!file_in.image().init_spec(in, 0, 0)) {
        failure.why = why_unreadable(file_in.image(), in);
        failure.code = code_of_message(failure.why);
        return false;
    }
    const OIIO::ImageBuf& image = file_in.image();
    if (!check_image(image, in, settings.options, failure))
        return false;
    // The cache's pixels may be of another type than the file's.
    OIIO::ImageSpec from = image.spec(), whole;
    from.set_format(image.nativespec().format);
    from.channelformats = image.nativespec().channelformats;
    if (!plan_result(from, settings, whole, failure))
        return false;
    const Grid grid(rect_of(image.roi()));
    if (!check_part(from, whole, grid, part, failure))
        return false;
    const ResizeMapping::Axis x = x_axis(from, whole, OIIO::get_roi(whole));
    const ResizeMapping::Axis y = y_axis(from, whole, OIIO::get_roi(whole));
    const Rect tiles = tiles_of_part(grid.columns(), grid.rows(), part);
    const Rect pixels = pixels_of_tiles(tiles, grid.columns(), grid.rows(), x, y);

    PartHeader header;
    header.job = fingerprint(in, from, whole, settings);
    if (header.job.empty()) {
        failure = {"\"" + in + "\" is no file that can be read as bytes, which --part needs"};
        return false;
    }
    header.part = part;
    header.whole = rect_of(OIIO::get_roi(whole));
    header.type = whole.format.c_str();
    header.colour_space = whole.get_string_attribute("oiio:ColorSpace");
    header.compression = whole.get_string_attribute("compression");
    header.channels = whole.channelnames;
    header.date = whole.get_string_attribute("DateTime");
    header.profile = profile_of(whole);
    header.bits = whole.get_int_attribute("oiio:BitsPerSample");
    header.no_aspect = !whole.find_attribute("PixelAspectRatio");
    OIIO::ImageSpec spec = file_spec(whole, pixels);
    header.write_to(spec);
    ImageFile file;
    if (!file.create(out, failure))
        return false;
    for (const char* needed : {"tiles", "displaywindow", "negativeorigin", "arbitrary_metadata"})
        if (!file.output().supports(needed)) {
            failure = {"\"" + out + "\" cannot hold a part; allowed are names that end in .exr",
                       exit_usage};
            return false;
        }
    if (!file.open(spec, failure))
        return false;

    MixedIds mixed(in, image, file.output().spec());
    OIIO::ImageBuf filled_first; // the whole image then
    if (std::string error;
        mixed && settings.options.holes != Holes::keep &&
        !(open_image(in, filled_first, error) && mixed.put_into(filled_first, error))) {
        failure = {error, code_of_message(error)};
        return false;
    }
    StripWriter writer(whole, pixels, spec.tile_height, file.output(), mixed);
    const bool only_ids = is_id_type(from.format);
    std::vector<int> all(size_t(only_ids ? from.nchannels : 0));
    std::iota(all.begin(), all.end(), 0);
    IdFile id_file = only_ids ? IdFile(in, image, all) : IdFile();
    for (int row = tiles.y0; row < tiles.y1; ++row) {
        const Rect one{tiles.x0, row, tiles.x1, row + 1};
        Options options = settings.options;
        options.progress = [&](float share) {
            return progress((float(row - tiles.y0) + share) / float(tiles.height()));
        };
        const int end = pixels_of_tiles(one, grid.columns(), grid.rows(), x, y).y1;
        std::string error;
        OIIO::ImageBuf ids;
        const Rect shown = source_of(one, grid);
        if (only_ids && !id_file.read(shown, ids, error)) {
            failure = {error, code_of_message(error)};
            return false;
        }
        const OIIO::ImageBuf& source = only_ids                     ? ids
                                       : filled_first.initialized() ? filled_first
                                                                    : image;
        if (!writer.strip(end, source, shown, options, settings.threads, error)) {
            failure = error.empty() ? file.failed() : Failure{error, code_of_message(error)};
            return false;
        }
    }
    if (!file.commit(failure))
        return false;
    note_lost_ids(image.nativespec(), whole, out);
    note_others(in, image.nsubimages());
    return true;
}

} // namespace ddt::tool

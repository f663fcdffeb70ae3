// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/join.h"

#include <algorithm>
#include <cstring>
#include <numeric>

#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include "plugin/image/channels.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"
#include "plugin/tool/file/fit_format.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/rows_together.h"
#include "plugin/tool/part/part_file.h"
#include "plugin/tool/part/part_header.h"

namespace ddt::tool {

namespace {

/// Whether both are of one whole, and have pixels of one kind.
bool belong_together(const PartFile& a, const PartFile& b) {
    return a.header.job == b.header.job && a.header.part.count == b.header.part.count &&
           a.header.type == b.header.type && a.header.whole == b.header.whole &&
           a.spec.nchannels == b.spec.nchannels && a.spec.format == b.spec.format &&
           a.spec.channelformats == b.spec.channelformats &&
           a.spec.channelnames == b.spec.channelnames;
}

/// Whether the parts, in order of their numbers, are all there are, and once.
bool check_numbers(const std::vector<PartFile>& parts, Failure& failure) {
    const PartHeader& first = parts.front().header;
    for (size_t i = 1; i < parts.size(); ++i) {
        const PartHeader& other = parts[i].header;
        if (!belong_together(parts[i], parts.front())) {
            failure = {format("\"{}\" and \"{}\" are parts of different jobs: another source, size "
                              "or option",
                              parts[0].path, parts[i].path)};
            return false;
        }
        if (other.part.index == parts[i - 1].header.part.index) {
            failure = {format("part {} is there twice: \"{}\" and \"{}\"", other.part.index,
                              parts[i - 1].path, parts[i].path)};
            return false;
        }
    }
    std::vector<std::string> missing;
    auto part = parts.begin();
    for (int i = 1; i <= first.part.count; ++i) {
        if (part != parts.end() && part->header.part.index == i)
            ++part;
        else
            missing.push_back(std::to_string(i));
    }
    if (missing.empty())
        return true;
    if (missing.size() > 8) {
        missing.resize(8);
        missing.push_back("...");
    }
    failure = {format("of {} parts there are missing: {}", first.part.count,
                      OIIO::Strutil::join(missing, ", "))};
    return false;
}

/// Whether their windows fill the whole, without overlaps.
bool check_windows(const std::vector<PartFile>& parts, Failure& failure) {
    const Rect& whole = parts.front().header.whole;
    size_t area = 0;
    for (size_t i = 0; i < parts.size(); ++i) {
        area += parts[i].window.area();
        for (size_t k = 0; k < i; ++k)
            if (!intersection(parts[i].window, parts[k].window).empty()) {
                failure = {format("\"{}\" and \"{}\" overlap", parts[k].path, parts[i].path)};
                return false;
            }
        if (!whole.contains(parts[i].window)) {
            failure = {"\"" + parts[i].path + "\" leaves the whole's window"};
            return false;
        }
    }
    if (area == whole.area())
        return true;
    failure = {"the parts do not fill the whole's window"};
    return false;
}

/// As the parts have them, where a file of the spec `written` has that; else channels of types of
/// their own become floats, as ddt resize holds them.
Held find_held(const OIIO::ImageSpec& part, const OIIO::ImageSpec& written) {
    if (part.channelformats.empty())
        return {part.format, part.pixel_bytes()};
    if (!written.channelformats.empty())
        return {OIIO::TypeUnknown, part.pixel_bytes(true)};
    return {OIIO::TypeFloat, size_t(part.nchannels) * sizeof(float)};
}

/// Of the pixel (x, y) in the rows of `window`, which are held one after the other.
size_t place_in(const Rect& window, int x, int y) {
    return size_t(y - window.y0) * size_t(window.width()) + size_t(x - window.x0);
}

/// Put what a part has of the pixels of `band` where they belong in `rows`, which holds the band.
bool copy_rows(PartFile& part, const Rect& band, const Held& held, char* rows, Failure& failure) {
    const Rect& own = part.window;
    const Rect here = intersection(band, own);
    const size_t pixel = held.pixel;
    for (int y = here.y0; y < here.y1 && !here.empty(); ++y) {
        if ((y < part.y0 || y >= part.y1) && !load(part, y, held, failure))
            return false;
        const Rect there{own.x0, part.y0, own.x1, part.y1};
        std::memcpy(rows + pixel * place_in(band, here.x0, y),
                    &part.tiles[pixel * place_in(there, here.x0, y)], pixel * size_t(here.width()));
    }
    if (own.y1 <= band.y1) {
        part.input.reset();
        part.tiles = {};
    }
    return true;
}

/// Whether those that were joined are those that were found to belong together.
bool are_unchanged(const std::vector<PartFile>& parts, Failure& failure) {
    return std::all_of(parts.begin(), parts.end(),
                       [&](const PartFile& part) { return part.state.confirm(true, failure); });
}

/// The whole's spec from a part's.
OIIO::ImageSpec whole_spec(OIIO::ImageSpec spec, const PartHeader& header) {
    spec.x = header.whole.x0;
    spec.y = header.whole.y0;
    spec.width = header.whole.width();
    spec.height = header.whole.height();
    if (const OIIO::TypeDesc type(header.type); type != spec.format)
        spec.set_format(type);
    spec.extra_attribs = header.metadata;
    spec.tile_width = header.tile_width;
    spec.tile_height = header.tile_height;
    return spec;
}

/// Whether numbers of `written` are what one run would have rounded less.
bool has_room_for_more(OIIO::TypeDesc written, OIIO::TypeDesc parts) {
    return written.is_floating_point() && !is_id_type(parts) &&
           (!parts.is_floating_point() ||
            (parts == OIIO::TypeHalf && written.size() > parts.size()));
}

/// Say that a file with room for more has what the type of parts, or of one of their channels,
/// leaves of the pixels.
void note_rounded(const std::string& path, const OIIO::ImageSpec& file, const PartFile& part) {
    const OIIO::TypeDesc written = file.format;
    OIIO::TypeDesc parts(part.header.type);
    for (int c = 0; c < part.spec.nchannels && !part.spec.channelformats.empty(); ++c)
        if (has_room_for_more(file.channelformat(c), part.spec.channelformat(c)))
            parts = part.spec.channelformat(c);
    if (has_room_for_more(written, parts) && file.channelformats.empty())
        note(format("\"{}\" has {}, and the parts were rounded to {}; --type {} for each part "
                    "keeps what one run keeps",
                    path, written, parts, written));
}

/// Bytes of pixels to hold at once, and at most where it takes so many to have tiles.
constexpr size_t usual_bytes = size_t(16) << 20, most_bytes = size_t(64) << 20;

/// Rows to write at once: of low ones many, so that writers compress them side by side; of tiles
/// whole ones; and so many, if that is not too much, as the format keeps together.
int rows_at_once(ImageFile& into, size_t row, int part_rows) {
    const OIIO::ImageSpec& file = into.output().spec();
    if (into.wants_all_rows())
        return file.height;
    const int of_file = rows_together(file);
    const auto both = size_t(std::lcm(int64_t(of_file), int64_t(part_rows)));
    const auto least = size_t(file.tile_width > 0 ? of_file : part_rows);
    const size_t step = both > most_bytes / row ? least : both;
    const size_t rows = std::max(usual_bytes / row / step, size_t(1)) * step;
    return int(std::min(rows, size_t(file.height)));
}

} // namespace

bool join(const std::vector<std::string>& paths, const std::string& out,
          const ProgressCallback& progress, Failure& failure) {
    std::vector<PartFile> parts;
    for (const std::string& path : paths)
        if (!read_header(parts.emplace_back(path), failure))
            return false;
    const OIIO::ImageSpec spec = parts.back().spec;
    std::stable_sort(parts.begin(), parts.end(), [](const PartFile& a, const PartFile& b) {
        return a.header.part.index < b.header.part.index;
    });
    if (!check_numbers(parts, failure) || !check_windows(parts, failure))
        return false;

    const Rect whole = parts.front().header.whole;
    ImageFile file;
    if (!file.create(out, failure))
        return false;
    OIIO::ImageSpec written = whole_spec(spec, parts.front().header);
    if (!fit_format(file.output(), out, written, failure))
        return false;
    const std::string left_out = fit_channels(file.output(), written);
    const Held held = find_held(spec, written);
    const size_t row = held.pixel * size_t(written.width);
    if (size_t(written.tile_height) > most_bytes / row)
        forget_tiles(written);
    if (!file.open(written, failure))
        return false;
    note_left_out(out, left_out);
    note_rounded(out, file.output().spec(), parts.front());
    const Rect kept = rect_of(written.roi());
    const int step = rows_at_once(file, row, spec.tile_height);
    std::vector<char> rows(row * size_t(step)); // black where the whole has no pixels
    for (int y0 = kept.y0; y0 < kept.y1; y0 += step) {
        const Rect band{kept.x0, y0, kept.x1, std::min(y0 + step, kept.y1)};
        progress(float(y0 - kept.y0) / float(kept.height()));
        if (whole.y1 < band.y1)
            std::fill(rows.begin(), rows.end(), char(0));
        for (PartFile& part : parts)
            if (!copy_rows(part, band, held, rows.data(), failure))
                return false;
        if (!file.write_rows(band.y0, band.y1, held.type, rows.data(),
                             OIIO::stride_t(held.pixel))) {
            failure = file.failed();
            return false;
        }
    }
    if (!are_unchanged(parts, failure) || !file.commit(failure))
        return false;
    progress(1);
    return true;
}

} // namespace ddt::tool

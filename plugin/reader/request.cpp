// SPDX-License-Identifier: Apache-2.0
#include "plugin/reader/request.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "core/base/one_line.h"
#include "core/base/parse_number.h"
#include "ddt/rect.h"
#include "plugin/image/largest_side.h"
#include "plugin/message/byte_order_mark.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

constexpr char extension[] = ".ddt";
constexpr size_t extension_length = sizeof(extension) - 1;
constexpr size_t longest_sidecar = 65536;

std::string before_query(const std::string& name) {
    return name.substr(0, name.find('?'));
}

/// Collects options in the order they come; nothing is checked before all are known.
class Parser {
public:
    explicit Parser(Request& request) : m_request(request) {}

    bool set(const std::string& item, std::string& error) {
        const size_t equals = item.find('=');
        const std::string key = item.substr(0, equals);
        const std::string value = equals == std::string::npos ? "" : item.substr(equals + 1);
        if (key == "scale")
            return set_scale(item, value, error);
        if (key == "width")
            return set_size(item, value, m_request.width, error);
        if (key == "height")
            return set_size(item, value, m_request.height, error);
        if (key == "filter") {
            m_filter = value;
            if (is_filter_name(value))
                return true;
            error = format("ddt: unknown filter \"{}\"; allowed are {}", value,
                           OIIO::Strutil::join(filter_names(), ", "));
            return false;
        }
        m_options += "," + item;
        FilterOptions ignored;
        if (parse_filter("ddt," + item, ignored, error))
            return true;
        error += "; and filter, height, scale, width";
        return false;
    }

    bool finish(std::string& error) {
        if (m_request.scale == 0 && m_request.width == 0 && m_request.height == 0) {
            error = "ddt: no size; give scale=FACTOR or width=PIXELS or height=PIXELS";
            return false;
        }
        return parse_filter(m_filter + m_options, m_request.options, error);
    }

private:
    // A factor and sizes exclude each other; the last wins.
    bool set_scale(const std::string& item, const std::string& value, std::string& error) {
        if (!parse_number(value, std::numeric_limits<double>::min(), double(largest_side),
                          m_request.scale)) {
            error = format("ddt: \"{}\" is not allowed; scale is a number above 0, at most {}",
                           item, largest_side);
            return false;
        }
        m_request.width = m_request.height = 0;
        return true;
    }

    bool set_size(const std::string& item, const std::string& value, int& size,
                  std::string& error) {
        if (!parse_number(value, 1, largest_side, size)) {
            error = format("ddt: \"{}\" is not allowed; width and height are whole numbers from 1 "
                           "to {}",
                           item, largest_side);
            return false;
        }
        m_request.scale = 0;
        return true;
    }

    Request& m_request;
    std::string m_filter = "ddt", m_options;
};

/// The lines that count.
bool read_sidecar(const std::string& path, std::vector<std::string>& lines, std::string& error) {
    std::string text;
    if (OIIO::Filesystem::file_size(path) > longest_sidecar ||
        !OIIO::Filesystem::read_text_file(path, text) || text.find('\0') != std::string::npos) {
        error = format("ddt: \"{}\" is not a sidecar; its first line is the path of an image, the "
                       "others are key=value",
                       path);
        return false;
    }
    text.erase(0, begin_of_text(text));
    for (OIIO::string_view line : OIIO::Strutil::splitsv(text, "\n")) {
        line = OIIO::Strutil::strip(line);
        if (!line.empty() && line[0] != '#')
            lines.emplace_back(line);
    }
    if (lines.empty()) {
        error = format("ddt: \"{}\" is empty; its first line is the path of an image", path);
        return false;
    }
    return true;
}

/// Whether a path is one that the library below OpenImageIO's reader of films takes for an address
/// ("http://", "tcp:", "pipe:0", "concat:a|b"): it would reach the network, or wait. (FFmpeg's
/// rule, url_find_protocol() in libavformat/avio.c; "subfile" has options before its colon.)
bool has_protocol(const std::string& path) {
    constexpr char in_protocols[] =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789+-.";
    const size_t end = path.find_first_not_of(in_protocols);
    return (end != std::string::npos && end > 0 && path[end] == ':') ||
           OIIO::Strutil::starts_with(path, "subfile,");
}

std::string in_this_folder(const std::string& path) {
    return "./" + path;
}

std::string beside(const std::string& sidecar, const std::string& path) {
    if (OIIO::Filesystem::path_is_absolute(path))
        return path;
    const std::string folder = OIIO::Filesystem::parent_path(sidecar);
    return folder.empty() ? in_this_folder(path) : folder + "/" + path;
}

/// Pipes, sockets, devices, folders: opening these may wait for ever, or never end. What does not
/// exist may still be an image to some reader.
bool is_special(const std::string& path) {
    return OIIO::Filesystem::exists(path) && !OIIO::Filesystem::is_regular(path);
}

/// Whether a reader that is given `source`, which was `written` so, may open something else than a
/// file that ends. Some open the whole name, others what stands before its query.
bool may_be_no_file(const std::string& written, const std::string& source) {
    const std::string path = before_query(source);
    return is_special(source) || is_special(path) ||
           (has_protocol(written) && !OIIO::Filesystem::is_regular(source) &&
            !OIIO::Filesystem::is_regular(path));
}

bool parse(const std::string& name, Request& request, std::string& error) {
    const std::string path = before_query(name);
    Parser parser(request);
    std::string written; // the source's name
    if (OIIO::Filesystem::is_regular(path)) {
        std::vector<std::string> lines;
        if (!read_sidecar(path, lines, error))
            return false;
        written = lines[0];
        request.source = beside(path, written);
        for (size_t i = 1; i < lines.size(); ++i)
            if (!parser.set(lines[i], error)) {
                error += format("; in \"{}\"", path);
                return false;
            }
    } else {
        request.source = written = path.substr(0, path.size() - extension_length);
    }
    if (has_protocol(request.source)) // a file, if it is there, is opened as one
        request.source = in_this_folder(request.source);
    // A sidecar that names itself, or a chain of them, would never end.
    if (request.source.empty() || is_request_name(request.source)) {
        error = format("ddt: \"{}\" does not name an image to enlarge; allowed is a file that is "
                       "not itself a .ddt",
                       request.source);
        return false;
    }
    if (may_be_no_file(written, request.source)) {
        error = format("ddt: \"{}\" is not a regular file; allowed is a file that holds an image",
                       request.source);
        return false;
    }
    if (path.size() < name.size())
        for (const std::string& item : OIIO::Strutil::splits(name.substr(path.size() + 1), "&"))
            if (!item.empty() && !parser.set(item, error))
                return false;
    return parser.finish(error);
}

/// Floor and ceiling of a * b / c, c > 0.
int64_t scale_down(int64_t a, int64_t b, int64_t c) {
    const int64_t product = a * b;
    return product / c - (product % c < 0);
}
int64_t scale_up(int64_t a, int64_t b, int64_t c) {
    return -scale_down(-a, b, c);
}

} // namespace

bool is_request_name(const std::string& name) noexcept {
    const size_t end = std::min(name.find('?'), name.size());
    // At least one character of the file's name before it: ".ddt" itself is a hidden file without
    // an extension.
    if (end <= extension_length || name[end - extension_length - 1] == '/')
        return false;
    for (size_t i = 0; i < extension_length; ++i) {
        const char c = name[end - extension_length + i];
        if ((c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c) != extension[i])
            return false;
    }
    return true;
}

bool parse_request(const std::string& name, Request& request, std::string& error) {
    Request parsed;
    if (!parse(name, parsed, error)) {
        error = one_line(error); // names may hold breaks
        return false;
    }
    request = parsed;
    return true;
}

bool Request::windows(const OIIO::ImageSpec& from, OIIO::ImageSpec& to, std::string& error) const {
    const double w = from.full_width, h = from.full_height;
    const double x_factor = scale > 0 ? scale : width > 0 ? width / w : height / h;
    const double y_factor = scale > 0 ? scale : height > 0 ? height / h : width / w;
    const double full_w = std::max(1.0, std::round(w * x_factor));
    const double full_h = std::max(1.0, std::round(h * y_factor));
    if (!(full_w <= largest_side && full_h <= largest_side)) {
        error = format("ddt: the output of {:.0f} x {:.0f} pixels is too large; a side may have {}",
                       full_w, full_h, largest_side);
        return false;
    }
    to.full_width = int(full_w);
    to.full_height = int(full_h);
    const int64_t x0 = scale_down(int64_t(from.x) - from.full_x, to.full_width, from.full_width);
    const int64_t y0 = scale_down(int64_t(from.y) - from.full_y, to.full_height, from.full_height);
    const int64_t x1 =
        scale_up(int64_t(from.x) - from.full_x + from.width, to.full_width, from.full_width);
    const int64_t y1 =
        scale_up(int64_t(from.y) - from.full_y + from.height, to.full_height, from.full_height);
    // The origin stays, as with oiiotool --resize.
    constexpr int64_t limit = largest_coordinate;
    if (x0 < -limit || y0 < -limit || x1 > limit || y1 > limit) {
        error = format("ddt: the output's data window of {} x {} pixels is too large", x1 - x0,
                       y1 - y0);
        return false;
    }
    to.x = int(from.full_x + x0);
    to.y = int(from.full_y + y0);
    to.width = int(x1 - x0);
    to.height = int(y1 - y0);
    return true;
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
// The plugin as a genuine ImageInput: enlarged images under names of their own, see request.h.
//
// It does not claim to be "procedural": a failing open would crash oiiotool. While OIIO looks for a
// reader of a file that nobody else wants, it asks every reader under a mutex that opening a file
// takes, too: foreign names are refused before anything is called.
#include <algorithm>
#include <cstring>
#include <memory>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include "core/base/guarded.h"
#include "core/base/log.h"
#include "plugin/image/memory.h"
#include "plugin/image/metadata.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/image/reading.h"
#include "plugin/image/windows.h"
#include "plugin/message/format.h"
#include "plugin/reader/pieces.h"
#include "plugin/reader/request.h"
#include "plugin/reader/source_image.h"

namespace ddt {
namespace {

constexpr int reader_tile = 64;

class Reader final : public OIIO::ImageInput {
public:
    ~Reader() override { close(); }

    const char* format_name() const override { return "ddt"; }
    bool open(const std::string& name, OIIO::ImageSpec& newspec) override {
        return open(name, newspec, OIIO::ImageSpec());
    }
    bool open(const std::string& name, OIIO::ImageSpec& newspec,
              const OIIO::ImageSpec& config) override;
    bool close() override;
    int current_subimage() const override {
        lock_guard lock(*this);
        return m_subimage;
    }
    bool seek_subimage(int subimage, int miplevel) override;
    bool read_native_scanline(int, int, int, int, void*) override { return false; } // tiles only
    bool read_native_tile(int subimage, int miplevel, int x, int y, int z, void* data) override;
    using ImageInput::read_native_tiles;
    bool read_native_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin, int yend,
                           int zbegin, int zend, void* data) override;

private:
    bool open_source(const OIIO::ImageSpec& config, std::string& error);
    /// Go to a subimage that the source has; the result's description becomes m_spec.
    bool describe(int subimage, std::string& error);
    /// Copy pixels of the current subimage to rows of `width` pixels; what `r` has beyond the data
    /// window is black.
    bool read(const Rect& r, int width, void* data, std::string& error);
    /// Run f(error); a failure or an exception becomes this reader's error.
    template <typename F>
    bool report(F f);

    Request m_request;
    std::unique_ptr<OIIO::ImageInput> m_source;
    int m_subimage = -1;
    OIIO::ImageSpec m_hints;              ///< that the source was opened with
    std::unique_ptr<SourceImage> m_image; ///< the current subimage, null until it is asked for
    std::unique_ptr<Pieces> m_pieces;     ///< of it enlarged, likewise
    std::string m_failure;                ///< why it cannot be had
};

template <typename F>
bool Reader::report(F f) {
    std::string error;
    if (succeeds(&error, f))
        return true;
    if (!error.empty())
        guarded_call(nullptr, [&] {
            errorfmt("{}", error);
            if (verbose()) // oiiotool tells its own: that there is no such file
                say("%s", error.c_str());
        });
    return false;
}

bool Reader::open(const std::string& name, OIIO::ImageSpec& newspec,
                  const OIIO::ImageSpec& config) {
    // "nowait" is OIIO's word to readers that it tries in turn. It has asked us before, by the
    // extension, and without that mutex.
    if (!is_request_name(name) || config.get_int_attribute("nowait"))
        return false;
    lock_guard lock(*this);
    close();
    const bool ok = report([&](std::string& error) {
        return parse_request(name, m_request, error) && open_source(config, error) &&
               describe(0, error);
    });
    if (ok)
        newspec = m_spec;
    else
        close();
    return ok;
}

bool Reader::open_source(const OIIO::ImageSpec& config, std::string& error) {
    m_hints = config;
    // Meant for the file that we are, not for the one that we read.
    m_hints.erase_attribute("oiio:ioproxy");
    m_source = OIIO::ImageInput::open(m_request.source, &m_hints);
    if (m_source)
        return true;
    error = format("ddt: cannot open \"{}\": {}", m_request.source, OIIO::geterror());
    return false;
}

bool Reader::close() {
    m_pieces.reset();
    m_image.reset();
    m_source.reset();
    m_failure.clear();
    m_subimage = -1;
    return true;
}

bool Reader::seek_subimage(int subimage, int miplevel) {
    lock_guard lock(*this);
    if (!m_source || miplevel != 0)
        return false;
    if (subimage == m_subimage)
        return true;
    // Failing is how callers find out how many there are: no message.
    if (!m_source->seek_subimage(subimage, 0) &&
        !(m_source->seek_subimage(0, 0) && m_source->seek_subimage(subimage, 0))) {
        m_source->geterror();
        return false;
    }
    return report([&](std::string& error) { return describe(subimage, error); });
}

bool Reader::describe(int subimage, std::string& error) {
    const OIIO::ImageSpec from = m_source->spec(subimage);
    if (from.deep) {
        error = "ddt: deep images are not supported";
        return false;
    }
    if (from.depth > 1 || from.full_depth > 1) {
        error = "ddt: volumes are not supported";
        return false;
    }
    if (from.undefined() || from.full_width < 1 || from.full_height < 1) {
        error = format("ddt: \"{}\" has no pixels", m_request.source);
        return false;
    }
    if (overruns_memory(from)) {
        error = format("ddt: cannot read \"{}\": {}", m_request.source, why_overrun);
        return false;
    }
    OIIO::ImageSpec to = from;
    if (!m_request.windows(from, to, error))
        return false;
    // Who reads pixels may not ask whether that failed.
    if (!check_light(from, from, m_request.options, error)) {
        error = "ddt: " + error;
        return false;
    }
    if (!check_size(from.roi(), from.nchannels, from.format, error) ||
        !check_size(to.roi(), to.nchannels, to.format, error)) {
        error = "ddt: " + error;
        return false;
    }
    to.channelformats.clear(); // all channels have one type
    to.tile_width = to.tile_height = reader_tile;
    to.tile_depth = 1;
    forget_pixels(to);
    forget_old_size(to);
    // Who copies an image writes it in tiles if it has some: TIFF's, where doubles are black, too.
    if (to.format == OIIO::TypeDesc(OIIO::TypeDesc::DOUBLE))
        to.set_format(OIIO::TypeFloat); // all that there is
    auto& metadata = to.extra_attribs;
    metadata.erase(std::remove_if(metadata.begin(), metadata.end(), spoils_tiff_tiles),
                   metadata.end());
    m_pieces.reset();
    m_image.reset();
    m_failure.clear();
    m_spec = to;
    m_subimage = subimage;
    return true;
}

bool Reader::read_native_tile(int subimage, int miplevel, int x, int y, int, void* data) {
    lock_guard lock(*this);
    if (!seek_subimage(subimage, miplevel))
        return false;
    return report([&](std::string& error) {
        return read({x, y, x + reader_tile, y + reader_tile}, reader_tile, data, error);
    });
}

bool Reader::read_native_tiles(int subimage, int miplevel, int xbegin, int xend, int ybegin,
                               int yend, int, int, void* data) {
    lock_guard lock(*this);
    if (!seek_subimage(subimage, miplevel))
        return false;
    return report([&](std::string& error) {
        return read({xbegin, ybegin, xend, yend}, xend - xbegin, data, error);
    });
}

bool Reader::read(const Rect& r, int width, void* data, std::string& error) {
    error = m_failure;
    if (!error.empty())
        return false;
    if (!m_pieces) {
        m_image = std::make_unique<SourceImage>();
        if (!m_image->open(m_request.source, *m_source, m_subimage, m_hints, error)) {
            m_failure = error;
            return false;
        }
        m_pieces = std::make_unique<Pieces>(m_image->image(), m_spec, m_request.options);
    }
    const Rect window = rect_of(m_spec.roi());
    const Rect wanted = intersection(r, window);
    const size_t pixel = m_spec.pixel_bytes(), stride = pixel * size_t(width);
    if (!(wanted == r))
        std::memset(data, 0, stride * size_t(r.height()));
    if (wanted.empty())
        return true;
    auto* first = static_cast<char*>(data) + stride * size_t(wanted.y0 - r.y0) +
                  pixel * size_t(wanted.x0 - r.x0);
    return m_pieces->read(wanted, threads(), first, stride, error);
}

} // namespace
} // namespace ddt

// What OIIO looks for in a file ddt.imageio.so.
OIIO_PLUGIN_EXPORTS_BEGIN

OIIO_EXPORT int ddt_imageio_version = OIIO_PLUGIN_VERSION;
OIIO_EXPORT const char* ddt_imageio_library_version() {
    return "oiio-ddt " DDT_VERSION;
}
OIIO_EXPORT OIIO::ImageInput* ddt_input_imageio_create() {
    return new ddt::Reader;
}
OIIO_EXPORT const char* ddt_input_extensions[] = {"ddt", nullptr};

OIIO_PLUGIN_EXPORTS_END

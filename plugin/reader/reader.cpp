// SPDX-License-Identifier: Apache-2.0
// The plugin as a genuine ImageInput: enlarged images under names of their own, see request.h.
//
// It does not claim to be "procedural": a failing open would crash oiiotool. While OIIO looks for a
// reader of a file that nobody else wants, it asks every reader under a mutex that opening a file
// takes, too: foreign names are refused before anything is called.
#include <cstring>
#include <memory>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>
#include <OpenImageIO/strutil.h>

#include "core/base/guarded.h"
#include "plugin/image/windows.h"
#include "request.h"

namespace ddt {
namespace {

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
    bool read_native_scanline(int subimage, int miplevel, int y, int z, void* data) override {
        return read_native_scanlines(subimage, miplevel, y, y + 1, z, data);
    }
    bool read_native_scanlines(int subimage, int miplevel, int ybegin, int yend, int z,
                               void* data) override;

private:
    bool open_source(const OIIO::ImageSpec& config, std::string& error);
    /// Go to a subimage that the source has; the result's description becomes m_spec.
    bool describe(int subimage, std::string& error);
    /// Enlarge the current subimage, unless that has been done.
    bool compute(std::string& error);
    /// Run f(error); a failure or an exception becomes this reader's error.
    template <typename F>
    bool report(F f);

    Request m_request;
    std::unique_ptr<OIIO::ImageInput> m_source;
    int m_subimage = -1;
    OIIO::ImageBuf m_result; ///< of the current subimage, uninitialised until it is asked for
    std::string m_failure;   ///< why there will be no result of the current subimage
};

template <typename F>
bool Reader::report(F f) {
    std::string error;
    if (succeeds(&error, f))
        return true;
    if (!error.empty())
        guarded_call(nullptr, [&] { errorfmt("{}", error); });
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
    OIIO::ImageSpec hints = config;
    // Meant for the file that we are, not for the one that we read.
    hints.erase_attribute("oiio:ioproxy");
    m_source = OIIO::ImageInput::open(m_request.source, &hints);
    if (m_source)
        return true;
    std::string reason = OIIO::geterror();
    reason = reason.substr(0, reason.find('\n'));
    error = OIIO::Strutil::fmt::format("ddt: cannot open \"{}\": {}", m_request.source, reason);
    return false;
}

bool Reader::close() {
    m_source.reset();
    m_result.clear();
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
    if (!m_source->seek_subimage(subimage, 0)) {
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
        error = OIIO::Strutil::fmt::format("ddt: \"{}\" has no pixels", m_request.source);
        return false;
    }
    OIIO::ImageSpec to = from;
    if (!m_request.windows(from, to, error) ||
        !check_size(from.roi(), from.nchannels, from.format, error) ||
        !check_size(to.roi(), to.nchannels, to.format, error))
        return false;
    // All channels have one type, and rows come whole.
    to.channelformats.clear();
    to.tile_width = to.tile_height = to.tile_depth = 0;
    // True of the source's pixels only.
    for (const char* name :
         {"oiio:SHA-1", "oiio:ConstantColor", "oiio:AverageColor", "textureformat"})
        to.erase_attribute(name);
    m_spec = to;
    m_subimage = subimage;
    m_result.clear();
    m_failure.clear();
    return true;
}

bool Reader::read_native_scanlines(int subimage, int miplevel, int ybegin, int yend, int,
                                   void* data) {
    lock_guard lock(*this);
    if (!seek_subimage(subimage, miplevel))
        return false;
    return report([&](std::string& error) {
        if (!compute(error))
            return false;
        const size_t row = m_spec.scanline_bytes();
        const auto* pixels = static_cast<const char*>(m_result.localpixels());
        const int top = m_spec.y, bottom = m_spec.y + m_spec.height;
        if (ybegin < top || yend > bottom || ybegin > yend) {
            error = OIIO::Strutil::fmt::format("ddt: no rows {} to {}; allowed are {} to {}",
                                               ybegin, yend - 1, top, bottom - 1);
            return false;
        }
        std::memcpy(data, pixels + size_t(ybegin - top) * row, size_t(yend - ybegin) * row);
        return true;
    });
}

bool Reader::compute(std::string& error) {
    if (m_result.initialized())
        return true;
    error = m_failure;
    if (!error.empty())
        return false;

    OIIO::ImageSpec from = m_source->spec(m_subimage);
    from.channelformats.clear();
    OIIO::ImageBuf source(from), result(m_spec);
    if (!source.localpixels() || !result.localpixels())
        error = "ddt: out of memory";
    else if (!m_source->read_image(m_subimage, 0, 0, from.nchannels, from.format,
                                   source.localpixels()))
        error = OIIO::Strutil::fmt::format("ddt: cannot read \"{}\": {}", m_request.source,
                                           m_source->geterror());
    else if (!resize(result, source, m_request.options, result.roi(), threads()))
        error = result.geterror();
    if (error.empty())
        m_result = std::move(result);
    m_failure = error;
    return error.empty();
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

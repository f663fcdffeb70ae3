// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/image_file.h"

#include <algorithm>

#include <vector>

#include <OpenImageIO/strutil.h>

namespace ddt::tool {

namespace {

/// The JPEG library ends the program when a write to a FILE* of its own fails; OpenImageIO gives it
/// one of streams that say they are files.
class Stream final : public OIIO::Filesystem::IOFile {
public:
    explicit Stream(std::FILE* file) : IOFile(file, Write) {}
    const char* proxytype() const override { return "whole file"; }
};

/// Read every pixel; false if that fails.
bool can_be_read(const std::string& path) {
    const auto in = OIIO::ImageInput::open(path);
    if (!in)
        return false;
    const OIIO::ImageSpec& spec = in->spec();
    const int rows = spec.tile_height > 0 ? spec.tile_height : 16;
    // Room for whole tiles: OpenImageIO's reader writes beyond the image's edge (2.4.7, TIFF).
    const size_t width =
        spec.tile_width > 0 ? size_t(spec.width) + size_t(spec.tile_width) : size_t(spec.width);
    std::vector<char> pixels(spec.pixel_bytes(true) * width * size_t(rows));
    const int end = spec.y + spec.height;
    for (int y = spec.y; y < end; y += rows) {
        const int y1 = std::min(end, y + rows);
        const bool read = spec.tile_width > 0
                              ? in->read_native_tiles(0, 0, spec.x, spec.x + spec.width, y, y1, 0,
                                                      1, pixels.data())
                              : in->read_native_scanlines(0, 0, y, y1, 0, pixels.data());
        if (!read)
            return false;
    }
    return true;
}

} // namespace

bool ImageFile::create(const std::string& path, Failure& failure) {
    m_path = path;
    m_output = OIIO::ImageOutput::create(path);
    if (!m_output) {
        const std::string why(OIIO::Strutil::strip(OIIO::geterror()));
        failure = {why.empty() ? "cannot write \"" + path + "\"" : why};
        return false;
    }
    return m_whole.open(path, failure);
}

bool ImageFile::open(const OIIO::ImageSpec& spec, Failure& failure) {
    // TIFF's rows make a broken file that way (OpenImageIO 2.4.7).
    if (m_output->supports("ioproxy") && m_output->format_name() != std::string("tiff")) {
        m_stream = std::make_unique<Stream>(m_whole.file());
        m_output->set_ioproxy(m_stream.get());
    }
    if (m_output->open(temporary(), spec))
        return true;
    failure = failed();
    return false;
}

bool ImageFile::begin(const std::string& path, OIIO::ImageSpec spec, Failure& failure) {
    spec.tile_width = spec.tile_height = spec.tile_depth = 0;
    return create(path, failure) && open(spec, failure);
}

Failure ImageFile::failed() const {
    std::string why(OIIO::Strutil::strip(m_output->geterror()));
    why = OIIO::Strutil::replace(why.substr(0, why.find('\n')), temporary(), m_path, true);
    const bool of_stream = m_whole.file() && std::ferror(m_whole.file());
    return {"cannot write \"" + m_path + "\"" + (why.empty() ? "" : ": " + why),
            of_stream ? exit_resources : code_of_message(why)};
}

bool ImageFile::commit(Failure& failure) {
    if (!m_output->close()) {
        failure = failed();
        return false;
    }
    if (!m_stream && !can_be_read(temporary())) {
        failure = {"cannot write \"" + m_path + "\": what was written cannot be read back",
                   exit_resources};
        return false;
    }
    m_output.reset();
    m_stream.reset();
    return m_whole.commit(failure);
}

int rows_in_strip(const OIIO::ImageSpec& spec) {
    return std::clamp(spec.get_int_attribute("tiff:RowsPerStrip", 1), 1, 1 << 20);
}

bool write_image(const OIIO::ImageBuf& image, const std::string& path,
                 const std::function<void(float)>& progress, Failure& failure) {
    ImageFile file;
    if (!file.begin(path, image.spec(), failure))
        return false;
    const auto callback = [](void* data, float share) {
        (*static_cast<const std::function<void(float)>*>(data))(share);
        return false; // do not stop
    };
    auto* const data = const_cast<std::function<void(float)>*>(&progress);
    if (!image.write(&file.output(), callback, data)) {
        failure = file.failed();
        if (const std::string why(OIIO::Strutil::strip(image.geterror()));
            !why.empty() && failure.why.find(':') == std::string::npos) {
            failure.why += ": " + why.substr(0, why.find('\n'));
            if (failure.code == exit_failed)
                failure.code = code_of_message(why);
        }
        return false;
    }
    return file.commit(failure);
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "plugin/reader/source_image.h"

#include <OpenImageIO/strutil.h>

#include "plugin/image/memory.h"
#include "plugin/image/own_tasks.h"
#include "plugin/message/format.h"

namespace ddt {
namespace {

/// Other numbers become floats in an image cache.
bool cache_keeps(OIIO::TypeDesc type) {
    return type == OIIO::TypeUInt8 || type == OIIO::TypeUInt16 || type == OIIO::TypeHalf ||
           type == OIIO::TypeFloat;
}

} // namespace

bool SourceImage::open(const std::string& path, OIIO::ImageInput& input, int subimage,
                       const OIIO::ImageSpec& hints, std::string& error) {
    OIIO::ImageSpec spec = input.spec(subimage);
    // OpenImageIO 3.1's reader of GIF does not find its way back to any image but the first, which
    // a cache asks it for.
    const bool lost = subimage > 0 && input.format_name() == std::string("gif");
    if (cache_keeps(spec.format) && !lost) {
        m_file = std::make_unique<LazyFile>(path, subimage, LazyFile::Pieces(), &hints);
        const OIIO::ImageBuf& image = m_file->image();
        if (const OIIO::ImageSpec& now = image.nativespec(); image.has_error())
            error = format("cannot read \"{}\": {}", path, image.geterror());
        else if (is_unchanged(spec, now, path, error) && m_file->make_room(0, error))
            return true;
        error = "ddt: " + error;
        return false;
    }
    spec.channelformats.clear();
    const OwnTasksOnly alone;
    if (!take_memory(m_pixels, spec, error)) {
        error = "ddt: " + error;
        return false;
    }
    if (input.read_image(subimage, 0, 0, spec.nchannels, spec.format, m_pixels.localpixels()))
        return true;
    error = format("ddt: cannot read \"{}\": {}", path, input.geterror());
    return false;
}

} // namespace ddt

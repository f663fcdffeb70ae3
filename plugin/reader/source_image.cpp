// SPDX-License-Identifier: Apache-2.0
#include "source_image.h"

#include <OpenImageIO/strutil.h>

namespace ddt {
namespace {

constexpr float cache_megabytes = 128;
constexpr int cache_tile = 256; // of files that are not tiled

/// Other numbers become floats in an image cache.
bool cache_keeps(OIIO::TypeDesc type) {
    return type == OIIO::TypeUInt8 || type == OIIO::TypeUInt16 || type == OIIO::TypeHalf ||
           type == OIIO::TypeFloat;
}

} // namespace

std::shared_ptr<OIIO::ImageCache> make_cache() {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
    return OIIO::ImageCache::create(false);
#else
    return {OIIO::ImageCache::create(false),
            [](OIIO::ImageCache* cache) { OIIO::ImageCache::destroy(cache); }};
#endif
}

bool SourceImage::open(const std::string& path, OIIO::ImageInput& input, int subimage,
                       const OIIO::ImageSpec& hints, std::string& error) {
    OIIO::ImageSpec spec = input.spec(subimage);
    if (cache_keeps(spec.format)) {
        m_cache = make_cache();
        m_cache->attribute("max_memory_MB", cache_megabytes);
        m_cache->attribute("autotile", cache_tile);
        m_image =
            std::make_unique<OIIO::ImageBuf>(path, subimage, 0, cache_argument(m_cache), &hints);
        return true; // what cannot be read is found when it is
    }
    spec.channelformats.clear();
    m_image = std::make_unique<OIIO::ImageBuf>();
    m_image->reset(spec, OIIO::InitializePixels::No);
    if (!m_image->localpixels()) {
        error = "ddt: out of memory";
        return false;
    }
    if (input.read_image(subimage, 0, 0, spec.nchannels, spec.format, m_image->localpixels()))
        return true;
    error = OIIO::Strutil::fmt::format("ddt: cannot read \"{}\": {}", path, input.geterror());
    return false;
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
#include "source_image.h"

#include <mutex>
#include <utility>
#include <vector>

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

/// An image cache of one's own, whatever OpenImageIO's version hands out.
std::shared_ptr<OIIO::ImageCache> make_cache() {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
    return OIIO::ImageCache::create(false);
#else
    return {OIIO::ImageCache::create(false),
            [](OIIO::ImageCache* cache) { OIIO::ImageCache::destroy(cache); }};
#endif
}

/// That cache as an ImageBuf takes it.
auto cache_argument(const std::shared_ptr<OIIO::ImageCache>& cache) {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
    return cache;
#else
    return cache.get();
#endif
}

/// Caches that are done with. OpenImageIO destroys one under a lock of the process, and a reader
/// may be closed just there, by the destruction of a host's cache: its own is then destroyed by the
/// next reader that is opened.
class DoneCaches {
public:
    void add(std::shared_ptr<OIIO::ImageCache> cache) {
        cache->invalidate_all(true);
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_caches.push_back(std::move(cache));
    }
    void destroy() {
        std::vector<std::shared_ptr<OIIO::ImageCache>> caches;
        const std::lock_guard<std::mutex> lock(m_mutex);
        caches.swap(m_caches);
        // The lock goes first: whoever destroys a host's cache may wait for it.
    }

private:
    std::mutex m_mutex;
    std::vector<std::shared_ptr<OIIO::ImageCache>> m_caches;
};

DoneCaches& done_caches() {
    static auto* caches = new DoneCaches; // readers are closed until the last moment of a process
    return *caches;
}

} // namespace

SourceImage::~SourceImage() {
    m_image.reset();
    if (m_cache)
        done_caches().add(std::move(m_cache));
}

bool SourceImage::open(const std::string& path, OIIO::ImageInput& input, int subimage,
                       const OIIO::ImageSpec& hints, std::string& error) {
    OIIO::ImageSpec spec = input.spec(subimage);
    if (cache_keeps(spec.format)) {
        done_caches().destroy();
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

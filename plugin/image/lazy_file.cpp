// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/lazy_file.h"

#include <mutex>
#include <vector>

#include "core/tiles/grid.h"
#include "plugin/image/metadata.h"

namespace ddt {
namespace {

/// The caches that no file uses at the moment. None is ever destroyed, but used again: what a
/// thread knows of a cache, tiles and open files, OpenImageIO 2.4 finds by the cache's address and
/// forgets when the thread ends. A later cache at that address would be taken for the one that was,
/// by every worker that outlives it. Destroying one would also wait for a lock of the process,
/// under which a reader may be closed, by the destruction of a host's cache.
class IdleCaches {
public:
    CacheHandle take() {
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (m_caches.empty())
            return OIIO::ImageCache::create(false);
        CacheHandle cache = m_caches.back();
        m_caches.pop_back();
        return cache;
    }
    void give_back(const CacheHandle& cache) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        m_caches.push_back(cache);
    }

private:
    std::mutex m_mutex;
    std::vector<CacheHandle> m_caches;
};

IdleCaches& idle_caches() {
    static auto* caches = new IdleCaches; // files are closed until a process's last moment
    return *caches;
}

} // namespace

LazyFile::LazyFile(const std::string& path, int subimage, const Pieces& pieces,
                   const OIIO::ImageSpec* hints)
    : m_path(path), m_cache(idle_caches().take()) {
    m_cache->attribute("max_memory_MB", pieces.megabytes);
    m_cache->attribute("autotile", tile_size);
    m_cache->attribute("autoscanline", int(pieces.whole_rows));
    m_cache->attribute("forcefloat", 0);
    m_image = std::make_unique<OIIO::ImageBuf>(path, subimage, 0, m_cache, hints);
    if (!is_associated_when_read(m_image->nativespec()))
        return;
    m_image.reset();
    m_cache->attribute("forcefloat", 1);
    m_image = std::make_unique<OIIO::ImageBuf>(path, subimage, 0, m_cache, hints);
}

LazyFile::~LazyFile() {
    m_image.reset();
    m_cache->invalidate(OIIO::ustring(m_path), true); // closed, and its tiles gone
    idle_caches().give_back(m_cache);
}

std::string why_changed(const std::string& path) {
    return "\"" + path + "\" was changed while it was read";
}

bool is_unchanged(const OIIO::ImageSpec& before, const OIIO::ImageSpec& now,
                  const std::string& path, std::string& error) {
    if (before.roi() == now.roi() && before.roi_full() == now.roi_full() &&
        before.format == now.format && before.channelformats == now.channelformats &&
        before.tile_width == now.tile_width && before.tile_height == now.tile_height)
        return true;
    error = why_changed(path);
    return false;
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/lazy_file.h"

#include <algorithm>
#include <cmath>
#include <mutex>
#include <vector>

#include "core/base/parallel.h"
#include "core/tiles/grid.h"
#include "plugin/image/memory.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/message/format.h"

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

/// Bytes that a cache must be allowed for an image, of which this is its spec: as the cache holds
/// it, in tiles even if the file has none. Where it holds ten times what it may, the cache ends the
/// program (check_max_mem() in OpenImageIO's imagecache.cpp). It holds what it may, the tile that
/// was just read and, for each thread, the two that the thread used last; or, where it may hold the
/// whole image, no more than that. Two at least, or no tile would stay until it is used again.
double bytes_needed(const OIIO::ImageSpec& cached, int threads) {
    const auto count = [](int size, int tile) { return std::ceil(double(size) / double(tile)); };
    const double all = count(cached.width, cached.tile_width) *
                       count(cached.height, cached.tile_height),
                 beside = 2.0 * threads + 1;
    return std::min(all, std::max(2.0, beside / 9)) * double(cached.tile_width) *
           double(cached.tile_height) * double(cached.nchannels) * double(cached.format.size());
}

} // namespace

LazyFile::LazyFile(const std::string& path, int subimage, const Pieces& pieces,
                   const OIIO::ImageSpec* hints)
    : m_path(path), m_megabytes(pieces.megabytes), m_cache(idle_caches().take()) {
    m_cache->attribute("max_memory_MB", m_megabytes);
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

bool LazyFile::make_room(int threads, std::string& error) {
    const OIIO::ImageSpec& cached = m_image->spec();
    const double bytes = bytes_needed(cached, std::max(usual_threads(), threads_for(threads)));
    if (bytes < std::ldexp(m_megabytes, 20))
        return true;
    if (!check_memory(format("reading \"{}\" in pieces of {} x {} pixels", m_path,
                             cached.tile_width, cached.tile_height),
                      bytes, error))
        return false;
    m_cache->attribute("max_memory_MB", int(std::ldexp(bytes, -20)) + 1);
    return true;
}

std::string why_changed(const std::string& path) {
    return "\"" + path + "\" " + changed_text;
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

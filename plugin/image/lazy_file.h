// SPDX-License-Identifier: Apache-2.0
// A file as an image of which only what is asked for is read.
#pragma once

#include <memory>
#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagecache.h>

namespace ddt {

/// An image cache as it is handed out: a pointer, from 3.x on a shared one.
using CacheHandle = decltype(OIIO::ImageCache::create(false));

/// Behind an image cache that no other file uses for as long as this one is open: programs limit
/// and empty the one they share.
class LazyFile {
public:
    /// What the cache keeps, at most, unless make_room() finds that too little, and in which pieces
    /// it reads a file that has no tiles: squares of the mesh's grid, or whole rows of them.
    struct Pieces {
        int megabytes = 128;
        bool whole_rows = false;
    };

    /// `hints` are handed to the file's reader. Pixels that cannot be read are noticed when they
    /// are asked for. The image is of the file's type, or of floats where
    /// is_associated_when_read().
    LazyFile(const std::string& path, int subimage, const Pieces& pieces,
             const OIIO::ImageSpec* hints = nullptr);
    ~LazyFile();
    LazyFile(const LazyFile&) = delete;
    LazyFile& operator=(const LazyFile&) = delete;

    /// Let the cache keep what so many threads (0: the usual number) take of the pieces in which it
    /// reads the file, tiles or rows. To be called before they ask for pixels: OpenImageIO ends the
    /// program where a cache holds far more than it may. False with one line in `error` if that is
    /// more memory than is allowed: a file may claim tiles of any size.
    bool make_room(int threads, std::string& error);

    OIIO::ImageBuf& image() { return *m_image; }
    const OIIO::ImageBuf& image() const { return *m_image; }

private:
    std::string m_path;
    int m_megabytes;
    CacheHandle m_cache; // older than the image, which uses it until its end
    std::unique_ptr<OIIO::ImageBuf> m_image;
};

/// What is said of a file, after its name, that is another than the one that was begun with.
inline constexpr char changed_text[] = "was changed while it was read";
/// The error that a file's name became another's, or its bytes others, before all were read.
std::string why_changed(const std::string& path);

/// Whether a file that is opened again has pixels where it had them, of the same types: another may
/// have been given its name meanwhile. False with one line in `error`.
bool is_unchanged(const OIIO::ImageSpec& before, const OIIO::ImageSpec& now,
                  const std::string& path, std::string& error);

} // namespace ddt

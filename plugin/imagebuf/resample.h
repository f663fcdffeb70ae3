// SPDX-License-Identifier: Apache-2.0
// An ImageBuf read off its mesh under any mapping.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/resize.h"
#include "plugin/image/arrival.h"

namespace ddt {

/// Write those pixels of `roi` that `mapping` gives, in the roi's channels, from src's mesh. Both
/// images have passed check_source() and prepare(). arrival: of src's pixels; null: all are there.
/// False with one line in `error`.
bool resample(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Mapping& mapping,
              const OIIO::ROI& roi, const Options& options, int nthreads, std::string& error,
              Arrival* arrival = nullptr);

/// Whether numbers of this type are cut off to 0 .. 1 (SurfaceOptions::clipped).
inline bool cuts_off(OIIO::TypeDesc type) {
    return type == OIIO::TypeUInt8 || type == OIIO::TypeUInt16;
}

/// Threads for `nthreads` as ddt/resize.h says; 0: the core takes all.
int thread_count(int nthreads);

/// Whether a display window that becomes another is enlarged by the mesh alone: an axis grows and
/// none shrinks.
inline bool enlarges(const OIIO::ROI& from, const OIIO::ROI& to) {
    return to.width() >= from.width() && to.height() >= from.height() &&
           (to.width() > from.width() || to.height() > from.height());
}

/// resize() of ddt/resize.h, if there is an arrival while pixels of src are coming, which is then
/// not dst. What a mesh is not made of is not completed.
bool resize_arriving(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, Arrival* arrival,
                     const Options& options, OIIO::ROI roi, int nthreads);

/// Whether all was read of an image in OpenImageIO's cache since it had no error.
bool check_was_read(const OIIO::ImageBuf& reader, std::string& error);

/// Call work(image) of src, which leaves to OpenImageIO to read its pixels. That goes on with black
/// where a file cannot be read: then false with one line in `error`.
template <class Work>
bool while_reading(const OIIO::ImageBuf& src, std::string& error, Work&& work) {
    if (src.storage() != OIIO::ImageBuf::IMAGECACHE)
        return work(src);
    // Of the same pixels, with errors of its own: another may be pending on src.
    const OIIO::ImageBuf reader(src);
    reader.geterror();
    const bool done = work(reader);
    return check_was_read(reader, error) && done;
}
/// Whether OpenImageIO's own filters write this type; of another they make dst an image of floats,
/// in memory of its own.
bool is_written_by_oiio(OIIO::TypeDesc type);
/// OpenImageIO's default filter for the pixels and channels of `roi` (its own resize writes all
/// channels).
bool resize_by_oiio(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                    int nthreads, std::string& error);

/// What shows where the source has no pixels.
enum class Beyond { edge, black };

/// Write the pixels of `roi` from the source moved by (dx, dy): the same bits where the pixel types
/// are the same.
bool copy_moved(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi, int dx,
                int dy, Beyond beyond, std::string& error);

/// Make `copy` an image of its own with src's pixels and metadata, in this type. False with one
/// line in `error`.
bool copy_whole(OIIO::ImageBuf& copy, const OIIO::ImageBuf& src, OIIO::TypeDesc type,
                std::string& error);

/// Whether the roi's channels are IDs, all of them.
bool all_are_ids(const OIIO::ImageBuf& src, const OIIO::ROI& roi);

/// Resize those of the roi's channels that are IDs by the nearest pixels.
bool copy_nearest_ids(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                      std::string& error);

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
// Object IDs of 32 bits among channels of other types.
#pragma once

#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/resize.h"
#include "plugin/image/arrival.h"
#include "plugin/tool/ids/id_file.h"

namespace ddt::tool {

/// An image of a file whose channels have several types is held as floats, which have no room for
/// all numbers that name objects. Such a number's bits stand in its place while the image is worked
/// on, which means that they are copied, and are written.
class MixedIds final : public Arrival {
public:
    MixedIds() = default;
    /// For those channels of the image of this number from 0 in the file `path` that are 32-bit
    /// integers in it and in the file that is written; `written`: its spec.
    MixedIds(const std::string& path, int number, const OIIO::ImageBuf& image,
             const OIIO::ImageSpec& written);

    /// Whether there are any. If not, nothing below is called.
    explicit operator bool() const { return !m_channels.empty(); }

    /// Put the bits into the image, all of whose pixels are in local memory. False with one line in
    /// `error`.
    bool put_into(OIIO::ImageBuf& image, std::string& error);

    /// resize() of ddt/resize.h of the image, whose bits need not be in it, into the pixels `roi`
    /// of `result`, of floats, which are made from those of `source`. Without holes to be filled.
    bool resize(OIIO::ImageBuf& result, const OIIO::ImageBuf& image, const Rect& source,
                const Options& options, const OIIO::ROI& roi, int threads);

    /// n pixels of the result as a file of this spec is written, which is ImageOutput's
    /// TypeUnknown; in memory that is this one's, until the next call.
    const char* pack(const float* pixels, size_t n, const OIIO::ImageSpec& written);

    bool wait_for(int, std::string&) override { return true; } // it is there
    void complete(const Rect& r, float* pixels) const override;

private:
    void copy_ids(const OIIO::ImageBuf& ids, const Rect& r, float* pixels) const;
    /// Where no mesh is made, each is that of the nearest pixel.
    bool copy_nearest(OIIO::ImageBuf& result, const OIIO::ROI& roi, int threads,
                      std::string& error) const;

    IdFile m_file;
    std::vector<int> m_channels;
    size_t m_all = 0;     ///< how many channels the image has
    OIIO::ImageBuf m_ids; ///< those last read
    std::vector<char> m_packed;
};

/// How many such channels there would be.
int count_mixed_ids(const OIIO::ImageSpec& file, const OIIO::ImageSpec& written);

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
// An enlarged image, piece by piece.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <OpenImageIO/imagebuf.h>

#include "ddt/resize.h"

namespace ddt {

/// Computes what is asked for, and what lies with it on the same tiles of the source's mesh, and
/// keeps the latest pieces; with options.holes the whole at once. Not thread-safe.
class Pieces {
public:
    /// `source` and `spec`, which describes the whole result, stay the caller's, and unchanged. At
    /// most so many bytes of pieces are kept, and one piece.
    Pieces(const OIIO::ImageBuf& source, const OIIO::ImageSpec& spec, const Options& options,
           size_t most_kept = size_t(128) << 20);

    /// Copy the pixels of `r`, which lies within the data window, to `out`: all channels, rows
    /// `stride` bytes apart. False with one line in `error`; after that, always so.
    bool read(const Rect& r, int threads, void* out, size_t stride, std::string& error);

    size_t bytes_kept() const { return m_bytes; }

private:
    struct Piece {
        std::vector<char> pixels;
        uint64_t used = 0; ///< the time by m_clock
    };
    using Place = std::pair<size_t, size_t>; ///< row and column

    bool read_row(size_t row, const Rect& r, int threads, char* out, size_t stride,
                  std::string& error);
    bool compute(size_t row, size_t first, size_t last, int threads, OIIO::ImageBuf& band,
                 std::string& error) const;
    void keep(size_t row, size_t first, size_t last, const OIIO::ImageBuf& band);
    void forget_oldest();
    Rect rect(size_t row, size_t column) const;
    void copy(const Rect& from, const char* pixels, const Rect& r, char* out, size_t stride) const;

    const OIIO::ImageBuf& m_source;
    const OIIO::ImageSpec& m_spec;
    const Options m_options;
    const size_t m_most_kept;
    std::vector<int> m_x, m_y; ///< where columns and rows of pieces begin, and the end
    std::map<Place, Piece> m_kept;
    size_t m_bytes = 0;
    uint64_t m_clock = 0;
    std::string m_failure;
};

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
// Frames of a stream of pictures: Netpbm's PAM (P7), PPM (P6), PGM (P5), and PFM (PF, Pf), one
// after the other without anything between, as `ffmpeg -f image2pipe -c:v pam -` writes them.
#pragma once

#include <cstdio>
#include <memory>
#include <string>

#include "plugin/host/enlargement.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// A picture with its header. Alpha is not associated (PAM's definition). One whose largest value
/// is neither 255 nor 65535 is read as one of 16 bits.
struct FrameHeader {
    std::string magic;      ///< "P7", "P6", "P5", "PF", "Pf"
    std::string tuple_type; ///< PAM's TUPLTYPE, may be empty
    std::string scale;      ///< PFM's third number as it stands; below 0: the low byte comes first
    int width = 0, height = 0, channels = 0;
    int largest = 0; ///< 255 or 65535; PFM: 0
};

struct Frame : FrameHeader {
    /// Numbers of this machine's byte order, rows downwards: uint8, uint16 or float.
    std::unique_ptr<char[]> pixels;

    bool is_float() const { return largest == 0; }
    host::Sample sample() const;
    host::Buffer buffer();
    /// Take the memory for the size, which nothing is written to: a header alone makes no page of
    /// it. False with one line in `error` if an image may not be so large (check_size() of
    /// plugin/image/memory.h); throws std::bad_alloc.
    bool allocate(std::string& error);
    size_t row_bytes() const;
    size_t bytes() const { return row_bytes() * size_t(height); }
    /// The same header for another size, without pixels.
    Frame of_size(int width, int height) const;
};

enum class ReadResult { frame, end, failed };

/// Read the next frame. `end`: the stream ended where a frame could have begun. `failed`: one line
/// that says what is wrong with it, or that the stream cannot be read.
ReadResult read_frame(std::FILE* file, Frame& frame, Failure& failure);

/// Write it, and hand it on at once. False with one line in `error`; a closed pipe is such a
/// failure (SIGPIPE is to be ignored). May change the order of the frame's bytes.
bool write_frame(std::FILE* out, Frame& frame, std::string& error);

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
// The files of parts, as the join reads them.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>

#include "ddt/rect.h"
#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/part/part_header.h"

namespace ddt::tool {

/// A part's file, read from top to bottom, a row of tiles at a time.
struct PartFile {
    explicit PartFile(const std::string& file) : path(file), state(file) {}

    std::string path;
    FileState state; ///< before its header was read, on which all that follows is planned
    PartHeader header;
    Rect window;
    OIIO::ImageSpec spec;    ///< channels in the whole's order
    std::vector<int> places; ///< of these in the file; empty where they are the same
    std::unique_ptr<OIIO::ImageInput> input; ///< open only while its rows are wanted
    std::vector<char> tiles;                 ///< the pixels of a row of tiles
    int y0 = 0, y1 = 0;                      ///< of those rows
};

/// How pixels are held: all numbers of one type, or unknown: channels of types of their own.
struct Held {
    OIIO::TypeDesc type;
    size_t pixel; ///< bytes
};

/// Look at the file part.path. False with a failure unless it is a part's.
bool read_header(PartFile& part, Failure& failure);

/// Make the row of tiles with the pixels of row y the part's current one, held so, their channels
/// in the whole's order.
bool load(PartFile& part, int y, const Held& held, Failure& failure);

} // namespace ddt::tool

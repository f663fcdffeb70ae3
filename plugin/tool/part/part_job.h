// SPDX-License-Identifier: Apache-2.0
// What a part is made from and belongs to.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "core/tiles/grid.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/windows.h"
#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/part/part.h"
#include "plugin/tool/part/part_header.h"
#include "plugin/tool/resize/plan_result.h"

namespace ddt::tool {

/// The result that a part is of, as every part of it plans it. check_reader() is to be asked of the
/// source before.
struct PartJob {
    explicit PartJob(const std::string& in);
    const OIIO::ImageBuf& image() const { return file.image(); }
    Grid grid() const { return Grid(rect_of(image().roi())); }

    /// Look at the source and plan the result. False with a failure unless such a part can be made.
    bool plan(const ResizeSettings& settings, const Part& part, Failure& failure);

    const std::string path;
    const FileState state; ///< before anything was read
    LazyFile file;
    OIIO::ImageSpec from, whole; ///< the source and the result
    PartHeader header;
};

} // namespace ddt::tool

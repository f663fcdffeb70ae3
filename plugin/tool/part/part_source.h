// SPDX-License-Identifier: Apache-2.0
// The pixels that a part is made from.
#pragma once

#include <limits>
#include <memory>
#include <string>

#include <OpenImageIO/imagebuf.h>

#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/ids/id_file.h"
#include "plugin/tool/ids/mixed_ids.h"

namespace ddt::tool {

/// The image that strips are made from.
class PartSource {
public:
    /// `image`: of the file `path`, through the cache; `from`: its spec.
    PartSource(const std::string& path, const OIIO::ImageBuf& image, const OIIO::ImageSpec& from);

    /// Have all of it in memory, with the bits of its object IDs.
    bool open_whole(MixedIds& ids, Failure& failure);

    /// One that has those pixels, until the next call; null if they cannot be read.
    const OIIO::ImageBuf* strip(const Rect& shown, Failure& failure);

private:
    bool can_be_read(const Rect& shown, Failure& failure);

    const std::string m_path;
    const OIIO::ImageBuf& m_image;
    const bool m_only_ids; ///< of which the cache would make floats
    IdFile m_id_file;
    OIIO::ImageBuf m_ids, m_whole;
    std::unique_ptr<OIIO::ImageInput> m_check; ///< of rows in which the cache may pass over errors
    int m_checked = std::numeric_limits<int>::min(); ///< rows above
};

} // namespace ddt::tool

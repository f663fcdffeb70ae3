// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part_source.h"

#include <numeric>
#include <vector>

#include "plugin/image/channels.h"
#include "plugin/tool/file/open_image.h"

namespace ddt::tool {

PartSource::PartSource(const std::string& path, const OIIO::ImageBuf& image,
                       const OIIO::ImageSpec& from)
    : m_path(path), m_image(image), m_only_ids(is_id_type(from.format)) {
    if (!m_only_ids)
        return;
    std::vector<int> all(size_t(from.nchannels));
    std::iota(all.begin(), all.end(), 0);
    m_id_file = IdFile(path, 0, image, all);
}

bool PartSource::open_whole(MixedIds& ids, Failure& failure) {
    std::string error;
    if (open_image(m_path, m_whole, error) && ids.put_into(m_whole, error))
        return true;
    failure = {error, code_of_message(error)};
    return false;
}

const OIIO::ImageBuf* PartSource::strip(const Rect& shown, Failure& failure) {
    if (!m_only_ids)
        return m_whole.initialized() ? &m_whole : &m_image;
    std::string error;
    if (m_id_file.read(shown, m_ids, error))
        return &m_ids;
    failure = {error, code_of_message(error)};
    return nullptr;
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part_source.h"

#include <algorithm>
#include <numeric>
#include <vector>

#include "plugin/image/channels.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/read_native.h"
#include "plugin/tool/file/readable_pixels.h"

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

bool PartSource::can_be_read(const Rect& shown, Failure& failure) {
    if (!may_pass_over(std::string(m_image.file_format_name()), m_image.nativespec()))
        return true;
    std::string error;
    if (!m_check && !(m_check = open_input(m_path, 0, error))) {
        failure = unreadable(m_path, error);
        return false;
    }
    const Rect rows = readable(m_check->spec(), shown);
    const int begin = std::max(rows.y0, m_checked);
    if (begin > m_checked)
        go_to_row(*m_check, begin);
    m_checked = std::max(m_checked, rows.y1);
    if (begin >= rows.y1 || tool::can_be_read(*m_check, begin, rows.y1))
        return true;
    failure = unreadable(m_path, why_unreadable(m_check->geterror(), m_path));
    return false;
}

const OIIO::ImageBuf* PartSource::strip(const Rect& shown, Failure& failure) {
    if (!m_only_ids && m_whole.initialized())
        return &m_whole;
    if (!m_only_ids)
        return can_be_read(shown, failure) ? &m_image : nullptr;
    std::string error;
    if (m_id_file.read(shown, m_ids, error))
        return &m_ids;
    failure = {error, code_of_message(error)};
    return nullptr;
}

} // namespace ddt::tool

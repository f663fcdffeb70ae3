// SPDX-License-Identifier: Apache-2.0
#include "core/tiles/channel_groups.h"

#include <algorithm>

#include "core/base/constants.h"

namespace ddt {

int group_count(int channels) {
    return (channels + group_size - 1) / group_size;
}

int channels_in_group(int channels, int group) {
    return std::min(group_size, channels - group * group_size);
}

Channel kind_of(const Job& job, int channel) {
    return size_t(channel) < job.kinds.size() ? job.kinds[size_t(channel)] : Channel::blend;
}

bool any_nearest(const Job& job) {
    return std::find(job.kinds.begin(), job.kinds.end(), Channel::nearest) != job.kinds.end();
}

NearestMask nearest_mask(const Job& job, int group) {
    NearestMask mask = 0;
    for (int c = 0; c < channels_in_group(job.channels, group); ++c)
        if (kind_of(job, group * group_size + c) == Channel::nearest)
            mask |= 1u << c;
    return mask;
}

std::vector<int> bounded_channels(const Job& job) {
    std::vector<int> bounded;
    for (int c = 0; c < job.channels && job.surface.consistency > 0; ++c)
        if (kind_of(job, c) == Channel::alpha)
            bounded.push_back(c);
    return bounded;
}

} // namespace ddt

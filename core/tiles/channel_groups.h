// SPDX-License-Identifier: Apache-2.0
// A job's channels, and the groups in which they are worked on.
#pragma once

#include <vector>

#include "core/sample/evaluate.h"
#include "ddt/core.h"

namespace ddt {

/// Channels are worked on in groups of group_size.
int group_count(int channels);
int channels_in_group(int channels, int group);
/// What a channel is; also those past Job::channels in the last group are something.
Channel kind_of(const Job& job, int channel);
/// Whether any channel is Channel::nearest.
bool any_nearest(const Job& job);
/// Which channels of a job's group are Channel::nearest.
NearestMask nearest_mask(const Job& job, int group);
/// Which channels of a job are to be bounded by bound_alpha().
std::vector<int> bounded_channels(const Job& job);

} // namespace ddt

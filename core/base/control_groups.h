// SPDX-License-Identifier: Apache-2.0
// What Linux' control groups leave to this process: a container's share, or a batch job's.
//
// A limit holds for a group and for all within it, so the least of a group's and of those about it
// counts. Source: Linux, Documentation/admin-guide/cgroup-v2.rst and cgroup-v1/.
#pragma once

#include <cstdint>
#include <istream>
#include <string>

namespace ddt {

/// Where a process's groups are named, and where they are mounted.
constexpr const char *control_groups_file = "/proc/self/cgroup",
                     *control_groups_root = "/sys/fs/cgroup";

/// The memory in bytes, that is what `groups`, as control_groups_file, allows by the files below
/// `root`; the largest number if nothing limits it.
int64_t memory_of_groups(std::istream& groups, const std::string& root);

/// The processors, a part of one counted as a whole, that a quota of time is worth; the largest
/// number if there is none. Which processors may be used is not looked at: a process' affinity says
/// that.
int processors_of_groups(std::istream& groups, const std::string& root);

/// The same of this process; a quota as it was when first asked for.
int64_t memory_of_groups();
int processors_of_groups();

} // namespace ddt

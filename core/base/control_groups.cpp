// SPDX-License-Identifier: Apache-2.0
#include "core/base/control_groups.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <limits>
#include <locale>

namespace ddt {

namespace {

/// Whether a list with commas between has `word`.
bool has_word(const std::string& list, const std::string& word) {
    return ("," + list + ",").find("," + word + ",") != std::string::npos;
}

/// Call look(folder, second) for each folder of a group that limits what `controller` hands out.
/// second: its files are those of the second version.
template <class Look>
void each_group(std::istream& groups, const std::string& controller, const std::string& root,
                const Look& look) {
    // "0::/user.slice/..." of the second version, "4:cpu,cpuacct:/slurm/..." of the first.
    for (std::string line; std::getline(groups, line);) {
        const size_t name = line.find(':'), path = line.find(':', name + 1);
        if (name == std::string::npos || path == std::string::npos)
            continue;
        const std::string controllers = line.substr(name + 1, path - name - 1);
        const bool second = controllers.empty();
        if (!second && !has_word(controllers, controller))
            continue;
        const std::string mounted = second ? root : root + "/" + controller;
        // In a container the first is the root.
        for (std::filesystem::path group = line.substr(path + 1);; group = group.parent_path()) {
            look(mounted + group.string(), second);
            if (!group.has_relative_path())
                break;
        }
    }
}

/// The number that a file goes on with, if it is more than 0: elsewhere "max", or -1, stands for no
/// limit. Whatever locale the process has: in some a space is between the digits of one number.
bool read_limit(std::istream& file, int64_t& limit) {
    file.imbue(std::locale::classic());
    return file >> limit && limit > 0;
}

} // namespace

int64_t memory_of_groups(std::istream& groups, const std::string& root) {
    int64_t least = std::numeric_limits<int64_t>::max();
    each_group(groups, "memory", root, [&](const std::string& folder, bool second) {
        std::ifstream file(folder + (second ? "/memory.max" : "/memory.limit_in_bytes"));
        if (int64_t limit = 0; read_limit(file, limit))
            least = std::min(least, limit);
    });
    return least;
}

int processors_of_groups(std::istream& groups, const std::string& root) {
    int64_t least = std::numeric_limits<int>::max();
    each_group(groups, "cpu", root, [&](const std::string& folder, bool second) {
        int64_t time = 0, period = 0; // in microseconds: so much of each period
        if (second) {
            std::ifstream file(folder + "/cpu.max");
            if (!read_limit(file, time) || !read_limit(file, period))
                return;
        } else {
            std::ifstream of_time(folder + "/cpu.cfs_quota_us"),
                of_period(folder + "/cpu.cfs_period_us");
            if (!read_limit(of_time, time) || !read_limit(of_period, period))
                return;
        }
        least = std::min(least, (time - 1) / period + 1);
    });
    return int(least);
}

int64_t memory_of_groups() {
    std::ifstream groups(control_groups_file);
    return memory_of_groups(groups, control_groups_root);
}

int processors_of_groups() {
    static const int processors = [] {
        std::ifstream groups(control_groups_file);
        return processors_of_groups(groups, control_groups_root);
    }();
    return processors;
}

} // namespace ddt

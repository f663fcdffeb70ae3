// SPDX-License-Identifier: Apache-2.0
// Many files, several at a time.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ddt/progress.h"
#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/command/progress.h"

namespace ddt::tool {

struct FrameTask {
    std::string in, out;
};

struct FrameRun {
    int jobs = 1;               ///< frames at a time
    bool skip_existing = false; ///< leave out those whose `out` is there
    bool keep_going = false;    ///< go on with the others after one failed
    /// One frame. Called from several threads at once.
    std::function<bool(const FrameTask&, const ProgressCallback& progress, Failure&)> run;
    /// Whether what is there is what `run` would write; null: it is. Called from several threads at
    /// once.
    std::function<bool(const FrameTask&)> is_made;
    /// Bytes that a frame will take, about.
    std::function<int64_t(const FrameTask&)> memory_of;
};

struct FrameCounts {
    int written = 0, skipped = 0, failed = 0;
    /// exit_resources if a frame failed for want of them, else the first failure's.
    ExitCode code = exit_done;
};

/// Frames are taken in order. One waits while the others at work and itself would take more than
/// memory_allowed(); smaller ones may begin before it. Every failure is a line on stderr.
FrameCounts run_frames(const std::vector<FrameTask>& tasks, const FrameRun& run,
                       Progress& progress);

/// Three quarters of what this process may have: of the machine's memory, or of its control
/// groups' if that is less.
int64_t memory_allowed();

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace bench {

/// Run a program found on the PATH and wait for it; returns its exit status, or 127 if it could not
/// be started. No shell is involved.
int run_child(const std::vector<std::string>& arguments);

/// A folder of its own under the system's temporary one, removed with all in it at the end.
class ScratchFolder {
public:
    ScratchFolder();
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    /// A path in it; empty if the folder could not be made.
    std::string file(const std::string& name) const;

private:
    std::string m_path;
};

} // namespace bench

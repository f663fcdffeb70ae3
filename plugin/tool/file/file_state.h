// SPDX-License-Identifier: Apache-2.0
// Whether a file was written to meanwhile.
#pragma once

#include <string>

#include <sys/stat.h>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// What changes with a file's bytes: which file has the name, its size and the times of its last
/// changes; not its rights, nor what other names it has. Readers do not notice changes: they go on
/// with the bytes that they find.
class FileState {
public:
    /// To be made before anything is read.
    explicit FileState(const std::string& path);

    /// Whether what was read until now is of one file. A name of no file says nothing of changes: a
    /// pipe's times are those of reading it, and readers know names with a query.
    bool is_unchanged() const;

    /// The same of all that was to be read, if that is what was_read tells: a file that has gone
    /// since is no reason to give up what was made of it.
    bool is_of_one_file(bool was_read) const;

    /// What is to be said once all was read, and something was made of it or not: false with the
    /// failure that the file was changed, if it was; else `made`, and `failure` as it is. A failure
    /// that says to try again, or that the command line is wrong, stays as it is, too.
    bool confirm(bool made, Failure& failure) const;

private:
    bool is_file() const { return m_there && S_ISREG(m_state.st_mode); }

    std::string m_path;
    struct stat m_state {};
    bool m_there;
};

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
// Sequences: frames' numbers, and the names of their files.
#pragma once

#include <string>
#include <vector>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

constexpr const char* allowed_frames =
    "numbers and ranges such as 7, 1-100, 1-100x2 (every second), -5--1, several after commas; a "
    "million frames at most";

/// "1-100x2,200": the numbers as listed, each once; a range may count down. False for anything
/// else.
bool parse_frames(const std::string& text, std::vector<int>& frames);

/// A file's name with its frame, and perhaps its view, left open. As oiiotool has them: # is a
/// number of four digits, @ each one digit, %d and %04d as in printf, %V a view's name, %v its
/// first letter. Several # are a digit each, as elsewhere. Zeros fill up; the sign of a negative
/// number counts as a digit. Folders may have views, but no numbers.
class FrameName {
public:
    explicit FrameName(const std::string& text);
    bool has_frame() const { return m_digits >= 0; }
    bool has_view() const { return m_has_view; }
    /// The file of a frame and a view.
    std::string name(int frame, const std::string& view = "") const;
    /// The frames of which there is a file, for any of the views ({} or {""}: no views). False with
    /// a failure where a folder is there and its files cannot be listed.
    bool frames_there(const std::vector<std::string>& views, std::vector<int>& frames,
                      Failure& failure) const;

private:
    std::string m_before, m_after; ///< of the number
    int m_digits = -1;             ///< at least so many; -1: no number
    bool m_has_view = false;
};

} // namespace ddt::tool

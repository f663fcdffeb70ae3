// SPDX-License-Identifier: Apache-2.0
// The host's progress bar.
#pragma once

#include "plugin/openfx/suites.h"

namespace ddt::ofx {

/// A progress bar of an instance, while this lives; none where the host has none, or where another
/// render of the instance shows one: hosts allow one at a time.
class ProgressBar {
public:
    explicit ProgressBar(Effect effect);
    ~ProgressBar();
    ProgressBar(const ProgressBar&) = delete;
    ProgressBar& operator=(const ProgressBar&) = delete;

    /// False if the user has closed it. Natron also answers no while there is no bar yet, which its
    /// main thread makes when it likes: that is no wish to stop. Nor is a failure of the bar's,
    /// after which it is not asked again.
    bool update(float share);

private:
    Effect m_effect;
    bool m_shown, m_seen = false, m_broken = false;
};

} // namespace ddt::ofx

// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/progress_bar.h"

#include <mutex>
#include <set>

namespace ddt::ofx {

namespace {

/// The instances that show a bar. The host is never called under the lock: it may wait for its main
/// thread, which may wait here.
class Shown {
public:
    bool insert(Effect effect) {
        const std::lock_guard lock(m_mutex);
        return m_effects.insert(effect).second;
    }
    void erase(Effect effect) {
        const std::lock_guard lock(m_mutex);
        m_effects.erase(effect);
    }

private:
    std::mutex m_mutex;
    std::set<Effect> m_effects;
};

/// Never destroyed: hosts may render while static objects are being torn down.
Shown& shown = *new Shown;

} // namespace

ProgressBar::ProgressBar(Effect effect)
    : m_effect(effect), m_shown(suites.progress && shown.insert(effect)) {
    if (!m_shown || suites.progress->start(effect, "Enlarge (ddt)") == ok)
        return;
    shown.erase(effect);
    m_shown = false;
}

ProgressBar::~ProgressBar() {
    if (!m_shown)
        return;
    suites.progress->end(m_effect);
    shown.erase(m_effect);
}

bool ProgressBar::update(float share) {
    if (!m_shown || m_broken)
        return true;
    const int status = suites.progress->update(m_effect, double(share));
    m_seen |= status == ok;
    m_broken = status != ok && status != reply_no;
    return status != reply_no || !m_seen;
}

} // namespace ddt::ofx

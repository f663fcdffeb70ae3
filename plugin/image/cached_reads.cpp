// SPDX-License-Identifier: Apache-2.0
#include "plugin/image/cached_reads.h"

#include <map>
#include <mutex>
#include <utility>

#include <OpenImageIO/imagecache.h>

namespace ddt {
namespace {

/// A file of a cache. All of its subimages: the cache forgets them together.
using File = std::pair<const void*, OIIO::ustring>;

File file_of(const OIIO::ImageBuf& image) {
    return {&*image.imagecache(), OIIO::ustring(image.name())};
}

} // namespace

struct CachedReads::State {
    File file;
    int calls = 0;     ///< under way
    std::string error; ///< of the first that failed
};

class CachedReads::Registry {
public:
    State* enter(const File& file) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        State& state = m_files[file];
        state.file = file;
        ++state.calls;
        return &state;
    }
    /// Whether this is the last call of a file that failed, which has yet to leave.
    bool is_to_forget(const State& state) const {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return state.calls == 1 && !state.error.empty();
    }
    void leave(State& state) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        if (--state.calls == 0)
            m_files.erase(m_files.find(state.file));
    }
    std::string error(const State& state) const {
        const std::lock_guard<std::mutex> lock(m_mutex);
        return state.error;
    }
    void fail(const File& file, const std::string& error) {
        const std::lock_guard<std::mutex> lock(m_mutex);
        const auto found = m_files.find(file);
        if (found != m_files.end() && found->second.error.empty())
            found->second.error = error;
    }

    static Registry& the() {
        static auto* registry = new Registry; // files are read until a process's last moment
        return *registry;
    }

private:
    mutable std::mutex m_mutex;
    std::map<File, State> m_files;
};

CachedReads::CachedReads(const OIIO::ImageBuf& image) : m_image(image) {
    if (image.storage() == OIIO::ImageBuf::IMAGECACHE)
        m_state = Registry::the().enter(file_of(image));
}

CachedReads::~CachedReads() {
    if (!m_state)
        return;
    // Not while others read: what the cache knows of the file goes too. Nor under the registry's
    // lock: closing a file may wait for somebody who reads.
    if (Registry::the().is_to_forget(*m_state))
        try {
            m_image.imagecache()->invalidate(m_state->file.second, true);
        } catch (...) { // out of memory: a later call may be told nothing
        }
    Registry::the().leave(*m_state);
}

bool CachedReads::all_well(std::string& error) const {
    std::string why = m_state ? Registry::the().error(*m_state) : std::string();
    if (why.empty())
        return true;
    error = std::move(why);
    return false;
}

void CachedReads::fail(const OIIO::ImageBuf& image, const std::string& error) {
    Registry::the().fail(file_of(image), error);
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/tiff_write_errors.h"

#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <mutex>
#include <vector>

#include <dlfcn.h>
#include <sys/stat.h>

namespace ddt::tool {

namespace {

std::mutex listeners_lock; // of the texts they heard, too
std::vector<TiffWriteErrors*> listeners;

/// Whether something was not written: libtiff says much else of what it then writes all the same.
bool tells_of_writing(const char* format) {
    constexpr const char* parts[] = {"Write error", "rror writing", "Error updating",
                                     "Error fetching", "Seek error"};
    return std::any_of(std::begin(parts), std::end(parts),
                       [&](const char* part) { return std::strstr(format, part) != nullptr; });
}

/// As libtiff's own functions for files have it, the handle is a descriptor.
void hear(void* handle, const char*, const char* format, std::va_list values) {
    struct stat file {};
    if (!tells_of_writing(format) || fstat(int(reinterpret_cast<intptr_t>(handle)), &file) != 0)
        return;
    char said[256];
    std::vsnprintf(said, sizeof said, format, values);
    const std::lock_guard lock(listeners_lock);
    for (TiffWriteErrors* listener : listeners)
        if (listener->is_of(file.st_dev, file.st_ino))
            listener->hear(said);
}

/// libtiff is OpenImageIO's, and this program is not linked with it.
void listen_to_libtiff() {
    using Handler = void (*)(void*, const char*, const char*, std::va_list);
    using Set = Handler (*)(Handler);
    static const bool listens = [] {
        const auto set = reinterpret_cast<Set>(dlsym(RTLD_DEFAULT, "TIFFSetErrorHandlerExt"));
        if (set)
            set(hear);
        return set != nullptr;
    }();
    (void)listens;
}

} // namespace

TiffWriteErrors::TiffWriteErrors(int descriptor) {
    struct stat file {};
    if (fstat(descriptor, &file) != 0)
        return;
    m_device = file.st_dev;
    m_inode = file.st_ino;
    listen_to_libtiff();
    const std::lock_guard lock(listeners_lock);
    listeners.push_back(this);
}

TiffWriteErrors::~TiffWriteErrors() {
    const std::lock_guard lock(listeners_lock);
    listeners.erase(std::remove(listeners.begin(), listeners.end(), this), listeners.end());
}

std::string TiffWriteErrors::first() const {
    const std::lock_guard lock(listeners_lock);
    return m_first;
}

void TiffWriteErrors::hear(const char* said) {
    if (!m_first[0])
        std::strncpy(m_first, said, sizeof m_first - 1);
}

} // namespace ddt::tool

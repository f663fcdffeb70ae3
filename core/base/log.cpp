// SPDX-License-Identifier: Apache-2.0
#include "core/base/log.h"

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <utility>

#include "core/base/one_line.h"

namespace ddt {

namespace {

/// The callback in use, or null. Never freed: threads may outlive main().
struct Log {
    std::mutex mutex;
    std::shared_ptr<const LogCallback> callback;
};
Log& the_log() {
    static auto* made = new Log;
    return *made;
}

std::shared_ptr<const LogCallback> current() {
    const std::lock_guard<std::mutex> lock(the_log().mutex);
    return the_log().callback;
}

bool wanted_on_stderr() {
    const char* value = std::getenv("DDT_VERBOSE");
    return value && *value && *value != '0';
}

} // namespace

void set_log(LogCallback callback) {
    auto made = callback ? std::make_shared<const LogCallback>(std::move(callback)) : nullptr;
    const std::lock_guard<std::mutex> lock(the_log().mutex);
    the_log().callback.swap(made);
}

bool verbose() {
    return current() || wanted_on_stderr();
}

void say(const char* format, ...) noexcept {
    char text[4096]; // drivers' logs are up to 2 KB
    va_list arguments;
    va_start(arguments, format);
    std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    try {
        const std::string line = one_line(text);
        if (const auto callback = current())
            (*callback)(line.c_str());
        else if (wanted_on_stderr())
            std::fprintf(stderr, "%s\n", line.c_str());
    } catch (...) {
    }
}

} // namespace ddt

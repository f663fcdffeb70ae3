// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/exit_code.h"

#include <cerrno>
#include <cstring>
#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <system_error>
#include <vector>

#include "core/base/one_line.h"
#include "plugin/colour/space_light.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/memory.h"

namespace ddt::tool {

namespace {

/// Whether the quote there may be the first of two.
bool opens(const std::string& message, size_t at) {
    const auto is_one_of = [](const char* some, char c) { return std::strchr(some, c) != nullptr; };
    return is_one_of(" (", message[at - 1]) && at + 1 < message.size() &&
           !is_one_of(" :,;)", message[at + 1]);
}

/// Where the text in double quotes that begins at `open` ends: at the last quote before another
/// such text begins, as names of files may have quotes within. npos if nothing ends it.
size_t end_of_quoted(const std::string& message, size_t open) {
    size_t end = std::string::npos;
    for (size_t at = open; (at = message.find('"', at + 1)) != std::string::npos;) {
        if (!opens(message, at))
            end = at;
        else if (end != std::string::npos)
            break;
    }
    return end;
}

/// Whether a text says that something is wanting.
bool tells_of_want(const std::string& text) {
    // Of the library: memory that ran out, images that another machine may have memory for (see
    // check_size() in plugin/image/memory.h), devices that this one has not; of libtiff and of
    // OpenImageIO's writers: a full disk; of libtiff: a read that failed, or a table there was
    // no memory for; of OpenEXR: what it had no memory for; of OpenEXR's threads, of zlib's
    // compress() and of what a reader was thrown: there are no more, or no memory; of ours: a
    // file that another took the place of.
    for (const char* said :
         {out_of_memory_text, machine_memory_text, unavailable_text, "Write error at ",
          "Write error: wrote", "; got -1 bytes", "Out of memory reading of ",
          "Failed to allocate memory", "std::bad_alloc", "Data compression (zlib) failed",
          "Resource temporarily unavailable", changed_text})
        if (text.find(said) != std::string::npos)
            return true;
    return false;
}

void erase_all(std::string& text, const std::string& part) {
    for (size_t at = 0; (at = text.find(part, at)) != std::string::npos;)
        text.erase(at, part.size());
}

/// The message without what is in double quotes: names, which may say anything. One that misleads
/// does not stay without quotes either, as the readers of WebP and FITS repeat it.
std::string without_names(const std::string& message) {
    std::string rest;
    std::vector<std::string> misleading;
    size_t from = 0;
    for (size_t open; (open = message.find('"', from)) != std::string::npos;) {
        const size_t end = end_of_quoted(message, open);
        if (end == std::string::npos)
            break;
        rest.append(message, from, open - from);
        from = end + 1;
        if (const std::string name = message.substr(open + 1, end - open - 1); tells_of_want(name))
            misleading.push_back(name);
    }
    rest.append(message, from);
    for (const std::string& name : misleading)
        erase_all(rest, name);
    return rest;
}

/// Whether it says that a filter's option light= names none, which the library alone knows. The
/// names that follow are not in quotes, and may have some.
bool tells_of_unknown_light(const std::string& message) {
    const size_t at = message.rfind(allowed_lights_text);
    if (at == std::string::npos)
        return false;
    const std::string before = message.substr(0, at);
    const bool in_a_name = without_names(before).find('"') != std::string::npos ||
                           before.find(allowed_lights_text) != std::string::npos;
    return !in_a_name;
}

} // namespace

ExitCode code_of_errno(int number) {
    switch (number) {
    case ENOSPC:
    case EDQUOT:
    case EFBIG:
    case EIO:
    case ENOMEM:
    case EMFILE:
    case ENFILE:
    case EAGAIN:
    case EINTR:
    case EBUSY:
    case ENOLCK:
    case ENODEV:
    // Of a file system on a network:
    case ESTALE:
    case ETIMEDOUT:
    case ENOTCONN:
    case ECONNABORTED:
    case ECONNRESET:
    case ESHUTDOWN:
    case EHOSTDOWN:
    case EHOSTUNREACH:
    case ENETDOWN:
    case ENETUNREACH:
    case EREMOTEIO:
    case EKEYEXPIRED:
        return exit_resources;
    default:
        return exit_failed;
    }
}

Failure thrown() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return {out_of_memory_text, exit_resources};
    } catch (const std::length_error&) { // of a size that no vector can have
        return {out_of_memory_text, exit_resources};
    } catch (const std::system_error& e) {
        const int number = e.code().value();
        return {number == EAGAIN ? "no more threads can be started" : e.what(),
                code_of_errno(number)};
    } catch (const std::exception& e) {
        return {e.what(), code_of_message(e.what())};
    }
}

ExitCode code_of_message(const std::string& message) {
    if (tells_of_unknown_light(message))
        return exit_usage;
    return tells_of_want(without_names(message)) ? exit_resources : exit_failed;
}

} // namespace ddt::tool

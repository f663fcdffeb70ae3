// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/exit_code.h"

#include <cerrno>
#include <exception>
#include <new>
#include <stdexcept>
#include <system_error>

namespace ddt::tool {

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
        return {"out of memory", exit_resources};
    } catch (const std::length_error&) { // of a size that no vector can have
        return {"out of memory", exit_resources};
    } catch (const std::system_error& e) {
        const int number = e.code().value();
        return {number == EAGAIN ? "no more threads can be started" : e.what(),
                code_of_errno(number)};
    } catch (const std::exception& e) {
        return {e.what(), code_of_message(e.what())};
    }
}

ExitCode code_of_message(const std::string& message) {
    // Of the library: memory that ran out, images that another machine may have memory for (see
    // check_size in plugin/image/windows.h), devices that this one has not; of libtiff and of
    // OpenImageIO's writers: a full disk; of OpenEXR's threads, of zlib's compress() and of what a
    // reader was thrown: there are no more, or no memory; of ours: a file that another took the
    // place of.
    for (const char* said :
         {"out of memory", "this machine's memory", " is unavailable: ", "Write error at ",
          "Write error: wrote", "std::bad_alloc", "Data compression (zlib) failed",
          "Resource temporarily unavailable", "was changed while it was read"})
        if (message.find(said) != std::string::npos)
            return exit_resources;
    return exit_failed;
}

} // namespace ddt::tool

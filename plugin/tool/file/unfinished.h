// SPDX-License-Identifier: Apache-2.0
// Files that go when a signal, or want of memory, ends the program.
#pragma once

#include <csignal>
#include <string>

namespace ddt::tool {

/// From now on SIGINT, SIGTERM and the other signals that end a program, except SIGKILL and those
/// of its own faults (SIGSEGV), remove the files listed, and then end it as they would have.
/// SIGXFSZ and SIGPIPE are ignored: writing fails instead, which is told. A library that ends the
/// program by exit() leaves none either. Once, at the start.
void remove_unfinished_on_signals();

/// Remove them now, and from now on: for a program that ends at once. If several threads call it,
/// only the first returns.
void remove_unfinished();

/// Remove them and end with exit_resources and one line, for which no memory is needed.
[[noreturn]] void end_without_memory();

/// While one of these is there, a signal waits: between the making of a file and its listing nobody
/// would remove it. For a moment only. Thread-safe.
class SignalsWait {
public:
    SignalsWait();
    ~SignalsWait();
    SignalsWait(const SignalsWait&) = delete;
    SignalsWait& operator=(const SignalsWait&) = delete;

private:
    sigset_t m_before;
};

/// While one of these is there, the program ends when memory runs out, by end_without_memory(). For
/// what would never end otherwise: OpenImageIO 2.4's image cache keeps a tile that no memory was
/// found for as one that is being read, and all who need it wait. Thread-safe, as long as nobody
/// else sets the handler that is called then.
class EndsWithoutMemory {
public:
    EndsWithoutMemory();
    ~EndsWithoutMemory();
    EndsWithoutMemory(const EndsWithoutMemory&) = delete;
    EndsWithoutMemory& operator=(const EndsWithoutMemory&) = delete;
};

/// List the file that has this name now, which is to stay open: if another has it by then, that one
/// is not removed. A number for unlist_unfinished(), or -1 if there is none or the list is full (64
/// at once). Thread-safe.
int list_unfinished(const std::string& path);
void unlist_unfinished(int number);

} // namespace ddt::tool

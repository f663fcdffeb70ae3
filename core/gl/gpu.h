// SPDX-License-Identifier: Apache-2.0
// A device that work can be given to.
#pragma once

#include <atomic>
#include <memory>
#include <string>

#include "core/gl/check/self_checks.h"
#include "core/gl/context/context.h"
#include "core/gl/context/thread.h"
#include "core/gl/programs.h"
#include "ddt/core.h"

namespace ddt::gl {

/// A context on its thread. One a process and kind, opened at the first job that wants it, never
/// closed. What is told of the device (`block_limit`, `open_milliseconds`, the context's texts and
/// flags) never changes once open() returned it, and is for any thread; so are `thread` and
/// `broken`. `context->gl`, `programs` and `checks` are for that thread.
struct Gpu {
    Thread thread;
    std::unique_ptr<Context> context;
    std::unique_ptr<Programs> programs;
    SelfChecks checks;
    size_t block_limit = 0; ///< bytes a storage block may have
    double open_milliseconds = 0;
    std::atomic<bool> broken{false}; ///< lost: of no more use
};

/// The device for Device::egl or Device::osmesa, or with Device::automatic a hardware device. Null
/// if it cannot be had: `why` says which library or call failed, and for what version.
///
/// Thread-safe. In a process forked from one that had a device there is none, since drivers do not
/// survive a fork; `forked` is then true.
Gpu* open(Device device, std::string& why, bool& forked);

/// Whether open() has been asked for that device before, so that it takes no time now.
bool is_open(Device device);

/// Source pixels for each thread that the CPU has worked on so far, in this process, in jobs that a
/// GPU would have done sooner had it been open.
std::atomic<size_t>& missed_pixels();

/// True the first time that this process asks: why it has no GPU is told once, not with each job.
bool first_told_of_cpu();

} // namespace ddt::gl

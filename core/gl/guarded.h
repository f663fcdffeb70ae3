// SPDX-License-Identifier: Apache-2.0
// The boundary of core/gl: no Failure passes it, and a device that was lost is not used again.
#pragma once

#include <string>
#include <utility>

#include "core/gl/context/failure.h"
#include "core/gl/gpu.h"

namespace ddt::gl {

/// f(), which returns an empty text or what the GPU failed at; that it threw a Failure counts as
/// the latter.
template <class F>
std::string guarded_on(Gpu& gpu, F&& f) {
    try {
        return std::forward<F>(f)();
    } catch (const ContextLost& e) {
        gpu.broken = true;
        return e.what();
    } catch (const Failure& e) {
        return e.what();
    }
}

} // namespace ddt::gl

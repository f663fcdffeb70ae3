// SPDX-License-Identifier: Apache-2.0
// Memory of the host from which and to which the device copies.
#pragma once

#include <cstddef>
#include <memory>

#include "core/gl/buffer.h"

namespace ddt::gl {

/// Where the driver can (OpenGL 4.4), pinned and mapped for as long as it exists: the device copies
/// by itself, and the thread that asked for it goes on. Elsewhere plain memory, and copying may
/// wait.
class HostBuffer {
public:
    /// Of plain memory.
    explicit HostBuffer(size_t bytes);
    /// To be made and destroyed on the context's thread.
    HostBuffer(const Functions& gl, size_t bytes);
    ~HostBuffer();
    HostBuffer(const HostBuffer&) = delete;
    HostBuffer& operator=(const HostBuffer&) = delete;

    size_t bytes() const { return m_bytes; }
    std::byte* data() { return m_data; }
    const std::byte* data() const { return m_data; }

    // On the context's thread:

    /// Have `bytes` from `from` on copied to `to`, from `at` on. They must stay as they are until a
    /// Fence placed afterwards has passed.
    void upload(size_t from, size_t bytes, const Buffer& to, size_t at) const;
    /// Have the first bytes of `from`, which shaders wrote, copied here: they are here when a Fence
    /// placed afterwards has passed.
    void download(const Functions& gl, const Buffer& from, size_t bytes);

private:
    const Functions* m_gl = nullptr;
    GLuint m_name = 0;
    size_t m_bytes;
    std::unique_ptr<std::byte[]> m_plain;
    std::byte* m_data = nullptr;
};

} // namespace ddt::gl

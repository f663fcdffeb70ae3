// SPDX-License-Identifier: Apache-2.0
// Buffers on the device.
#pragma once

#include <cstddef>

#include "core/gl/context/functions.h"
#include "core/gl/program_interface.h"

namespace ddt::gl {

/// A buffer of a fixed size in the device's own memory. Where the driver can (OpenGL 4.4), it is
/// one that the host cannot touch, and what is written and read goes by way of another: a driver
/// that sees the host read a buffer may move it to the host's memory for good, and every shader
/// after that goes over the bus. To be made, used and destroyed on the context's thread.
class Buffer {
public:
    /// Throws what check() does, OutOfMemory where there is none. A size of 0 is rounded up.
    Buffer(const Functions& gl, size_t bytes);
    ~Buffer();
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;

    size_t bytes() const { return m_bytes; }
    GLuint name() const { return m_name; }

    void bind(Binding binding) const;
    void bind_uniform(UniformBinding binding) const;
    /// Throws Failure if what goes there finds no memory on the way.
    void write(size_t offset, size_t bytes, const void* data) const;
    /// Read, also what shaders wrote. Waits, as finish() does, for all that was asked of the
    /// device. Throws Failure if it cannot be read.
    void read(size_t offset, size_t bytes, void* data) const;
    void clear() const { fill(0); }

private:
    void fill(GLuint word) const;
    const Functions& m_gl;
    GLuint m_name = 0;
    size_t m_bytes;
    bool m_out_of_reach; ///< of the host
};

/// While there is one on a thread, buffers made there begin with NaN everywhere: a check must not
/// find what the same program wrote into the same memory before.
class FilledBuffers {
public:
    static constexpr GLuint word = 0xffd1d1d1u;
    FilledBuffers();
    ~FilledBuffers();
    FilledBuffers(const FilledBuffers&) = delete;
    FilledBuffers& operator=(const FilledBuffers&) = delete;

private:
    bool m_before;
};

/// Have the device copy `bytes` from one buffer, told by its name, to another.
void copy(const Functions& gl, GLuint from, size_t from_offset, GLuint to, size_t to_offset,
          size_t bytes);

/// Throw ContextLost, OutOfMemory or Failure if GL has recorded an error; `where` names the step.
void check(const Functions& gl, const char* where);

/// A point in what is asked of the device: all that was asked before it was made, which the device
/// begins with at once.
class Fence {
public:
    explicit Fence(const Functions& gl);
    ~Fence();
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    /// Wait until the device is there, then check(). One that does not get there within half a
    /// minute counts as lost. Throws Failure where it cannot be waited for.
    void wait(const char* where);

private:
    const Functions& m_gl;
    GLsync m_sync;
};

/// Wait until the device has done all that was asked of it.
void finish(const Functions& gl, const char* where);

} // namespace ddt::gl

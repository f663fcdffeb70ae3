// SPDX-License-Identifier: Apache-2.0
#include "core/gl/buffer.h"

#include <algorithm>
#include <string>

#include "core/gl/context/failure.h"
#include "core/gl/context/faults.h"

namespace ddt::gl {

namespace {

thread_local bool g_filled = false; ///< new buffers are (FilledBuffers)

/// The name of a buffer, which is given back with it.
class Name {
public:
    explicit Name(const Functions& gl) : m_gl(gl) { gl.GenBuffers(1, &m_name); }
    ~Name() { m_gl.DeleteBuffers(1, &m_name); }
    Name(const Name&) = delete;
    Name& operator=(const Name&) = delete;

    operator GLuint() const { return m_name; }

private:
    const Functions& m_gl;
    GLuint m_name = 0;
};

/// A buffer on its way from or to the host.
struct Passing {
    Passing(const Functions& gl, size_t bytes, const void* data, GLenum usage) : name(gl) {
        if (strikes(Fault::allocation))
            throw OutOfMemory("glBufferData for what travels: out of memory");
        gl.BindBuffer(GL_COPY_READ_BUFFER, name);
        gl.BufferData(GL_COPY_READ_BUFFER, GLsizeiptr(bytes), data, usage);
        check(gl, "glBufferData for what travels");
    }

    const Name name;
};

/// Whether the context says that it is lost.
bool was_reset(const Functions& gl) {
    return gl.GetGraphicsResetStatus && gl.GetGraphicsResetStatus() != GL_NO_ERROR;
}

/// Throw what an error that GL has recorded means.
[[noreturn]] void fail(const std::string& where, GLenum error) {
    const std::string message = where + ": " + error_name(error);
    if (error == GL_CONTEXT_LOST)
        throw ContextLost(message);
    if (error == GL_OUT_OF_MEMORY)
        throw OutOfMemory(message);
    throw Failure(message);
}

} // namespace

Buffer::Buffer(const Functions& gl, size_t bytes)
    : m_gl(gl), m_bytes(std::max<size_t>(bytes, 16)), m_out_of_reach(gl.BufferStorage != nullptr) {
    check(gl, "before a buffer is made");
    if (strikes(Fault::allocation))
        throw OutOfMemory("glBufferData: out of memory");
    gl.GenBuffers(1, &m_name);
    gl.BindBuffer(GL_SHADER_STORAGE_BUFFER, m_name);
    const auto size = GLsizeiptr(m_bytes);
    if (m_out_of_reach)
        gl.BufferStorage(GL_SHADER_STORAGE_BUFFER, size, nullptr, 0);
    else
        gl.BufferData(GL_SHADER_STORAGE_BUFFER, size, nullptr, GL_DYNAMIC_COPY);
    const GLenum error = gl.GetError();
    if (error == GL_NO_ERROR) {
        if (g_filled)
            fill(FilledBuffers::word);
        return;
    }
    gl.DeleteBuffers(1, &m_name);
    // A device that is gone may say that it has no memory; fewer tiles would not help.
    fail("a buffer of " + std::to_string(m_bytes) + " bytes",
         was_reset(gl) ? GLenum(GL_CONTEXT_LOST) : error);
}

Buffer::~Buffer() {
    m_gl.DeleteBuffers(1, &m_name);
}

void Buffer::bind(Binding binding) const {
    m_gl.BindBufferBase(GL_SHADER_STORAGE_BUFFER, GLuint(binding), m_name);
}

void Buffer::bind_uniform(UniformBinding binding) const {
    m_gl.BindBufferBase(GL_UNIFORM_BUFFER, GLuint(binding), m_name);
}

void Buffer::write(size_t offset, size_t bytes, const void* data) const {
    if (m_out_of_reach) {
        const Passing from(m_gl, bytes, data, GL_STREAM_DRAW);
        return copy(m_gl, from.name, 0, m_name, offset, bytes);
    }
    m_gl.BindBuffer(GL_COPY_WRITE_BUFFER, m_name);
    m_gl.BufferSubData(GL_COPY_WRITE_BUFFER, GLintptr(offset), GLsizeiptr(bytes), data);
}

void Buffer::read(size_t offset, size_t bytes, void* data) const {
    m_gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    // Reading waits for what writes to the buffer, for ever if that does not end.
    finish(m_gl, "before a buffer is read");
    if (m_out_of_reach) {
        const Passing to(m_gl, bytes, nullptr, GL_STREAM_READ);
        copy(m_gl, m_name, offset, to.name, 0, bytes);
        m_gl.GetBufferSubData(GL_COPY_WRITE_BUFFER, 0, GLsizeiptr(bytes), data);
    } else {
        m_gl.BindBuffer(GL_COPY_READ_BUFFER, m_name);
        m_gl.GetBufferSubData(GL_COPY_READ_BUFFER, GLintptr(offset), GLsizeiptr(bytes), data);
    }
    // Else `data` is what it was, and nobody would know.
    check(m_gl, "glGetBufferSubData");
}

void Buffer::fill(GLuint word) const {
    m_gl.BindBuffer(GL_COPY_WRITE_BUFFER, m_name);
    m_gl.ClearBufferData(GL_COPY_WRITE_BUFFER, GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT, &word);
}

FilledBuffers::FilledBuffers() : m_before(g_filled) {
    g_filled = true;
}

FilledBuffers::~FilledBuffers() {
    g_filled = m_before;
}

void copy(const Functions& gl, GLuint from, size_t from_offset, GLuint to, size_t to_offset,
          size_t bytes) {
    gl.BindBuffer(GL_COPY_READ_BUFFER, from);
    gl.BindBuffer(GL_COPY_WRITE_BUFFER, to);
    gl.CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, GLintptr(from_offset),
                         GLintptr(to_offset), GLsizeiptr(bytes));
}

void check(const Functions& gl, const char* where) {
    if (strikes(Fault::lost) || was_reset(gl))
        throw ContextLost(std::string(where) + ": the context was lost");
    if (const GLenum error = gl.GetError(); error != GL_NO_ERROR)
        fail(where, error);
}

Fence::Fence(const Functions& gl)
    : m_gl(gl), m_sync(gl.FenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0)) {
    gl.Flush();
}

Fence::~Fence() {
    if (m_sync)
        m_gl.DeleteSync(m_sync);
}

void Fence::wait(const char* where) {
    constexpr GLuint64 half_a_minute = 30'000'000'000u;
    const GLenum state =
        m_sync ? m_gl.ClientWaitSync(m_sync, GL_SYNC_FLUSH_COMMANDS_BIT, half_a_minute)
               : GLenum(GL_WAIT_FAILED);
    check(m_gl, where);
    if (state == GL_TIMEOUT_EXPIRED)
        throw ContextLost(std::string(where) + ": the device does not answer");
    // What was to be copied may still be on its way, also where GL records no error.
    if (state != GL_ALREADY_SIGNALED && state != GL_CONDITION_SATISFIED)
        throw Failure(std::string(where) + ": the device cannot be waited for");
}

void finish(const Functions& gl, const char* where) {
    Fence(gl).wait(where);
}

} // namespace ddt::gl

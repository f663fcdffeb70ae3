// SPDX-License-Identifier: Apache-2.0
#include "core/gl/host_buffer.h"

#include <algorithm>

namespace ddt::gl {

HostBuffer::HostBuffer(size_t bytes) : m_bytes(std::max<size_t>(bytes, 1)) {
    m_plain.reset(new std::byte[m_bytes]); // not filled: make_unique would
    m_data = m_plain.get();
}

HostBuffer::HostBuffer(const Functions& gl, size_t bytes)
    : m_gl(&gl), m_bytes(std::max<size_t>(bytes, 1)) {
    if (gl.BufferStorage) {
        constexpr GLbitfield access =
            GL_MAP_READ_BIT | GL_MAP_WRITE_BIT | GL_MAP_PERSISTENT_BIT | GL_MAP_COHERENT_BIT;
        check(gl, "before glBufferStorage");
        gl.GenBuffers(1, &m_name);
        gl.BindBuffer(GL_COPY_WRITE_BUFFER, m_name);
        gl.BufferStorage(GL_COPY_WRITE_BUFFER, GLsizeiptr(m_bytes), nullptr,
                         access | GL_CLIENT_STORAGE_BIT);
        // Asked after each: an error of either that stayed would be a later call's.
        const bool stored = gl.GetError() == GL_NO_ERROR;
        if (stored)
            m_data = static_cast<std::byte*>(
                gl.MapBufferRange(GL_COPY_WRITE_BUFFER, 0, GLsizeiptr(m_bytes), access));
        if (stored && gl.GetError() == GL_NO_ERROR && m_data)
            return;
        // What can be pinned has limits of its own.
        gl.DeleteBuffers(1, &m_name);
        m_name = 0;
    }
    m_plain.reset(new std::byte[m_bytes]);
    m_data = m_plain.get();
}

HostBuffer::~HostBuffer() {
    if (m_name)
        m_gl->DeleteBuffers(1, &m_name); // and is no longer mapped
}

void HostBuffer::upload(size_t from, size_t bytes, const Buffer& to, size_t at) const {
    if (m_name)
        copy(*m_gl, m_name, from, to.name(), at, bytes);
    else
        to.write(at, bytes, m_data + from);
}

void HostBuffer::download(const Functions& gl, const Buffer& from, size_t bytes) {
    if (!m_name)
        return from.read(0, bytes, m_data);
    gl.MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    copy(gl, from.name(), 0, m_name, 0, bytes);
}

} // namespace ddt::gl

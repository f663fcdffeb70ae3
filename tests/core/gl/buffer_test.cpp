// SPDX-License-Identifier: Apache-2.0
#include "core/gl/buffer.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "core/gl/context/failure.h"
#include "core/gl/context/faults.h"
#include "tests/core/gl/devices.h"

namespace ddt::test {
namespace {

class Buffers : public OnDevice {
protected:
    void TearDown() override { gl::forget_devices(); }

    /// Do it on the device's thread, twice: with OpenGL 4.4's buffers, and as before it.
    template <class F>
    void on_both_kinds(F f) {
        for (const bool storage : {true, false}) {
            SCOPED_TRACE(storage ? "out of the host's reach" : "plain");
            gl::Gpu& gpu = fresh_device();
            gpu.thread
                .post([&] {
                    gl::Functions& gl = gpu.context->gl;
                    EXPECT_NE(gl.BufferStorage, nullptr);
                    if (!storage)
                        gl.BufferStorage = nullptr;
                    f(gl);
                    gl::check(gl, "a test");
                })
                .get();
        }
    }

    static std::vector<uint32_t> words_of(const gl::Buffer& buffer) {
        std::vector<uint32_t> words(buffer.bytes() / sizeof(uint32_t));
        buffer.read(0, buffer.bytes(), words.data());
        return words;
    }
};

TEST_P(Buffers, KeepWhatIsWritten) {
    on_both_kinds([](const gl::Functions& gl) {
        const gl::Buffer buffer(gl, 400);
        buffer.clear();
        std::vector<uint32_t> expected(100, 0), part(30);
        std::iota(part.begin(), part.end(), 1000u);
        buffer.write(20 * sizeof(uint32_t), part.size() * sizeof(uint32_t), part.data());
        std::copy(part.begin(), part.end(), expected.begin() + 20);
        EXPECT_EQ(words_of(buffer), expected);
        std::vector<uint32_t> middle(10);
        buffer.read(45 * sizeof(uint32_t), middle.size() * sizeof(uint32_t), middle.data());
        EXPECT_EQ(middle, std::vector<uint32_t>(expected.begin() + 45, expected.begin() + 55));
    });
}

TEST_P(Buffers, AreFilledWhereAskedFor) {
    on_both_kinds([](const gl::Functions& gl) {
        const std::vector<uint32_t> filled(100, gl::FilledBuffers::word);
        {
            const gl::FilledBuffers outer;
            { const gl::FilledBuffers inner; }
            EXPECT_EQ(words_of(gl::Buffer(gl, 400)), filled);
        }
        const gl::Buffer later(gl, 400);
        later.clear(); // what it begins with is the driver's affair
        EXPECT_EQ(words_of(later), std::vector<uint32_t>(100, 0));
    });
}

TEST_P(Buffers, SayWhenThereIsNoMemoryForWhatTravels) {
    gl::Gpu& gpu = fresh_device();
    gpu.thread
        .post([&] {
            const gl::Buffer buffer(gpu.context->gl, 400);
            buffer.clear();
            const std::vector<uint32_t> zeros(100, 0);
            std::vector<uint32_t> found(100, 7);
            gl::arm(gl::Fault::allocation, 1, 2);
            EXPECT_THROW(buffer.write(0, 400, found.data()), gl::OutOfMemory);
            EXPECT_THROW(buffer.read(0, 400, found.data()), gl::OutOfMemory);
            gl::arm(gl::Fault::allocation, 0);
            EXPECT_EQ(words_of(buffer), zeros);
        })
        .get();
}

TEST_P(Buffers, SayWhenTheyCannotBeRead) {
    on_both_kinds([](const gl::Functions& gl) {
        const gl::Buffer buffer(gl, 400);
        std::vector<uint32_t> found(200);
        EXPECT_THROW(buffer.read(8, 400, found.data()), gl::Failure) << "past its end";
        EXPECT_EQ(gl.GetError(), GLenum(GL_NO_ERROR)) << "told of twice";
    });
}

GLenum g_error;
bool g_failed;
GLenum APIENTRY one_error() {
    g_failed |= g_error != GL_NO_ERROR;
    return std::exchange(g_error, GLenum(GL_NO_ERROR));
}
// Once it has failed.
GLenum APIENTRY reset_after_error() {
    return g_failed ? GLenum(GL_UNKNOWN_CONTEXT_RESET) : GLenum(GL_NO_ERROR);
}

// Fewer tiles help where there is no memory, and nothing where the device is gone.
TEST_P(Buffers, ThatCannotBeHadSayWhy) {
    on_both_kinds([](const gl::Functions& right) {
        gl::Functions gl = right;
        const auto get_error = gl.GetError;
        const auto make = [&](GLenum error) {
            // Not before it is made.
            static PFNGLGENBUFFERSPROC gen_buffers;
            static GLenum next_error;
            gen_buffers = right.GenBuffers;
            next_error = error;
            g_failed = false;
            gl.GenBuffers = [](GLsizei n, GLuint* names) {
                gen_buffers(n, names);
                g_error = next_error;
            };
            gl.GetError = one_error;
            const gl::Buffer buffer(gl, 400);
        };
        EXPECT_NO_THROW(make(GL_NO_ERROR));
        EXPECT_THROW(make(GL_OUT_OF_MEMORY), gl::OutOfMemory);
        EXPECT_THROW(make(GL_CONTEXT_LOST), gl::ContextLost);
        try {
            make(GL_INVALID_VALUE);
            ADD_FAILURE() << "an error that is none";
        } catch (const gl::Failure& e) {
            EXPECT_EQ(dynamic_cast<const gl::OutOfMemory*>(&e), nullptr) << e.what();
            EXPECT_NE(std::string(e.what()).find("400 bytes"), std::string::npos) << e.what();
        }
        gl.GetGraphicsResetStatus = reset_after_error;
        EXPECT_NO_THROW(make(GL_NO_ERROR));
        EXPECT_THROW(make(GL_OUT_OF_MEMORY), gl::ContextLost) << "and the context says so";
        EXPECT_EQ(get_error(), GLenum(GL_NO_ERROR));
    });
}

GLenum g_state;
GLenum APIENTRY wait_sync(GLsync, GLbitfield, GLuint64) {
    return g_state;
}
GLsync APIENTRY no_fence(GLenum, GLbitfield) {
    return nullptr;
}

// Else what is on its way would be read before it is there.
TEST_P(Buffers, AreNotReadBeforeAFenceThatCannotBeWaitedFor) {
    gl::Gpu& gpu = fresh_device();
    gpu.thread
        .post([&] {
            gl::Functions gl = gpu.context->gl;
            EXPECT_NO_THROW(gl::finish(gl, "a test"));
            gl.ClientWaitSync = wait_sync;
            for (const GLenum passed : {GL_ALREADY_SIGNALED, GL_CONDITION_SATISFIED}) {
                g_state = passed;
                EXPECT_NO_THROW(gl::finish(gl, "a test"));
            }
            g_state = GL_TIMEOUT_EXPIRED;
            EXPECT_THROW(gl::finish(gl, "a test"), gl::ContextLost);
            g_state = GL_WAIT_FAILED; // and no error is recorded
            EXPECT_THROW(gl::finish(gl, "a test"), gl::Failure);
            g_state = GL_CONDITION_SATISFIED;
            gl.FenceSync = no_fence;
            EXPECT_THROW(gl::finish(gl, "a test"), gl::Failure);
        })
        .get();
}

bool g_read;
void APIENTRY get_buffer(GLenum, GLintptr, GLsizeiptr, void*) {
    g_read = true;
}

// A driver may wait for ever for what writes to it.
TEST_P(Buffers, AreNotReadFromADeviceThatDoesNotAnswer) {
    on_both_kinds([](const gl::Functions& right) {
        gl::Functions gl = right;
        const gl::Buffer buffer(gl, 400);
        std::vector<uint32_t> found(100);
        gl.GetBufferSubData = get_buffer;
        gl.ClientWaitSync = wait_sync;
        g_read = false;
        g_state = GL_TIMEOUT_EXPIRED;
        EXPECT_THROW(buffer.read(0, 400, found.data()), gl::ContextLost);
        EXPECT_FALSE(g_read);
        g_state = GL_ALREADY_SIGNALED;
        EXPECT_NO_THROW(buffer.read(0, 400, found.data()));
        EXPECT_TRUE(g_read);
    });
}

// Memory that a driver hands out again may hold what the same program wrote there before.
TEST_P(Buffers, AreFilledInChecks) {
    gl::Gpu& gpu = fresh_device();
    gpu.thread
        .post([&] {
            std::vector<uint32_t> found;
            gpu.checks.differs(gpu, "a check", [&] {
                found = words_of(gl::Buffer(gpu.context->gl, 400));
                return std::string();
            });
            EXPECT_EQ(found, std::vector<uint32_t>(100, gl::FilledBuffers::word));
        })
        .get();
}

INSTANTIATE_TEST_SUITE_P(Devices, Buffers, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test

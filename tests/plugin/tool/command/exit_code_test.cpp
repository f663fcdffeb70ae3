// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/command/exit_code.h"

#include <cerrno>
#include <new>
#include <stdexcept>

#include <gtest/gtest.h>

#include "core/base/one_line.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/memory.h"

namespace ddt::tool {
namespace {

template <class Thrown>
Failure failure_of(const Thrown& what) {
    try {
        throw what;
    } catch (...) {
        return thrown();
    }
}

TEST(ExitCodes, SizesThatNoVectorCanHaveAreOutOfMemory) {
    for (const Failure& failure :
         {failure_of(std::bad_alloc()), failure_of(std::length_error("vector::reserve"))}) {
        EXPECT_EQ(failure.why, "out of memory");
        EXPECT_EQ(failure.code, exit_resources);
    }
    const Failure other = failure_of(std::runtime_error("no such reel"));
    EXPECT_EQ(other.why, "no such reel");
    EXPECT_EQ(other.code, exit_failed);
}

TEST(ExitCodes, WhatAFileIsCalledIsNotWhatHappenedToIt) {
    for (const char* message :
         {R"("out of memory.png": Permission denied)", R"(cannot write "std::bad_alloc": why)",
          R"("no "out of memory" here.png": Permission denied)",
          R"("no" out of memory.png": Permission denied)", R"("out of memory ": Permission denied)",
          R"("no "out of memory.png": Permission denied)", R"(no reader for "a out of memory ")",
          R"("a.png" and ("out of memory.png") differ)",
          R"("out of memory.webp": out of memory.webp is not a WebP image file)"})
        EXPECT_EQ(code_of_message(message), exit_failed) << message;
    for (const char* message :
         {R"(out of memory)", R"("a.png": out of memory)", R"("m": out of memory)",
          R"("out of memory.png": std::bad_alloc)", R"(cannot write "a"b.png": out of memory)",
          R"("a.exr": OpenEXR exception: Failed to allocate memory for scanline buffers)",
          R"("a.tif": Could not open file: Out of memory reading of "StripByteCounts")",
          R"("a.tif": Read error at scanline 32; got -1 bytes, expected 4800)",
          R"("a.png": device egl is unavailable: no "libEGL.so")",
          R"("a.png" was changed while it was read, as was "b.png")",
          R"(a quote " alone: out of memory)"})
        EXPECT_EQ(code_of_message(message), exit_resources) << message;
}

TEST(ExitCodes, WhatOursSayIsKnown) {
    std::string error;
    ASSERT_FALSE(check_memory("a test", 1e18, error));
    EXPECT_EQ(code_of_message(error), exit_resources) << error;
    EXPECT_EQ(code_of_message(why_changed("a.exr")), exit_resources);
    for (const char* said :
         {out_of_memory_text, machine_memory_text, unavailable_text, changed_text})
        EXPECT_EQ(code_of_message(std::string("x: ") + said), exit_resources) << said;
}

TEST(ExitCodes, ALightThatThereIsNotIsWrongUsage) {
    for (const char* message :
         {R"("a.png": light "foo" is not a colour space; allowed are auto, encoded, raw)",
          "light=foo: the OCIO config has no role scene_linear; allowed are auto and encoded",
          R"(light "foo" is none; allowed are auto, encoded, 5" film, std::bad_alloc)"})
        EXPECT_EQ(code_of_message(message), exit_usage) << message;
    for (const char* message :
         {R"("; allowed are auto": Permission denied)",
          R"(Invalid image file "x; allowed are auto.fits": x; allowed are auto.fits isn't FITS)"})
        EXPECT_EQ(code_of_message(message), exit_failed) << message;
}

TEST(ExitCodes, AMountThatIsLostMayComeBack) {
    for (const int number :
         {ENOTCONN, ECONNABORTED, ECONNRESET, EHOSTDOWN, EHOSTUNREACH, ENETUNREACH, ENETDOWN,
          EREMOTEIO, ESHUTDOWN, ESTALE, ETIMEDOUT, EBUSY, ENOLCK, ENODEV, EKEYEXPIRED})
        EXPECT_EQ(code_of_errno(number), exit_resources) << number;
    for (const int number : {0, ENOENT, EACCES, EPERM, EROFS, EISDIR, ENOTDIR, ELOOP, EINVAL})
        EXPECT_EQ(code_of_errno(number), exit_failed) << number;
}

} // namespace
} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/stream/stream_frame.h"

#include <algorithm>
#include <cerrno>
#include <cstring>

#include <gtest/gtest.h>

namespace ddt::tool {
namespace {

/// A stream of which one read fails; those after it would succeed.
struct Broken {
    std::string text;
    size_t fails_at;
    int number; ///< of the error; 0: none, it ends there
    size_t at = 0;
    bool has_failed = false;

    static ssize_t read(void* cookie, char* to, size_t size) {
        auto& self = *static_cast<Broken*>(cookie);
        if (!self.has_failed && self.at == self.fails_at) {
            self.has_failed = self.number != 0;
            errno = self.number;
            return self.number ? -1 : 0;
        }
        const size_t end = self.has_failed ? self.text.size() : self.fails_at;
        const size_t n = std::min(size, end - self.at);
        std::memcpy(to, &self.text[self.at], n);
        self.at += n;
        return ssize_t(n);
    }
};

ReadResult read_broken(Broken broken, Failure& failure) {
    std::FILE* file = fopencookie(&broken, "r", {Broken::read, nullptr, nullptr, nullptr});
    Frame frame;
    const ReadResult result = read_frame(file, frame, failure);
    std::fclose(file);
    return result;
}

TEST(StreamFrame, AReadThatFailsIsNoEndWhereverItIs) {
    for (const std::string text :
         {"P5\n# grey\n4 2\n255\nabcdefgh", "Pf\n1 2\n-1.0\nabcdefgh",
          "P7\nWIDTH 4\nHEIGHT 2\nDEPTH 1\nMAXVAL 255\nTUPLTYPE GRAYSCALE\nENDHDR\nabcdefgh"})
        for (size_t at = 0; at < text.size(); ++at) {
            Failure failure;
            EXPECT_EQ(read_broken({text, at, EIO}, failure), ReadResult::failed) << text << at;
            EXPECT_EQ(failure.why, std::string("the stream cannot be read: ") + std::strerror(EIO))
                << text << at;
            EXPECT_EQ(failure.code, exit_resources) << text << at;
            EXPECT_EQ(read_broken({text, at, EISDIR}, failure), ReadResult::failed);
            EXPECT_EQ(failure.code, exit_failed) << text << at;
            Failure short_of;
            EXPECT_EQ(read_broken({text, at, 0}, short_of),
                      at == 0 ? ReadResult::end : ReadResult::failed);
            EXPECT_EQ(short_of.why.find("cannot be read"), std::string::npos) << short_of.why;
        }
}

} // namespace
} // namespace ddt::tool

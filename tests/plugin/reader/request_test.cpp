// SPDX-License-Identifier: Apache-2.0
#include "plugin/reader/request.h"
#include "tests/temporary.h"

#include <sys/stat.h>

#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

namespace {

using ddt::Request;

Request parsed(const std::string& name) {
    Request request;
    std::string error;
    EXPECT_TRUE(ddt::parse_request(name, request, error)) << name << ": " << error;
    return request;
}

/// The error for a name, which must leave the request as it was.
std::string refused(const std::string& name) {
    Request request;
    request.source = "untouched";
    std::string error;
    EXPECT_FALSE(ddt::parse_request(name, request, error)) << name;
    EXPECT_EQ(request.source, "untouched");
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    return error;
}

/// A file that is gone when the test is over.
class File {
public:
    explicit File(const std::string& text) { std::ofstream(path(), std::ios::binary) << text; }
    ~File() { std::remove(path().c_str()); }
    static std::string path() { return ddt::temporary("request_test.ddt"); }
};

OIIO::ImageSpec spec(int x, int y, int width, int height, int full_x, int full_y, int full_width,
                     int full_height) {
    OIIO::ImageSpec s(width, height, 3, OIIO::TypeFloat);
    s.x = x;
    s.y = y;
    s.full_x = full_x;
    s.full_y = full_y;
    s.full_width = full_width;
    s.full_height = full_height;
    return s;
}

TEST(Request, KnowsItsNames) {
    for (const char* name : {"a.ddt", "a.png.ddt", "a.png.ddt?scale=2", "/x/a.DDT", "a.b/c.ddt?",
                             "..ddt", "a.ddt?x=y.png"})
        EXPECT_TRUE(ddt::is_request_name(name)) << name;
    for (const char* name : {"", "ddt", ".ddt", "x/.ddt", ".ddt?scale=2", "a.png", "a.ddtx",
                             "a.ddt.png", "a.png?x=.ddt", "addt", "?.ddt", "a.dd"})
        EXPECT_FALSE(ddt::is_request_name(name)) << name;
}

TEST(Request, ReadsOptionsFromTheName) {
    const Request r = parsed("some/photo.png.ddt?scale=2.5&filter=ddt-linear&light=encoded"
                             "&scheme=lawson");
    EXPECT_EQ(r.source, "some/photo.png");
    EXPECT_EQ(r.scale, 2.5);
    EXPECT_EQ(r.options.surface.kind, ddt::Surface::linear);
    EXPECT_EQ(r.options.light, "encoded");
    EXPECT_EQ(r.options.mesh.scheme, ddt::Scheme::lawson);
}

TEST(Request, TakesAFilterSpecificationWithOptions) {
    const Request r = parsed("a.png.ddt?scale=2&filter=ddt-linear,light=encoded&light=sRGB");
    EXPECT_EQ(r.options.surface.kind, ddt::Surface::linear);
    EXPECT_EQ(r.options.light, "sRGB"); // the last wins
}

TEST(Request, TheLastSizeWins) {
    EXPECT_EQ(parsed("a.ddt?scale=2&width=10").scale, 0);
    EXPECT_EQ(parsed("a.ddt?scale=2&width=10").width, 10);
    EXPECT_EQ(parsed("a.ddt?width=10&height=9&scale=3").height, 0);
    EXPECT_EQ(parsed("a.ddt?width=10&width=11").width, 11);
}

TEST(Request, ReadsSidecars) {
    // As an editor of Windows writes it.
    const File file("\xEF\xBB\xBF# a comment\r\n\r\n  photo.png \r\nscale=3\nfilter=ddt-linear\n");
    const Request r = parsed(File::path());
    EXPECT_EQ(r.source, ddt::temporary("photo.png"));
    EXPECT_EQ(r.scale, 3);
    EXPECT_EQ(r.options.surface.kind, ddt::Surface::linear);
    EXPECT_EQ(parsed(File::path() + "?width=7").width, 7);
    EXPECT_EQ(parsed(File::path() + "?filter=ddt").options.surface.kind, ddt::Surface::patch);
}

TEST(Request, KeepsAbsolutePathsOfSidecars) {
    const File file("/somewhere/photo.png\nwidth=5");
    EXPECT_EQ(parsed(File::path()).source, "/somewhere/photo.png");
}

TEST(Request, RefusesWhatItDoesNotKnow) {
    EXPECT_NE(refused("a.ddt").find("scale="), std::string::npos);
    EXPECT_NE(refused("a.ddt?scale=-1").find("\"scale=-1\""), std::string::npos);
    EXPECT_NE(refused("a.ddt?scale=1e300").find("16777216"), std::string::npos);
    EXPECT_NE(refused("a.ddt?width=99999999999").find("whole numbers"), std::string::npos);
    EXPECT_NE(refused("a.ddt?width=2.5").find("whole numbers"), std::string::npos);
    EXPECT_NE(refused("a.ddt?scale=2&filter=ddtx").find("\"ddtx\""), std::string::npos);
    EXPECT_NE(refused("a.ddt?scale=2&filter=").find("ddt-linear"), std::string::npos);
    EXPECT_NE(refused("a.ddt?scale=2&x=1").find("height, scale, width"), std::string::npos);
    EXPECT_NE(refused("a.ddt.ddt?scale=2").find("\"a.ddt\""), std::string::npos);
}

TEST(Request, RefusesSidecarsThatLeadToSidecars) {
    const File file("ddt_request_test.ddt\nscale=2\n");
    EXPECT_NE(refused(File::path()).find("not itself a .ddt"), std::string::npos);
}

TEST(Request, ScalesWindowsOutwards) {
    Request r;
    r.scale = 2.5;
    std::string error;
    const OIIO::ImageSpec from = spec(-3, 1, 7, 5, 10, 20, 100, 50);
    OIIO::ImageSpec to = from;
    ASSERT_TRUE(r.windows(from, to, error)) << error;
    EXPECT_EQ(to.full_x, 10);
    EXPECT_EQ(to.full_y, 20);
    EXPECT_EQ(to.full_width, 250);
    EXPECT_EQ(to.full_height, 125);
    // -13 * 2.5 = -32.5 and -6 * 2.5 = -15; -19 * 2.5 = -47.5 and -14 * 2.5 = -35.
    EXPECT_EQ(to.x, 10 - 33);
    EXPECT_EQ(to.width, 33 - 15);
    EXPECT_EQ(to.y, 20 - 48);
    EXPECT_EQ(to.height, 48 - 35);
}

TEST(Request, KeepsTheShapeIfOneSizeIsGiven) {
    const OIIO::ImageSpec from = spec(0, 0, 30, 20, 0, 0, 30, 20);
    std::string error;
    Request r;
    OIIO::ImageSpec to = from;
    r.width = 100;
    ASSERT_TRUE(r.windows(from, to, error));
    EXPECT_EQ(to.height, 67);
    r = {};
    r.height = 1;
    ASSERT_TRUE(r.windows(from, to, error));
    EXPECT_EQ(to.width, 2);
    // Never nothing.
    const OIIO::ImageSpec thin = spec(0, 0, 1000, 1, 0, 0, 1000, 1);
    r = {};
    r.width = 10;
    ASSERT_TRUE(r.windows(thin, to, error));
    EXPECT_EQ(to.height, 1);
}

TEST(Request, BoundsSizes) {
    Request r;
    r.scale = 1e6;
    std::string error;
    const OIIO::ImageSpec from = spec(0, 0, 300, 200, 0, 0, 300, 200);
    OIIO::ImageSpec to = from;
    EXPECT_FALSE(r.windows(from, to, error));
    EXPECT_NE(error.find("300000000 x 200000000"), std::string::npos) << error;
    // A small display window with a large data window far away.
    const OIIO::ImageSpec far = spec(1 << 28, 0, 1 << 20, 2, 0, 0, 2, 2);
    r.scale = 1 << 20;
    error.clear();
    EXPECT_FALSE(r.windows(far, to, error));
    EXPECT_NE(error.find("data window"), std::string::npos) << error;
}

TEST(Request, RefusesWhatIsNoRegularFile) {
    const std::string pipe = ddt::temporary("pipe.png");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    for (const std::string& source : {pipe, std::string("/dev/zero"), ddt::temporary(".")}) {
        const std::string error = refused(source + ".ddt?scale=2");
        EXPECT_NE(error.find("not a regular file"), std::string::npos) << error;
        const File sidecar(source + "\nscale=2\n");
        EXPECT_NE(refused(File::path()).find("not a regular file"), std::string::npos);
    }
    std::remove(pipe.c_str());
}

/// Readers open the whole name, or what stands before its query.
TEST(Request, AsksOfTheWholeNameAndOfWhatIsBeforeItsQuery) {
    const std::string pipe = ddt::temporary("queried.png?b=1"),
                      image = ddt::temporary("image.png?b=1");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::ofstream(image).put('x');
    {
        const File sidecar(pipe + "\nscale=2\n");
        EXPECT_NE(refused(File::path()).find("not a regular file"), std::string::npos);
    }
    {
        const File sidecar(image + "\nscale=2\n");
        EXPECT_EQ(parsed(File::path()).source, image);
    }
    std::remove(pipe.c_str());
    std::remove(image.c_str());
}

/// Works in the folder of temporary files.
class There {
public:
    There() : m_before(std::filesystem::current_path()) {
        std::filesystem::current_path(ddt::temporary(""));
    }
    ~There() { std::filesystem::current_path(m_before); }

private:
    std::filesystem::path m_before;
};

TEST(Request, RefusesAddresses) {
    const There there;
    for (const char* address :
         {"http://127.0.0.1:9/x.mp4", "tcp://127.0.0.1:9", "tcp://127.0.0.1:9?listen=1",
          "pipe:0.mp4", "concat:/etc/hostname|/etc/hosts", "rtmp+x-1.2:y.mp4",
          "subfile,,start,0,end,9,,:/etc/hostname"}) {
        if (!std::strchr(address, '?')) {
            const std::string error = refused(std::string(address) + ".ddt?scale=2");
            EXPECT_NE(error.find("allowed is a file"), std::string::npos) << error;
        }
        const File sidecar(std::string(address) + "\nscale=2\n");
        for (const std::string& name : {File::path(), std::string("request_test.ddt")}) {
            const std::string error = refused(name);
            EXPECT_NE(error.find("allowed is a file"), std::string::npos) << error;
        }
    }
    // What is no address may still be an image to some reader.
    EXPECT_EQ(parsed("a/b:c.png.ddt?scale=2").source, "a/b:c.png");
    EXPECT_EQ(parsed(":c.png.ddt?scale=2").source, ":c.png");
}

TEST(Request, OpensFilesAsFilesWhateverTheirNames) {
    const There there;
    for (const std::string name : {"http:x.png", "subfile,x.png"}) {
        std::ofstream(name).put('x');
        EXPECT_EQ(parsed(name + ".ddt?scale=2").source, "./" + name);
        std::remove(name.c_str());
    }
    const File sidecar("photo.png\nscale=2\n");
    EXPECT_EQ(parsed("request_test.ddt").source, "./photo.png");
}

} // namespace

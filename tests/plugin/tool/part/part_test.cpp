// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <vector>

#include <gtest/gtest.h>

#include <OpenImageIO/imagebufalgo.h>

#include "plugin/tool/part/fingerprint.h"
#include "plugin/tool/part/join.h"
#include "plugin/tool/part/part_header.h"
#include "plugin/tool/part/resize_part.h"
#include "tests/environment.h"
#include "tests/resource_limit.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

TEST(Parts, Texts) {
    Part part;
    EXPECT_TRUE(parse_part("3/16", part));
    EXPECT_EQ(part.index, 3);
    EXPECT_EQ(part.count, 16);
    for (const char* wrong : {"", "3", "0/4", "5/4", "3/", "/4", "-1/4", "1/0", "1/2/3"})
        EXPECT_FALSE(parse_part(wrong, part)) << wrong;
}

/// Every tile belongs to one part, and no part is without.
void expect_cover(int columns, int rows, int count) {
    std::vector<int> owners(size_t(columns) * size_t(rows));
    for (int i = 1; i <= count; ++i) {
        const Rect tiles = tiles_of_part(columns, rows, {i, count});
        ASSERT_FALSE(tiles.empty()) << columns << " x " << rows << ", " << i << "/" << count;
        for (int y = tiles.y0; y < tiles.y1; ++y)
            for (int x = tiles.x0; x < tiles.x1; ++x)
                ++owners[size_t(y) * size_t(columns) + size_t(x)];
    }
    for (const int owner : owners)
        ASSERT_EQ(owner, 1) << columns << " x " << rows << " in " << count;
}

TEST(Parts, AreTheGridWhateverTheirNumber) {
    for (int columns = 1; columns <= 7; ++columns)
        for (int rows = 1; rows <= 7; ++rows)
            for (int count = 1; count <= columns * rows; ++count)
                expect_cover(columns, rows, count);
    expect_cover(512, 512, 1000);
}

TEST(Parts, AreWholeRowsWhereThereAreEnough) {
    for (int i = 1; i <= 16; ++i) {
        const Rect tiles = tiles_of_part(40, 32, {i, 16});
        EXPECT_EQ(tiles.width(), 40);
        EXPECT_EQ(tiles.height(), 2);
    }
}

/// Half of a whole of 32 x 32 pixels, black; called the one of that number from 0, of `count`.
std::string write_half(int index, int channels, const std::string& whole, const std::string& type,
                       int count = 2, const std::string& names = "", const Rect* window = nullptr) {
    OIIO::ImageSpec spec(32, 16, channels, OIIO::TypeHalf);
    spec.y = 16 * (index % 2);
    if (window) {
        spec.x = window->x0;
        spec.y = window->y0;
        spec.width = window->width();
        spec.height = window->height();
    }
    spec.tile_width = spec.tile_height = 16;
    PartHeader header;
    header.job = "job";
    header.part = {index + 1, count};
    header.whole = {0, 0, 32, 32};
    header.type = type;
    header.write_to(spec);
    spec.attribute("ddt_part:whole", whole);
    spec.attribute("ddt_part:channels", names);
    const std::string path = temporary("half" + std::to_string(index) + ".exr");
    const auto file = OIIO::ImageOutput::create(path);
    const std::vector<char> pixels(spec.image_bytes());
    EXPECT_TRUE(file && file->open(path, spec) &&
                file->write_image(OIIO::TypeHalf, pixels.data()) && file->close());
    return path;
}

TEST(Parts, AreThereIfTheyAreOfTheSameResult) {
    const std::string in = temporary("part_source.exr"), out = temporary("part_there.exr"),
                      other = temporary("part_other.exr");
    OIIO::ImageBuf image(OIIO::ImageSpec(300, 600, 1, OIIO::TypeHalf));
    ASSERT_TRUE(image.write(in));
    ResizeSettings settings;
    settings.size = "200%";
    settings.threads = 1;
    const Part part{2, 3};
    const auto is_there = [&](const Part& which) {
        return is_part_there(in, out, settings, which);
    };
    EXPECT_FALSE(is_there(part));
    std::ofstream(out).put('x');
    EXPECT_FALSE(is_there(part));
    ASSERT_TRUE(image.write(out)); // no part
    EXPECT_FALSE(is_there(part));
    Failure failure;
    ASSERT_TRUE(resize_part(
        in, out, settings, part, [](float) { return true; }, failure))
        << failure.why;
    EXPECT_TRUE(is_there(part));
    EXPECT_FALSE(is_there({1, 3}));
    EXPECT_FALSE(is_there({2, 4}));
    settings.threads = 2; // changes no bit
    EXPECT_TRUE(is_there(part));
    settings.options.mesh.cost = Cost::scf;
    EXPECT_FALSE(is_there(part));
    settings.options = {};
    settings.compression = "piz"; // of the joined file
    EXPECT_FALSE(is_there(part));
    settings.compression = "";
    settings.size = "300%";
    EXPECT_FALSE(is_there(part));
    settings.size = "200%";
    OIIO::ImageBufAlgo::fill(image, {0.5f});
    ASSERT_TRUE(image.write(other));
    std::filesystem::rename(other, in);
    EXPECT_FALSE(is_there(part));
    std::filesystem::remove(in);
    EXPECT_FALSE(is_there(part));
}

TEST(Parts, OfAnotherTypeAreNotThereThoughTheirWidestIsTheSame) {
    const std::string in = temporary("part_types.exr"), out = temporary("part_of_types.exr");
    OIIO::ImageSpec spec(300, 600, 2, OIIO::TypeFloat);
    spec.channelnames = {"Y", "Z"};
    spec.channelformats = {OIIO::TypeHalf, OIIO::TypeFloat};
    const auto file = OIIO::ImageOutput::create(in);
    const std::vector<float> pixels(spec.image_pixels() * 2);
    ASSERT_TRUE(file->open(in, spec) && file->write_image(OIIO::TypeFloat, pixels.data()) &&
                file->close());
    ResizeSettings settings;
    settings.size = "200%";
    settings.threads = 1;
    for (const char* type : {"float", ""}) {
        settings.type = type;
        EXPECT_FALSE(is_part_there(in, out, settings, {1, 2})) << type;
        Failure failure;
        ASSERT_TRUE(resize_part(
            in, out, settings, {1, 2}, [](float) { return true; }, failure))
            << failure.why;
        EXPECT_TRUE(is_part_there(in, out, settings, {1, 2})) << type;
    }
}

TEST(Parts, ThatWereCutOffAreNotThere) {
    const std::string in = temporary("cut_source.exr"), out = temporary("cut_part.exr");
    ASSERT_TRUE(OIIO::ImageBuf(OIIO::ImageSpec(300, 600, 1, OIIO::TypeHalf)).write(in));
    ResizeSettings settings;
    settings.size = "200%";
    settings.threads = 1;
    Failure failure;
    ASSERT_TRUE(resize_part(
        in, out, settings, {2, 3}, [](float) { return true; }, failure))
        << failure.why;
    ASSERT_TRUE(is_part_there(in, out, settings, {2, 3}));
    std::filesystem::resize_file(out, std::filesystem::file_size(out) - 1);
    EXPECT_FALSE(is_part_there(in, out, settings, {2, 3}));
}

TEST(Parts, OfASourceThatChangesMeanwhileAreNone) {
    const std::string in = temporary("part_changes.tif"), out = temporary("part_of_both.exr");
    OIIO::ImageBuf image(OIIO::ImageSpec(300, 600, 1, OIIO::TypeUInt8));
    image.specmod().attribute("compression", "none");
    ASSERT_TRUE(image.write(in));
    const auto size = std::filesystem::file_size(in);
    ResizeSettings settings;
    settings.size = "200%";
    settings.threads = 1;
    bool changed = false;
    const auto change = [&](float) {
        if (!changed)
            std::fstream(in, std::ios::in | std::ios::out).seekp(20000).put('x');
        return changed = true;
    };
    Failure failure;
    EXPECT_FALSE(resize_part(in, out, settings, {1, 1}, change, failure));
    EXPECT_TRUE(changed);
    EXPECT_EQ(std::filesystem::file_size(in), size);
    EXPECT_EQ(failure.code, exit_resources);
    EXPECT_NE(failure.why.find("was changed while it was read"), std::string::npos) << failure.why;
    EXPECT_FALSE(std::filesystem::exists(out));
    EXPECT_TRUE(resize_part(in, out, settings, {1, 1}, change, failure)) << failure.why;
}

/// They would be the names of more channels than there are.
TEST(Parts, OfNamesWithLineBreaksThereAreNone) {
    const std::string in = temporary("break_source.exr"), out = temporary("break_part.exr");
    OIIO::ImageSpec spec(300, 600, 2, OIIO::TypeHalf);
    spec.channelnames = {"a\nb", "c"};
    ASSERT_TRUE(OIIO::ImageBuf(spec).write(in));
    ASSERT_EQ(OIIO::ImageInput::open(in)->spec().channelnames, spec.channelnames);
    ResizeSettings settings;
    settings.size = "200%";
    Failure failure;
    EXPECT_FALSE(resize_part(
        in, out, settings, {1, 2}, [](float) { return true; }, failure));
    EXPECT_EQ(failure.code, exit_failed);
    EXPECT_NE(failure.why.find("allowed are names in one line"), std::string::npos) << failure.why;
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Parts, DoNotTakeThePlaceOfTheirSource) {
    const std::string in = temporary("part_onto_itself.exr"), link = temporary("part_link.exr");
    ASSERT_TRUE(OIIO::ImageBuf(OIIO::ImageSpec(300, 600, 1, OIIO::TypeHalf)).write(in));
    std::filesystem::create_symlink(in, link);
    const std::string before = text_in(in);
    ResizeSettings settings;
    settings.size = "200%";
    settings.threads = 1;
    for (const std::string& out : {in, link}) {
        Failure failure;
        EXPECT_FALSE(resize_part(
            in, out, settings, {1, 2}, [](float) { return true; }, failure));
        EXPECT_EQ(failure.code, exit_usage);
        EXPECT_NE(failure.why.find("\"" + out + "\": a part cannot take the place"),
                  std::string::npos)
            << failure.why;
        EXPECT_TRUE(std::filesystem::is_symlink(link));
        EXPECT_TRUE(text_in(in) == before);
    }
}

TEST(Join, RefusesHeadersThatDoNotFit) {
    const std::string whole = "0 0 32 32", out = temporary("whole.exr");
    std::filesystem::remove(out);
    const ProgressCallback progress = [](float) { return true; };
    const auto failure_of = [&](const std::string& a, const std::string& b) {
        Failure failure;
        EXPECT_FALSE(join({a, b}, out, progress, failure));
        EXPECT_FALSE(std::filesystem::exists(out));
        return failure.why;
    };
    const auto says = [](const std::string& why, const char* what) {
        EXPECT_NE(why.find(what), std::string::npos) << why;
    };
    says(failure_of(write_half(0, 4, whole, "half"), write_half(1, 3, whole, "half")),
         "of different jobs");
    says(failure_of(write_half(0, 3, whole, "half"), write_half(1, 3, "0 0 32 40", "half")),
         "of different jobs");
    says(failure_of(write_half(0, 3, whole, "point[7]"), write_half(1, 3, whole, "half")),
         "is no part");
    for (const char* wrong : {"0 0 32 32 40", "0 0 32 32x", "0 0 32", "0 0 32 4294967328",
                              "0 0 32 99999999999999999999", ""})
        says(failure_of(write_half(0, 3, wrong, "half"), write_half(1, 3, whole, "half")),
             "is no part");
    says(failure_of(write_half(0, 3, whole, "half", 2, "R\nG\nX"), write_half(1, 3, whole, "half")),
         "other channels");
    says(failure_of(write_half(0, 3, whole, "half", 2, "G\nB"), write_half(1, 3, whole, "half")),
         "other channels");
    says(failure_of(write_half(0, 3, whole, "half", 2, "G\nB\nR"), write_half(1, 3, whole, "half")),
         "of different jobs");
    const std::string far = "-2147483648 0 2147483647 32";
    says(failure_of(write_half(0, 3, far, "half"), write_half(1, 3, far, "half")), "not within");
    Failure failure;
    EXPECT_TRUE(join({write_half(0, 3, whole, "half"), write_half(1, 3, whole, "half")}, out,
                     progress, failure))
        << failure.why;
}

TEST(Parts, ArePipesAndDevicesNever) {
    const std::string pipe = temporary("part_pipe.exr"), device = temporary("part_device.exr");
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", device);
    const auto progress = [](float) { return true; };
    for (const std::string& path : {pipe, device}) {
        Failure failure;
        EXPECT_FALSE(join({path}, temporary("of_none.exr"), progress, failure));
        EXPECT_EQ(failure.code, exit_failed);
        EXPECT_EQ(failure.why.rfind("cannot read \"" + path + "\": it is a ", 0), 0u)
            << failure.why;
        EXPECT_FALSE(is_part_there(temporary("none.exr"), path, {}, {1, 2}));
    }
}

/// Join two halves of a whole, the first of which is changed once progress tells of this share.
Failure failure_of_changed(const Rect& whole, float share, const std::function<void()>& change) {
    const std::string out = temporary("join_changed.exr"),
                      window = std::to_string(whole.x0) + " 0 " + std::to_string(whole.x1) + " " +
                               std::to_string(whole.y1);
    const int middle = whole.y1 / 2;
    const Rect upper{whole.x0, 0, whole.x1, middle}, lower{whole.x0, middle, whole.x1, whole.y1};
    const std::vector<std::string> parts = {write_half(0, 3, window, "half", 2, "", &upper),
                                            write_half(1, 3, window, "half", 2, "", &lower)};
    bool changed = false;
    const auto progress = [&](float now) {
        if (!changed && now >= share) {
            change();
            changed = true;
        }
        return true;
    };
    Failure failure;
    EXPECT_FALSE(join(parts, out, progress, failure));
    EXPECT_TRUE(changed);
    EXPECT_FALSE(std::filesystem::exists(out));
    return failure;
}

TEST(Join, OfPartsThatChangeMeanwhileIsNone) {
    const std::string first = temporary("half0.exr"), kept = temporary("kept.exr"),
                      said = "\"" + first + "\" was changed while it was read";
    // Before its pixels are read: by one that would need more memory for a row.
    const auto replace = [&] {
        std::filesystem::rename(first, kept);
        const Rect larger{0, 0, 640, 320};
        write_half(0, 4, "0 0 640 640", "half", 2, "", &larger);
    };
    const Failure replaced = failure_of_changed({0, 0, 32, 32}, 0, replace);
    EXPECT_EQ(replaced.why, said);
    EXPECT_EQ(replaced.code, exit_resources);
    // After they were, of more than are written at once.
    const auto append = [&] { std::ofstream(first, std::ios::app).put('x'); };
    const Failure appended = failure_of_changed({0, 0, 2048, 2048}, 0.5f, append);
    EXPECT_EQ(appended.why, said);
    EXPECT_EQ(appended.code, exit_resources);
    // Which cannot be read.
    const auto cut_off = [&] { std::filesystem::resize_file(first, 100); };
    const Failure cut = failure_of_changed({0, 0, 32, 32}, 0, cut_off);
    EXPECT_EQ(cut.why, said);
    EXPECT_EQ(cut.code, exit_resources);
}

TEST(Join, RefusesWindowsThatDoNotFillTheWhole) {
    const std::string out = temporary("filled.exr");
    std::filesystem::remove(out);
    const auto part = [](int index, const Rect& window) {
        return write_half(index, 3, "0 0 32 32", "half", 2, "", &window);
    };
    const auto failure_of = [&](const Rect& a, const Rect& b) {
        Failure failure;
        EXPECT_FALSE(join(
            {part(0, a), part(1, b)}, out, [](float) { return true; }, failure));
        EXPECT_FALSE(std::filesystem::exists(out));
        return failure.why;
    };
    const Rect upper{0, 0, 32, 16};
    // As many pixels as the whole has, each time but the last.
    for (const Rect& lower : {upper, Rect{0, 15, 32, 31}})
        EXPECT_NE(failure_of(upper, lower).find(" overlap"), std::string::npos);
    for (const Rect& lower : {Rect{0, 17, 32, 33}, Rect{1, 16, 33, 32}, Rect{-1, 16, 31, 32}})
        EXPECT_NE(failure_of(upper, lower).find("leaves the whole's window"), std::string::npos);
    EXPECT_NE(failure_of({0, 1, 32, 17}, {0, -15, 32, 1}).find("leaves the whole's window"),
              std::string::npos);
    for (const Rect& lower : {Rect{0, 17, 32, 32}, Rect{1, 16, 32, 32}})
        EXPECT_EQ(failure_of(upper, lower), "the parts do not fill the whole's window");
}

TEST(Join, NamesThePartsThatAreMissing) {
    const auto part = [](int index, int count) {
        return write_half(index, 3, "0 0 32 32", "half", count);
    };
    const auto missing = [](const std::vector<std::string>& paths) {
        const std::string out = temporary("some_parts.exr");
        Failure failure;
        EXPECT_FALSE(join(
            paths, out, [](float) { return true; }, failure));
        EXPECT_FALSE(std::filesystem::exists(out));
        return failure.why;
    };
    EXPECT_EQ(missing({part(0, 2)}), "of 2 parts there are missing: 2");
    EXPECT_EQ(missing({part(1, 2)}), "of 2 parts there are missing: 1");
    EXPECT_EQ(missing({part(3, 4), part(0, 4)}), "of 4 parts there are missing: 2, 3");
    EXPECT_EQ(missing({part(2, 20)}), "of 20 parts there are missing: 1, 2, 4, 5, 6, 7, 8, 9, ...");
}

TEST(Fingerprint, IsOfTheConfigThatIsInUse) {
    const std::string in = temporary("of_a_part.png"), config = temporary("other.ocio");
    OIIO::ImageBuf image(OIIO::ImageSpec(8, 8, 3, OIIO::TypeUInt8));
    OIIO::ImageBufAlgo::zero(image);
    ASSERT_TRUE(image.write(in));
    std::ofstream(config) << R"(ocio_profile_version: 2
roles: {default: raw, scene_linear: linear}
displays:
  none:
    - !<View> {name: raw, colorspace: raw}
colorspaces:
  - !<ColorSpace> {name: linear}
  - !<ColorSpace> {name: raw, isdata: true}
  - !<ColorSpace> {name: sRGB, to_scene_reference: !<ExponentTransform> {value: 3}}
)";
    OIIO::ImageSpec spec = image.spec(), result;
    spec.attribute("oiio:ColorSpace", "sRGB");
    ResizeSettings settings;
    settings.size = "200%";
    Failure failure;
    ASSERT_TRUE(plan_result(spec, settings, result, failure));
    const auto both = [&] {
        const auto fingerprint_in = [&](const std::optional<std::string>& ocio) {
            const Environment set("OCIO", ocio);
            return fingerprint(in, spec, result, settings, failure);
        };
        return std::pair(fingerprint_in(std::nullopt), fingerprint_in(config));
    };
    const auto [without, with] = both();
    EXPECT_NE(without, "");
    EXPECT_NE(with, without);
    settings.options.light = "encoded";
    const auto [encoded, encoded_too] = both();
    EXPECT_EQ(encoded, encoded_too);
}

TEST(Parts, OfAWideWholeHaveLowTiles) {
    const std::string in = temporary("part_of_wide.exr"), out = temporary("part_is_wide.exr");
    ASSERT_TRUE(OIIO::ImageBuf(OIIO::ImageSpec(300, 2, 1, OIIO::TypeFloat)).write(in));
    ResizeSettings settings;
    // A row of tiles of 64 rows is 64 MiB at most.
    for (const auto& [size, height] : {std::pair("262144x2", 64), {"262145x2", 16}}) {
        settings.size = size;
        Failure failure;
        ASSERT_TRUE(resize_part(
            in, out, settings, {1, 1}, [](float) { return true; }, failure))
            << failure.why;
        EXPECT_EQ(OIIO::ImageInput::open(out)->spec().tile_height, height) << size;
    }
}

/// How many files a process has open when it has opened so many more.
rlim_t open_files_and(int more) {
    const int next = dup(STDERR_FILENO);
    close(next);
    return rlim_t(next + more);
}

TEST(Join, HasNoMoreFilesOpenThanARowOfPartsNeeds) {
    constexpr int count = 40;
    std::vector<std::string> parts;
    for (int i = 0; i < count; ++i) {
        const Rect window{0, 16 * i, 32, 16 * i + 16};
        parts.push_back(write_half(i, 3, "0 0 32 640", "half", count, "", &window));
    }
    Failure failure;
    const test::ResourceLimit few(RLIMIT_NOFILE, open_files_and(12));
    EXPECT_TRUE(join(
        parts, temporary("of_many.exr"), [](float) { return true; }, failure))
        << failure.why;
}

TEST(Fingerprint, IsNoneOfBytesThatCannotBeRead) {
    // The system says that there are 4096 bytes of the first, and gives some.
    const std::string shorter = "/sys/devices/system/cpu/online", folder = temporary("a folder");
    std::filesystem::create_directory(folder);
    Failure failure;
    EXPECT_EQ(fingerprint(folder, {}, {}, {}, failure), "");
    EXPECT_EQ(failure.why, "\"" + folder + "\": " + std::strerror(EISDIR));
    EXPECT_EQ(fingerprint(folder + "/none", {}, {}, {}, failure), "");
    EXPECT_EQ(failure.why,
              "\"" + folder + "/none\" is no file that can be read as bytes, which --part needs");
    if (!std::filesystem::exists(shorter))
        GTEST_SKIP() << "no " << shorter;
    EXPECT_EQ(fingerprint(shorter, {}, {}, {}, failure), "");
    EXPECT_EQ(failure.why, "\"" + shorter + "\" was changed while it was read");
    EXPECT_EQ(failure.code, exit_resources);
}

TEST(Fingerprint, CountsEveryByteOfAFileUpToItsLast) {
    const std::string in = temporary("of_bytes.ppm");
    // A piece is 64 KiB.
    for (const size_t size : {size_t(1), size_t(65536), size_t(65537), size_t(200000)}) {
        const auto of = [&](const std::string& bytes) {
            std::ofstream(in, std::ios::binary | std::ios::trunc) << bytes;
            Failure failure;
            return fingerprint(in, {}, {}, {}, failure);
        };
        const std::string plain = of(std::string(size, 'a'));
        EXPECT_EQ(of(std::string(size, 'a')), plain);
        for (const size_t place : {size_t(0), size / 2, size - 1}) {
            std::string other(size, 'a');
            other[place] = 'b';
            EXPECT_NE(of(other), plain) << place << " of " << size;
        }
    }
}

} // namespace
} // namespace ddt::tool

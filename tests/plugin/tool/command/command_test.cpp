// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <gtest/gtest.h>

#include "ddt/option_table.h"
#include "plugin/tool/command/progress.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/picture.h"
#include "plugin/tool/man.h"
#include "plugin/tool/plugin_file.h"
#include "tests/plugin/tool/run_command.h"
#include "tests/temporary.h"

namespace ddt::tool {
namespace {

const std::string scene = TESTIMAGES "/scene.png";

TEST(Commands, HelpTellsOfEveryFlagAndOperand) {
    for (const auto& command : make_commands()) {
        const auto flags = command->flags;
        const auto operands = command->operands;
        const std::string name = command->name;
        for (auto& fresh : make_commands()) {
            if (fresh->name != name)
                continue;
            const Ran ran = run(std::move(fresh), {"--help"});
            EXPECT_EQ(ran.code, exit_done);
            EXPECT_EQ(ran.err, "");
            for (const Flag& flag : flags)
                EXPECT_NE(ran.out.find(flag.name), std::string::npos) << ran.out;
            for (const Operand& operand : operands)
                EXPECT_NE(ran.out.find(operand.help), std::string::npos) << ran.out;
        }
    }
}

TEST(Commands, HelpIsPrintedForItsShortNameToo) {
    const Ran ran = run(make_mesh_command(), {"-h"});
    EXPECT_EQ(ran.code, exit_done);
    EXPECT_EQ(ran.err, "");
    EXPECT_EQ(ran.out, run(make_mesh_command(), {"--help"}).out);
}

TEST(Commands, HelpTellsWhichNumbersAreAllowed) {
    const std::string before_range = "numbers from ";
    int found = 0;
    for (const auto& command : make_commands())
        for (const Flag& flag : command->flags) {
            const size_t at = flag.allowed.find(before_range);
            if (at == std::string::npos)
                continue;
            ++found;
            const std::string range = flag.allowed.substr(at + before_range.size());
            EXPECT_NE(flag.help.find(range), std::string::npos) << flag.name << ": " << flag.help;
        }
    EXPECT_GE(found, 6);
}

/// With hyphens as man(7) wants them.
std::string for_man(const std::string& flag) {
    std::string escaped;
    for (const char c : flag)
        escaped += c == '-' ? "\\-" : std::string(1, c);
    return escaped;
}

TEST(Commands, TheManualPageHasThemAll) {
    const auto commands = make_commands();
    const std::string page = man_page(commands);
    EXPECT_EQ(page.rfind(".TH DDT 1", 0), 0u);
    for (const auto& command : commands) {
        EXPECT_NE(page.find(".SS ddt " + command->name), std::string::npos);
        for (const Flag& flag : command->flags)
            EXPECT_NE(page.find(for_man(flag.name)), std::string::npos) << flag.name;
    }
    EXPECT_NE(page.find(".SH EXIT STATUS"), std::string::npos);
    const std::string help = overview(commands);
    for (const char* variable : {"DDT_DEVICE", "DDT_EGL_DEVICE", "DDT_VERBOSE", "OCIO",
                                 plugin_path_variable, "OPENIMAGEIO_OPTIONS"}) {
        EXPECT_NE(page.find(std::string(".TP\n.B ") + variable + "\n"), std::string::npos) << page;
        EXPECT_NE(help.find(std::string("\n  ") + variable + "\n"), std::string::npos) << help;
    }
    // No line of text that man(7) would take for a macro.
    for (size_t at = page.find('\n'); at + 1 < page.size(); at = page.find('\n', at + 1))
        EXPECT_NE(page[at + 1], '\'');
}

TEST(Commands, WrongUsageIsExitCode2AndTellsWhatIsAllowed) {
    struct Case {
        std::vector<std::string> args;
        const char* told;
    };
    for (const Case& c :
         {Case{{}, "takes 2 arguments"}, Case{{scene}, "takes 2 arguments"},
          Case{{scene, "a.ply", "b"}, "takes 2 arguments"},
          Case{{scene, "a.stl"}, ".svg, .ply or .obj"},
          Case{{scene, "a.ply", "--fill", "red"}, "gradient, flat, none"},
          Case{{scene, "a.svg", "--lines", "x"}, "numbers from 0"},
          Case{{scene, "a.ply", "--filter", "ddt,scheme=magic"}, "one-round, lawson"},
          Case{{scene, "a.ply", "--fliter", "ddt"}, "\"--fliter\"; did you mean --filter?"},
          Case{{scene, "a.ply", "--fliter=ddt"}, "\"--fliter=ddt\"; did you mean --filter?"},
          Case{{scene, "a.ply", "--verbose=1"}, "; --verbose has no value"},
          Case{{scene, "a.ply", "--fill=red"}, "\"--fill red\" is not allowed"},
          Case{{scene, "a.ply", "--fill="}, "gradient, flat, none"},
          Case{{scene, "a.ply", "--filter=ddt,scheme=magic"}, "one-round, lawson"},
          Case{{scene, "a.ply", "--scheme", "magic"}, "exproiN-maxgain"},
          Case{{scene, "a.ply", "--nonsense"}, "\"--nonsense\"\n"}}) {
        const Ran ran = run(make_mesh_command(), c.args);
        EXPECT_EQ(ran.code, exit_usage) << c.told;
        EXPECT_EQ(ran.err.rfind("ddt: ", 0), 0u) << ran.err;
        EXPECT_NE(ran.err.find(c.told), std::string::npos) << ran.err;
        EXPECT_EQ(ran.out, "");
    }
    const Ran ran = run(make_resize_command(), {scene, "big", temporary("a.png")});
    EXPECT_EQ(ran.code, exit_usage);
    EXPECT_NE(ran.err.find("W%xH%"), std::string::npos) << ran.err;
}

TEST(Commands, HelpListsTheOptionsThatCount) {
    const auto listed = [](std::unique_ptr<Command> command) {
        const Ran ran = run(std::move(command), {"--help"});
        EXPECT_EQ(ran.code, exit_done);
        std::string keys;
        for (const Option& option : option_table())
            if (ran.out.find(std::string("\n  ") + option.key + "= ") != std::string::npos)
                keys += std::string(option.key) + ' ';
        return keys;
    };
    std::string all;
    for (const Option& option : option_table())
        all += std::string(option.key) + ' ';
    EXPECT_EQ(listed(make_resize_command()), all);
    EXPECT_EQ(listed(make_stream_command()), all);
    EXPECT_EQ(listed(make_scatter_command()), "cost min_gain iterations scheme seed device ");
    EXPECT_EQ(listed(make_fill_command()), "light cost iterations scheme seed holes device ");
    EXPECT_EQ(listed(make_mesh_command()),
              "light cost blur contour min_gain iterations scheme seed start holes device ");
}

TEST(Commands, LightThatThereIsNotIsRefusedByThoseThatHaveNoUseForIt) {
    const std::string points = temporary("light.csv"), out = temporary("light.exr"),
                      mesh = temporary("light.ply"), flipped_to = temporary("flipped.ply");
    std::ofstream(points) << "x,y,z\n0,0,1\n1,0,2\n0,1,3\n";
    for (const char* light : {"auto", "encoded", "sRGB"})
        EXPECT_EQ(run(make_scatter_command(), {points, out, "--size", "4x4", "--mesh", mesh,
                                               "--filter", std::string("ddt,light=") + light})
                      .code,
                  exit_done);
    const std::vector<std::string> wrong{"--filter", "ddt,light=NoSuchSpace"};
    std::filesystem::remove(out);
    const Ran scattered = run(make_scatter_command(), {points, out, wrong[0], wrong[1]}),
              flipped = run(make_mesh_command(), {mesh, flipped_to, wrong[0], wrong[1]});
    for (const Ran& ran : {scattered, flipped}) {
        EXPECT_EQ(ran.code, exit_usage);
        EXPECT_NE(ran.err.find("\"NoSuchSpace\""), std::string::npos) << ran.err;
    }
    EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(Commands, AfterTwoHyphensAllIsOperands) {
    const Ran ran =
        run(make_resize_command(), {"--filter", "ddt", "--", "--size.exr", "200%", "-"});
    EXPECT_EQ(ran.code, exit_failed);
    EXPECT_NE(ran.err.find("--size.exr"), std::string::npos) << ran.err;
    EXPECT_EQ(run(make_resize_command(), {"a.exr", "--", "200%"}).code, exit_usage);
}

TEST(Commands, ValuesMayLookLikeOptions) {
    // The view's name, and after two hyphens a file's.
    const Ran view =
        run(make_resize_command(), {"in.%V.exr", "2", "out.%V.exr", "--views", "--type=half"});
    EXPECT_EQ(view.code, exit_failed);
    EXPECT_NE(view.err.find("in.--type=half.exr"), std::string::npos) << view.err;
    const Ran file = run(make_resize_command(), {"--", "--type=half", "2", "out.exr"});
    EXPECT_EQ(file.code, exit_failed);
    EXPECT_NE(file.err.find("\"--type=half\""), std::string::npos) << file.err;
}

TEST(Commands, WhatCannotBeReadOrWrittenIsExitCode1AndNamed) {
    for (const Ran& ran : {run(make_mesh_command(), {"missing.png", temporary("a.ply")}),
                           run(make_resize_command(), {"missing.png", "2", temporary("a.png")}),
                           run(make_compare_command(), {scene, "missing.png"})}) {
        EXPECT_EQ(ran.code, exit_failed);
        EXPECT_NE(ran.err.find("missing.png"), std::string::npos) << ran.err;
        EXPECT_EQ(std::count(ran.err.begin(), ran.err.end(), '\n'), 1) << ran.err;
    }
    EXPECT_EQ(run(make_mesh_command(), {scene, "/no/folder/a.ply"}).code, exit_failed);
    EXPECT_EQ(run(make_resize_command(), {scene, "2", "/no/folder/a.png"}).code, exit_failed);
}

TEST(Commands, ResizeThenCompare) {
    const std::string large = temporary("large.png"), same = temporary("same.png");
    EXPECT_EQ(run(make_resize_command(), {scene, "200%", large}).code, exit_done);
    OIIO::ImageBuf image;
    std::string error;
    ASSERT_TRUE(open_image(large, image, error)) << error;
    EXPECT_EQ(image.spec().width, 384);
    EXPECT_EQ(image.spec().height, 288);
    const Ran sizes = run(make_compare_command(), {scene, large});
    EXPECT_EQ(sizes.code, exit_failed);
    EXPECT_NE(sizes.err.find("384 x 288"), std::string::npos) << sizes.err;

    // The same size: the same pixels.
    EXPECT_EQ(run(make_resize_command(), {scene, "1", same, "--type", "uint8"}).code, exit_done);
    const Ran equal = run(make_compare_command(), {scene, same, "--csv"});
    EXPECT_EQ(equal.code, exit_done);
    EXPECT_EQ(equal.out, "psnr,mse,snr,correlation,cross-correlation,uiqi,ssim,ms-ssim,gmsd\n"
                         "inf,0,inf,1,1,1,1,1,0\n");
}

TEST(Commands, CompareRefusesImagesAtDifferentPlaces) {
    const auto image = [](const char* name, OIIO::ROI data, OIIO::ROI full) {
        OIIO::ImageSpec spec(data.width(), data.height(), 3, OIIO::TypeHalf);
        OIIO::set_roi(spec, data);
        OIIO::set_roi_full(spec, full);
        spec.nchannels = 3;
        OIIO::ImageBuf pixels(spec);
        const std::string path = temporary(name);
        EXPECT_TRUE(OIIO::ImageBufAlgo::zero(pixels) && pixels.write(path)) << pixels.geterror();
        return path;
    };
    const std::string a = image("place.exr", {0, 20, 0, 16}, {0, 32, 0, 24}),
                      moved = image("moved.exr", {5, 25, -3, 13}, {0, 32, 0, 24}),
                      based = image("based.exr", {105, 125, 7, 23}, {105, 137, 7, 31});
    const Ran ran = run(make_compare_command(), {a, moved});
    EXPECT_EQ(ran.code, exit_failed);
    EXPECT_EQ(ran.out, "");
    EXPECT_NE(ran.err.find("20x16+0+0 in 32x24+0+0 and 20x16+5-3 in 32x24+0+0"), std::string::npos)
        << ran.err;
    // Both windows moved together: the same place.
    EXPECT_EQ(run(make_compare_command(), {a, based}).code, exit_done);
}

TEST(Commands, CompareTakesPixelsThatAreNotFiniteForBlack) {
    const auto image = [](const char* name, float value, float second, float depth) {
        OIIO::ImageSpec spec(20, 20, 4, OIIO::TypeFloat);
        spec.channelnames = {"R", "G", "B", "Z"};
        OIIO::ImageBuf pixels(spec);
        EXPECT_TRUE(OIIO::ImageBufAlgo::fill(pixels, {value, value, value, depth}));
        pixels.setpixel(7, 5, {value, second, value, depth});
        const std::string path = temporary(name);
        EXPECT_TRUE(pixels.write(path)) << pixels.geterror();
        return path;
    };
    constexpr float infinity = std::numeric_limits<float>::infinity(), nan = NAN;
    const std::string plain = image("plain.exr", 0.25f, 0.25f, infinity),
                      darker = image("darker.exr", 0.2f, infinity, 1);
    for (const float odd : {infinity, -infinity, nan}) {
        const std::string other = image("odd.exr", 0.25f, odd, 1);
        for (const auto& pair : {std::vector{plain, other}, {other, plain}, {other, other}}) {
            const Ran ran = run(make_compare_command(), pair);
            EXPECT_EQ(ran.code, exit_done);
            EXPECT_EQ(ran.err, "ddt: 1 of the pixels are not finite in one image, and taken for "
                               "black in both\n");
            EXPECT_EQ(ran.out.find("psnr                        inf"), 0u) << ran.out;
        }
    }
    const Ran ran = run(make_compare_command(), {plain, darker, "--csv"});
    const double psnr = std::stod(ran.out.substr(ran.out.find('\n')));
    EXPECT_GT(psnr, 20);
    EXPECT_LT(psnr, 40);
    EXPECT_EQ(run(make_compare_command(), {plain, plain}).err, "");
    // Whatever type the numbers have.
    for (const OIIO::TypeDesc& type : {OIIO::TypeUInt8, OIIO::TypeUInt16, OIIO::TypeHalf}) {
        OIIO::ImageBuf noise(OIIO::ImageSpec(40, 30, 3, type));
        EXPECT_TRUE(OIIO::ImageBufAlgo::noise(noise, "uniform", 0.0f, 1.0f));
        const std::string path = temporary("noise.tif");
        EXPECT_TRUE(noise.write(path)) << noise.geterror();
        EXPECT_EQ(run(make_compare_command(), {path, path}).err, "");
    }
}

TEST(Commands, CompareSaysWhatItDoesNotLookAt) {
    const std::string path = temporary("channels.exr");
    const auto said = [&](const std::vector<std::string>& names) {
        OIIO::ImageBuf image(OIIO::ImageSpec(192, 144, int(names.size()), OIIO::TypeFloat));
        image.specmod().channelnames = names;
        EXPECT_TRUE(OIIO::ImageBufAlgo::zero(image) && image.write(path)) << image.geterror();
        const Ran ran = run(make_compare_command(), {scene, path}),
                  turned = run(make_compare_command(), {path, scene});
        EXPECT_EQ(ran.err, turned.err);
        return ran.err;
    };
    const std::string not_compared = "ddt: not compared of \"" + path + "\": ";
    EXPECT_EQ(said({"forward.u", "forward.v"}), not_compared + "forward.v\n");
    EXPECT_EQ(said({"R", "G", "B", "A", "glow.R", "glow.G"}), not_compared + "glow.R, glow.G\n");
    for (const auto& names :
         {std::vector<std::string>{"R", "G", "B", "A"}, {"Y"}, {"Y", "A"}, {"R", "G", "B", "Z"}})
        EXPECT_EQ(said(names), "");
}

TEST(Commands, MeshFillsHolesWhereTheFilterDoes) {
    OIIO::ImageBuf image(OIIO::ImageSpec(8, 8, 3, OIIO::TypeFloat));
    EXPECT_TRUE(OIIO::ImageBufAlgo::fill(image, {0.5f, 0.5f, 0.5f}));
    image.setpixel(3, 3, {NAN, NAN, NAN});
    const std::string in = temporary("holed.exr"), out = temporary("holed.obj"),
                      whole = temporary("whole.obj");
    EXPECT_TRUE(image.write(in));
    const auto text = [&](const std::string& filter) {
        EXPECT_EQ(run(make_mesh_command(), {in, out, "--filter", filter}).code, exit_done);
        std::string all;
        EXPECT_TRUE(OIIO::Filesystem::read_text_file(out, all));
        return all;
    };
    const std::string kept = text("ddt"), filled = text("ddt,holes=fill");
    EXPECT_NE(kept, filled);
    image.setpixel(3, 3, {0.5f, 0.5f, 0.5f});
    EXPECT_TRUE(image.write(in));
    EXPECT_EQ(text("ddt"), filled);
}

TEST(Commands, OfAFlagThatIsGivenTwiceTheLastCounts) {
    const std::string out = temporary("twice.ply");
    EXPECT_EQ(run(make_mesh_command(), {scene, out, "--filter", "bogus", "--filter", "ddt"}).code,
              exit_done);
    EXPECT_EQ(run(make_mesh_command(), {scene, out, "--filter", "ddt", "--filter", "bogus"}).code,
              exit_usage);
}

TEST(Commands, MemoryIsCheckedBeforeItIsTaken) {
    int before = 0;
    OIIO::getattribute("limits:imagesize_MB", before);
    OIIO::attribute("limits:imagesize_MB", 1); // the picture has 192 x 144 pixels
    const Ran compared = run(make_compare_command(), {scene, scene}),
              triangulated = run(make_mesh_command(), {scene, temporary("large.ply")});
    OIIO::attribute("limits:imagesize_MB", before);
    EXPECT_EQ(compared.code, exit_resources);
    EXPECT_NE(compared.err.find("comparing 192 x 144 pixels would need"), std::string::npos)
        << compared.err;
    EXPECT_EQ(triangulated.code, exit_resources);
    EXPECT_NE(triangulated.err.find("triangulating 192 x 144 pixels"), std::string::npos)
        << triangulated.err;
}

TEST(Commands, CompareRefusesIdsAlone) {
    const auto image = [](const char* name, OIIO::TypeDesc type, uint32_t value) {
        const OIIO::ImageSpec spec(20, 20, 1, type);
        const std::vector<uint32_t> pixels(400, value);
        const std::string path = temporary(name);
        const auto file = OIIO::ImageOutput::create(path);
        EXPECT_TRUE(file && file->open(path, spec) &&
                    file->write_image(OIIO::TypeUInt32, pixels.data()) && file->close());
        return path;
    };
    const std::string a = image("a.tif", OIIO::TypeUInt32, 1),
                      b = image("b.tif", OIIO::TypeUInt32, 2);
    const Ran ids = run(make_compare_command(), {a, b});
    EXPECT_EQ(ids.code, exit_failed);
    EXPECT_NE(ids.err.find("nothing to look at"), std::string::npos) << ids.err;
    const std::string c = image("c.tif", OIIO::TypeUInt16, 0x12345678);
    EXPECT_EQ(run(make_compare_command(), {c, c}).code, exit_done);
}

TEST(Commands, MeshPrintsTheCost) {
    const Ran ran = run(make_mesh_command(), {scene, temporary("a.ply"), "--verbose"});
    EXPECT_EQ(ran.code, exit_done);
    double before = 0, after = 0;
    ASSERT_EQ(std::sscanf(ran.out.c_str(), "cost a pixel %lf before, %lf after", &before, &after),
              2)
        << ran.out;
    EXPECT_LT(after, before);
}

TEST(Commands, MeshsFlagsAreItemsOfTheFilter) {
    const auto made = [](std::vector<std::string> flags) {
        const std::string out = temporary("flags.ply");
        flags.insert(flags.begin(), {scene, out, "--verbose"});
        const Ran ran = run(make_mesh_command(), flags);
        EXPECT_EQ(ran.code, exit_done) << ran.err;
        return ran.out;
    };
    const std::string usual = made({});
    EXPECT_EQ(made({"--cost", "abn"}), usual);
    EXPECT_EQ(made({"--cost", "scf"}), made({"--filter", "ddt,cost=scf"}));
    EXPECT_NE(made({"--cost", "scf"}), made({"--filter", "ddt,cost=scf,contour=0.8"}));
    EXPECT_EQ(made({"--scheme", "lawson", "--filter", "ddt-sharp"}),
              made({"--filter", "ddt-sharp,scheme=lawson"}));
    EXPECT_EQ(made({"--cost=scf", "--filter=ddt,blur=0"}),
              made({"--filter", "ddt,cost=scf,blur=0"}));
    EXPECT_EQ(made({"--cost", "scf", "--filter", "ddt,cost=jnd"}),
              made({"--filter", "ddt,cost=scf"}));
}

TEST(Commands, InfoNamesTheLibraries) {
    const Ran ran = run(make_info_command(), {});
    EXPECT_EQ(ran.code, exit_done);
    for (const char* what : {"ddt ", "OpenImageIO", "OpenColorIO", "exproiN-maxgain", "dlp"})
        EXPECT_NE(ran.out.find(what), std::string::npos) << ran.out;
}

TEST(Progress, Line) {
    EXPECT_EQ(Progress::line("writing", 0),
              "writing [                                        ]   0 %");
    EXPECT_EQ(Progress::line("writing", 0.5f),
              "writing [====================                    ]  50 %");
    EXPECT_EQ(Progress::line("writing", 7),
              "writing [========================================] 100 %");
}

TEST(Progress, ShortWorkAndOtherThanTerminalsShowNothing) {
    testing::internal::CaptureStderr();
    {
        const bool terminal = true;
        Progress progress("working", ProgressMode::automatic, &terminal);
        for (int i = 0; i <= 10; ++i)
            EXPECT_TRUE(progress(0.1f * float(i)));
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(Progress, LinesForPrograms) {
    testing::internal::CaptureStderr();
    {
        Progress progress("resizing", ProgressMode::lines);
        for (const float share : {0.0f, 0.01f, 0.06f, 0.04f, 0.5f, 1.0f})
            progress(share);
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "ddt progress 0% resizing\nddt progress 5% resizing\n"
              "ddt progress 50% resizing\nddt progress 100% resizing\n");
}

TEST(Picture, ColoursAreAsDisplayed) {
    // Linear light 0.2140 is displayed as 0.5; associated with alpha 0.5 it is stored as half.
    OIIO::ImageSpec spec(3, 2, 4, OIIO::TypeFloat);
    spec.attribute("oiio:ColorSpace", "linear");
    OIIO::ImageBuf image(spec);
    const float pixel[4] = {0.1070207f, 0.0f, 0.5f, 0.5f};
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 3; ++x)
            image.setpixel(x, y, pixel);
    Picture picture;
    std::string error;
    ASSERT_TRUE(read_picture(image, {}, picture, error)) << error;
    EXPECT_TRUE(picture.has_alpha);
    ASSERT_EQ(picture.colours.size(), 6u);
    EXPECT_NEAR(picture.colours[5].red, 0.5f, 1e-3f);
    EXPECT_NEAR(picture.colours[5].green, 0.0f, 1e-6f);
    EXPECT_NEAR(picture.colours[5].blue, 1.0f, 1e-3f);
    EXPECT_EQ(picture.colours[5].alpha, 0.5f);
    // Light without cover is not divided by 0.
    const float glow[4] = {0.2140411f, 0.0f, 0.0f, 0.0f};
    image.setpixel(1, 0, glow);
    ASSERT_TRUE(read_picture(image, {}, picture, error)) << error;
    EXPECT_NEAR(picture.colours[1].red, 0.5f, 1e-3f);
    EXPECT_EQ(picture.colours[1].green, 0.0f);
    EXPECT_EQ(picture.colours[1].alpha, 0.0f);
}

} // namespace
} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
// Headers of parts: files that claim to be parts, of any windows, kinds of pixels and texts, join
// to a whole of the size they say, or fail with one line and leave nothing.
#include <iterator>

#include <OpenImageIO/imageio.h>

#include "plugin/tool/file/metadata_text.h"
#include "plugin/tool/part/join.h"
#include "plugin/tool/part/part.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"
#include "tests/temporary.h"

using namespace ddt;
using namespace ddt::fuzz;

namespace {

/// Mostly as a part has them, of any type and name.
std::string line_of_metadata(Bytes& bytes) {
    constexpr const char* names[] = {"compression", "oiio:ColorSpace", "Orientation",
                                     "smpte:TimeCode"};
    OIIO::ParamValueList list;
    list.attribute(names[bytes.below(int(std::size(names)))], bytes.line(24));
    std::string text = tool::text_of(list);
    for (int changes = bytes.below(8); changes > 0; --changes)
        text[size_t(bytes.below(int(text.size())))] = "0123456789abcdef -\n"[bytes.below(19)];
    return text;
}

/// Mostly a part of two halves of 40 x 40, with something changed.
bool write_part(Bytes& bytes, int index, const std::string& path) {
    constexpr OIIO::TypeDesc::BASETYPE types[] = {OIIO::TypeDesc::HALF, OIIO::TypeDesc::FLOAT,
                                                  OIIO::TypeDesc::UINT32};
    constexpr const char* others[] = {"channels", "metadata"};
    constexpr const char* orders[] = {"B\nG\nR", "G\nR", "R\nR\nR", "R\nG\nB\nA", "\n\n"};
    OIIO::ImageSpec spec(40, 20, 3, OIIO::TypeHalf);
    spec.y = 20 * index;
    spec.full_height = 40;
    spec.tile_width = spec.tile_height = 16;
    std::string part = std::to_string(index + 1) + "/2", whole = "0 0 40 40", type = "half",
                job = "job";
    for (int changes = bytes.below(4); changes > 0; --changes)
        switch (bytes.below(14)) {
        case 0:
            spec.x = bytes.take<int8_t>();
            break;
        case 1:
            spec.y = bytes.coin() ? bytes.take<int8_t>() : bytes.take<int32_t>();
            break;
        case 2:
            spec.width = bytes.between(1, 90);
            break;
        case 3:
            spec.height = bytes.between(1, 90);
            break;
        case 4:
            spec.nchannels = bytes.between(1, 5);
            spec.default_channel_names();
            break;
        case 5:
            spec.set_format(types[bytes.below(3)]);
            break;
        case 6:
            part = bytes.line(24);
            break;
        case 7:
            whole = bytes.line(60);
            break;
        case 8:
            type = bytes.line(24);
            break;
        case 9:
            job = bytes.line(8);
            break;
        case 10:
            spec.tile_width = bytes.below(3) * 16;
            spec.tile_height = bytes.below(5) * 16;
            break;
        case 11:
            spec.attribute(std::string("ddt_part:") + others[bytes.below(int(std::size(others)))],
                           bytes.line(24));
            break;
        case 12: // of the file, or of another
            spec.attribute("ddt_part:channels", orders[bytes.below(int(std::size(orders)))]);
            break;
        case 13:
            spec.attribute("ddt_part:metadata", line_of_metadata(bytes));
            break;
        }
    spec.attribute("ddt_part:job", job);
    spec.attribute("ddt_part:part", part);
    spec.attribute("ddt_part:whole", whole);
    spec.attribute("ddt_part:type", type);
    const auto file = OIIO::ImageOutput::create(path);
    const std::vector<char> pixels(spec.image_bytes());
    const bool done = file && file->open(path, spec) &&
                      file->write_image(spec.format, pixels.data()) && file->close();
    OIIO::geterror();
    return done;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Bytes bytes(data, size);
    tool::Part part;
    if (tool::parse_part(bytes.line(30), part))
        require(part.index >= 1 && part.index <= part.count && part.count <= tool::most_parts,
                "a part is one of those there are");
    std::vector<std::string> paths;
    for (int i = 0; i < 2; ++i) {
        paths.push_back(temporary("part." + std::to_string(i) + ".exr"));
        if (!write_part(bytes, i, paths.back()))
            return 0; // OpenEXR writes no such file
    }
    const std::string out = temporary("whole.exr");
    std::filesystem::remove(out);
    tool::Failure failure;
    const ProgressCallback progress = [](float) { return true; };
    if (tool::join(paths, out, progress, failure)) {
        const auto whole = OIIO::ImageInput::open(out);
        require(bool(whole), "what was joined can be read");
        require(whole->spec().width > 0 && whole->spec().height > 0, "it has pixels");
        return 0;
    }
    require(!failure.why.empty() && failure.why.find('\n') == std::string::npos,
            "a failure says why in one line: " + failure.why);
    require(!std::filesystem::exists(out), "a failure leaves nothing");
    return 0;
}

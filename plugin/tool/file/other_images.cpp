// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/other_images.h"

#include <OpenImageIO/imageio.h>

#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"

namespace ddt::tool {

namespace {

// 3.x prints errors that nobody asked for.

/// `look` at a file; nothing where it cannot be opened.
template <class Look>
void look_at(const std::string& path, Look&& look) {
    if (const auto input = OIIO::ImageInput::open(path))
        look(*input);
    else
        OIIO::geterror();
}

/// What the reader says of it, where that is so: a file's own texts may be metadata of that name.
int count_images(OIIO::ImageInput& input) {
    const OIIO::ParamValue* const told =
        input.spec().find_attribute("oiio:subimages", OIIO::TypeInt);
    int images = told ? told->get_int() : 1;
    if (images < 1 || !input.seek_subimage(images - 1, 0))
        images = 1;
    while (input.seek_subimage(images, 0))
        ++images;
    input.geterror();
    return images;
}

void add_levels(OIIO::ImageInput& input, const std::string& path, std::vector<std::string>& told) {
    if (input.seek_subimage(0, 1))
        told.push_back(format("\"{}\" has MIP levels; the largest alone was taken", path));
    input.geterror();
}

} // namespace

int count_images(const std::string& path) {
    int images = 0;
    look_at(path, [&](OIIO::ImageInput& input) { images = count_images(input); });
    return images;
}

std::vector<std::string> images_beside(const std::string& path,
                                       const std::string& how_to_have_all) {
    std::vector<std::string> told;
    look_at(path, [&](OIIO::ImageInput& input) {
        if (const int images = count_images(input); images > 1)
            told.push_back(
                format("\"{}\" has {} images; the first alone was taken{}", path, images,
                       how_to_have_all.empty() ? "" : " (all: " + how_to_have_all + ")"));
        add_levels(input, path, told);
    });
    return told;
}

std::vector<std::string> levels_beside(const std::string& path) {
    std::vector<std::string> told;
    look_at(path, [&](OIIO::ImageInput& input) { add_levels(input, path, told); });
    return told;
}

void note_others(const std::string& path) {
    note(images_beside(path));
}

} // namespace ddt::tool

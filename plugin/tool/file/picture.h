// SPDX-License-Identifier: Apache-2.0
// An image file as the commands look at it.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "ddt/resize.h"
#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// One pixel as a display shows it: not associated with alpha, 0 to 1 from black to white (values
/// of a scene may be beyond).
struct Colour {
    float red = 0, green = 0, blue = 0, alpha = 1;
};

/// The pixels of an image's data window, row by row.
struct Picture {
    int width = 0, height = 0;
    bool has_alpha = false;
    std::vector<Colour> colours; ///< grey as three equal; without colour, the guide's channel
    std::vector<float> guide;
    std::vector<float> heights; ///< a pixel, in a mesh that is lifted (mesh/heights.h); or none
};

/// One line that says why the image of a file cannot be read; said: by OpenImageIO, or nothing.
std::string why_unreadable(const std::string& said, const std::string& path);
std::string why_unreadable(const OIIO::ImageBuf& image, const std::string& path);

/// How messages name the image of this number from 0 in a file: "in.exr", or "in.exr", image 2.
std::string image_name(const std::string& path, int number = 0);

/// False with one line in `error` if the image of a file makes its reader overrun its memory
/// (plugin/image/metadata.h), or the file is a pipe or a character device, with which readers would
/// never be done. To be asked before a reader is tried on a file, and before an ImageBuf without a
/// cache is made of it: that of OpenImageIO 2.5 reads pixels at once.
bool check_reader(const std::string& path, int number, std::string& error);
bool check_reader(const std::string& path, int number, Failure& failure);

/// Have an ImageBuf of the image of this number in a file, of which check_reader() was asked, know
/// its spec. False with one line in `error`, also if the file is cut off (truncated.h), which its
/// reader would not say.
bool begin_image(const std::string& path, int number, OIIO::ImageBuf& image, std::string& error);

/// Read the image of this number from 0 in a file, its pixels included; hints: for its reader, or
/// null. False with one line in `error`, also if the file was changed meanwhile.
bool open_image(const std::string& path, OIIO::ImageBuf& image, std::string& error, int number = 0,
                const OIIO::ImageSpec* hints = nullptr);

/// The image's spec with the file's types, where its pixels are held as others.
OIIO::ImageSpec spec_of_file(const OIIO::ImageBuf& image);

/// The failure for a file that open_image() could not open.
Failure unreadable(const std::string& path, const std::string& error);

/// Open a file at the image of this number from 0. Null with one line in `error`.
std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path, int number,
                                             std::string& error);

/// How many images a file has; 0 if it cannot be opened. OpenImageIO 3's ImageBuf does not know it
/// of every format.
int count_images(const std::string& path);

/// Say on stderr that of the images in a file only the first was looked at, if there are more, and
/// how to have all, if that can be said; and what note_levels() says.
void note_others(const std::string& path, const std::string& how_to_have_all = "");

/// Say on stderr that of the first image in a file only the largest MIP level was looked at, if it
/// has more: results have none.
void note_levels(const std::string& path);

/// Read an image under options.light. False with one line in `error`, as for an image of IDs
/// alone, which no display shows.
bool read_picture(const OIIO::ImageBuf& image, const Options& options, Picture& picture,
                  std::string& error);

/// False with a failure unless an image of that size may be had (check_size() of
/// plugin/image/windows.h).
bool check_size_of(const OIIO::ImageSpec& spec, Failure& failure);

/// Read channels [chbegin, chend) of pixels of the image that the input is at as they are, without
/// gaps: whole tiles where it has them, else whole rows. False with a line in input.geterror().
bool read_native(OIIO::ImageInput& input, const Rect& r, int chbegin, int chend, void* to);
/// All channels.
bool read_native(OIIO::ImageInput& input, const Rect& r, void* to);

/// [r.x0, r.x1) x [r.y0, r.y1) cut to the file's pixels and extended to what read_native() reads.
Rect readable(const OIIO::ImageSpec& file, const Rect& r);

} // namespace ddt::tool

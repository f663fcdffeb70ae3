// SPDX-License-Identifier: Apache-2.0
// Opening the images of files, and why one cannot be read.
#pragma once

#include <memory>
#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "plugin/tool/command/exit_code.h"

namespace ddt::tool {

/// One line that says why the image of a file cannot be read; said: by OpenImageIO, or nothing.
std::string why_unreadable(const std::string& said, const std::string& path);
std::string why_unreadable(const OIIO::ImageBuf& image, const std::string& path);

/// How messages name the image of this number from 0 in a file: "in.exr", or "in.exr", image 2.
std::string image_name(const std::string& path, int number = 0);

/// False with one line in `error` if the image of a file makes its reader overrun its memory
/// (plugin/image/oiio_defects.h), or the file is a pipe or a character device, with which readers
/// would never be done. To be asked before a reader is tried on a file, and before an ImageBuf
/// without a cache is made of it: that of OpenImageIO 2.5 reads pixels at once.
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

/// Open a file at the image of this number from 0. Null with one line in `error`;
/// hints: for its reader, or null.
std::unique_ptr<OIIO::ImageInput> open_input(const std::string& path, int number,
                                             std::string& error,
                                             const OIIO::ImageSpec* hints = nullptr);

} // namespace ddt::tool

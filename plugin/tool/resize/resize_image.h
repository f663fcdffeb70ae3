// SPDX-License-Identifier: Apache-2.0
// One image of a file into one of another, read and written while it is resized.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

#include "ddt/progress.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/resize/plan_result.h"
#include "plugin/tool/resize/row_reader.h"

namespace ddt::tool {

/// An image of a file, the rows of which may still be on their way once it was begun.
struct ArrivingImage {
    ArrivingImage(const std::string& file, int of_file) : path(file), number(of_file) {}
    /// False with a failure.
    bool begin(Failure& failure) {
        if (reader.begin(path, image, failure.why, number))
            return true;
        failure.code = code_of_message(failure.why);
        return false;
    }

    const std::string path;
    const int number; ///< of the image, from 0
    OIIO::ImageBuf image;
    RowReader reader; // which ends before the image
};

/// Resize an image into the one that the file is open for, which has this spec. wanted: the pixels
/// that the result would have in a file with room for all.
bool resize_image(ArrivingImage& source, const OIIO::ROI& wanted, const OIIO::ImageSpec& spec,
                  ImageFile& file, const ResizeSettings& settings, const ProgressCallback& progress,
                  Failure& failure);

} // namespace ddt::tool

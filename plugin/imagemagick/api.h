// SPDX-License-Identifier: Apache-2.0
// What ImageMagick 6 and 7 call otherwise, under one name each.
#pragma once

#if __has_include(<MagickCore/MagickCore.h>)
#include <MagickCore/MagickCore.h>
#define DDT_MAGICK_7 1
#else
#include <magick/MagickCore.h>
#define DDT_MAGICK_7 0
#endif

namespace ddt::magick {

inline bool has_alpha(const Image& image) {
#if DDT_MAGICK_7
    return image.alpha_trait != UndefinedPixelTrait;
#else
    return image.matte != MagickFalse;
#endif
}

/// Have the image keep its pixels themselves. False with an exception.
inline bool keep_pixels(Image& image, ExceptionInfo* exception) {
#if DDT_MAGICK_7
    return SetImageStorageClass(&image, DirectClass, exception) != MagickFalse;
#else
    if (SetImageStorageClass(&image, DirectClass) != MagickFalse)
        return true;
    InheritException(exception, &image.exception);
    return false;
#endif
}

/// Store numbers of all pixels, named by `map`. False with an exception.
inline bool import_pixels(Image& image, const char* map, StorageType type, const void* numbers,
                          ExceptionInfo* exception) {
#if DDT_MAGICK_7
    return ImportImagePixels(&image, 0, 0, image.columns, image.rows, map, type, numbers,
                             exception) != MagickFalse;
#else
    if (ImportImagePixels(&image, 0, 0, image.columns, image.rows, map, type, numbers) !=
        MagickFalse)
        return true;
    InheritException(exception, &image.exception);
    return false;
#endif
}

} // namespace ddt::magick

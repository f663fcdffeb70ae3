// SPDX-License-Identifier: Apache-2.0
// The test images, one function each.
#pragma once

#include <OpenImageIO/imagebuf.h>

namespace testimages {

// charts.cpp
OIIO::ImageBuf siemens_star();  ///< wedges that meet in the centre: all angles, all frequencies
OIIO::ImageBuf zone_plate();    ///< rings from frequency 0 to half the sampling rate
OIIO::ImageBuf checkerboards(); ///< squares of 1, 2, 3 and 8 pixels
OIIO::ImageBuf ramps();         ///< planes: must come back as planes

// drawings.cpp
OIIO::ImageBuf strokes(); ///< text-like strokes from 1 to 5 pixels wide
OIIO::ImageBuf lines();   ///< circles, and thin lines at many angles
OIIO::ImageBuf alpha();   ///< soft and hard alpha edges over colour, black strokes on nothing

// scene_linear.cpp
OIIO::ImageBuf light();  ///< a light of 1000 beside black
OIIO::ImageBuf window(); ///< a data window that leaves the display window on two sides
OIIO::ImageBuf layers(); ///< colour, coverage, depth and object IDs in one float image
OIIO::ImageBuf ids();    ///< object IDs as 32-bit integers

// scene.cpp
OIIO::ImageBuf scene(); ///< something to look at: sky, roof, fence, leaves

} // namespace testimages

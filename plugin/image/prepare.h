// SPDX-License-Identifier: Apache-2.0
// Before pixels are worked on: checks of the images of a call, and the destination's preparation.
#pragma once

#include <string>

#include <OpenImageIO/imagebuf.h>

namespace ddt {

/// False with one line in `error` unless `src` is an image the filters can work on: readable, flat,
/// not a volume, not empty, of numbers OpenImageIO converts.
bool check_source(const OIIO::ImageBuf& src, std::string& error);
/// The same before pixels are read.
bool check_source_spec(const OIIO::ImageSpec& spec, std::string& error);

/// Make `dst` ready to be written and `roi` what is to be written of it, as ImageBufAlgo does (the
/// flags are IBAprep's): an initialised dst keeps its size and cuts the roi; another is allocated
/// for the roi, or like src without one. The size and the roi's channels are checked before. False
/// with one line in `error`. A roi that misses dst comes back empty.
bool prepare(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::ROI& roi, int flags,
             std::string& error);

} // namespace ddt

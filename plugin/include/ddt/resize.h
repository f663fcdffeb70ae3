// SPDX-License-Identifier: Apache-2.0
// Resizing an ImageBuf by data-dependent triangulation.
//
//     OIIO::ImageBuf in("photo.png"), out;
//     if (!ddt::resize(out, in, {}, OIIO::ROI(0, 4 * in.spec().width, 0, 4 * in.spec().height)))
//         std::cerr << out.geterror() << "\n";
//
// These functions behave as their namesakes in OIIO::ImageBufAlgo. They return false on failure,
// with one line in dst's error that names the thing at fault and what is allowed; they never throw,
// never print (unless the environment variable DDT_VERBOSE is set), and may be called from several
// threads at once for different dst. After a failure a dst that was not initialised is so still; in
// another the pixels asked for are untouched or black, never half of a result.
//
// Pixels. uint8, int8, uint16, int16, half, float and double are interpolated as float32 numbers;
// uint32 and int32 are object IDs, copied bit for bit, to either type, from the nearest vertex of
// the mesh, and so are the channels of other images that are IDs by name, by cryptomatte metadata
// or by their own type in the file: as floats, which have no room for all doubles and integers
// beyond 2^24. NaN and infinities stay within the triangles that touch them; an integer dst shows
// NaN as 0. Numbers of magnitude below 2^-80, some 8e-25, count as 0 where they are interpolated.
// An image whose display window does not change its size keeps its pixels' exact bits.
//
// Light. Colour (R, G, B or grey) is interpolated in linear light: OpenColorIO converts it from the
// image's colour space and back, by the config in $OCIO or else a built-in one. Where the image
// names no space that is known (oiio:ColorSpace), or one of data, numbers stay as they are. Other
// channels are not converted. Colour that is associated with alpha is divided by it only round that
// conversion, and not where 0 and 1 are not 0 and 1 in linear light, as in logarithmic spaces;
// colour where alpha is 0 survives.
//
// Regions. A roi limits which pixels and channels are written. One beside the pixels of a dst that
// is initialised writes nothing, which is no failure; a range without any of the image's channels
// is one.
//
// Result. A function of the source's pixels, windows and metadata and of the options alone: it has
// the same bits for any number of threads, and a part (roi) is a crop of the whole; where an axis
// shrinks and none grows, within 2^25 pixels from the origin (docs/limits.md).
#pragma once

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "ddt/core.h"
#include "ddt/names.h"
#include "ddt/option_table.h"
#include "ddt/progress.h"

namespace ddt {

/// How to resize; the defaults are those of the filter `ddt`. parse_filter() of
/// ddt/option_table.h sets the inherited fields by a specification such as "ddt-sharp,cost=scf".
/// `clipped` is set by itself for a dst of uint8 or uint16; `fitted` does not follow. A colour
/// space in `light` must be in the OCIO config.
struct Options : FilterOptions {
    /// Not called for what is OpenImageIO's own work or a copy.
    ProgressCallback progress;
    Statistics* statistics = nullptr; ///< filled in when not null and a mesh was made
};

/// Resize: the source's display window maps onto dst's, pixel centres at half integers; data
/// windows are honoured, beyond the source's data window its outermost pixels go on. `roi` limits
/// which pixels and channels are written. A dst that is not initialised becomes roi's size, or
/// src's without one, with src's channels and pixel type.
///
/// If an axis shrinks and the other does not grow, this is OpenImageIO's own resize with its
/// default filter, on the numbers as they are. If one grows and the other shrinks, the first is
/// enlarged by the mesh and the second shrunk by that filter along this axis alone. IDs are copied
/// from the nearest pixel.
///
/// nthreads 0: OpenImageIO's attribute "threads"; where that is the number of processors, no more
/// than a container's quota is worth.
bool resize(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options = {},
            OIIO::ROI roi = {}, int nthreads = 0);

/// Which pixels are missing, beside those with a NaN in a channel.
enum class Missing {
    nan,   ///< no others
    alpha, ///< those whose alpha is 0, if there is alpha
};

/// Fill the missing pixels: dst becomes a copy of src in which they are interpolated over triangles
/// of the pixels about them, as Job::holes of ddt/job.h says, whatever options.holes; edges are
/// sought under options.light, values are interpolated as they are. A pixel that lacks some
/// channels keeps the others; channels of IDs are copied from the nearest vertex. A failure
/// if no pixel is there; not if none is missing. A dst that wraps its caller's memory keeps it, and
/// its spec: it has src's size and channels, or else this is a failure.
bool fill(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options = {},
          Missing missing = Missing::nan);

/// Warp: M maps source to output pixel coordinates, (x, y, 1) * M with pixel centres at half
/// integers. An output pixel whose centre comes from outside the source's data window is black. A
/// dst that is not initialised becomes roi's size, or without one src's, or with `recompute_roi`
/// that of the box of the data window's outermost pixel centres as mapped, as OpenImageIO has it:
/// half a source pixel less on each side than that of the window. Its display window is src's.
///
/// Where M shrinks the data window anywhere, in any direction, by more than a thousandth, and for
/// the wrap modes other than default and black, this is OpenImageIO's own warp with its default
/// filter, which blends IDs as it does all numbers. A matrix without inverse is an error.
bool warp(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::M33fParam M,
          const Options& options = {}, bool recompute_roi = false,
          OIIO::ImageBuf::WrapMode wrap = OIIO::ImageBuf::WrapDefault, OIIO::ROI roi = {},
          int nthreads = 0);

} // namespace ddt

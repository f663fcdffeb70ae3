// Resizing an ImageBuf by data-dependent triangulation.
#pragma once

#include <functional>
#include <string>

#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imagebufalgo.h>

#include "ddt/core.h"

namespace ddt {

/// How to resize; the defaults are those of the filter name "ddt".
struct Options {
    Surface surface = Surface::patch; ///< filter names: ddt-linear, ddt
    MeshOptions mesh;
    /// Light in which values are interpolated. "auto": linear, from the colour space in the image's
    /// "oiio:ColorSpace"; "encoded": as the numbers are; otherwise the name of the image's space.
    std::string light = "auto";
    /// Called now and then with the share done (0..1); return false to cancel.
    std::function<bool(float)> progress;
};

/// Names that start a filter specification, "ddt" or "ddt-linear", possibly followed by
/// ",key=value" options.
bool is_filter_name(OIIO::string_view spec);

/// Parse "ddt,key=value,...". On failure return false with one line in `error` that names the
/// option and lists what is allowed; `options` is then unchanged.
bool parse_filter(OIIO::string_view spec, Options& options, std::string& error);

/// Resize in the manner of ImageBufAlgo::resize: the source's display window maps onto dst's, both
/// data windows are honoured, `roi` limits what is computed; an uninitialised dst takes its size
/// from roi, its channels and format from src. An axis that shrinks goes to OIIO's own filter.
/// Returns false with dst.errorfmt set on failure; never throws. nthreads 0: OIIO's default.
bool resize(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Options& options = {},
            OIIO::ROI roi = {}, int nthreads = 0);

/// Warp in the manner of ImageBufAlgo::warp: M maps source to output coordinates; outside the
/// source's data window the output is black. Where M shrinks, OIIO's default filter is used.
bool warp(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, OIIO::M33fParam M,
          const Options& options = {}, bool recompute_roi = false,
          OIIO::ImageBuf::WrapMode wrap = OIIO::ImageBuf::WrapDefault, OIIO::ROI roi = {},
          int nthreads = 0);

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/by_oiio.h"

#include <OpenImageIO/imagebufalgo.h>

#include "plugin/image/cached_reads.h"
#include "plugin/image/memory.h"
#include "plugin/imagebuf/copy.h"

namespace ddt {

bool check_was_read(const OIIO::ImageBuf& reader, std::string& error) {
    if (!reader.has_error())
        return true;
    error = "the source image cannot be read: " + reader.geterror();
    CachedReads::fail(reader, error);
    return false;
}

bool is_written_by_oiio(OIIO::TypeDesc type) {
    return type == OIIO::TypeUInt8 || type == OIIO::TypeUInt16 || type == OIIO::TypeHalf ||
           type == OIIO::TypeFloat;
}

bool resize_by_oiio(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                    int nthreads, std::string& error) {
    const auto resized = [&](OIIO::ImageBuf& out, const OIIO::ROI& part) {
        return while_reading(src, error, [&](const OIIO::ImageBuf& from) {
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
            const bool ok =
                OIIO::ImageBufAlgo::resize(out, from, OIIO::ParamValueSpan(), part, nthreads);
#else
            const bool ok = OIIO::ImageBufAlgo::resize(out, from, "", 0.0f, part, nthreads);
#endif
            if (!ok)
                error = out.has_error() ? out.geterror() : "OpenImageIO's resize failed";
            return ok;
        });
    };
    const OIIO::TypeDesc type = dst.spec().format;
    const bool known = is_written_by_oiio(type);
    if (known && roi.chbegin == 0 && roi.chend == dst.nchannels() && roi.chend == src.nchannels())
        return resized(dst, roi);
    OIIO::ImageSpec spec = src.spec();
    spec.set_format(known ? type : OIIO::TypeFloat);
    OIIO::ROI part = roi;
    part.chbegin = 0;
    part.chend = src.nchannels();
    OIIO::set_roi(spec, part);
    OIIO::set_roi_full(spec, dst.roi_full());
    if (!check_size(part, spec.nchannels, spec.format, error))
        return false;
    OIIO::ImageBuf all;
    return make_image(all, spec, error) && resized(all, part) &&
           copy_moved(dst, all, roi, 0, 0, Beyond::edge, error);
}

} // namespace ddt

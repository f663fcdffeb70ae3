// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo's resize, fit and warp from OIIO 3.0 on, where filters come in a list of parameters,
// by every entry point: a library linked with -Bsymbolic-functions calls its own functions past our
// redirection.
#include "plugin/imagebuf/warp.h"
#include "plugin/register/filter.h"
#include "plugin/register/fit.h"
#include "plugin/register/hooks.h"
#include "plugin/register/returning.h"

namespace ddt {
namespace {

using namespace OIIO;
using ImageBufAlgo::KWArgs;

/// Whether a call is ours, and with which options.
class Call {
public:
    /// "filterptr" goes before "filtername", as in OIIO.
    Call(KWArgs args) {
        const auto pointer = args.find("filterptr", TypePointer);
        if (pointer != args.end() && pointer->get<const Filter2D*>())
            m_filter = as_ours(pointer->get<const Filter2D*>());
        else
            m_name = args.get_string("filtername");
    }

    bool ours() const { return m_filter || is_filter_name(m_name); }

    bool parse(ImageBuf& dst, Options& options) const {
        if (!m_filter)
            return parse_filter_for(dst, m_name, options);
        options = m_filter->options();
        return true;
    }

private:
    const Filter* m_filter = nullptr;
    string_view m_name;
};

bool resize_by_list(ImageBuf& dst, const ImageBuf& src, KWArgs args, ROI roi, int nthreads) {
    const Call call(args);
    if (!call.ours())
        return ImageBufAlgo::resize(dst, src, args, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return call.parse(dst, options) && resize(dst, src, options, roi, nthreads);
    });
}

bool fit_by_list(ImageBuf& dst, const ImageBuf& src, KWArgs args, ROI roi, int nthreads) {
    const Call call(args);
    if (!call.ours())
        return ImageBufAlgo::fit(dst, src, args, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return call.parse(dst, options) &&
               fit(dst, src, options, args.get_string("fillmode", "letterbox"),
                   args.get_int("exact"), roi, nthreads);
    });
}

ImageBuf::WrapMode wrap_mode(KWArgs args) {
    const auto wrap = args.find("wrap");
    if (wrap == args.end())
        return ImageBuf::WrapDefault;
    return wrap->type() == TypeString ? ImageBuf::WrapMode_from_string(wrap->get_string())
                                      : ImageBuf::WrapMode(wrap->get_int());
}

bool warp_by_list(ImageBuf& dst, const ImageBuf& src, M33fParam M, KWArgs args, ROI roi,
                  int nthreads) {
    const Call call(args);
    if (!call.ours())
        return ImageBufAlgo::warp(dst, src, M, args, roi, nthreads);
    return without_throwing(dst, [&] {
        Options options;
        return call.parse(dst, options) &&
               warp(dst, src, M, options, args.get_int("recompute_roi"), wrap_mode(args),
                    args.get_int("edgeclamp"), roi, nthreads);
    });
}

} // namespace

void add_algorithms(Redirects& list) {
    constexpr const char *resizing = "ImageBufAlgo::resize", *fitting = "ImageBufAlgo::fit",
                         *warping = "ImageBufAlgo::warp";
    add_both<&resize_by_list>(list, resizing, &ImageBufAlgo::resize, &ImageBufAlgo::resize);
    add_both<&fit_by_list>(list, fitting, &ImageBufAlgo::fit, &ImageBufAlgo::fit);
    add_both<&warp_by_list>(list, warping, &ImageBufAlgo::warp, &ImageBufAlgo::warp);
    add_warp(list);
    add_rotate(list);
    add_st_warp(list);
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
// ImageBufAlgo's choke points from OIIO 3.0 on, where filters come in a list of parameters. The
// deprecated forms, and those that return an ImageBuf, call these within OIIO through its own table
// of functions.
//
// Compiled against the headers of OIIO 3.0, never run.
#include "filter.h"
#include "fit.h"
#include "hooks.h"

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
        if (!call.parse(dst, options))
            return false;
        const string_view fillmode = args.get_string("fillmode", "letterbox");
        if (args.get_int("exact"))
            return fit_exactly(dst, src, options, fillmode, roi, nthreads);
        // By way of ImageBufAlgo::resize, which gets this filter.
        const Filter filter("ddt", options, 2.0f, 2.0f);
        const Filter2D* base = &filter;
        return ImageBufAlgo::fit(dst, src, {make_pv("filterptr", base), {"fillmode", fillmode}},
                                 roi, nthreads);
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
        return call.parse(dst, options) && warp(dst, src, M, options, args.get_int("recompute_roi"),
                                                wrap_mode(args), roi, nthreads);
    });
}

} // namespace

void add_algorithms(Redirects& list) {
    // rotate needs no stand-in: it calls warp.
    add(list, "ImageBufAlgo::resize", &ImageBufAlgo::resize, &resize_by_list);
    add(list, "ImageBufAlgo::fit", &ImageBufAlgo::fit, &fit_by_list);
    add(list, "ImageBufAlgo::warp", &ImageBufAlgo::warp, &warp_by_list);
}

} // namespace ddt

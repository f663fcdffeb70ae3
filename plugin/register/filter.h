// SPDX-License-Identifier: Apache-2.0
// The filter objects that stand for "ddt" wherever OpenImageIO passes a Filter2D.
#pragma once

#include <string>

#include <OpenImageIO/filter.h>

#include "core/base/guarded.h"
#include "ddt/resize.h"
#include "plugin/message/format.h"

namespace ddt {

/// Carries the options from Filter2D::create to the functions that take a filter. Those of
/// ImageBufAlgo that are redirected ask for the options; code that just evaluates the filter sees
/// a tent, the nearest thing to interpolation over triangles that a fixed kernel can be, and once
/// in the process a line on standard error says so.
class Filter final : public OIIO::Filter2D {
public:
    Filter(OIIO::string_view spec, Options options, float width, float height)
        : Filter2D(width, height), m_spec(spec), m_options(std::move(options)) {}

    bool separable() const override { return true; }
    float operator()(float x, float y) const override { return xfilt(x) * yfilt(y); }
    float xfilt(float x) const override { return tent(x, m_w); }
    float yfilt(float y) const override { return tent(y, m_h); }
    /// The whole specification: creating a filter by it gives an equal one.
    OIIO::string_view name() const override { return m_spec; }

    const Options& options() const { return m_options; }

private:
    static float tent(float x, float width);

    std::string m_spec;
    Options m_options;
};

/// `filter` if it is one of ours, else null.
const Filter* as_ours(const OIIO::Filter2D* filter);

/// The number of our filters, and how OpenImageIO lists the one at `index`.
int filter_count();
const OIIO::FilterDesc& filter_description(int index);

/// Parse a filter specification; on failure put the reason into dst's error and return false.
bool parse_filter_for(OIIO::ImageBuf& dst, OIIO::string_view spec, Options& options);

/// Run f and return what it does; an exception becomes an error of dst.
template <typename F>
bool without_throwing(OIIO::ImageBuf& dst, F f) {
    bool done = false;
    std::string error;
    if (guarded_call(&error, [&] { done = f(); }) == Caught::nothing)
        return done;
    guarded_call(nullptr, [&] { set_error(dst, error); });
    return false;
}

} // namespace ddt

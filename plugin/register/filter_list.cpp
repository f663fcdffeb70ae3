// SPDX-License-Identifier: Apache-2.0
#include <dlfcn.h>

#include <OpenImageIO/imagebufalgo.h>

#include "core/base/guarded.h"
#include "plugin/register/filter.h"
#include "plugin/register/hooks.h"

namespace ddt {
namespace {

int num_filters() {
    return OIIO::Filter2D::num_filters() + filter_count();
}

const OIIO::FilterDesc& get_filterdesc(int index) {
    const int ours = index - OIIO::Filter2D::num_filters();
    return ours >= 0 && ours < filter_count() ? filter_description(ours)
                                              : OIIO::Filter2D::get_filterdesc(index);
}

void copy_filterdesc(int index, OIIO::FilterDesc* description) {
    *description = get_filterdesc(index);
}

/// Null for options that do not parse, as OIIO has it for names it does not know.
Filter* create_ours(OIIO::string_view spec, float width, float height) noexcept {
    Filter* filter = nullptr;
    guarded_call(nullptr, [&] {
        Options options;
        std::string error;
        if (parse_filter(spec, options, error))
            filter = new Filter(spec, std::move(options), width, height);
    });
    return filter;
}

/// False for a caller within OpenImageIO that would evaluate the filter itself, because what it
/// calls then does not reach us: it gets no filter, and fails with a line of its own.
bool may_have_filters(void* caller) {
    if (own_calls_redirected())
        return true;
    Dl_info asking, library;
    const auto some = reinterpret_cast<void*>(
        static_cast<bool (*)(OIIO::ImageBuf&, const OIIO::ImageBuf&, bool, OIIO::ROI, int)>(
            &OIIO::ImageBufAlgo::resample));
    return !dladdr(caller, &asking) || !dladdr(some, &library) ||
           asking.dli_fbase != library.dli_fbase;
}

OIIO::Filter2D* create(OIIO::string_view name, float width, float height) {
    if (!is_filter_name(name))
        return OIIO::Filter2D::create(name, width, height);
    return may_have_filters(__builtin_return_address(0)) ? create_ours(name, width, height)
                                                         : nullptr;
}

#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
OIIO::Filter2D::ref create_shared(OIIO::string_view name, float width, float height) {
    if (!is_filter_name(name))
        return OIIO::Filter2D::create_shared(name, width, height);
    return OIIO::Filter2D::ref(
        may_have_filters(__builtin_return_address(0)) ? create_ours(name, width, height) : nullptr);
}
#endif

} // namespace

void add_filter_list(Redirects& list) {
    using OIIO::Filter2D;
    add(list, "Filter2D::num_filters", &Filter2D::num_filters, &num_filters);
    add(list, "Filter2D::get_filterdesc", &Filter2D::get_filterdesc, &get_filterdesc);
    add(list, "Filter2D::get_filterdesc", &Filter2D::get_filterdesc, &copy_filterdesc);
    add(list, "Filter2D::create", &Filter2D::create, &create);
#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
    add(list, "Filter2D::create_shared", &Filter2D::create_shared, &create_shared);
#endif
}

} // namespace ddt

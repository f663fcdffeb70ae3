// SPDX-License-Identifier: Apache-2.0
#include "filter.h"
#include "hooks.h"

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
    try {
        Options options;
        std::string error;
        if (parse_filter(spec, options, error))
            return new Filter(spec, std::move(options), width, height);
    } catch (...) {
    }
    return nullptr;
}

OIIO::Filter2D* create(OIIO::string_view name, float width, float height) {
    return is_filter_name(name) ? create_ours(name, width, height)
                                : OIIO::Filter2D::create(name, width, height);
}

#if OIIO_VERSION >= OIIO_MAKE_VERSION(3, 0, 0)
// Compiled against the headers of OIIO 3.0, never run.
OIIO::Filter2D::ref create_shared(OIIO::string_view name, float width, float height) {
    return is_filter_name(name) ? OIIO::Filter2D::ref(create_ours(name, width, height))
                                : OIIO::Filter2D::create_shared(name, width, height);
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

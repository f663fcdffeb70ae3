// SPDX-License-Identifier: Apache-2.0
// The operation gegl:ddt: in GIMP's tool for GEGL operations, in programs that use GEGL, and
//
//     gegl in.png -o out.png -- ddt scale=4
//
// It works in linear light, or on the encoded numbers.
#include <algorithm>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include <gegl-plugin.h>
#include <gegl.h>

#include "core/base/guarded.h"
#include "plugin/gegl/properties.h"
#include "plugin/host/parameters.h"
#include "plugin/host/pixels.h"
#include "plugin/host/request.h"

namespace {

using namespace ddt::host;
using ddt::Rect;
using ddt::gegl::Settings;
using ddt::gegl::specification;

/// The instance. GObject gives and takes its memory.
struct Operation {
    GeglOperationFilter parent;
    Settings settings;
};
struct OperationClass {
    GeglOperationFilterClass parent;
};

GTypeModule* module = nullptr;
GType operation_type = 0;
gpointer parent_class = nullptr;

Operation& self_of(gpointer object) {
    return *reinterpret_cast<Operation*>(object);
}

Rect rect_of(const GeglRectangle& r) {
    return {r.x, r.y, r.x + r.width, r.y + r.height};
}
GeglRectangle rectangle_of(const Rect& r) {
    return {r.x0, r.y0, std::max(0, r.width()), std::max(0, r.height())};
}

GeglRectangle source_box(GeglOperation* operation) {
    const GeglRectangle* box = gegl_operation_source_get_bounding_box(operation, "input");
    return box ? *box : GeglRectangle{0, 0, 0, 0};
}

/// False where there is nothing to enlarge: no picture, or an endless one.
bool find_place(GeglOperation* operation, Placing& place) {
    const GeglRectangle box = source_box(operation);
    if (box.width <= 0 || box.height <= 0 || gegl_rectangle_is_infinite_plane(&box))
        return false;
    const Rect window = rect_of(box);
    if (!window.within_limits())
        return false;
    place =
        by_factors(window, self_of(operation).settings.scale, self_of(operation).settings.scale);
    return true;
}

/// What the operation asks babl for, and what it makes of it by itself.
struct Wanted {
    const Babl* format = nullptr; ///< float, grey or colour, with alpha or without, as the input is
    int channels = 0;
    bool associated = true;
    const char* light = "linear"; ///< one of meaning_names()
    /// The largest of the input's whole numbers if it has such, and they only became floats; else
    /// 0.
    float largest = 0;
};

/// As OpenImageIO makes floats of whole numbers; babl's may differ in the last place.
void snap(float largest, float* values, size_t count) {
    const float unit = 1.0f / largest;
    for (size_t i = 0; i < count; ++i)
        values[i] = std::nearbyint(values[i] * largest) * unit;
}

/// The name of the light whose numbers a space's curve makes of linear light; null if there is
/// none.
const char* curve_of(const Babl* space) {
    const Babl* curves[3] = {};
    babl_space_get(space, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr, nullptr,
                   &curves[0], &curves[1], &curves[2]);
    if (curves[0] != curves[1] || curves[0] != curves[2])
        return nullptr;
    return curves[0] == babl_trc("sRGB")     ? "sRGB"
           : curves[0] == babl_trc("linear") ? "linear"
                                             : nullptr;
}

/// Numbers are taken as the input has them where their curve is known: babl's own way through it
/// and back differs from the filter's in the last places, and for transparent pixels.
Wanted wanted_by(GeglOperation* operation) {
    // By curve, then without alpha, with, and associated.
    static const char* const colour[2][3] = {{"RGB float", "RGBA float", "RaGaBaA float"},
                                             {"R'G'B' float", "R'G'B'A float", "R'aG'aB'aA float"}};
    static const char* const grey[2][3] = {{"Y float", "YA float", "YaA float"},
                                           {"Y' float", "Y'A float", "Y'aA float"}};
    const Babl* source = gegl_operation_get_source_format(operation, "input");
    const Babl* space = gegl_operation_get_source_space(operation, "input");
    const auto flags = source ? babl_get_model_flags(source)
                              : BablModelFlag(BABL_MODEL_FLAG_RGB | BABL_MODEL_FLAG_ALPHA |
                                              BABL_MODEL_FLAG_ASSOCIATED);
    // Of palettes there are no flags; of formats such as "HSVA float" the flags alone tell.
    const bool alpha = !source || babl_format_has_alpha(source) || flags & BABL_MODEL_FLAG_ALPHA,
               is_grey = flags & BABL_MODEL_FLAG_GRAY;
    const char* curve =
        flags & BABL_MODEL_FLAG_NONLINEAR ? curve_of(space ? space : babl_space("sRGB")) : nullptr;
    const bool blend_encoded = self_of(operation).settings.blends_encoded();
    Wanted wanted;
    wanted.channels = (is_grey ? 1 : 3) + (alpha ? 1 : 0);
    // Of transparent pixels babl's way from "YaA float" to "Y'aA float" writes beyond its memory.
    const bool is_unsafe = is_grey && blend_encoded && !(flags & BABL_MODEL_FLAG_NONLINEAR);
    wanted.associated = flags & BABL_MODEL_FLAG_ASSOCIATED && !is_unsafe;
    wanted.light = blend_encoded ? "encoded" : curve ? curve : "linear";
    wanted.format = babl_format_with_space(
        (is_grey ? grey : colour)[blend_encoded || curve][alpha ? wanted.associated ? 2 : 1 : 0],
        space);
    if (source && babl_format_get_model(source) == babl_format_get_model(wanted.format)) {
        const Babl* type = babl_format_get_type(source, 0);
        wanted.largest = type == babl_type("u8") ? 255.0f : type == babl_type("u16") ? 65535.0f : 0;
    }
    return wanted;
}

class GeglSource final : public ddt::Source {
public:
    GeglSource(GeglBuffer* buffer, const Wanted& wanted, const Enlargement& work)
        : m_buffer(buffer), m_wanted(wanted), m_work(work),
          m_guide(guide_recipe(work.layout, work.meaning)) {}
    bool read(const Rect& r, float* values, float* guide) override {
        const GeglRectangle box = rectangle_of(r);
        gegl_buffer_get(m_buffer, &box, 1.0, m_wanted.format, values, GEGL_AUTO_ROWSTRIDE,
                        GEGL_ABYSS_CLAMP);
        if (m_wanted.largest > 0)
            snap(m_wanted.largest, values, r.area() * size_t(m_wanted.channels));
        to_work(m_work, values, r.area());
        ddt::make_guide(m_guide, values, r.area(), m_work.layout.channels, guide);
        return true;
    }

private:
    GeglBuffer* m_buffer;
    const Wanted m_wanted;
    const Enlargement& m_work;
    ddt::GuideRecipe m_guide;
};

class GeglSink final : public ddt::Sink {
public:
    GeglSink(GeglBuffer* buffer, const Babl* format, const Enlargement& work)
        : m_buffer(buffer), m_format(format), m_work(work) {}
    bool write(const Rect& r, float* values) override {
        const GeglRectangle box = rectangle_of(r);
        from_work(m_work, values, r.area());
        gegl_buffer_set(m_buffer, &box, 0, m_format, values, GEGL_AUTO_ROWSTRIDE);
        return true;
    }

private:
    GeglBuffer* m_buffer;
    const Babl* m_format;
    const Enlargement& m_work;
};

void prepare(GeglOperation* operation) {
    const Babl* format = wanted_by(operation).format;
    gegl_operation_set_format(operation, "input", format);
    gegl_operation_set_format(operation, "output", format);
}

GeglRectangle get_bounding_box(GeglOperation* operation) {
    Placing place;
    return find_place(operation, place) ? rectangle_of(place.full) : source_box(operation);
}

/// The specification's holes.
ddt::Holes holes_of(GeglOperation* operation) {
    Enlargement work;
    std::string error;
    set_filter(specification(self_of(operation).settings), "linear", work, error);
    return work.holes;
}

GeglRectangle get_required_for_output(GeglOperation* operation, const gchar*,
                                      const GeglRectangle* part) {
    Placing place;
    return find_place(operation, place)
               ? rectangle_of(needed(place, rect_of(*part), holes_of(operation)))
               : *part;
}

/// GEGL keeps the result for what it asks for next.
GeglRectangle get_cached_region(GeglOperation* operation, const GeglRectangle* part) {
    Placing place;
    return find_place(operation, place)
               ? rectangle_of(made_at_once(place, rect_of(*part), holes_of(operation)))
               : *part;
}

GeglRectangle get_invalidated_by_change(GeglOperation* operation, const gchar*,
                                        const GeglRectangle*) {
    return get_bounding_box(operation);
}

/// What $GEGL_THREADS or a program such as GIMP says.
int threads_of_gegl() {
    gint threads = 1;
    g_object_get(gegl_config(), "threads", &threads, nullptr);
    return threads_within(uint64_t(std::max(threads, 1)));
}

/// A buffer of floats for the pixels of a box.
Buffer buffer_of(std::vector<float>& values, const Rect& box, int channels) {
    constexpr auto size = ptrdiff_t(sizeof(float));
    values.resize(box.area() * size_t(channels));
    return {values.data(),  size * channels * box.width(), size * channels, size, box,
            Sample::float32};
}

/// A copy without holes. Its pixels go through memory, in the format that both have.
bool fill(Enlargement work, GeglBuffer* input, GeglBuffer* output, const Babl* format,
          std::string& error) {
    return ddt::succeeds(&error, [&](std::string& why) {
        const GeglRectangle all = rectangle_of(work.from.box), part = rectangle_of(work.to.box);
        std::vector<float> before, after;
        work.from = buffer_of(before, work.from.box, work.layout.channels);
        work.to = buffer_of(after, work.to.box, work.layout.channels);
        gegl_buffer_get(input, &all, 1.0, format, before.data(), GEGL_AUTO_ROWSTRIDE,
                        GEGL_ABYSS_CLAMP);
        if (enlarge(work, why) != ddt::Outcome::done)
            return false;
        gegl_buffer_set(output, &part, 0, format, after.data(), GEGL_AUTO_ROWSTRIDE);
        return true;
    });
}

gboolean process(GeglOperation* operation, GeglBuffer* input, GeglBuffer* output,
                 const GeglRectangle* part, gint) {
    Enlargement work;
    if (!find_place(operation, work.place)) {
        g_warning("ddt: there is no picture to enlarge, or an endless one; crop it first");
        return FALSE;
    }
    const bool copies = work.place.copies();
    if (copies && holes_of(operation) == ddt::Holes::keep) {
        const GeglRectangle from = rectangle_of(needed(work.place, rect_of(*part)));
        gegl_buffer_copy(input, &from, GEGL_ABYSS_CLAMP, output, part);
        return TRUE;
    }
    work.to.box = rect_of(*part);
    work.from.box = work.place.window;
    const Wanted wanted = wanted_by(operation);
    work.layout = Layout::usual(wanted.channels, wanted.associated);
    work.threads = threads_of_gegl();
    // GEGL's progress is for the thread that it calls us on. Of pieces the host counts how many are
    // done; and at 0 and 1 GIMP begins and ends a progress in place of its own, which could be
    // cancelled.
    const auto caller = std::this_thread::get_id();
    const bool everything = rect_of(*part) == work.place.full;
    work.progress = [&](float share) {
        if (everything && share > 0 && share < 1 && std::this_thread::get_id() == caller)
            gegl_operation_progress(operation, double(share), const_cast<gchar*>("ddt"));
        return true;
    };
    std::string error;
    if (!set_filter(specification(self_of(operation).settings), wanted.light, work, error)) {
        g_warning("%s", error.c_str());
        return FALSE;
    }
    GeglSource source(input, wanted, work);
    GeglSink sink(output, wanted.format, work);
    if (copies ? fill(work, input, output, wanted.format, error)
               : enlarge(work, source, sink, error) == ddt::Outcome::done)
        return TRUE;
    g_warning("%s", error.c_str());
    return FALSE;
}

void set_property(GObject* object, guint id, const GValue* value, GParamSpec* spec) {
    if (!set_property(self_of(object).settings, id, value))
        G_OBJECT_WARN_INVALID_PROPERTY_ID(object, id, spec);
}

void get_property(GObject* object, guint id, GValue* value, GParamSpec* spec) {
    if (!get_property(self_of(object).settings, id, value))
        G_OBJECT_WARN_INVALID_PROPERTY_ID(object, id, spec);
}

void finalize(GObject* object) {
    g_free(self_of(object).settings.values);
    G_OBJECT_CLASS(parent_class)->finalize(object);
}

void init_class(gpointer klass, gpointer) {
    parent_class = g_type_class_peek_parent(klass);
    GObjectClass* object = G_OBJECT_CLASS(klass);
    object->set_property = set_property;
    object->get_property = get_property;
    object->finalize = finalize;
    ddt::gegl::install_properties(object, module);

    GeglOperationClass* operation = GEGL_OPERATION_CLASS(klass);
    operation->prepare = prepare;
    operation->get_bounding_box = get_bounding_box;
    operation->get_required_for_output = get_required_for_output;
    operation->get_cached_region = get_cached_region;
    operation->get_invalidated_by_change = get_invalidated_by_change;
    operation->threaded = FALSE; // the core has threads of its own
    GEGL_OPERATION_FILTER_CLASS(klass)->process = process;
    gegl_operation_class_set_keys(
        operation, "name", "gegl:ddt", "title", "Enlarge",
        // Not "transform", which GIMP's tool for GEGL operations leaves out.
        "categories", "enhance", "description",
        "Enlarge by data-dependent triangulation: edges stay smooth at any factor", nullptr);
}

void init_instance(GTypeInstance* instance, gpointer) {
    self_of(instance).settings.values = g_new0(double, parameters().size());
}

const GeglModuleInfo info = {GEGL_MODULE_ABI_VERSION};

} // namespace

extern "C" {

G_MODULE_EXPORT const GeglModuleInfo* gegl_module_query(GTypeModule*);
G_MODULE_EXPORT gboolean gegl_module_register(GTypeModule*);

const GeglModuleInfo* gegl_module_query(GTypeModule*) {
    return &info;
}

gboolean gegl_module_register(GTypeModule* loading) {
    module = loading;
    const GTypeInfo type = {
        sizeof(OperationClass), nullptr, nullptr,       init_class, nullptr, nullptr,
        sizeof(Operation),      0,       init_instance, nullptr};
    operation_type = g_type_module_register_type(module, GEGL_TYPE_OPERATION_FILTER, "GeglOpDdt",
                                                 &type, GTypeFlags(0));
    return TRUE;
}
}

// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/openfx/mini_host.h"

#include <algorithm>
#include <cstdarg>
#include <thread>

#include <dlfcn.h>

#include <gtest/gtest.h>

namespace mini {

namespace ofx = ddt::ofx;

namespace {

Host* current = nullptr;
thread_local bool on_host_thread = false;

Properties& of(ofx::Properties p) {
    return *reinterpret_cast<Properties*>(p);
}
Effect& of(ofx::Effect e) {
    return *reinterpret_cast<Effect*>(e);
}
ofx::Properties handle(Properties* p) {
    return reinterpret_cast<ofx::Properties>(p);
}

template <class T>
int put(ofx::Properties p, const char* name, int index, T value) {
    if (of(p).unknown.count(name))
        return 3;
    of(p).put(name, Value(value), index);
    return ofx::ok;
}
int put_string(ofx::Properties p, const char* name, int index, const char* value) {
    return put(p, name, index, std::string(value));
}
template <class T>
int take(ofx::Properties p, const char* name, int index, T* value) {
    const auto it = of(p).values.find(name);
    if (it == of(p).values.end() || size_t(index) >= it->second.size())
        return 3;
    if (const T* there = std::get_if<T>(&it->second[size_t(index)])) {
        *value = *there;
        return ofx::ok;
    }
    return 3;
}
int take_string(ofx::Properties p, const char* name, int index, char** value) {
    const auto it = of(p).values.find(name);
    if (it == of(p).values.end() || size_t(index) >= it->second.size())
        return 3;
    *value = std::get<std::string>(it->second[size_t(index)]).data();
    return ofx::ok;
}
int dimension(ofx::Properties p, const char* name, int* n) {
    const auto it = of(p).values.find(name);
    *n = it == of(p).values.end() ? 0 : int(it->second.size());
    return ofx::ok;
}
const ofx::PropertySuite property_suite = {put<void*>, put_string,  put<double>, put<int>,
                                           {},         take<void*>, take_string, take<double>,
                                           take<int>,  {},          nullptr,     dimension};

// A clip's handle is its name's place in the effect's map, with the effect beside it.
struct ClipBehind {
    Effect* effect;
    std::string name;
};
std::map<std::pair<Effect*, std::string>, ClipBehind> clip_handles;

int get_property_set(ofx::Effect e, ofx::Properties* p) {
    *p = handle(&of(e).properties);
    return ofx::ok;
}
int get_param_set(ofx::Effect e, ofx::ParamSet* p) {
    *p = reinterpret_cast<ofx::ParamSet>(e);
    return ofx::ok;
}
int clip_define(ofx::Effect e, const char* name, ofx::Properties* p) {
    Properties& clip = of(e).clips[name];
    clip_handles[{&of(e), name}] = {&of(e), name};
    if (of(e).host.kind().pixel_aspect)
        clip.put("OfxImagePropPixelAspectRatio", of(e).aspect);
    *p = handle(&clip);
    return ofx::ok;
}
int clip_get_handle(ofx::Effect e, const char* name, ofx::Clip* clip, ofx::Properties* p) {
    const auto it = clip_handles.find({&of(e), name});
    if (it == clip_handles.end())
        return ofx::bad_handle;
    *clip = reinterpret_cast<ofx::Clip>(&it->second);
    if (p)
        *p = handle(&of(e).clips.at(name));
    return ofx::ok;
}
int clip_get_property_set(ofx::Clip clip, ofx::Properties* p) {
    auto& behind = *reinterpret_cast<ClipBehind*>(clip);
    *p = handle(&behind.effect->clips.at(behind.name));
    return ofx::ok;
}
void put_box(Properties& properties, const char* name, const Rect& box) {
    const int sides[] = {box.x0, box.y0, box.x1, box.y1};
    for (int i = 0; i < 4; ++i)
        properties.put(name, sides[i], i);
}
int clip_get_image(ofx::Clip clip, double, const ofx::RectD*, ofx::Properties* p) {
    auto& behind = *reinterpret_cast<ClipBehind*>(clip);
    Effect& effect = *behind.effect;
    Picture& picture = behind.name == "Source" ? effect.source : effect.output;
    const int status = behind.name == "Source" ? effect.source_status : effect.output_status;
    if (status != ofx::ok)
        return status;
    if (picture.bytes.empty())
        return ofx::failed;
    auto* image = new Properties;
    const char* const components[] = {"", "OfxImageComponentAlpha", "", "OfxImageComponentRGB",
                                      "OfxImageComponentRGBA"};
    image->put("OfxImageEffectPropComponents", std::string(components[picture.channels]));
    image->put("OfxImageEffectPropPixelDepth", picture.depth);
    image->put("OfxImageEffectPropPreMultiplication", picture.premultiplication);
    image->put("OfxImagePropData", static_cast<void*>(picture.row(picture.box.y0)));
    const int row = int(picture.row_bytes());
    image->put("OfxImagePropRowBytes", picture.rows_reversed ? -row : row);
    put_box(*image, "OfxImagePropBounds", picture.box);
    if (behind.name == "Source" && effect.source_defined)
        put_box(*image, "OfxImagePropRegionOfDefinition", *effect.source_defined);
    ++effect.images_held;
    image->put("effect", static_cast<void*>(&effect));
    *p = handle(image);
    return ofx::ok;
}
int clip_release_image(ofx::Properties p) {
    --static_cast<Effect*>(of(p).at<void*>("effect"))->images_held;
    delete &of(p);
    return ofx::ok;
}
int clip_get_region(ofx::Clip clip, double, ofx::RectD* region) {
    const Effect& effect = *reinterpret_cast<ClipBehind*>(clip)->effect;
    *region = effect.source_region;
    return effect.region_status;
}
int abort_asked(ofx::Effect e) {
    Effect& effect = of(e);
    if (!on_host_thread)
        ++effect.foreign_calls;
    return effect.abort_after >= 0 && effect.abort_after-- <= 0;
}
const ofx::EffectSuite effect_suite = {
    get_property_set, get_param_set,      clip_define,     clip_get_handle, clip_get_property_set,
    clip_get_image,   clip_release_image, clip_get_region, abort_asked,     {}};

int define(ofx::ParamSet set, const char* type, const char* name, ofx::Properties* p) {
    Effect& effect = *reinterpret_cast<Effect*>(set);
    EXPECT_EQ(effect.params.count(name), 0u) << name;
    EXPECT_EQ(effect.host.kind().no_types.count(type), 0u) << name << ", a " << type;
    Param& param = effect.params[name];
    param.type = type;
    effect.param_order.emplace_back(name);
    *p = handle(&param.properties);
    return ofx::ok;
}
int get_handle(ofx::ParamSet set, const char* name, ofx::Param* param, ofx::Properties*) {
    Effect& effect = *reinterpret_cast<Effect*>(set);
    const auto it = effect.params.find(name);
    if (it == effect.params.end())
        return ofx::bad_handle;
    *param = reinterpret_cast<ofx::Param>(&it->second);
    return ofx::ok;
}
// The value goes where the variable argument points to.
int value_at_time(ofx::Param p, double time, ...) {
    const Param& param = *reinterpret_cast<Param*>(p);
    if (param.status != ofx::ok)
        return param.status;
    std::va_list arguments;
    va_start(arguments, time);
    if (param.type == "OfxParamTypeDouble")
        *va_arg(arguments, double*) = param.value;
    else
        *va_arg(arguments, int*) = int(param.value);
    va_end(arguments);
    return ofx::ok;
}
const ofx::ParamSuite param_suite = {define,  get_handle,    nullptr, nullptr,
                                     nullptr, value_at_time, {}};

int progress_start(void* e, const char*) {
    Effect& effect = *static_cast<Effect*>(e);
    if (++effect.bars > 1)
        ++effect.bars_beside_others;
    ++current->progress_started;
    return ofx::ok;
}
int progress_update(void* e, double) {
    if (!on_host_thread)
        ++static_cast<Effect*>(e)->foreign_calls;
    ++current->progress_updates;
    const bool stops = current->stop_after >= 0 && current->stop_after-- <= 0;
    return stops ? current->stop_status : int(ofx::ok);
}
int progress_end(void* e) {
    --static_cast<Effect*>(e)->bars;
    ++current->progress_ended;
    return ofx::ok;
}
const ofx::ProgressSuite progress_suite = {progress_start, progress_update, progress_end};

int message(void*, const char* type, const char*, const char*, ...) {
    current->messages.emplace_back(type);
    return ofx::ok;
}
const ofx::MessageSuite message_suite = {message};

int number_of_cpus(unsigned int* cpus) {
    ++current->asked_for_cpus;
    *cpus = current->cpus;
    return ofx::ok;
}
const ofx::MultiThreadSuite multi_thread_suite = {nullptr, number_of_cpus, {}};

} // namespace

void Properties::put(const std::string& name, Value value, int index) {
    auto& list = values[name];
    if (list.size() <= size_t(index))
        list.resize(size_t(index) + 1, value);
    list[size_t(index)] = std::move(value);
}

size_t Picture::number_bytes() const {
    return depth == "OfxBitDepthFloat" ? 4 : depth == "OfxBitDepthByte" ? 1 : 2;
}

char* Picture::row(int y) {
    const int i = rows_reversed ? box.y1 - 1 - y : y - box.y0;
    return bytes.data() + row_bytes() * size_t(i);
}

const void* Host::fetch(ofx::Properties, const char* name, int version) {
    const std::string suite = name;
    current->asked.push_back(suite + " " + std::to_string(version));
    if (version != 1 || !current->kind().suites.count(suite) || current->withheld.count(suite))
        return nullptr;
    return suite == "OfxPropertySuite"      ? static_cast<const void*>(&property_suite)
           : suite == "OfxImageEffectSuite" ? static_cast<const void*>(&effect_suite)
           : suite == "OfxParameterSuite"   ? static_cast<const void*>(&param_suite)
           : suite == "OfxProgressSuite"    ? static_cast<const void*>(&progress_suite)
           : suite == "OfxMessageSuite"     ? static_cast<const void*>(&message_suite)
           : suite == "OfxMultiThreadSuite" ? static_cast<const void*>(&multi_thread_suite)
                                            : nullptr;
}

namespace {

void put_list(Properties& p, const char* name, const std::vector<std::string>& list) {
    for (size_t i = 0; i < list.size(); ++i)
        p.put(name, list[i], int(i));
}

} // namespace

Host::Host(const Kind& kind, const std::string& bundle_file) : m_kind(kind) {
    current = this;
    m_library = dlopen(bundle_file.c_str(), RTLD_NOW | RTLD_LOCAL);
    EXPECT_TRUE(m_library) << dlerror();
    const auto count = reinterpret_cast<int (*)()>(dlsym(m_library, "OfxGetNumberOfPlugins"));
    const auto get =
        reinterpret_cast<const ofx::Plugin* (*)(int)>(dlsym(m_library, "OfxGetPlugin"));
    EXPECT_EQ(count(), 1);
    EXPECT_EQ(get(1), nullptr);
    EXPECT_EQ(get(-1), nullptr);
    m_plugin = get(0);
    m_properties.put("OfxPropType", std::string("OfxTypeImageEffectHost"));
    m_properties.put("OfxPropName", kind.name);
    const size_t dot = kind.api_version.find('.');
    m_properties.put("OfxPropAPIVersion", std::stoi(kind.api_version), 0);
    m_properties.put("OfxPropAPIVersion", std::stoi(kind.api_version.substr(dot + 1)), 1);
    put_list(m_properties, "OfxImageEffectPropSupportedContexts", kind.contexts);
    put_list(m_properties, "OfxImageEffectPropSupportedComponents", kind.components);
    put_list(m_properties, "OfxImageEffectPropSupportedPixelDepths", kind.depths);
    m_properties.put("OfxImageEffectPropSupportsMultiResolution", kind.multi_resolution);
    m_properties.put("OfxImageEffectPropSupportsTiles", kind.tiles);
    for (const auto& [name, value] : kind.further)
        m_properties.put(name, value);
    m_abi = {handle(&m_properties), fetch};
}

Host::~Host() {
    dlclose(m_library);
}

int Host::act(const char* action, const void* h, Properties* in, Properties* out) const {
    current = const_cast<Host*>(this);
    on_host_thread = true;
    const int status = m_plugin->main_entry(action, h, handle(in), handle(out));
    on_host_thread = false;
    return status;
}

Effect::Effect(Host& host_) : host(host_) {}

void Effect::describe(const char* context) {
    properties.unknown = host.kind().unknown;
    ASSERT_EQ(host.act("OfxActionDescribe", this), ofx::ok);
    Properties in;
    in.put("OfxImageEffectPropContext", std::string(context));
    ASSERT_EQ(host.act("OfxImageEffectActionDescribeInContext", this, &in), ofx::ok);
    for (auto& [name, param] : params) {
        const auto it = param.properties.values.find("OfxParamPropDefault");
        if (it == param.properties.values.end())
            continue;
        const Value& initial = it->second[0];
        set(name, initial.index() == 0 ? std::get<int>(initial) : std::get<double>(initial));
    }
    ASSERT_EQ(host.act("OfxActionCreateInstance", this), ofx::ok);
}

namespace {

void put_scale(Properties& in, double scale) {
    in.put("OfxPropTime", 1.0);
    in.put("OfxImageEffectPropRenderScale", scale, 0);
    in.put("OfxImageEffectPropRenderScale", scale, 1);
}

int take_region(const Properties& out, const char* name, int status, ofx::RectD& region) {
    if (status == ofx::ok)
        region = {out.at<double>(name, 0), out.at<double>(name, 1), out.at<double>(name, 2),
                  out.at<double>(name, 3)};
    return status;
}

} // namespace

int Effect::render(const Rect& upwards, double scale) {
    Properties in;
    put_scale(in, scale);
    put_box(in, "OfxImageEffectPropRenderWindow", upwards);
    return host.act("OfxImageEffectActionRender", this, &in);
}

int Effect::region_of_definition(ofx::RectD& region) {
    Properties in, out;
    put_scale(in, 1);
    const int status = host.act("OfxImageEffectActionGetRegionOfDefinition", this, &in, &out);
    return take_region(out, "OfxImageEffectPropRegionOfDefinition", status, region);
}

int Effect::region_of_interest(const ofx::RectD& wanted, ofx::RectD& region, double scale) {
    Properties in, out;
    put_scale(in, scale);
    const double sides[] = {wanted.x1, wanted.y1, wanted.x2, wanted.y2};
    for (int i = 0; i < 4; ++i)
        in.put("OfxImageEffectPropRegionOfInterest", sides[i], i);
    const int status = host.act("OfxImageEffectActionGetRegionsOfInterest", this, &in, &out);
    return take_region(out, "OfxImageClipPropRoI_Source", status, region);
}

bool Effect::is_identity() {
    Properties in, out;
    put_scale(in, 1);
    return host.act("OfxImageEffectActionIsIdentity", this, &in, &out) == ofx::ok &&
           out.at<std::string>("OfxPropName") == "Source";
}

void Effect::set(const std::string& parameter, double value) {
    Param& param = params.at(parameter);
    const bool real = param.type == "OfxParamTypeDouble";
    const auto& given = param.properties.values;
    const bool ranges = given.count("OfxParamPropMin") && given.count("OfxParamPropMax") &&
                        given.count("OfxParamPropDisplayMin") &&
                        given.count("OfxParamPropDisplayMax");
    if (host.kind().narrow_numbers && !ranges && (real || param.type == "OfxParamTypeInteger"))
        value = real ? std::clamp(value, -1.0, 1.0) : 0;
    param.value = value;
}

void Effect::choose(const std::string& parameter, const std::string& option) {
    const auto& options = params.at(parameter).properties.values.at("OfxParamPropChoiceOption");
    for (size_t i = 0; i < options.size(); ++i)
        if (std::get<std::string>(options[i]) == option)
            return set(parameter, double(i));
    ADD_FAILURE() << parameter << " has no " << option;
}

} // namespace mini

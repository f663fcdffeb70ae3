// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/settings.h"

#include <algorithm>

#include "ddt/names.h"
#include "plugin/host/enlargement.h"
#include "plugin/host/parameters.h"
#include "plugin/openfx/suites.h"

namespace ddt::ofx {
namespace {

constexpr const char* advanced = "advanced";

constexpr double largest_scale = 1024;
constexpr int largest_output_side = 1 << 20;

/// A parameter of the type with what all have; null where the host refuses it.
Properties define(ParamSet set_, const char* type, const char* name, const char* label,
                  const std::string& help, const char* parent = nullptr) {
    Properties p = nullptr;
    if (suites.param->define(set_, type, name, &p) != ok)
        return nullptr;
    set(p, "OfxPropLabel", label);
    set(p, "OfxParamPropHint", help);
    if (parent)
        set(p, "OfxParamPropParent", parent);
    return p;
}

/// Some hosts limit a number to +-1 unless it has both ranges.
template <class Number>
void set_range(Properties p, Number initial, Number low, Number high, Number shown_high) {
    if (!p)
        return;
    set(p, "OfxParamPropDefault", initial);
    set(p, "OfxParamPropMin", low);
    set(p, "OfxParamPropMax", high);
    set(p, "OfxParamPropDisplayMin", low);
    set(p, "OfxParamPropDisplayMax", shown_high);
}

/// A number that is not whole; `step` is what a host's arrows add.
void set_real(Properties p, double initial, double low, double high, double shown_high,
              double step = 0.01) {
    set_range(p, initial, low, high, shown_high);
    if (!p)
        return;
    set(p, "OfxParamPropDigits", host::shown_digits);
    set(p, "OfxParamPropIncrement", step);
}

void define_choice(ParamSet set_, const char* name, const char* label, const std::string& help,
                   const std::vector<std::string>& names, int initial,
                   const char* parent = nullptr) {
    Properties p = define(set_, "OfxParamTypeChoice", name, label, help, parent);
    if (!p)
        return;
    for (size_t i = 0; i < names.size(); ++i)
        set(p, "OfxParamPropChoiceOption", names[i], int(i));
    set(p, "OfxParamPropDefault", initial);
}

/// A row of the option table.
void define_option(ParamSet set_, const host::Parameter& q) {
    const char *key = q.option->key, *label = q.label.c_str();
    const char* parent = q.is_main() ? nullptr : advanced;
    switch (q.kind) {
    case OptionKind::real:
        return set_real(define(set_, "OfxParamTypeDouble", key, label, q.help, parent), q.initial,
                        q.low, q.high, q.shown_high);
    case OptionKind::whole:
        return set_range(define(set_, "OfxParamTypeInteger", key, label, q.help, parent),
                         int(q.initial), int(q.low), int(q.high), int(q.shown_high));
    case OptionKind::toggle:
        if (Properties p = define(set_, "OfxParamTypeBoolean", key, label, q.help, parent))
            set(p, "OfxParamPropDefault", int(q.initial));
        return;
    default:
        define_choice(set_, key, label, q.help, q.names, int(q.initial), parent);
    }
}

/// The parameters' values at a time.
class Values {
public:
    Values(ParamSet set, double time) : m_set(set), m_time(time) {}
    /// `otherwise` where the host has no such parameter, or cannot hand out its value.
    template <class Number>
    Number operator()(const char* name, Number otherwise) {
        Param param = nullptr;
        if (suites.param->get_handle(m_set, name, &param, nullptr) != ok)
            return otherwise;
        Number number = otherwise;
        const int status = suites.param->get_value_at_time(param, m_time, &number);
        if (m_status == ok)
            m_status = status;
        return status == ok ? number : otherwise;
    }
    /// ok, or the status of the first value that could not be had.
    int status() const { return m_status; }

private:
    ParamSet m_set;
    double m_time;
    int m_status = ok;
};

/// As far as the range goes, which hosts need not keep expressions and curves in; NaN is the least.
double within(double number, double low, double high) {
    return std::min(std::max(low, number), high);
}

std::string name_at(const std::vector<std::string>& names, int index) {
    return names[index >= 0 && size_t(index) < names.size() ? size_t(index) : 0];
}

} // namespace

void define_parameters(ParamSet set_, bool zoom) {
    constexpr double step_of_scale = 0.1;
    set_real(define(set_, "OfxParamTypeDouble", "scale", "Scale", "By how much both sides grow"),
             2.0, 1.0, largest_scale, 8.0, step_of_scale);
    set_real(
        define(set_, "OfxParamTypeDouble", "scale_y", "Scale Y",
               "By how much the height grows; 0: as much as the width; between 0 and 1 it stays"),
        0.0, 0.0, largest_scale, 8.0, step_of_scale);
    if (!zoom) {
        set_range(define(set_, "OfxParamTypeInteger", "width", "Width",
                         "Width of the result in pixels instead of a scale, the source's at least; "
                         "0: by the scale, or from the height"),
                  0, 0, largest_output_side, 8192);
        set_range(define(set_, "OfxParamTypeInteger", "height", "Height",
                         "Height of the result in pixels instead of a scale, the source's at "
                         "least; 0: by the scale, or from the width"),
                  0, 0, largest_output_side, 8192);
    } else {
        set_real(define(set_, "OfxParamTypeDouble", "centre_x", "Centre X",
                        "What stays in its place: from the left, 0, to the right, 1"),
                 0.5, 0.0, 1.0, 1.0);
        set_real(define(set_, "OfxParamTypeDouble", "centre_y", "Centre Y",
                        "What stays in its place: from below, 0, to above, 1"),
                 0.5, 0.0, 1.0, 1.0);
    }
    define_choice(set_, "filter", "Filter", host::help_of_filters(), filter_names(), 0);
    define_choice(set_, "light", "Light",
                  "What the numbers are: linear light, as compositing hosts hand over; encoded: "
                  "blended as they are; or an encoding, blended in linear light",
                  host::meaning_names(), 0);
    define_choice(set_, "premultiplication", "Premultiplication",
                  "Whether colour is multiplied by alpha",
                  {"as the image says", "premultiplied", "unpremultiplied"}, 0);
    if (Properties group = define(set_, "OfxParamTypeGroup", advanced, "Advanced", ""))
        set(group, "OfxParamPropGroupOpen", 0);
    for (const host::Parameter& p : host::parameters())
        define_option(set_, p);
}

int settings_at(Effect effect, double time, Settings& s) {
    ParamSet set_ = nullptr;
    if (const int status = suites.effect->get_param_set(effect, &set_); status != ok)
        return status;
    Values value(set_, time);
    s.scale_x = within(value("scale", 2.0), 1, largest_scale);
    s.scale_y = value("scale_y", 0.0);
    s.scale_y = s.scale_y > 0 ? within(s.scale_y, 1, largest_scale) : s.scale_x;
    s.width = std::clamp(value("width", 0), 0, largest_output_side);
    s.height = std::clamp(value("height", 0), 0, largest_output_side);
    s.centre_x = within(value("centre_x", 0.5), 0, 1);
    s.centre_y = within(value("centre_y", 0.5), 0, 1);
    s.filter = name_at(filter_names(), value("filter", 0));
    s.light = name_at(host::meaning_names(), value("light", 0));
    s.premultiplication = value("premultiplication", 0);
    for (const host::Parameter& p : host::parameters())
        s.filter += host::item(p, p.kind == OptionKind::real
                                      ? value(p.option->key, p.initial)
                                      : double(value(p.option->key, int(p.initial))));
    return value.status();
}

} // namespace ddt::ofx

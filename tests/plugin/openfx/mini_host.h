// SPDX-License-Identifier: Apache-2.0
// A small OpenFX host: property sets, clips with images in memory, parameters; it loads the bundle
// as programs do and drives every action. Suites can be left out and flags set as hosts differ.
#pragma once

#include <atomic>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "ddt/rect.h"
#include "plugin/openfx/abi.h"

namespace mini {

using ddt::Rect;
using Value = std::variant<int, double, std::string, void*>;

/// A property set: names to lists of values.
struct Properties {
    std::map<std::string, std::vector<Value>> values;
    std::set<std::string> unknown; ///< names that the host refuses
    void put(const std::string& name, Value value, int index = 0);
    template <class T>
    T at(const std::string& name, int index = 0) const {
        return std::get<T>(values.at(name).at(size_t(index)));
    }
};

/// An image of a clip, its rows upwards.
struct Picture {
    Rect box; ///< rows counted upwards
    int channels = 4;
    std::string depth = "OfxBitDepthFloat", premultiplication = "OfxImageAlphaPremultiplied";
    std::vector<char> bytes;
    bool rows_reversed = false; ///< row bytes are negative

    size_t number_bytes() const;
    size_t row_bytes() const { return size_t(box.width()) * size_t(channels) * number_bytes(); }
    void allocate() { bytes.assign(row_bytes() * size_t(box.height()), char(0x55)); }
    /// Of the row `y`, counted upwards.
    char* row(int y);
};

/// What of hosts differs: kinds.h has some.
struct Kind {
    std::string name, api_version;
    std::vector<std::string> contexts, components, depths;
    int multi_resolution = 1, tiles = 1;
    std::map<std::string, int> further; ///< other properties of the host
    std::set<std::string> suites;       ///< all of version 1
    std::set<std::string> unknown;      ///< properties of effects that it refuses
    std::set<std::string> no_types;     ///< of parameters, with which it crashes
    bool pixel_aspect = true;           ///< clips have one
    /// Numbers without ranges and display ranges keep to -1 to 1, whole ones to 0.
    bool narrow_numbers = false;
};

class Effect;

class Host {
public:
    explicit Host(const Kind& kind, const std::string& bundle_file);
    ~Host();
    int act(const char* action, const void* handle = nullptr, Properties* in = nullptr,
            Properties* out = nullptr) const;
    const ddt::ofx::Plugin& plugin() const { return *m_plugin; }
    const Kind& kind() const { return m_kind; }
    ddt::ofx::Host* abi() { return &m_abi; }
    std::set<std::string> withheld; ///< suites that it does not have after all
    std::vector<std::string> asked; ///< suites that it was asked for, with a space and the version
    std::vector<std::string> messages;
    unsigned int cpus = 64; ///< that it allows a render
    std::atomic<int> asked_for_cpus{0};
    int progress_started = 0, progress_ended = 0;
    int stop_after = -1;                  ///< updates of progress until it says to stop; -1: never
    int stop_status = ddt::ofx::reply_no; ///< what it says then
    std::atomic<int> progress_updates{0};

private:
    static const void* fetch(ddt::ofx::Properties, const char* name, int version);
    Kind m_kind;
    void* m_library = nullptr;
    const ddt::ofx::Plugin* m_plugin = nullptr;
    Properties m_properties;
    ddt::ofx::Host m_abi{};
};

/// A parameter: its definition and its value.
struct Param {
    std::string type;
    Properties properties;
    double value = 0;
    int status = ddt::ofx::ok; ///< of asking for the value
};

/// A description or an instance.
class Effect {
public:
    explicit Effect(Host& host);
    /// Describe, describe in the context.
    void describe(const char* context = "OfxImageEffectContextFilter");
    int render(const Rect& upwards, double scale = 1);
    /// Canonical.
    int region_of_definition(ddt::ofx::RectD& region);
    int region_of_interest(const ddt::ofx::RectD& wanted, ddt::ofx::RectD& region,
                           double scale = 1);
    /// True if the action names the source.
    bool is_identity();
    /// As far as its range goes.
    void set(const std::string& parameter, double value);
    void choose(const std::string& parameter, const std::string& option);

    Host& host;
    Properties properties;
    std::map<std::string, Properties> clips;
    std::map<std::string, Param> params;
    std::vector<std::string> param_order;
    Picture source, output;
    ddt::ofx::RectD source_region{};                                ///< canonical
    int region_status = ddt::ofx::ok;                               ///< of asking for it
    int source_status = ddt::ofx::ok, output_status = ddt::ofx::ok; ///< of asking for the images
    std::optional<Rect> source_defined; ///< what the source's image says it is a part of
    double aspect = 1;
    std::atomic<int> abort_after{-1}; ///< calls of abort() until it says yes; -1: never
    std::atomic<int> images_held{0}, foreign_calls{0};
    std::atomic<int> bars{0}, bars_beside_others{0}; ///< of progress: one at a time is allowed
};

} // namespace mini

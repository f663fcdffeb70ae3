// SPDX-License-Identifier: Apache-2.0
#include "core/gl/context/faults.h"

#include <atomic>
#include <utility>

#include "core/gl/context/failure.h"

namespace ddt::gl {

namespace {

struct Armed {
    std::atomic<int> chances{0}, first{0}, times{0};
};
Armed g_armed[int(Fault::count)];

struct Change {
    std::string program, name, value;
    bool is_text = false;
};
/// Made on first use, since a static object may enlarge before those of this file are made.
Change& the_change() {
    static auto* made = new Change;
    return *made;
}
std::atomic<bool> g_was_changed{false};

void ask_for(Change change) {
    the_change() = std::move(change);
    g_was_changed = false;
}

} // namespace

void arm(Fault fault, int n, int times) {
    Armed& a = g_armed[int(fault)];
    a.first = n;
    a.times = times;
    a.chances = 0;
}

bool strikes(Fault fault) {
    Armed& a = g_armed[int(fault)];
    const int chance = ++a.chances;
    return a.first > 0 && chance >= a.first && chance < a.first + a.times;
}

int chances(Fault fault) {
    return g_armed[int(fault)].chances;
}

void change_constant(const std::string& program, const std::string& name,
                     const std::string& value) {
    ask_for({program, name, value, false});
}

void change_text(const std::string& program, const std::string& before, const std::string& after) {
    ask_for({program, before, after, true});
}

bool was_changed() {
    return g_was_changed;
}

namespace {

std::string with_changed_text(const Change& change, std::string source) {
    size_t at = source.find(change.name);
    if (at == source.npos)
        throw Failure("no text reads " + change.name);
    for (; at != source.npos; at = source.find(change.name, at + change.value.size()))
        source.replace(at, change.name.size(), change.value);
    return source;
}

} // namespace

std::string with_change(const std::string& program, std::string source) {
    const Change& change = the_change();
    if (change.program.empty() || program != change.program)
        return source;
    g_was_changed = true;
    if (change.is_text)
        return with_changed_text(change, std::move(source));
    for (const auto& [before, after] :
         {std::pair(" " + change.name + " = ", ";"), std::pair(" " + change.name + " ", "\n")}) {
        const size_t at = source.find(before);
        if (at == source.npos)
            continue;
        const size_t begin = at + before.size();
        return source.replace(begin, source.find(after, begin) - begin, change.value);
    }
    throw Failure("no constant is named " + change.name);
}

} // namespace ddt::gl

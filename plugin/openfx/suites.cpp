// SPDX-License-Identifier: Apache-2.0
#include "plugin/openfx/suites.h"

namespace ddt::ofx {

Suites suites;

namespace {

template <class Suite>
void fetch(const Suite*& suite, const char* name) {
    suite = static_cast<const Suite*>(suites.host->fetch_suite(suites.host->host, name, 1));
}

} // namespace

void load_suites() {
    if (!suites.host || !suites.host->fetch_suite)
        return;
    fetch(suites.property, "OfxPropertySuite");
    fetch(suites.effect, "OfxImageEffectSuite");
    fetch(suites.param, "OfxParameterSuite");
    fetch(suites.progress, "OfxProgressSuite");
    fetch(suites.message, "OfxMessageSuite");
    fetch(suites.multi_thread, "OfxMultiThreadSuite");
}

// A property that a host does not know is no failure: each knows some that others do not.
void set(Properties p, const char* name, const char* value, int index) {
    suites.property->set_string(p, name, index, value);
}
void set(Properties p, const char* name, const std::string& value, int index) {
    set(p, name, value.c_str(), index);
}
void set(Properties p, const char* name, int value, int index) {
    suites.property->set_int(p, name, index, value);
}
void set(Properties p, const char* name, double value, int index) {
    suites.property->set_double(p, name, index, value);
}

int get(Properties p, const char* name, int otherwise, int index) {
    int value = otherwise;
    return suites.property->get_int(p, name, index, &value) == ok ? value : otherwise;
}
double get(Properties p, const char* name, double otherwise, int index) {
    double value = otherwise;
    return suites.property->get_double(p, name, index, &value) == ok ? value : otherwise;
}
std::string get(Properties p, const char* name, const char* otherwise) {
    char* value = nullptr;
    return suites.property->get_string(p, name, 0, &value) == ok && value ? value : otherwise;
}
void* get_pointer(Properties p, const char* name) {
    void* value = nullptr;
    return suites.property->get_pointer(p, name, 0, &value) == ok ? value : nullptr;
}

void complain(Effect effect, const std::string& line) {
    if (suites.message && suites.message->message)
        suites.message->message(effect, "OfxMessageError", "ddt", "%s", line.c_str());
}

} // namespace ddt::ofx

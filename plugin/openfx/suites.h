// SPDX-License-Identifier: Apache-2.0
// The host's tables of functions, and properties by type.
#pragma once

#include <string>

#include "plugin/openfx/abi.h"

namespace ddt::ofx {

/// All null before load_suites(). The last three may stay null.
struct Suites {
    Host* host = nullptr;
    const PropertySuite* property = nullptr;
    const EffectSuite* effect = nullptr;
    const ParamSuite* param = nullptr;
    const ProgressSuite* progress = nullptr;
    const MessageSuite* message = nullptr;
    const MultiThreadSuite* multi_thread = nullptr;
    bool complete() const { return property && effect && param; }
};
extern Suites suites;

/// Fetch them from suites.host.
void load_suites();

void set(Properties p, const char* name, const char* value, int index = 0);
void set(Properties p, const char* name, const std::string& value, int index = 0);
void set(Properties p, const char* name, int value, int index = 0);
void set(Properties p, const char* name, double value, int index = 0);

/// The value, or `otherwise` where the host has none.
int get(Properties p, const char* name, int otherwise, int index = 0);
double get(Properties p, const char* name, double otherwise, int index = 0);
std::string get(Properties p, const char* name, const char* otherwise);
void* get_pointer(Properties p, const char* name);

/// Show a line to the user, where the host can.
void complain(Effect effect, const std::string& line);

} // namespace ddt::ofx

// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdlib>
#include <optional>
#include <string>

namespace ddt {

/// Gives a variable of the environment a value, or none, for as long as it lives; then the variable
/// is what it was: other tests of the process run in the environment that the process was given.
class Environment {
public:
    Environment(const char* name, const std::optional<std::string>& value) : m_name(name) {
        if (const char* before = std::getenv(name))
            m_before = before;
        put(value);
    }
    ~Environment() { put(m_before); }
    Environment(const Environment&) = delete;
    Environment& operator=(const Environment&) = delete;

private:
    void put(const std::optional<std::string>& value) const {
        if (value)
            setenv(m_name.c_str(), value->c_str(), 1);
        else
            unsetenv(m_name.c_str());
    }

    std::string m_name;
    std::optional<std::string> m_before;
};

} // namespace ddt

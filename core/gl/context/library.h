// SPDX-License-Identifier: Apache-2.0
// A shared library, opened by name at run time and never closed.
#pragma once

#include <initializer_list>
#include <string>

namespace ddt::gl {

class Library {
public:
    /// Open the first of `names` that can be; if none, open() is false and error() says why.
    explicit Library(std::initializer_list<const char*> names);

    bool open() const { return m_handle != nullptr; }
    const std::string& error() const { return m_error; }
    void* find(const char* symbol) const;

    /// find() as a function of the type of `f`; false if there is none.
    template <class F>
    bool find(const char* symbol, F& f) const {
        f = reinterpret_cast<F>(find(symbol));
        return f != nullptr;
    }

private:
    void* m_handle = nullptr;
    std::string m_error;
};

} // namespace ddt::gl

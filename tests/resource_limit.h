// SPDX-License-Identifier: Apache-2.0
// A process with less of something than it has.
#pragma once

#include <sys/resource.h>

namespace ddt::test {

/// A limit of the process (getrlimit(2)) for as long as this lives.
class ResourceLimit {
public:
    ResourceLimit(__rlimit_resource_t resource, rlim_t most) : m_resource(resource) {
        getrlimit(m_resource, &m_before);
        const rlimit limit{most, m_before.rlim_max};
        setrlimit(m_resource, &limit);
    }
    ~ResourceLimit() { setrlimit(m_resource, &m_before); }
    ResourceLimit(const ResourceLimit&) = delete;
    ResourceLimit& operator=(const ResourceLimit&) = delete;

private:
    __rlimit_resource_t m_resource;
    rlimit m_before{};
};

} // namespace ddt::test

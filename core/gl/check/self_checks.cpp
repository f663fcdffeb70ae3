// SPDX-License-Identifier: Apache-2.0
#include "core/gl/check/self_checks.h"

#include <utility>

#include "core/base/stopwatch.h"
#include "core/gl/buffer.h"
#include "core/gl/check/job_check.h"
#include "core/gl/check/tin_check.h"
#include "core/gl/check/transfer_check.h"
#include "core/gl/context/failure.h"
#include "core/gl/gpu.h"

namespace ddt::gl {

const std::string& SelfChecks::differs(Gpu& gpu, const std::string& key,
                                       const std::function<std::string()>& check) {
    static const std::string unchecked;
    if (gpu.context->tested && !tested_too)
        return unchecked;
    const auto known = m_differences.find(key);
    if (known != m_differences.end())
        return known->second;
    const Stopwatch watch;
    const FilledBuffers filled;
    std::string difference;
    try {
        difference = check();
    } catch (const OutOfMemory&) {
        throw; // there may be some for the next job
    } catch (const ContextLost&) {
        throw; // nothing is asked of the device again
    } catch (const Failure& e) {
        difference = e.what(); // as of a program that does not compile, which takes its time
    }
    m_milliseconds += watch.milliseconds();
    return m_differences[key] = std::move(difference);
}

const std::string& SelfChecks::differs(Gpu& gpu, const Job& job, const Transfer& transfer) {
    const std::string& there =
        differs(gpu, transfer_key_of(transfer), [&] { return transfer_differs(gpu, transfer); });
    if (!there.empty())
        return there;
    return differs(gpu, job_key_of(job), [&] { return job_differs_from_cpu(gpu, job); });
}

const std::string& SelfChecks::differs(Gpu& gpu, const MeshOptions& of_points) {
    return differs(gpu, tin_key_of(of_points),
                   [&] { return tin_differs_from_cpu(gpu, of_points); });
}

} // namespace ddt::gl

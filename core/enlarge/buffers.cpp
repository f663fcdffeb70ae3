// SPDX-License-Identifier: Apache-2.0
// enlarge() from and to plain buffers.
#include "core/enlarge/buffers.h"

#include "core/base/guarded.h"

namespace ddt {

Outcome enlarge(const float* src, int width, int height, int channels, const float* guide,
                float* dst, int dst_width, int dst_height, const SurfaceOptions& surface,
                const MeshOptions& mesh, int threads, std::string* error) noexcept {
    if (dst_width < width || dst_height < height || !src || !dst) {
        set_error(error, "ddt: the output must not be smaller than the input, nor a buffer null");
        return Outcome::bad_job;
    }
    Job job;
    job.window = {0, 0, width, height};
    job.channels = channels;
    job.surface = surface;
    job.mesh = mesh;
    job.threads = threads;
    BufferSource source(src, guide, width, channels);
    BufferSink sink(dst, dst_width, channels);
    const ResizeMapping mapping(ResizeMapping::Axis::whole(width, dst_width),
                                ResizeMapping::Axis::whole(height, dst_height));
    return enlarge(source, sink, mapping, job, error);
}

} // namespace ddt

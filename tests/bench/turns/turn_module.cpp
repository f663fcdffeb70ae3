// SPDX-License-Identifier: Apache-2.0
// The core of this build as a module that `turns` loads beside another build's.
#include <string>

#include "core/enlarge/buffers.h"
#include "ddt/option_table.h"
#include "turn.h"

extern "C" __attribute__((visibility("default"))) const char* ddt_take_turn(const turns::Turn& turn,
                                                                            turns::Spent& spent) {
    static std::string error; // a turn at a time
    ddt::FilterOptions options;
    if (!ddt::parse_filter(turn.filter, options, error))
        return error.c_str();
    ddt::Statistics statistics;
    ddt::Job job;
    job.window = {0, 0, turn.width, turn.height};
    job.channels = 3;
    job.mesh = options.mesh;
    job.surface = options.surface;
    job.threads = turn.threads;
    job.device = ddt::Device::cpu;
    job.statistics = &statistics;
    ddt::BufferSource source(turn.pixels, turn.guide, turn.width, job.channels);
    ddt::BufferSink sink(turn.to, turn.width * turn.scale, job.channels);
    const ddt::ResizeMapping mapping(
        ddt::ResizeMapping::Axis::whole(turn.width, turn.width * turn.scale),
        ddt::ResizeMapping::Axis::whole(turn.height, turn.height * turn.scale));
    if (ddt::enlarge(source, sink, mapping, job, &error) != ddt::Outcome::done)
        return error.c_str();
    const ddt::StageTimes& t = statistics.times;
    spent = {t.triangulate, t.surface, t.sample, t.read + t.write};
    return nullptr;
}

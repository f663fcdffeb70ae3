// SPDX-License-Identifier: Apache-2.0
#include "plugin/imagebuf/resample.h"

#include <algorithm>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/timer.h>

#include "core/base/log.h"
#include "plugin/image/memory.h"
#include "plugin/image/sink.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"
#include "plugin/imagebuf/thread_count.h"

namespace ddt {
namespace {

Writing plan_writing(const Reading& reading, const OIIO::ImageBuf& src, const OIIO::ROI& roi) {
    Writing writing;
    writing.light = reading.light;
    writing.channels = int(reading.selected.size());
    writing.chbegin = roi.chbegin;
    writing.chend = roi.chend;
    if (reading.channels.raw)
        writing.bits = src.spec().format;
    const auto place = [&](int channel) {
        const auto& s = reading.selected;
        const auto it = std::find(s.begin(), s.end(), channel);
        return it == s.end() ? -1 : int(it - s.begin());
    };
    const ColourLayout& colour = reading.channels.colour;
    if (colour.count && place(colour.channel[0]) >= 0) {
        writing.colour.count = colour.count;
        for (int k = 0; k < colour.count; ++k)
            writing.colour.channel[k] = place(colour.channel[k]);
        writing.colour.alpha = colour.alpha >= 0 ? place(colour.alpha) : -1;
    }
    return writing;
}

} // namespace

bool resample(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Mapping& mapping,
              const OIIO::ROI& roi, const Options& options, int nthreads, std::string& error,
              Arrival* arrival) {
    const OIIO::Timer timer;
    Reading reading;
    if (!plan_reading(src, options, roi, reading, error))
        return false;
    // IDs are never missing: the whole of them need not be read first.
    const Holes holes = reading.channels.raw ? Holes::keep : options.holes;
    if (holes != Holes::keep &&
        !check_size(src.roi(), int(reading.selected.size()) + 1, OIIO::TypeFloat, error))
        return false;
    const Writing writing = plan_writing(reading, src, roi);
    ImageSource source(src, reading, arrival);
    ImageSink sink(dst, writing);

    Statistics statistics;
    Job job;
    job.window = rect_of(src.roi());
    job.channels = int(reading.selected.size());
    for (int c : reading.selected)
        job.kinds.push_back(reading.channels.kinds[c]);
    job.mesh = options.mesh;
    job.surface = options.surface;
    job.surface.clipped |= cuts_off(dst.spec().format);
    job.threads = thread_count(nthreads);
    job.device = options.device;
    job.holes = holes;
    job.progress = options.progress;
    job.statistics = &statistics;
    const Outcome outcome = enlarge(source, sink, mapping, job, &error);
    if (options.statistics)
        *options.statistics = statistics;
    if (outcome != Outcome::done) {
        if (const std::string why = source.error(); !why.empty())
            error = why;
        return false;
    }
    if (verbose())
        say("ddt: %d x %d to %d x %d pixels, %d of %d channels, %s light, %d iterations, "
            "%.2f flips a pixel, %.3f s",
            job.window.width(), job.window.height(), roi.width(), roi.height(), roi.nchannels(),
            src.nchannels(), reading.light.converts() ? "converted to linear" : "unconverted",
            statistics.iterations,
            double(statistics.flips) / double(std::max<int64_t>(statistics.pixels, 1)), timer());
    return true;
}

} // namespace ddt

#include "plugin/resample.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/strutil.h>
#include <OpenImageIO/sysutil.h>
#include <OpenImageIO/timer.h>

#include "plugin/image/pixels.h"
#include "plugin/image/sink.h"
#include "plugin/image/source.h"
#include "plugin/image/windows.h"

namespace ddt {
namespace {

/// The channels the core works on: those wanted, then what the way back from linear light needs.
std::vector<int> select(const Reading& reading, const OIIO::ROI& roi) {
    std::vector<int> selected;
    for (int c = roi.chbegin; c < roi.chend; ++c)
        selected.push_back(c);
    const ColourLayout& colour = reading.channels.colour;
    const auto wanted = [&](int c) { return c >= roi.chbegin && c < roi.chend; };
    if (reading.light.converts() &&
        std::any_of(colour.channel, colour.channel + colour.count, wanted)) {
        for (int k = 0; k < colour.count; ++k)
            if (!wanted(colour.channel[k]))
                selected.push_back(colour.channel[k]);
        if (colour.alpha >= 0 && !wanted(colour.alpha))
            selected.push_back(colour.alpha);
    }
    return selected;
}

GuideRecipe recipe(const Channels& channels, const Light& light, bool linear) {
    GuideRecipe guide;
    guide.linear = linear;
    guide.alpha = channels.alpha;
    for (int k = 0; k < channels.colour.count; ++k) {
        guide.channel[k] = channels.colour.channel[k];
        guide.weight[k] = channels.colour.count == 3 ? light.luma()[k] : 1.0f;
    }
    if (channels.colour.count == 0) {
        guide.channel[0] = channels.guide;
        guide.weight[0] = 1.0f;
    }
    return guide;
}

bool plan_reading(const OIIO::ImageBuf& src, const Options& options, const OIIO::ROI& roi,
                  Reading& reading, std::string& error) {
    const OIIO::ImageSpec& spec = src.spec();
    reading.channels = channels_of(spec, src.nativespec().format);
    const bool encoded = options.light == "encoded";
    std::shared_ptr<const Light> light = std::make_shared<Light>();
    if (reading.channels.colour.count) {
        std::string why;
        auto found = find_light(options.light, spec.get_string_attribute("oiio:ColorSpace"), why);
        if (!found && !encoded) {
            error = why;
            return false;
        }
        // With light=encoded a space only tells how to look at the numbers; without one it is
        // guessed below.
        if (found)
            light = found;
    }
    // Numbers that are not converted are looked at as they are when they are an encoding, or
    // integers of which nobody says: those mostly are one.
    const bool linear =
        light->known() ? !(encoded && light->converts()) : spec.format.is_floating_point();
    reading.guide = recipe(reading.channels, *light, linear);
    if (!encoded)
        reading.light = *light;
    reading.selected = select(reading, roi);
    return true;
}

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

int thread_count(int nthreads) {
    if (nthreads <= 0)
        OIIO::getattribute("threads", nthreads);
    return std::max(nthreads, 0); // 0: the core takes all
}

bool verbose() {
    const char* value = std::getenv("DDT_VERBOSE");
    return value && *value && *value != '0';
}

} // namespace

bool resample(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const Mapping& mapping,
              const OIIO::ROI& roi, const Options& options, int nthreads, std::string& error) {
    const OIIO::Timer timer;
    Reading reading;
    if (!plan_reading(src, options, roi, reading, error))
        return false;
    const Writing writing = plan_writing(reading, src, roi);
    ImageSource source(src, reading);
    ImageSink sink(dst, writing);

    Statistics statistics;
    Job job;
    job.window = rect_of(src.roi());
    job.channels = int(reading.selected.size());
    for (int c : reading.selected)
        job.kinds.push_back(reading.channels.kinds[c]);
    job.mesh = options.mesh;
    job.surface = options.surface;
    job.threads = thread_count(nthreads);
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
        std::fprintf(
            stderr,
            "ddt: %d x %d to %d x %d pixels, %d of %d channels, %s light, %d iterations, "
            "%.2f flips a pixel, %.3f s\n",
            job.window.width(), job.window.height(), roi.width(), roi.height(), roi.nchannels(),
            src.nchannels(), reading.light.converts() ? "converted to linear" : "unconverted",
            statistics.iterations,
            double(statistics.flips) / double(std::max<int64_t>(statistics.pixels, 1)), timer());
    return true;
}

bool resize_by_oiio(OIIO::ImageBuf& dst, const OIIO::ImageBuf& src, const OIIO::ROI& roi,
                    int nthreads, std::string& error) {
    const auto resized = [&](OIIO::ImageBuf& out, const OIIO::ROI& part) {
        if (OIIO::ImageBufAlgo::resize(out, src, "", 0.0f, part, nthreads))
            return true;
        error = out.has_error() ? out.geterror() : "OpenImageIO's resize failed";
        return false;
    };
    if (roi.chbegin == 0 && roi.chend == dst.nchannels() && roi.chend == src.nchannels())
        return resized(dst, roi);
    OIIO::ImageSpec spec = src.spec();
    spec.set_format(dst.spec().format);
    OIIO::ROI part = roi;
    part.chbegin = 0;
    part.chend = src.nchannels();
    OIIO::set_roi(spec, part);
    OIIO::set_roi_full(spec, dst.roi_full());
    if (!check_size(part, spec.nchannels, spec.format, error))
        return false;
    OIIO::ImageBuf all(spec);
    return resized(all, part) && copy_moved(dst, all, roi, 0, 0, Beyond::edge, error);
}

} // namespace ddt

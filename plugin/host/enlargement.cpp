// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/enlargement.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/base/guarded.h"
#include "core/tiles/grid.h"
#include "core/tiles/tile_io.h"
#include "plugin/colour/encodings.h"
#include "plugin/host/pixels.h"

namespace ddt::host {
namespace {

ResizeMapping::Axis axis(int from0, int from1, int to0, int to1, int out0, int out1) {
    ResizeMapping::Axis a;
    a.from0 = a.window0 = from0;
    a.from_size = from1 - from0;
    a.window1 = from1;
    a.to0 = to0;
    a.to_size = to1 - to0;
    a.out0 = out0;
    a.out1 = out1;
    return a;
}

ResizeMapping mapping_of(const Rect& window, const Rect& full, const Rect& box) {
    return {axis(window.x0, window.x1, full.x0, full.x1, box.x0, box.x1),
            axis(window.y0, window.y1, full.y0, full.y1, box.y0, box.y1)};
}

bool holds(const Rect& outer, const Rect& inner) {
    return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 &&
           inner.y1 <= outer.y1;
}

bool same_size(const Rect& a, const Rect& b) {
    return a.width() == b.width() && a.height() == b.height();
}

bool check(const Enlargement& work, std::string& error) {
    if (work.window.empty() || work.full.empty())
        error = "ddt: the picture has no pixels";
    else if (work.full.width() < work.window.width() || work.full.height() < work.window.height())
        error = "ddt: the result of " + std::to_string(work.full.width()) + " x " +
                std::to_string(work.full.height()) + " pixels must not be smaller than the " +
                std::to_string(work.window.width()) + " x " + std::to_string(work.window.height()) +
                " of the picture";
    else if (work.to.box.empty() || !holds(work.full, work.to.box))
        error = "ddt: the part wanted lies outside the result";
    return error.empty();
}

/// The pixels as they are, in another place: bit for bit, if they are numbers of the same kind.
void copy(const Enlargement& work) {
    const Buffer &from = work.from, &to = work.to;
    const Rect& box = to.box;
    const int dx = work.window.x0 - work.full.x0, dy = work.window.y0 - work.full.y0;
    const int channels = work.layout.channels;
    const size_t size = size_of(to.sample);
    std::vector<float> pixel(size_t(channels), 0.0f);
    for (int y = box.y0; y < box.y1; ++y)
        for (int x = box.x0; x < box.x1; ++x) {
            const int u = x + dx, v = y + dy;
            const bool there =
                u >= from.box.x0 && u < from.box.x1 && v >= from.box.y0 && v < from.box.y1;
            if (there && from.sample == to.sample) {
                for (int c = 0; c < channels; ++c)
                    std::memcpy(to.at(x, y) + c * to.channel, from.at(u, v) + c * from.channel,
                                size);
                continue;
            }
            if (there)
                load(from, u, v, 1, channels, pixel.data());
            store(to, x, y, 1, channels, pixel.data());
            std::fill(pixel.begin(), pixel.end(), 0.0f);
        }
}

/// No exception leaves.
template <class Work>
Outcome guarded(std::string& error, Work&& body) {
    error.clear();
    Outcome outcome = Outcome::bad_job;
    const Caught caught = guarded_call(&error, [&] { outcome = body(); });
    if (caught == Caught::nothing)
        return outcome;
    return caught == Caught::out_of_memory ? Outcome::out_of_memory : Outcome::bad_job;
}

Job job_of(const Enlargement& work) {
    Job job;
    job.window = work.window;
    job.channels = work.layout.channels;
    job.kinds = work.layout.kinds;
    job.mesh = work.mesh;
    job.surface = work.surface;
    job.threads = work.threads;
    job.device = work.device;
    job.holes = work.holes;
    job.progress = work.progress;
    job.statistics = work.statistics;
    return job;
}

} // namespace

Layout Layout::usual(int channels, bool associated) {
    Layout layout;
    layout.channels = channels;
    layout.associated = associated;
    layout.kinds.assign(size_t(channels), Channel::blend);
    layout.colour.count = channels < 3 ? 1 : 3;
    for (int k = 0; k < layout.colour.count; ++k)
        layout.colour.channel[k] = k;
    if (channels == 2 || channels >= 4) {
        layout.colour.alpha = channels == 2 ? 1 : 3;
        layout.kinds[size_t(layout.colour.alpha)] = Channel::alpha;
    }
    return layout;
}

Layout Layout::ids(int channels) {
    Layout layout;
    layout.channels = channels;
    layout.kinds.assign(size_t(channels), Channel::nearest);
    return layout;
}

bool find_meaning(std::string_view name, Meaning& meaning, std::string& error) {
    if (name == "encoded") {
        meaning = {std::make_shared<Light>(), false};
        return true;
    }
    if (const auto light = find_encoding(name)) {
        meaning = {light, true};
        return true;
    }
    error = "ddt: light \"" + std::string(name) + "\" is not allowed; allowed are ";
    for (const std::string& allowed : meaning_names())
        error += (allowed == meaning_names().front() ? "" : ", ") + allowed;
    return false;
}

std::vector<std::string> meaning_names() {
    std::vector<std::string> names = encoding_names();
    names.insert(names.begin() + 1, "encoded");
    return names;
}

Rect needed(const Rect& window, const Rect& full, const Rect& box, Holes holes) {
    const Rect part = common(full, box);
    if (window.empty() || part.empty())
        return {};
    if (same_size(window, full))
        return {part.x0 + window.x0 - full.x0, part.y0 + window.y0 - full.y0,
                part.x1 + window.x0 - full.x0, part.y1 + window.y0 - full.y0};
    if (holes != Holes::keep)
        return window;
    const Grid tiles = shown_tiles(window, mapping_of(window, full, part));
    const Rect first = tiles.tile(0).pixels, last = tiles.tile(tiles.count() - 1).pixels;
    return {first.x0, first.y0, last.x1, last.y1};
}

Rect scaled(const Rect& window, double x_factor, double y_factor) {
    // What is beyond the limits of windows stays beyond them, and within ints.
    const auto times = [](int n, double factor) {
        return int(std::lround(std::clamp(double(n) * factor, -1e9, 1e9)));
    };
    Rect r;
    r.x0 = times(window.x0, x_factor);
    r.y0 = times(window.y0, y_factor);
    r.x1 = r.x0 + std::max(1, times(window.width(), x_factor));
    r.y1 = r.y0 + std::max(1, times(window.height(), y_factor));
    return r;
}

GuideRecipe guide_recipe(const Layout& layout, const Meaning& meaning) {
    GuideRecipe guide;
    guide.linear = meaning.linear;
    guide.alpha = layout.colour.alpha;
    for (int k = 0; k < layout.colour.count; ++k) {
        guide.channel[k] = layout.colour.channel[k];
        guide.weight[k] = layout.colour.count == 3 ? meaning.light->luma()[size_t(k)] : 1.0f;
    }
    return guide;
}

Outcome enlarge(const Enlargement& work, Source& source, Sink& sink, std::string& error) {
    return guarded(error, [&] {
        if (!check(work, error))
            return Outcome::bad_job;
        return ddt::enlarge(source, sink, mapping_of(work.window, work.full, work.to.box),
                            job_of(work), &error);
    });
}

Outcome enlarge(const Enlargement& work, std::string& error) {
    if (work.from.data && work.to.data && same_size(work.window, work.full))
        return guarded(error, [&] {
            if (!check(work, error))
                return Outcome::bad_job;
            copy(work);
            return Outcome::done;
        });
    if (!work.from.data || !work.to.data) {
        error = "ddt: there is no memory with pixels";
        return Outcome::bad_job;
    }
    BufferSource source(work);
    BufferSink sink(work);
    return enlarge(work, source, sink, error);
}

} // namespace ddt::host

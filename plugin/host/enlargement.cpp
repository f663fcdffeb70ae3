// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/enlargement.h"

#include <algorithm>
#include <cstring>

#include "core/base/guarded.h"
#include "core/base/one_line.h"
#include "core/base/parallel.h"
#include "plugin/colour/colour_pixels.h"
#include "plugin/colour/encodings.h"
#include "plugin/host/holes.h"
#include "plugin/host/pixels.h"

namespace ddt::host {
namespace {

bool holds(const Rect& outer, const Rect& inner) {
    return inner.x0 >= outer.x0 && inner.y0 >= outer.y0 && inner.x1 <= outer.x1 &&
           inner.y1 <= outer.y1;
}

bool check(const Enlargement& work, std::string& error) {
    const Rect &window = work.place.window, &full = work.place.full;
    if (window.empty() || full.empty())
        error = "ddt: the picture has no pixels";
    else if (full.width() < window.width() || full.height() < window.height())
        error = "ddt: the result of " + std::to_string(full.width()) + " x " +
                std::to_string(full.height()) + " pixels must not be smaller than the " +
                std::to_string(window.width()) + " x " + std::to_string(window.height()) +
                " of the picture";
    else if (work.to.box.empty() || !holds(full, work.to.box))
        error = "ddt: the part wanted lies outside the result";
    return error.empty();
}

/// The pixels as they are, in another place: bit for bit, if they are numbers of the same kind.
void copy(const Enlargement& work) {
    const Buffer &from = work.from, &to = work.to;
    const Rect& box = to.box;
    const Placing& place = work.place;
    const int dx = place.from.x0 - place.to.x0, dy = place.from.y0 - place.to.y0;
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
    job.window = work.place.window;
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

int threads_within(uint64_t allows) {
    const auto usual = uint64_t(usual_threads());
    return int(std::max<uint64_t>(std::min(usual, allows), 1));
}

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

bool find_meaning(std::string_view name, Meaning& meaning, std::string& error,
                  std::string_view other) {
    if (name == "encoded") {
        meaning = {std::make_shared<Light>(), false};
        return true;
    }
    if (const auto light = find_encoding(name)) {
        meaning = {light, true};
        return true;
    }
    error = "ddt: light \"" + one_line(std::string(name)) + "\" is not allowed; allowed are ";
    std::vector<std::string> allowed = meaning_names();
    if (!other.empty())
        allowed.insert(allowed.begin(), std::string(other));
    for (const std::string& name_allowed : allowed)
        error += (&name_allowed == &allowed.front() ? "" : ", ") + name_allowed;
    return false;
}

std::vector<std::string> meaning_names() {
    std::vector<std::string> names = encoding_names();
    names.insert(names.begin() + 1, "encoded");
    return names;
}

GuideRecipe guide_recipe(const Layout& layout, const Meaning& meaning) {
    return ddt::guide_recipe(*meaning.light, layout.colour, meaning.linear);
}

Outcome enlarge(const Enlargement& work, Source& source, Sink& sink, std::string& error) {
    return guarded(error, [&] {
        if (!check(work, error))
            return Outcome::bad_job;
        return ddt::enlarge(source, sink, work.place.mapping(work.to.box), job_of(work), &error);
    });
}

Outcome enlarge(const Enlargement& work, std::string& error) {
    if (work.from.data && work.to.data && work.place.copies())
        return guarded(error, [&] {
            if (!check(work, error))
                return Outcome::bad_job;
            copy(work);
            const bool fill = work.holes != Holes::keep && !work.layout.is_ids();
            return fill ? fill_copy(work, job_of(work), error) : Outcome::done;
        });
    if (!work.from.data || !work.to.data) {
        error = "ddt: the source's and the result's memory must not be null";
        return Outcome::bad_job;
    }
    HostSource source(work);
    HostSink sink(work);
    return enlarge(work, source, sink, error);
}

} // namespace ddt::host

// SPDX-License-Identifier: Apache-2.0
#include "plugin/host/holes.h"

#include <cstring>
#include <vector>

#include "core/base/float_bits.h"
#include "core/base/parallel.h"
#include "core/base/progress.h"
#include "core/fill/whole_source.h"
#include "ddt/devices.h"
#include "plugin/host/pixels.h"

namespace ddt::host {
namespace {

/// Of the time that all takes, about; the rest is telling that all is done.
constexpr float share_of_all = 0.99f;

Enlargement unconverted(Enlargement work) {
    work.meaning.light = std::make_shared<Light>();
    return work;
}

/// The numbers as they are, but associated, and the guide that all work on them has.
class UnconvertedSource final : public Source {
public:
    explicit UnconvertedSource(const Enlargement& work)
        : m_unconverted(unconverted(work)), m_values(m_unconverted), m_guide(work) {}
    UnconvertedSource(const UnconvertedSource&) = delete;
    UnconvertedSource& operator=(const UnconvertedSource&) = delete;
    bool read(const Rect& r, float* values, float* guide) override {
        std::vector<float> converted(r.area() * size_t(m_unconverted.layout.channels));
        return read_again(r, values, guide) && m_guide.read(r, converted.data(), guide);
    }
    /// The numbers alone; `guide` is room for one that means nothing.
    bool read_again(const Rect& r, float* values, float* guide) {
        return m_values.read(r, values, guide);
    }
    /// The way back from associated ones.
    void to_memory(float* values, size_t count) const { from_work(m_unconverted, values, count); }

private:
    const Enlargement m_unconverted;
    HostSource m_values, m_guide;
};

bool differ(float a, float b) {
    return bits_of(a) != bits_of(b);
}

bool is_colour(const Layout& layout, int channel) {
    for (int k = 0; k < layout.colour.count; ++k)
        if (layout.colour.channel[k] == channel)
            return true;
    return false;
}

/// A number of a pixel.
void store_one(Buffer to, int x, int y, int channel, float value) {
    to.data = to.at(x, y) + channel * to.channel;
    to.box = {x, y, x + 1, y + 1};
    store(to, x, y, 1, 1, &value);
}

/// Store a pixel's numbers that are others than before. `before` and `after` are associated,
/// `shown` is what memory is to have.
void put_pixel(const Enlargement& work, int x, int y, const float* before, const float* after,
               const float* shown) {
    const Layout& layout = work.layout;
    const int alpha = layout.colour.alpha;
    // Colour that was divided by another alpha, or that did not show.
    const bool all_colour = must_associate(layout) && differ(before[alpha], after[alpha]);
    for (int c = 0; c < layout.channels; ++c)
        if (differ(before[c], after[c]) || (all_colour && is_colour(layout, c)))
            store_one(work.to, x, y, c, shown[c]);
}

void put_filled(const Enlargement& work, UnconvertedSource& source, WholeSource& filled) {
    const Rect& box = work.to.box;
    const Rect &from = work.place.from, &to = work.place.to;
    const int dx = from.x0 - to.x0, dy = from.y0 - to.y0;
    const auto width = size_t(box.width()), channels = size_t(work.layout.channels);
    std::vector<float> before(width * channels), after(before.size()), shown, guide(width);
    for (int y = box.y0; y < box.y1; ++y) {
        const Rect row{box.x0 + dx, y + dy, box.x1 + dx, y + dy + 1};
        (void)source.read_again(row, before.data(), guide.data()); // memory is there
        filled.read(row, after.data(), guide.data());
        if (std::memcmp(before.data(), after.data(), before.size() * sizeof(float)) == 0)
            continue;
        shown = after;
        source.to_memory(shown.data(), width);
        for (size_t i = 0; i < width; ++i)
            put_pixel(work, box.x0 + int(i), y, &before[i * channels], &after[i * channels],
                      &shown[i * channels]);
    }
}

} // namespace

Outcome fill_copy(const Enlargement& work, const Job& job, std::string& error) {
    std::string line;
    // A device that was named is missed also where no pixel is; none is opened for that otherwise.
    const bool is_named = job.device != Device::automatic;
    if (is_named ? !describe_device(job, line) : !check_device(job.device, line)) {
        error = line;
        return Outcome::device_unavailable;
    }
    const ProgressCallback progress = until_it_ends(work.progress);
    UnconvertedSource source(work);
    WholeSource filled;
    Outcome outcome = filled.fill(source, job, threads_for(job.threads),
                                  part_of(progress, 0, share_of_all), error);
    if (outcome == Outcome::done && progress && !progress(1))
        outcome = Outcome::cancelled;
    if (outcome == Outcome::cancelled)
        error = "ddt: cancelled";
    if (outcome == Outcome::done)
        put_filled(work, source, filled);
    return outcome;
}

} // namespace ddt::host

// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstring>
#include <thread>

#include "plugin/host/request.h"
#include "plugin/openfx/actions.h"
#include "plugin/openfx/progress_bar.h"
#include "plugin/openfx/source_clip.h"
#include "plugin/openfx/suites.h"

namespace ddt::ofx {
namespace {

/// An image of a clip; released when it goes.
class Image {
public:
    /// `clip` may be null: that of a source without a region.
    Image(Clip clip, double time)
        : m_status(clip ? suites.effect->clip_get_image(clip, time, nullptr, &m_image)
                        : int(failed)) {
        if (m_status != ok)
            m_image = nullptr;
    }
    ~Image() {
        if (m_image)
            suites.effect->clip_release_image(m_image);
    }
    Image(const Image&) = delete;
    Image& operator=(const Image&) = delete;
    /// False where there is none, or one without pixels.
    explicit operator bool() const { return m_image && !bounds().empty(); }
    /// What clipGetImage() said. By `failed`, and by no other failure, it asks to take the image
    /// for black and transparent.
    int status() const { return m_status; }

    /// 4, 3, 1, or 0 for components that are not supported.
    int channels() const {
        const std::string components = get(m_image, "OfxImageEffectPropComponents", "");
        return components == "OfxImageComponentRGBA"    ? 4
               : components == "OfxImageComponentRGB"   ? 3
               : components == "OfxImageComponentAlpha" ? 1
                                                        : 0;
    }
    bool unpremultiplied() const {
        return get(m_image, "OfxImageEffectPropPreMultiplication", "") ==
               "OfxImageAlphaUnPremultiplied";
    }
    /// All that the image is a part of; empty where the host does not say.
    Rect defined() const { return host::flipped(rectangle("OfxImagePropRegionOfDefinition")); }
    /// False for a depth that is not supported or an image without memory.
    bool buffer(host::Buffer& b) const {
        constexpr std::pair<const char*, host::Sample> depths[] = {
            {"OfxBitDepthFloat", host::Sample::float32},
            {"OfxBitDepthHalf", host::Sample::half},
            {"OfxBitDepthShort", host::Sample::uint16},
            {"OfxBitDepthByte", host::Sample::uint8}};
        const std::string depth = get(m_image, "OfxImageEffectPropPixelDepth", "");
        const auto* known = std::find_if(std::begin(depths), std::end(depths),
                                         [&](const auto& d) { return depth == d.first; });
        char* data = static_cast<char*>(get_pointer(m_image, "OfxImagePropData"));
        if (known == std::end(depths) || !data)
            return false;
        const Rect upwards = bounds();
        const ptrdiff_t row = get(m_image, "OfxImagePropRowBytes", 0);
        b.sample = known->second;
        b.channel = ptrdiff_t(host::size_of(b.sample));
        b.pixel = b.channel * channels();
        b.row = -row;
        b.box = host::flipped(upwards);
        b.data = data + row * (upwards.height() - 1); // the uppermost
        return true;
    }

private:
    /// Rows upwards.
    Rect bounds() const { return rectangle("OfxImagePropBounds"); }
    Rect rectangle(const char* name) const {
        const auto side = [&](int i) { return get(m_image, name, 0, i); };
        return {side(0), side(1), side(2), side(3)};
    }

    Properties m_image = nullptr; // before m_status, whose making sets it
    int m_status;
};

/// Progress, and the host's wish to stop, both on the thread that it called us on alone.
class Watch {
public:
    explicit Watch(Effect effect) : m_effect(effect), m_bar(effect) {}
    bool operator()(float share) {
        if (std::this_thread::get_id() != m_thread)
            return true;
        m_closed = !m_bar.update(share);
        return !m_closed && !suites.effect->abort(m_effect);
    }
    /// Whether it was the bar that stopped the work, of which the host's render knows nothing.
    bool closed() const { return m_closed; }

private:
    Effect m_effect;
    ProgressBar m_bar;
    bool m_closed = false;
    std::thread::id m_thread = std::this_thread::get_id();
};

Rect render_window(Properties in) {
    const auto side = [&](int i) { return get(in, "OfxImageEffectPropRenderWindow", 0, i); };
    return host::flipped({side(0), side(1), side(2), side(3)});
}

/// Make the part of the output black.
void clear(const host::Buffer& to, const Rect& part, int channels) {
    const size_t bytes =
        part.empty() ? 0 : size_t(part.width()) * size_t(channels) * size_t(to.channel);
    for (int y = part.y0; y < part.y1; ++y)
        std::memset(to.at(part.x0, y), 0, bytes);
}

/// What to do with pixels of these components.
bool plan(const Image& image, const Settings& settings, host::Enlargement& work,
          std::string& error) {
    const bool straight =
        settings.premultiplication == unpremultiplied ||
        (settings.premultiplication == as_the_image_says && image.unpremultiplied());
    work.layout = host::Layout::usual(image.channels(), !straight);
    // A matte is coverage, which mixes like linear light: its numbers are never converted.
    const bool matte = image.channels() == 1 && settings.light != "encoded";
    return host::set_filter(settings.filter, matte ? "linear" : settings.light, work, error);
}

/// What the host allows a render, which may be one of several that run side by side.
int threads_of_host() {
    unsigned int cpus = 0;
    const bool says = suites.multi_thread && suites.multi_thread->number_of_cpus &&
                      suites.multi_thread->number_of_cpus(&cpus) == ok && cpus > 0;
    return says ? host::threads_within(cpus) : 0;
}

int render_part(Effect effect, const SourceClip& source, const Image& from, const Image& to,
                Rect part, std::string& error) {
    host::Enlargement work;
    if (!from.buffer(work.from) || !to.buffer(work.to) || from.channels() == 0 ||
        from.channels() != to.channels()) {
        error = "ddt: allowed are RGBA, RGB and Alpha of 8 or 16 bits, half or float, the same in "
                "and out";
        return failed;
    }
    if (!plan(from, source.settings, work, error))
        return failed;
    const Windows w = source.windows();
    work.place = w.place;
    work.place.window = w.window_of(from.defined());
    if (!w.bounded())
        work.holes = Holes::keep; // a copy, whatever else is asked for
    part = intersection(part, work.to.box);
    const Rect inside = intersection(part, w.place.full);
    if (inside.width() != part.width() || inside.height() != part.height())
        clear(work.to, part, work.layout.channels);
    if (inside.empty())
        return ok;
    host::Buffer& out = work.to;
    out.data = out.at(inside.x0, inside.y0);
    out.box = inside;
    work.threads = threads_of_host();
    Watch watch(effect);
    work.progress = std::ref(watch);
    const Outcome outcome = host::enlarge(work, error);
    if (outcome == Outcome::cancelled)
        error.clear();
    // The host does not look at what is left of a render that it stopped: that is no failure.
    const bool stopped = outcome == Outcome::cancelled && !watch.closed();
    return outcome == Outcome::done || stopped ? int(ok)
           : outcome == Outcome::out_of_memory ? int(out_of_memory)
                                               : int(failed);
}

/// What clipGetImage() asks of an effect whose source has no image at that time: it is black. So is
/// one whose image has no pixels, and one whose region could not be determined.
int render_black(const Image& to, const Rect& part) {
    host::Buffer buffer;
    if (!to.buffer(buffer) || to.channels() == 0)
        return failed;
    clear(buffer, intersection(part, buffer.box), to.channels());
    return ok;
}

/// One of them is not there.
int render_without(const Image& from, const Image& to, const Rect& part) {
    if (!to)
        return failure(to.status());
    if (from.status() != ok && from.status() != failed)
        return failure(from.status());
    return render_black(to, part);
}

} // namespace

int render(Effect effect, Properties in) {
    SourceClip source;
    Clip output = nullptr;
    std::string error;
    const int found = source.find(effect, in);
    // A host that stops a render may have nothing more to hand out, and looks at no failure.
    const auto stopped = [&] { return suites.effect->abort(effect) != 0; };
    if (found != ok && !source.is_black)
        return stopped() ? int(ok) : failure(found);
    if (suites.effect->clip_get_handle(effect, "Output", &output, nullptr) != ok)
        return failed;
    const Image from(found == ok ? source.clip : nullptr, source.time), to(output, source.time);
    if (!from || !to)
        return stopped() ? int(ok) : render_without(from, to, render_window(in));
    const int status = render_part(effect, source, from, to, render_window(in), error);
    if (!error.empty())
        complain(effect, error);
    return status;
}

} // namespace ddt::ofx

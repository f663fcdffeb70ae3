// SPDX-License-Identifier: Apache-2.0
// A part of a picture in a host's memory, enlarged into another: what all hosts have in common.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ddt/core.h"
#include "ddt/guide.h"
#include "ddt/progress.h"
#include "plugin/colour/layout.h"
#include "plugin/colour/light.h"
#include "plugin/host/buffer.h"
#include "plugin/host/placing.h"

namespace ddt::host {

/// What a pixel's numbers are.
struct Layout {
    int channels = 1;
    ColourLayout colour; ///< colour.alpha: what it is associated with, also while it is not yet
    std::vector<Channel> kinds; ///< one a channel
    /// False: memory holds colour that is to be multiplied by alpha first, and divided afterwards.
    bool associated = true;

    /// Of so many channels as OpenImageIO names them: grey, grey and alpha, RGB, RGBA, RGBA and
    /// more.
    static Layout usual(int channels, bool associated = true);
    /// Nothing but object IDs.
    static Layout ids(int channels);
    bool is_ids() const { return kinds[0] == Channel::nearest; }
};

/// What the numbers of colour mean.
struct Meaning {
    std::shared_ptr<const Light> light; ///< not null; which may convert nothing
    bool linear = true; ///< once converted they are linear light; else seen as they are
};

/// "linear", "encoded" (blended as they are), or one of encoding_names(): blended in linear light.
/// False, with one line in `error`, for any other name; which tells of `other` too, a name that the
/// caller knows besides.
bool find_meaning(std::string_view name, Meaning& meaning, std::string& error,
                  std::string_view other = {});
std::vector<std::string> meaning_names();

/// The work. What is written is to.box, bit for bit a crop of the whole. Both buffers have the
/// layout's channels.
struct Enlargement {
    Buffer from, to; ///< from.box holds needed(place, to.box, holes); what it lacks counts as 0
    Placing place;   ///< of the whole source, whether in memory or not
    Layout layout;
    Meaning meaning;
    SurfaceOptions surface; ///< `clipped` is what the user says: oiiotool's files count as floats
    MeshOptions mesh;
    Device device = Device::automatic;
    Holes holes = Holes::keep; ///< not keep: from.box holds the whole window
    int threads = 0;           ///< see Job::threads; threads_within() of the program's own limit
    ProgressCallback progress; ///< see Job::progress
    Statistics* statistics = nullptr;
};

/// As many threads as usual, but no more than the program that we are in `allows` its own work.
int threads_within(uint64_t allows);

/// Do it. A full that has the window's size and is not enlarged is a copy, in which holes are
/// filled if `holes` says so: what is there keeps its bits. A smaller one is Outcome::bad_job, with
/// one line in `error` as of any failure. Never throws.
Outcome enlarge(const Enlargement& work, std::string& error);

/// The same with a source and a sink of the host's own, whose pixels are associated linear light or
/// stay as they are; of from and to only the boxes and the kind of numbers count. Sizes differ.
Outcome enlarge(const Enlargement& work, Source& source, Sink& sink, std::string& error);

/// How edges are sought in such pixels; the same as the filter does for images of OpenImageIO.
GuideRecipe guide_recipe(const Layout& layout, const Meaning& meaning);

} // namespace ddt::host

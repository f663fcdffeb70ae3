// SPDX-License-Identifier: Apache-2.0
// A piece of work: where pixels come from, where they go, and what is done with them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ddt/code_table.h"
#include "ddt/mapping.h"
#include "ddt/options.h"
#include "ddt/progress.h"

namespace ddt {

/// What a channel's numbers are.
enum class Channel : uint8_t {
    /// A quantity: interpolated over the surface.
    blend,
    /// A share: as blend, but where a surface leaves the range of its pixels
    /// (SurfaceOptions::consistency), what is read off it is cut off at 0 and 1, or at the four
    /// pixels of its cell where they leave that. So 0 to 1 stays 0 to 1, and alpha remains that of
    /// the colours that are multiplied by it.
    alpha,
    /// An object ID: copied, bit for bit, from the vertex with the largest weight.
    nearest,
};

/// Where pixels come from. Called from several threads at once.
class Source {
public:
    virtual ~Source() = default;
    /// Fill `values`, `channels` interleaved floats per pixel, and `guide`, one float per pixel,
    /// for the pixels of `r`, row by row without gaps. `r` lies within Job::window. The guide is
    /// what edges are sought in, about 0 to 1 from black to white, below 0 where nothing is;
    /// make_guide() of ddt/guide.h makes the usual one. Values of magnitude below 2^-80 count as 0,
    /// but Channel::nearest, and so does a guide's below 2^-24: little that is computed from
    /// others is near the denormal floats, which devices treat in different ways. A guide value
    /// that is not finite counts as 0 too. Return false to end the work (an error the source itself
    /// keeps).
    virtual bool read(const Rect& r, float* values, float* guide) = 0;

    /// Where every number is one of 256 or 65536 codes, the floats that they stand for, in order;
    /// else nothing, as which any other number of floats counts. Asked once, before anything is
    /// read, for devices to which numbers travel far: they are then read by read_codes().
    virtual std::vector<float> codes() { return {}; }
    /// As read(), with the codes of the values in `codes`: a uint8_t each where codes() has 256,
    /// and a uint16_t where it has 65536.
    virtual bool read_codes(const Rect& /*r*/, void* /*codes*/, float* /*guide*/) { return false; }
};

/// Where results go. Called from several threads at once, never twice for the same pixel.
class Sink {
public:
    virtual ~Sink() = default;
    /// Take the output pixels of `r`: `channels` interleaved floats, rows without gaps. The sink
    /// may change `values`. Return false to end the work.
    virtual bool write(const Rect& r, float* values) = 0;
    /// Memory of the sink's own where the pixels of `r` may be put instead of being handed to
    /// write(), as they are: `row` receives the floats from one row to the next. Null: none.
    virtual float* place(const Rect& /*r*/, size_t& /*row*/) { return nullptr; }

    // Results that have far to go, from a GPU, may be made smaller before they do. What a sink
    // takes is asked once, before anything is written.

    /// Whether write_packed() takes 16-bit floats (IEEE 754 binary16): the nearest, of two the even
    /// one.
    virtual bool takes_halfs() const { return false; }
    /// The table, which must stay, whose codes write_packed() takes, a byte each; before halfs.
    /// Null, or one without entries: none.
    virtual const CodeTable* takes_codes() const { return nullptr; }
    /// As write(); some devices call it in its place, of a sink that takes one or the other.
    /// `numbers`: one byte each, codes of takes_codes()'s table, if there is one, else binary16.
    virtual bool write_packed(const Rect& /*r*/, const void* /*numbers*/) { return false; }
};

/// Nanoseconds that the threads spent, added up, in each stage of a job on the CPU.
struct StageTimes {
    int64_t read = 0;        ///< Source::read: with its conversions and the guide
    int64_t triangulate = 0; ///< with the making of the starting mesh
    int64_t surface = 0;     ///< gradients, bends, corrections
    int64_t sample = 0;      ///< positions by the mapping, and the surface there
    int64_t write = 0;       ///< Sink::write: with its conversions
};

/// What was done; sums over all tiles, so halos count.
struct Statistics {
    int64_t pixels = 0;      ///< vertices of all meshes
    int64_t evaluations = 0; ///< gains computed
    int64_t flips = 0;
    int64_t rounds = 0; ///< of accepting and rejecting, in the schemes that do
    int iterations = 0; ///< the largest of any tile
    StageTimes times;
    /// Where the tiles were worked on; cpu if at least one was. Never automatic.
    Device device = Device::cpu;

    /// Add what other tiles were worth; `device` stays.
    Statistics& operator+=(const Statistics& other);
};

/// A piece of work.
struct Job {
    Rect window;      ///< the source's pixels (data window), not empty, 2^45 of them at most
    int channels = 1; ///< floats per pixel, 1 or more
    std::vector<Channel> kinds; ///< one a channel; empty: all blend
    MeshOptions mesh;
    SurfaceOptions surface;
    int threads = 0; ///< 0: one a processor that the process may use, or a container's quota
    /// A device that is named and cannot be had is Outcome::device_unavailable, before anything is
    /// read. A device that fails later, also for lack of memory, leaves the rest to the CPU; one
    /// that does not answer any more cannot be had by later jobs of the process. A
    /// process forked from one that used a GPU has none and uses the CPU, whatever is named.
    Device device = Device::automatic;
    /// Unless keep, the whole window is read first, and kept. Pixels in which a channel that is not
    /// Channel::nearest is NaN, and by fill_alpha those whose Channel::alpha is 0, are filled as by
    /// fill_holes() of ddt/points.h, with `mesh` (but the cost's own min_gain, and look_ahead in
    /// place of one_round); a pixel that lacks some channels keeps the others. A failure if all
    /// pixels are missing, the image has more than 2^31 - 1, or more than 2^27 lie about one hole.
    ///
    /// Memory, where small holes count together, by blocks of 64 x 64, and large ones in pieces
    /// where they are thin:
    ///
    ///     of                                                             | bytes
    ///     ---------------------------------------------------------------|---------------------
    ///     each pixel                                                     | 14 + 4 a channel
    ///     each missing pixel                                             | some 50
    ///     each missing pixel that has some channels                      | 4 a channel more
    ///     each thread, for each pixel about the hole that it works on    | some 300 + 4 a channel
    ///     each thread, for each pixel of the box round that hole         | 2
    Holes holes = Holes::keep;
    /// Called with 1 at the very end; when a tile of 256 x 256 source pixels is done, and on the
    /// CPU whenever some 4 million more numbers of a tile's result are written. Little more is
    /// written once it said false.
    ProgressCallback progress;
    Statistics* statistics = nullptr; ///< filled in when not null
};

/// How a job ended. Unless done, some of its pixels may have been written all the same.
enum class Outcome {
    done,
    cancelled,     ///< Job::progress returned false
    source_failed, ///< Source::read() or read_codes() returned false
    sink_failed,   ///< Sink::write() or write_packed() returned false
    /// Nothing that could be done: a window that is empty or too large, an output out of limits, no
    /// channel, kinds or options that are not allowed; holes that cannot be filled (Job::holes). Or
    /// source, sink, mapping or progress threw, but for lack of memory.
    bad_job,
    out_of_memory,      ///< also where one of these threw for lack of it
    device_unavailable, ///< Job::device, or DDT_DEVICE in its place, names one not to be had
};

/// Read the source tile by tile, triangulate, and write every output pixel the mapping gives.
///
/// What source, sink, mapping or progress throw is Outcome::out_of_memory or bad_job. They may use
/// oneTBB themselves. `error` is that of ddt/core.h. ddt/log.h tells the device, the iterations and
/// where the time went.
///
/// Memory beside what source and sink hold:
///
///     of                              | at most
///     --------------------------------|-----------------------------------
///     40 threads or fewer             | 200 MiB, times MeshOptions::meshes
///     each further thread             | 6 MiB, times MeshOptions::meshes
///     each 65536 pixels of the source | 4 bytes
///
/// Of up to 4 channels a tile's mesh takes 3.8 to 5 MiB of it, and a thread 1.3 to 4, or up to 5.1
/// with corrections and a mapping that is not separable(). As many threads work as have room, one
/// whatever it takes, as with hundreds of channels; and as many tiles are there at once. All work
/// where there are no more channels than these; of more, or of larger results, fewer do.
///
///     mapping         | enlarges up to | channels | with corrections
///     ----------------|----------------|----------|---------------------------------------
///     separable()     | 4 times        | 12       | 4
///     separable()     | 8 times        | 10       | 4
///     not separable() | 2 times        | 8        | 4, on four fifths of the threads or more
Outcome enlarge(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                std::string* error = nullptr) noexcept;

/// Give back the memory, up to 24 MiB, that a process keeps for its next enlarge() on the CPU: of
/// two threads, if neither takes more than 12. It stays because to be given pages anew is a quarter
/// of the time of a small picture. Thread-safe.
void release_memory() noexcept;

} // namespace ddt

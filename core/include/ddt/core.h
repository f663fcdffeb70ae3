// Enlarging plain float images by data-dependent triangulation.
//
// The pixels of an image become the vertices of a triangle mesh; mesh edges are flipped until they
// run along the image's own edges; the enlarged image is read off the mesh. After Cervenansky,
// Toth, Starinsky, Ferko, Sramek, "Parallel GPU-based data-dependent triangulations", Computers &
// Graphics 2010.
//
// The result is a function of the pixels and of these options alone: it has the same bits for
// every number of threads, every instruction set, every device, every part of the output asked for.
//
// Nothing here throws; functions that can fail return false and describe why.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "ddt/costs.h"

namespace ddt {

/// How much an edge of the mesh costs, from the gradients of the guide in its two triangles.
/// Formulas and sources are in core/cost/cost-inl.h.
enum class Cost : uint8_t {
#define DDT_ENUMERATOR(name, ...) name,
    DDT_COSTS(DDT_ENUMERATOR)
#undef DDT_ENUMERATOR
};

/// Which edges flip, in which order. Sources are in core/triangulate/; names in ddt/names.h.
enum class Scheme : uint8_t {
    one_round,        ///< parallel: of the edges that gain, those that are the best of their region
    lawson,           ///< sequential: sweeps in address order, an edge that gains flips at once
    basic,            ///< the paper's: edges with the smallest addresses, accepted in rounds
    exproi,           ///< the paper's: basic with the wide region
    maxgain,          ///< the paper's: edges with the largest gains, accepted in rounds
    exproi_maxgain,   ///< the paper's: maxgain with the wide region
    exproi_n_maxgain, ///< the paper's: maxgain, the region wide for the first iterations only
    look_ahead,       ///< sequential: also flips that pay together with a second (Yu et al. 2001)
    annealing,        ///< parallel: flips that lose, at random, then one_round (Schumaker 1993)
    pixel,            ///< the starting mesh as it is (Su & Willis 2004)
};

/// Which diagonal a 2x2 cell of pixels starts with.
enum class Start : uint8_t {
    flat,     ///< the one whose ends differ less in the guide (Su & Willis 2004)
    diagonal, ///< the same in every cell, from upper left to lower right
};

/// The surface that is laid over the mesh.
enum class Surface : uint8_t {
    linear, ///< a plane a triangle
    patch,  ///< a quadratic patch a triangle; like `linear` never outside the triangle's 3 values
};

/// What a channel's numbers are.
enum class Channel : uint8_t {
    blend,   ///< a quantity: interpolated over the surface
    alpha,   ///< a quantity that no option may take out of the range of its triangle's 3 values
    nearest, ///< an identifier: copied, bit for bit, from the vertex with the largest weight
};

/// How values are read off the mesh.
struct SurfaceOptions {
    /// Implicit: a plain Surface is one without corrections.
    SurfaceOptions(Surface kind_ = Surface::patch) : kind(kind_) {}

    Surface kind;
    /// Rounds that correct the vertices so that the surface's mean over each source pixel comes
    /// back to that pixel's value; 0 to 16. More than 0 can overshoot the source's values.
    int consistency = 0;
    /// How far a corrected vertex may leave the range of its 3x3 source pixels, as a share of that
    /// range, and downwards, where none of the nine is negative, of the smallest of them if that is
    /// less; 0 or more. So it never gets negative where none is, unless `clipped`.
    float limit = 0.25f;
    /// Edges that would lose less than this by a flip are blended with their flipped state, so that
    /// the picture is nearly continuous in its input; in units of the cost, 0: none. Without
    /// `consistency` the surface still keeps to its triangle's range, with it to that of the
    /// vertices near.
    float soft = 0.0f;
    /// The output will be cut off at 0, as integers are: vertices may then get negative within the
    /// limit, and what is left above 0 is sharper for it.
    bool clipped = false;
};

/// See MeshOptions::meshes.
constexpr int most_meshes = 4;
constexpr float mesh_spread = 0.07f;

struct MeshOptions {
    Cost cost = Cost::abn;
    Scheme scheme = Scheme::one_round;
    Start start = Start::flat;
    /// A flip must gain more than this, in units of the cost. Negative: the cost's own default (see
    /// ddt/costs.h), for lawson and the paper's schemes a bare guard against rounding.
    float min_gain = -1.0f;
    /// Iterations after which flipping ends; 0 to 250. For lawson and look_ahead these are sweeps,
    /// for annealing it is the number of random iterations and the limit of those that follow.
    int max_iterations = 64;
    /// Share of each neighbour, in rows and then in columns, that is mixed into the guide before
    /// edges are sought in it; 0 to 1/4. A little keeps single pixels' noise out of the mesh.
    float blur = 0.0f;
    /// How many meshes are made and their surfaces averaged; 1 to most_meshes. The guides of
    /// several are blurred by shares from `blur` - mesh_spread to `blur` + mesh_spread, as far as
    /// allowed, in even steps. Steadier in sequences and smoother, for so many times the time and
    /// memory.
    int meshes = 1;
    int wide_iterations = 2; ///< exproi_n_maxgain: iterations with the wide region
    uint32_t seed = 1;       ///< annealing: another seed, another mesh
};

/// Pixels x0 <= x < x1, y0 <= y < y1.
struct Rect {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool empty() const { return x1 <= x0 || y1 <= y0; }
    size_t area() const { return empty() ? 0 : size_t(width()) * size_t(height()); }
};

/// Where pixels come from. Called from several threads at once.
class Source {
public:
    virtual ~Source() = default;
    /// Fill `values`, `channels` interleaved floats a pixel, and `guide`, one float a pixel, for
    /// the pixels of `r`, row by row without gaps. `r` lies within Job::window. The guide is what
    /// edges are sought in, about 0 to 1 from black to white; see core/guide for the usual one.
    /// Return false to end the work (an error the source itself keeps).
    virtual bool read(const Rect& r, float* values, float* guide) = 0;
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
};

/// One position in the source: pixel centres at integers, in units of 2^-16 pixel.
struct Position {
    int64_t x = 0, y = 0;
};

/// Which source position an output pixel shows. Called from several threads at once.
class Mapping {
public:
    virtual ~Mapping() = default;
    /// A rectangle that holds every output pixel whose position lies in the source rectangle
    /// [x0, x1) x [y0, y1) (pixel centres at integers). It may hold others too.
    virtual Rect reach(double x0, double y0, double x1, double y1) const = 0;
    /// Positions of the output pixels x0 <= x < x1 of row y; at most 2 source pixels may lie
    /// between neighbours. inside[i] = 0 marks a pixel that shows nothing of the source: it is
    /// not written.
    virtual void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const = 0;
    /// True if reach() holds exactly the pixels of its rectangle and row() is all inside.
    virtual bool separable() const { return false; }
};

/// Maps the interval [from0, from0 + from_size) onto [to0, to0 + to_size), pixel centres at half
/// integers, on both axes; positions outside `window` clamp to its outermost pixel centres.
class ResizeMapping final : public Mapping {
public:
    struct Axis {
        int from0 = 0, from_size = 1; ///< the source's display window
        int to0 = 0, to_size = 1;     ///< the output's display window
        int window0 = 0, window1 = 1; ///< the source's data window
        int out0 = 0, out1 = 1;       ///< the output pixels wanted
        /// Source position of the output pixel i, clamped, in 2^-16 pixel, by integer arithmetic.
        int64_t position(int i) const;
        /// First output pixel of [out0, out1) whose position is >= limit (a pixel coordinate).
        int first_at_or_after(int limit) const;
    };
    ResizeMapping(const Axis& x, const Axis& y) : m_x(x), m_y(y) {}
    Rect reach(double x0, double y0, double x1, double y1) const override;
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override;
    bool separable() const override { return true; }

private:
    Axis m_x, m_y;
};

/// What the work is done on. The result has the same bits on all of them.
enum class Device : uint8_t {
    /// What the environment variable DDT_DEVICE names (auto, cpu, egl, osmesa); without it a
    /// hardware GPU if there is one and the image is large enough to gain from it, else the CPU.
    automatic,
    cpu,
    egl,    ///< OpenGL through libEGL, on a GPU or, where there is none, a software renderer
    osmesa, ///< OpenGL through libOSMesa, a software renderer: for tests
};

/// Nanoseconds that the threads spent, added up, in each stage of a job on the CPU.
struct StageTimes {
    int64_t read = 0;        ///< Source::read: with its conversions and the guide
    int64_t triangulate = 0; ///< with the making of the starting mesh
    int64_t surface = 0;     ///< gradients, bends, corrections
    int64_t sample = 0;
    int64_t write = 0; ///< Sink::write: with its conversions
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
};

/// A piece of work.
struct Job {
    Rect window;                ///< the source's pixels (data window), not empty
    int channels = 1;           ///< floats a pixel, 1 or more
    std::vector<Channel> kinds; ///< one a channel; empty: all blend
    MeshOptions mesh;
    SurfaceOptions surface;
    int threads = 0; ///< 0: as many as there are cores
    /// A device that is named and cannot be had is Outcome::device_unavailable, before anything is
    /// read. A device that fails later, also for lack of memory, leaves the rest to the CPU. A
    /// process forked from one that used a GPU has none and uses the CPU, whatever is named.
    Device device = Device::automatic;
    /// Called from time to time with the share done, 0 to 1, one thread at a time; return false
    /// to cancel. May be empty.
    std::function<bool(float)> progress;
    Statistics* statistics = nullptr; ///< filled in when not null
};

enum class Outcome {
    done,
    cancelled,
    source_failed,
    sink_failed,
    bad_job,
    out_of_memory,
    device_unavailable,
};

/// Read the source tile by tile, triangulate, and write every output pixel the mapping gives.
/// Memory: a few MB a thread beside what source and sink hold. Never throws. `error`, when not
/// null, receives one line if the outcome is not `done`. With the environment variable DDT_VERBOSE
/// set, and not to 0, lines on stderr tell the device, the iterations and where the time went.
Outcome enlarge(Source& source, Sink& sink, const Mapping& mapping, const Job& job,
                std::string* error = nullptr);

/// The same from and to plain buffers: `src` is width x height x channels interleaved floats,
/// `dst` likewise for the output size; `guide` is width x height floats or null, then the mean of
/// the first up to three channels serves as it is.
Outcome enlarge(const float* src, int width, int height, int channels, const float* guide,
                float* dst, int dst_width, int dst_height, const SurfaceOptions& surface = {},
                const MeshOptions& mesh = {}, int threads = 0, std::string* error = nullptr);

} // namespace ddt

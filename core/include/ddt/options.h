// SPDX-License-Identifier: Apache-2.0
// What can be chosen: how the mesh is made, the surface laid over it, the device. Unless set, every
// option is that of the filter `ddt`. The fields that a specification such as "ddt,cost=scf" can
// set have a row each in ddt/option_table.h, which tells how to add one.
#pragma once

#include <cstdint>
#include <string>

#include "ddt/costs.h"
#include "ddt/schemes.h"

namespace ddt {

/// How much an edge of the mesh costs, from the gradients of the guide in its two triangles.
/// Formulas and sources are in core/cost/cost-inl.h.
enum class Cost : uint8_t {
#define DDT_ENUMERATOR(name, ...) name,
    DDT_COSTS(DDT_ENUMERATOR)
#undef DDT_ENUMERATOR
};

/// Which edges flip, in which order.
enum class Scheme : uint8_t {
#define DDT_ENUMERATOR(name, ...) name,
    DDT_SCHEMES(DDT_ENUMERATOR)
#undef DDT_ENUMERATOR
};

/// Which diagonal a 2x2 cell of pixels starts with.
enum class Start : uint8_t {
    flat,     ///< the one whose ends differ less in the guide (Su & Willis 2004)
    diagonal, ///< the same in every cell, from upper left to lower right
};

/// The surface that is laid over the mesh.
enum class Surface : uint8_t {
    linear, ///< one plane per triangle
    patch,  ///< one quadratic patch per triangle; like `linear` never outside the triangle's 3
            ///< values
};

/// Options that are reals and have no bound of their own are 0 to this. None may be subnormal.
constexpr float largest_real = 1e6f;

/// See SurfaceOptions::consistency.
constexpr int most_consistency = 16;

/// How values are read off the mesh.
struct SurfaceOptions {
    Surface kind = Surface::patch;
    /// Rounds that correct the vertices so that the surface's mean over each source pixel comes
    /// back to that pixel's value; 0 to most_consistency. More than 0 can overshoot the source's
    /// values. Where the output is less than twice as large they correct the less, down to nothing
    /// where it is as large (Mapping::scale()).
    int consistency = 0;
    /// How far a corrected vertex may leave the range of its 3x3 source pixels, as a share of that
    /// range, and downwards, where none of the nine is negative, of the smallest of them if that is
    /// less; 0 or more. So it never gets negative where none is, unless `clipped`. Unless
    /// that, it also keeps half of its own pixel (of a negative one all) where one of the nine is 2
    /// or more, and some of that where one is above 1: beside lights one channel alone would fall
    /// to that of a dark neighbour.
    float limit = 0.25f;
    /// Edges that would lose less than this by a flip are blended with their flipped state, so that
    /// the picture is nearly continuous in its input; in units of the cost, 0: none. Without
    /// `consistency` the surface still keeps to its triangle's range. With it Surface::linear keeps
    /// to that of the vertices near, and Surface::patch may pass that by a share of it: downwards,
    /// unless `clipped`, where none of the triangle's three is negative, to half the smallest of
    /// them at most. The default is meant for the cost abn.
    float soft = 0.4f;
    /// The output will be cut off to 0 .. 1, as integers are: vertices may then get negative within
    /// the limit, and the surface between them, and what is left above 0 is sharper for it. But
    /// where the smallest of the 3x3 source pixels is 1/64 or more they keep half of that, and
    /// below 1/64 may fall further the darker that is, by 80 times what it is less (at 0: 1.25).
    /// `fitted` ones at 0 or 1 (their group reaches it and they stand on that side of it) may leave
    /// their range by five times the limit, if they are two pixels or more within the image.
    bool clipped = false;
    /// Vertices and bends by weights that were fitted to pictures stand in place of the rounds of
    /// consistency, however many; without any, and in Surface::linear, there are none. The limit
    /// holds, see `clipped`. Bends may be up to twice the range of the four pixels round the edge.
    /// The pictures had no highlights; with some, the rounds are better (docs/quality.md).
    bool fitted = false;
};

/// See MeshOptions::max_iterations, contour, blur and meshes.
constexpr int most_iterations = 400;
constexpr float most_contour = 1000.0f;
constexpr float largest_blur = 0.25f;
constexpr int most_meshes = 4;
constexpr float mesh_spread = 0.07f;

struct MeshOptions {
    Cost cost = Cost::abn;
    Scheme scheme = Scheme::one_round;
    Start start = Start::flat;
    /// A flip must gain more than this, in units of the cost. Negative: the cost's own (see
    /// ddt/costs.h), for lawson and the paper's schemes a bare guard against rounding. The default
    /// is meant for the cost abn and Scheme::one_round; parse_filter() gives others theirs.
    float min_gain = 0.1f;
    /// Iterations after which flipping ends; 0 to most_iterations. Photographs take about 30;
    /// along straight hard edges of slopes 2:1, 3:1 flips run on from an end, a pixel an iteration,
    /// and a tile with its halo is up to 321 pixels long: 329 were the most seen. For lawson and
    /// look_ahead these are sweeps, for annealing it is the number of random iterations and the
    /// limit of those that follow; parse_filter() gives it 64.
    int max_iterations = most_iterations;
    /// Share of each neighbour, in rows and then in columns, that is mixed into the guide before
    /// edges are sought in it; 0 to largest_blur. A little keeps single pixels' noise out of the
    /// mesh.
    float blur = 0.07f;
    /// How much more than by its cost an edge is judged by the contours about it; 0 to
    /// most_contour, in units of the cost. A structure tensor of the guide, smoothed over seven
    /// pixels, tells where they run (core/guide/contour.h): the mesh gets steadier and follows them
    /// further. 0: by the cost alone. The default is meant for the cost abn and Scheme::one_round;
    /// parse_filter() gives others 0.
    float contour = 0.8f;
    /// How many meshes are made and their surfaces averaged; 1 to most_meshes. The guides of
    /// several are blurred by shares from `blur` - mesh_spread to `blur` + mesh_spread, as far as
    /// allowed, in even steps. Steadier in sequences and smoother, for so many times the time and
    /// memory.
    int meshes = 1;
    /// exproi_n_maxgain: iterations with the wide region; 1 to most_iterations.
    int wide_iterations = 2;
    uint32_t seed = 1; ///< annealing: another seed, another mesh
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

/// What becomes of pixels that are missing.
enum class Holes : uint8_t {
    keep,       ///< nothing: they are pixels as all others
    fill,       ///< those with a NaN are filled first, see Job::holes
    fill_alpha, ///< those whose alpha is 0, too
};

/// All that a specification of a filter can say.
struct FilterOptions {
    SurfaceOptions surface;
    MeshOptions mesh;
    /// Light in which values are interpolated, for hosts that convert colours; the core itself
    /// does not read it. "auto": linear, from the colour space that the image names; as the numbers
    /// are where it names none that is known, or one of data. "encoded": as the numbers are.
    /// Otherwise the name of the image's colour space.
    std::string light = "auto";
    /// What the work is done on; the result is the same everywhere. A device named here that cannot
    /// be had is a failure that says why.
    Device device = Device::automatic;
    Holes holes = Holes::keep;
};

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
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
// Functions that work on pictures and meshes are noexcept: that they failed they say by what they
// return. Others throw nothing but std::bad_alloc, and that only where it is said. `error` receives
// why something failed in one line, "ddt: ...", without line end; it is empty where there was no
// memory for the line. Where it is a pointer it may be null, and success empties the text; where it
// is a reference success leaves the text as it is. A thread must not be cancelled (pthread_cancel)
// while it works here: what is noexcept cannot be unwound, and the process would be aborted.
//
// All functions may be called from several threads at once, with different destinations.
//
// A process may fork while none of its threads is in a call here, and its child may call these
// again; with more than one thread, as far as oneTBB can, whose threads do not survive a fork.
// Forked while another thread is in a call, above all in the process's first, the child may wait
// for ever in one of its own: for a lock that the other thread had, which the child has not got
// (of the compiler's for static objects, of oneTBB's).
//
// A shared object into which this is linked must not be unloaded once it was called: threads of
// oneTBB's, and the GPU's, go on and may be within its code. Link it with -z nodelete. The CMake
// targets see to that; who links by pkg-config says it (-Wl,-z,nodelete).
#pragma once

#include <string>

#include "ddt/job.h"
#include "ddt/mapping.h"
#include "ddt/options.h"

namespace ddt {

/// enlarge() of ddt/job.h from and to plain buffers, which must not overlap: `src` is width x
/// height x channels interleaved floats, `dst` likewise for the output size, on either axis not
/// smaller (else Outcome::bad_job). `guide`: width x height floats, as Source::read() has them;
/// null: the mean of the first three channels, of fewer than three the first. `threads` and `error`
/// are those of Job and enlarge(). The defaults are the filter `ddt`; `surface` and `mesh` of
/// ddt-linear and ddt-sharp come from parse_filter() of ddt/option_table.h.
Outcome enlarge(const float* src, int width, int height, int channels, const float* guide,
                float* dst, int dst_width, int dst_height, const SurfaceOptions& surface = {},
                const MeshOptions& mesh = {}, int threads = 0,
                std::string* error = nullptr) noexcept;

} // namespace ddt

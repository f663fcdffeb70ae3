// SPDX-License-Identifier: Apache-2.0
// The cells' contour words. A cell's has half the number of the site of its upper left pixel: a tile's
// part is slot_sites / 2 words long, in rows of `stride` of which one half is used. After
// lattice.glsl.

#ifndef CONTOUR_ACCESS
#define CONTOUR_ACCESS readonly
#endif
layout(std430, binding = 2) CONTOUR_ACCESS buffer ContourWords { uint contour_words[]; };

// SPDX-License-Identifier: Apache-2.0
// Numbers that CPU and GPU compute with, each said once: a constexpr here, and a constant of the
// same name before every shader (core/gl/programs.cpp).
#pragma once

#include <cfloat>
#include <cstdint>

namespace ddt {

#define DDT_CONSTANTS(INT, FLOAT)                                                                  \
    /* 1/sqrt(x) is guessed as this less half the bits of x (base/rsqrt-inl.h). */                 \
    INT(rsqrt_magic, 0x5f3759df)                                                                   \
    /* 1/x alike. */                                                                               \
    INT(reciprocal_magic, 0x7ef311c7)                                                              \
    /* The most there is; beyond lie infinity and NaN. */                                          \
    FLOAT(largest_float, FLT_MAX)                                                                  \
                                                                                                   \
    /* No edge is longer than this in either coordinate, in pixels: a flip to a longer one is */   \
    /* not made. It keeps every vector in a signed byte. (Longest ever seen: 36.) */               \
    INT(longest_edge, 63)                                                                          \
    /* So no more triangles, 2 * 128^2, have all their vertices that near to a cell: no walk */    \
    /* round a vertex or across a cell takes more steps. Devices walk no further, should memory */ \
    /* fail them: a walk without an end stops a whole screen. */                                   \
    INT(longest_walk, 1 << 15)                                                                     \
    /* How a cell is divided: Division of lattice/site.h. */                                       \
    INT(division_down, 0)                                                                          \
    INT(division_up, 1)                                                                            \
    INT(division_crossed, 2)                                                                       \
    /* A position's bits behind the point; a pixel in its units, and these in pixels. */           \
    INT(position_bits, 16)                                                                         \
    INT(position_one, 1 << 16)                                                                     \
    FLOAT(position_unit, 0x1p-16f)                                                                 \
    /* From a triangle's corner to the one a row below it, in the order of sites. */               \
    INT(corner_stride, 1 << 16)                                                                    \
    /* Edges in a 2-region, the edge itself among them, and in one of degree 3, at most. */        \
    INT(most_in_region, 13)                                                                        \
    INT(most_in_wide_region, 28)                                                                   \
                                                                                                   \
    /* Of a guide, in units a pixel: the slope that counts as 45 degrees, and its square. */       \
    FLOAT(cost_slope, 0.2f)                                                                        \
    FLOAT(cost_slope_square, 0.04f)                                                                \
    /* The step of the usual guide. */                                                             \
    FLOAT(guide_unit, 0x1p-12f)                                                                    \
    /* The most of it, below and above zero. */                                                    \
    FLOAT(guide_limit, 1024.0f)                                                                    \
    /* What it is where alpha is 0: below all that shows. */                                       \
    FLOAT(guide_of_nothing, -0.5f)                                                                 \
    /* The gain of an edge that cannot be flipped. */                                              \
    FLOAT(no_gain, -1e30f)                                                                         \
                                                                                                   \
    /* Contours (guide/contour.h): bits of each of a word's integers. */                           \
    INT(contour_bits, 10)                                                                          \
    /* Steps of 1 that they count, whole and as a float. */                                        \
    INT(contour_steps, 500)                                                                        \
    FLOAT(contour_scale, 500.0f)                                                                   \
    /* Added before the fraction is dropped: to Nxx and Nyy 0.01 of the steps and a half, */       \
    FLOAT(contour_square_bias, 5.5f)                                                               \
    /* to Nxy half of them and a half. */                                                          \
    FLOAT(contour_product_bias, 250.5f)                                                            \
    /* The most that Nxx and Nyy get. */                                                           \
    FLOAT(contour_most, 505.0f)                                                                    \
    /* 1 / the square of the steps of direction from which it counts whole (45 of 250). */         \
    FLOAT(contour_trust, 1.0f / 2048)                                                              \
    /* The square of a slope that is noise, 0.05 a pixel, of a cell's 4 * 64 * 64 shares. */       \
    FLOAT(contour_noise, 4.0f * 64 * 64 * 0.05f * 0.05f)                                           \
    /* What a gain of 1 of two words' sums is: 4 / (2 * steps). */                                 \
    FLOAT(contour_unit, 4.0f / 1000)                                                               \
                                                                                                   \
    /* Annealing: parts of the edges, which are tried one after another; log(2); four times */     \
    /* the most that log2(1 + f), taken for a parabola, is above f: its chord */                   \
    /* between 0 and 1. */                                                                         \
    INT(annealing_parts, 8)                                                                        \
    FLOAT(natural_log_2, 0.69314718f)                                                              \
    FLOAT(log_bow, 0.34f)                                                                          \
    /* What numbers that are drawn are multiples of, and the fraction of a float in 1 .. 2. */     \
    FLOAT(draw_unit, 0x1p-24f)                                                                     \
    FLOAT(fraction_unit, 0x1p-23f)                                                                 \
                                                                                                   \
    /* Channels that are worked on together, at most: the lanes of a vec4. */                      \
    INT(group_size, 4)                                                                             \
    /* Square of the gradient below which triangles weigh nearly alike (gradient-inl.h). */        \
    FLOAT(gradient_epsilon, 0.02f * 0.02f)                                                         \
    /* How much more than by the gradients an edge is bent (gradient-inl.h). */                    \
    FLOAT(bend_strength, 1.75f)                                                                    \
    /* Weight of an edge's flipped state where a flip gains nothing: both count alike. */          \
    FLOAT(soft_share, 0.5f)                                                                        \
    /* Share of a triangle's smallest value that softness leaves where none is negative. */        \
    FLOAT(dark_share, 0.5f)                                                                        \
    /* Where what is negative will be cut off: from which pixel on neighbours keep half of it, */  \
    /* and how much further they may fall by each part that it is darker: by 1.25 at 0. */         \
    FLOAT(nearly_black, 1.0f / 64)                                                                 \
    FLOAT(black_fall, 80.0f)                                                                       \
                                                                                                   \
    /* Means over a quadrant (core/surface/consistency/consistency-inl.h) of values, bends */      \
    /* and softness, where the cell's diagonal goes through V, */                                  \
    FLOAT(through_beside, 1.0f / 16)                                                               \
    FLOAT(through_opposite, 3.0f / 16)                                                             \
    FLOAT(through_bend_diagonal, 1.0f / 8)                                                         \
    FLOAT(through_bend_near, 5.0f / 128)                                                           \
    FLOAT(through_bend_far, 1.0f / 128)                                                            \
    FLOAT(through_soft_diagonal, 3.0f / 16)                                                        \
    FLOAT(through_soft_near, 1.0f / 16)                                                            \
    FLOAT(through_soft_far, 1.0f / 32)                                                             \
    /* and where it goes across, past V. */                                                        \
    FLOAT(across_beside, 1.0f / 4)                                                                 \
    FLOAT(across_bend_near, 7.0f / 64)                                                             \
    FLOAT(across_bend_diagonal, 1.0f / 16)                                                         \
    FLOAT(across_soft_near, 7.0f / 32)                                                             \
    FLOAT(across_soft_diagonal, 3.0f / 16)

#define DDT_INT(name, value) constexpr int32_t name = value;
#define DDT_FLOAT(name, value) constexpr float name = value;
DDT_CONSTANTS(DDT_INT, DDT_FLOAT)
#undef DDT_INT
#undef DDT_FLOAT

static_assert(position_one == 1 << position_bits);

} // namespace ddt

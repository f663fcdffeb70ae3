// SPDX-License-Identifier: Apache-2.0
// The definition of annealing() of core/triangulate/schemes.h.
#pragma once

#include "core/base/constants.h"
#include "core/base/float_bits.h"
#include "core/triangulate/gain.h"
#include "core/triangulate/one_round.h"
#include "core/triangulate/schemes.h"

namespace ddt {

// GLSL twins: shaders/annealing.glsl and the programs anneal_*.comp, tin_anneal_*.comp.

/// 64 well mixed bits of a number (the finalizer of SplitMix64: Steele, Lea & Flood 2014, "Fast
/// splittable pseudorandom number generators").
inline uint64_t mixed(uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// A random number with exponential distribution, mean 1, from 32 random bits: -log of a number
/// uniform in (0, 1]. Only + - * of floats, log(1 + f) as a parabola (within 0.01), so that all
/// machines agree.
inline float exponential(uint32_t bits) {
    const float uniform = float((bits >> 8) + 1) * draw_unit;
    const uint32_t word = bits_of(uniform);
    const auto exponent = int(word >> 23) - 127;
    const float f = float(word & 0x7fffffu) * fraction_unit;
    return natural_log_2 * ((0.0f - float(exponent)) - (f + ((log_bow * f) * (1.0f - f))));
}

/// What an iteration's random numbers begin with; `seed` is mixed.
inline uint64_t annealing_salt(uint64_t seed, int iteration) {
    return mixed(seed + uint64_t(iteration));
}

/// The temperature of an iteration, from the cost's own down to 0 by a parabola.
inline float annealing_temperature(Cost cost, int iteration, int iterations) {
    const float left = float(iterations - iteration) / float(iterations);
    return (traits(cost).temperature * left) * left;
}

/// Whether the edge that this number was drawn for is of the part that is tried.
inline bool is_of_part(uint32_t drawn, uint32_t part) {
    return drawn % uint32_t(annealing_parts) == part;
}

/// Of two edges of a part: whether the other one, where it can be flipped, is selected rather than
/// m.
inline bool draws_before(int other, uint32_t other_drawn, int m, uint32_t m_drawn) {
    return other_drawn > m_drawn || (other_drawn == m_drawn && other < m);
}

/// Metropolis' u < exp(gain / t), with u = exp(-e); `seed` is mixed.
inline bool is_taken(float gain, float temperature, uint64_t seed, uint32_t drawn) {
    const float least = 0.0f - temperature * exponential(uint32_t(mixed(seed ^ drawn)));
    return gain > least;
}

template <class Mesh>
class Annealing {
public:
    Annealing(Mesh& mesh, const Criterion& criterion, uint32_t seed, Workspace& w,
              Statistics& statistics)
        : m_mesh(mesh), m_criterion(criterion), m_seed(mixed(seed)), m_w(w),
          m_statistics(statistics) {
        for (auto& part : m_part)
            part.reserve(edges_a_part(mesh.vertices()));
    }

    /// Edges that chance puts into a part, of about three a vertex, and some more.
    static constexpr size_t edges_a_part(size_t vertices) {
        return vertices * 3 / parts + vertices / 64 + 16;
    }
    /// About the bytes that this takes.
    static constexpr size_t memory(size_t sites, size_t vertices) {
        return sites * sizeof(uint32_t) + parts * edges_a_part(vertices) * sizeof(int);
    }

    /// Try about every second flippable edge once, an eighth of all edges after another.
    void iterate(int iteration, float temperature) {
        shuffle(annealing_salt(m_seed, iteration));
        for (uint32_t part = 0; part < parts; ++part) {
            select(part);
            find_gains(m_mesh, m_criterion, m_w.selected.data(), m_w.selected.size());
            m_statistics.evaluations += int64_t(m_w.selected.size());
            for (const int m : m_w.selected)
                if (is_taken(m_mesh.gain(m), temperature, m_seed, m_drawn[size_t(m)])) {
                    m_mesh.flip(m);
                    ++m_statistics.flips;
                }
        }
    }

private:
    static constexpr uint32_t parts = annealing_parts;

    /// Draw a number for every edge, and by it put the edge in one of the parts. The edge's place
    /// is taken in the image, not in the lattice, so that tiles that overlap draw the same.
    void shuffle(uint64_t salt) {
        for (auto& part : m_part)
            part.clear();
        m_mesh.each_edge([&](int m) {
            const auto drawn = uint32_t(mixed(salt ^ m_mesh.place(m, m_w.origin_x, m_w.origin_y)));
            m_drawn[size_t(m)] = drawn;
            m_part[drawn % parts].push_back(m);
        });
    }

    /// Fill m_w.selected with edges of a part that are outside each other's 2-region: the flippable
    /// ones with the largest number among those of their region.
    void select(uint32_t part) {
        m_w.selected.clear();
        for (const int m : m_part[part]) {
            if (!m_mesh.flippable(m))
                continue;
            const uint32_t own = m_drawn[size_t(m)];
            const bool beaten = m_mesh.any_of_region(m, [&](int other) {
                const uint32_t drawn = m_drawn[size_t(other)];
                return is_of_part(drawn, part) && draws_before(other, drawn, m, own) &&
                       m_mesh.flippable(other);
            });
            if (!beaten)
                m_w.selected.push_back(m);
        }
    }

    Mesh& m_mesh;
    const Criterion m_criterion;
    const uint64_t m_seed;
    std::vector<uint32_t> m_drawn = std::vector<uint32_t>(m_mesh.size()); ///< a site
    std::vector<int> m_part[parts];                                       ///< its edges
    Workspace& m_w;
    Statistics& m_statistics;
};

template <class Mesh>
void annealing(Mesh& mesh, const Criterion& criterion, float min_gain, int iterations,
               uint32_t seed, Workspace& w, Statistics& statistics) {
    // The random iterations take nearly all the time; only they are reported.
    const auto settle = [&] {
        ProgressCallback silent;
        w.progress.swap(silent);
        one_round(mesh, criterion, min_gain, iterations, w, statistics);
        w.progress.swap(silent);
    };
    settle();
    Annealing<Mesh> scheme(mesh, criterion, seed, w, statistics);
    for (int i = 0; i < iterations; ++i) {
        scheme.iterate(i, annealing_temperature(criterion.cost, i, iterations));
        if (!w.go_on(size_t(iterations - i), size_t(iterations)))
            return;
    }
    settle();
}

} // namespace ddt

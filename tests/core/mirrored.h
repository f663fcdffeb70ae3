// SPDX-License-Identifier: Apache-2.0
// A mapping whose rows or columns run backwards.
#pragma once

#include "ddt/mapping.h"

namespace ddt::test {

/// Another mapping's picture, mirrored along an axis or both.
class Mirrored final : public Mapping {
public:
    Mirrored(const Mapping& mapping, const Rect& out, bool x, bool y)
        : m_mapping(mapping), m_out(out), m_x(x), m_y(y) {}
    Rect reach(double x0, double y0, double x1, double y1) const override {
        const Rect r = m_mapping.reach(x0, y0, x1, y1);
        return {m_x ? m_out.x1 - r.x1 : r.x0, m_y ? m_out.y1 - r.y1 : r.y0,
                m_x ? m_out.x1 - r.x0 : r.x1, m_y ? m_out.y1 - r.y0 : r.y1};
    }
    void row(int y, int x0, int x1, Position* positions, uint8_t* inside) const override {
        for (int x = x0; x < x1; ++x, ++positions, ++inside) {
            const int from = m_x ? m_out.x1 - 1 - x : x;
            m_mapping.row(m_y ? m_out.y1 - 1 - y : y, from, from + 1, positions, inside);
        }
    }
    bool separable() const override { return true; }

private:
    const Mapping& m_mapping;
    Rect m_out;
    bool m_x, m_y;
};

} // namespace ddt::test

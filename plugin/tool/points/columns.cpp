// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/points/columns.h"

#include <algorithm>
#include <cmath>

#include "plugin/tool/points/point_file.h"

namespace ddt::tool {

std::vector<const Column*> all_columns(const PointFile& points) {
    std::vector<const Column*> columns;
    for (const Column& column : points.columns)
        columns.push_back(&column);
    return columns;
}

std::vector<const Column*> usual_columns(const PointFile& points) {
    if (points.find("red") && points.find("green") && points.find("blue")) {
        std::vector<const Column*> columns;
        for (const auto& [name, letter] : colour_columns)
            if (const Column* column = points.find(name))
                columns.push_back(column);
        return columns;
    }
    if (const Column* z = points.find("z"))
        return {z};
    return all_columns(points);
}

namespace {

/// The range of the numbers that are finite, as what makes 0 to 1 of them.
class Range {
public:
    template <class Numbers>
    explicit Range(const Numbers& numbers) {
        double high = -INFINITY;
        for (const double v : numbers)
            if (std::isfinite(v)) {
                m_low = std::min(m_low, v);
                high = std::max(high, v);
            }
        m_scale = high > m_low ? 1 / (high - m_low) : 0;
    }
    double share(double v) const { return (v - m_low) * m_scale; }

private:
    double m_low = INFINITY, m_scale = 0;
};

/// As floats, whose sums and quotients are finite.
std::vector<double> floats_of(const Column& column) {
    std::vector<double> values;
    values.reserve(column.values.size());
    for (const double v : column.values)
        values.push_back(double(float(v)));
    return values;
}

} // namespace

std::vector<float> guide_of(const PointFile& points, const std::vector<const Column*>& columns) {
    std::vector<const Column*> parts;
    for (const Column* column : columns)
        if (!column->is_alpha())
            parts.push_back(column);
    if (parts.empty())
        parts = columns;
    // Up to three are one quantity's, a colour or a vector. More are not.
    const bool unlike = parts.size() > 3;
    std::vector<double> sum(points.mesh.x.size(), 0);
    for (const Column* column : parts) {
        const std::vector<double> values = floats_of(*column);
        const Range range(values);
        for (size_t i = 0; i < sum.size(); ++i)
            sum[i] += unlike ? range.share(values[i]) : values[i];
    }
    const Range range(sum);
    std::vector<float> guide(sum.size(), 0.0f);
    for (size_t i = 0; i < sum.size(); ++i)
        if (std::isfinite(sum[i]))
            guide[i] = float(range.share(sum[i]));
    return guide;
}

} // namespace ddt::tool

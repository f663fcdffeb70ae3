// SPDX-License-Identifier: Apache-2.0
#include "paper/fig13.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>

#include "core/base/float_mode.h"
#include "core/triangulate/triangulate.h"
#include "ddt/names.h"
#include "growth.h"
#include "paper/subject.h"
#include "paper/table.h"

namespace paper {

namespace {

/// Rows of the folder's images beside and below one another, repeated as often as needed.
class Mosaic {
public:
    explicit Mosaic(const std::string& folder) {
        each_subject(folder, 1, Reduce::bilinear, [&](const Subject& s) {
            // All cut to one size, the first's or smaller.
            if (m_tiles.empty()) {
                m_width = s.width();
                m_height = s.height();
            }
            m_width = std::min(m_width, s.width());
            m_height = std::min(m_height, s.height());
            m_tiles.push_back(luma(s.original));
        });
    }
    bool empty() const { return m_tiles.empty(); }

    std::vector<float> guide(int width, int height) const {
        std::vector<float> guide;
        guide.reserve(size_t(width) * size_t(height));
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                const size_t tile = size_t(x / m_width + y / m_height * 5) % m_tiles.size();
                guide.push_back(
                    float(std::round(m_tiles[tile].at(x % m_width, y % m_height) / 255 * 4096)) /
                    4096.0f);
            }
        return guide;
    }

private:
    int m_width = 0, m_height = 0;
    std::vector<metrics::Plane> m_tiles;
};

double seconds(const std::vector<float>& guide, int width, int height, const ddt::MeshOptions& o) {
    const ddt::DenormalsAreZero as_on_gpus;
    ddt::Lattice lattice;
    ddt::Workspace workspace;
    ddt::Statistics statistics;
    const std::clock_t begin = std::clock();
    ddt::start(lattice, width, height, guide.data(), o);
    triangulate(lattice, o, workspace, statistics);
    return double(std::clock() - begin) / CLOCKS_PER_SEC;
}

} // namespace

bool fig13(const std::string& folder, double megapixels, const std::string& csv_folder) {
    const Mosaic mosaic(folder);
    if (mosaic.empty()) {
        std::fprintf(stderr, "paper_tables: no image in \"%s\"\n", folder.c_str());
        return false;
    }
    std::vector<ddt::MeshOptions> schemes;
    for (const ddt::MeshOptions& o : all_schemes())
        // Annealing takes a time of its own choice.
        if (o.scheme != ddt::Scheme::annealing && o.scheme != ddt::Scheme::pixel)
            schemes.push_back(o);
    std::vector<std::string> columns{"megapixels"};
    for (const ddt::MeshOptions& o : schemes)
        columns.push_back(label(o) + " s");
    Table table("fig13", columns);
    std::vector<std::vector<std::pair<double, double>>> points(schemes.size());
    for (double size = 0.125; size <= megapixels * 1.0001; size *= 2) {
        const int height = int(std::sqrt(size * 1e6 / 1.5)), width = height * 3 / 2;
        const auto guide = mosaic.guide(width, height);
        std::vector<std::string> cells{number(double(guide.size()) / 1e6, 3)};
        for (size_t i = 0; i < schemes.size(); ++i) {
            const double time = seconds(guide, width, height, schemes[i]);
            points[i].push_back({double(guide.size()), time});
            cells.push_back(number(time, 3));
        }
        table.add(cells);
    }
    std::vector<std::string> cells{"exponent"};
    for (const auto& p : points)
        cells.push_back(bench::exponent_text(p));
    table.add(cells);
    return table.show(csv_folder);
}

} // namespace paper

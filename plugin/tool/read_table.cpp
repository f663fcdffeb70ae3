// SPDX-License-Identifier: Apache-2.0
// Points as text: comma-separated values, XYZ files with a header.
#include <algorithm>
#include <cmath>

#include <OpenImageIO/strutil.h>

#include "plugin/message/byte_order_mark.h"
#include "plugin/message/format.h"
#include "plugin/tool/point_file.h"

namespace ddt::tool {

namespace {

/// The cells of a line.
std::vector<std::string> split(const std::string& line) {
    const bool separated = line.find_first_of(",;") != std::string::npos;
    std::vector<std::string> cells;
    if (separated) {
        for (const std::string& cell :
             OIIO::Strutil::splits(line, line.find(',') != std::string::npos ? "," : ";"))
            cells.emplace_back(OIIO::Strutil::strip(cell, " \t\"'"));
    } else {
        cells = OIIO::Strutil::splits(line); // at blanks
    }
    return cells;
}

/// Whether the columns hold 8-bit numbers: whole ones from 0 to 255 (and NaNs), some above 1.
bool are_bytes(const std::vector<Column*>& columns) {
    bool above_one = false;
    for (const Column* column : columns)
        for (const double v : column->values) {
            if (!std::isnan(v) && !(v >= 0 && v <= 255 && v == std::floor(v)))
                return false;
            above_one |= v > 1;
        }
    return above_one;
}

void take_as_bytes(const std::vector<Column*>& columns) {
    for (Column* column : columns) {
        column->type = "uchar";
        column->scale = 255;
        for (auto& v : column->values)
            v /= column->scale;
    }
}

/// Text has no types: colours that can only be meant as 8 bits are such. Alpha is by itself, as
/// it is often a share beside colours that are bytes.
void find_bytes(PointFile& points) {
    std::vector<Column*> colours, alphas;
    for (Column& column : points.columns) {
        if (column.name == "red" || column.name == "green" || column.name == "blue")
            colours.push_back(&column);
        if (column.name == "alpha")
            alphas.push_back(&column);
    }
    for (const auto& columns : {colours, alphas})
        if (are_bytes(columns))
            take_as_bytes(columns);
}

} // namespace

bool read_table(const std::string& text, PointFile& points, std::string& error) {
    points = {};
    std::vector<int> place; ///< of each column: -1 x, -2 y, else an index
    size_t number = 0;
    for (size_t at = begin_of_text(text); at < text.size(); ++number) {
        const size_t end = std::min(text.find('\n', at), text.size());
        std::string line(OIIO::Strutil::strip(text.substr(at, end - at)));
        at = end + 1;
        if (!line.empty() && line[0] == '#')
            line = place.empty() ? std::string(OIIO::Strutil::strip(line.substr(1))) : "";
        if (line.empty())
            continue;
        const std::vector<std::string> cells = split(line);
        if (place.empty()) {
            for (const std::string& cell : cells) {
                const std::string name = OIIO::Strutil::lower(cell);
                if (name == "x" || name == "y") {
                    place.push_back(name == "x" ? -1 : -2);
                    continue;
                }
                place.push_back(int(points.columns.size()));
                points.columns.push_back({name, "float", 1, {}});
            }
            const auto axes = [&](int axis) {
                return std::count(place.begin(), place.end(), axis);
            };
            if (axes(-1) != 1 || axes(-2) != 1) {
                error = format("line {}: the first line must name the columns, x and y among them",
                               number + 1);
                return false;
            }
            continue;
        }
        if (cells.size() != place.size()) {
            error =
                format("line {} has {} columns, not {}", number + 1, cells.size(), place.size());
            return false;
        }
        for (size_t k = 0; k < cells.size(); ++k) {
            char* parsed = nullptr;
            const double v =
                cells[k].empty() ? 0 : OIIO::Strutil::strtod(cells[k].c_str(), &parsed);
            if (cells[k].empty() || *parsed) {
                error = format("line {}: \"{}\" is no number", number + 1, cells[k]);
                return false;
            }
            if (place[k] < 0 && !std::isfinite(v)) {
                error = format("line {}: a position that is not finite", number + 1);
                return false;
            }
            if (place[k] == -1)
                points.mesh.x.push_back(v);
            else if (place[k] == -2)
                points.mesh.y.push_back(v);
            else
                points.columns[size_t(place[k])].values.push_back(v);
        }
    }
    if (points.mesh.x.empty())
        error = "there are no points";
    find_bytes(points);
    return !points.mesh.x.empty();
}

} // namespace ddt::tool

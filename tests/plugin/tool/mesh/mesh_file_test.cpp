// SPDX-License-Identifier: Apache-2.0
// Every kind of mesh file is read back and its triangles checked.
#include "plugin/tool/mesh/mesh_file.h"
#include "tests/temporary.h"

#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <regex>
#include <sstream>

#include <unistd.h>

#include <gtest/gtest.h>

namespace ddt::tool {
namespace {

/// What a file says, in its own coordinates.
struct Vertex {
    double x = 0, y = 0, z = 0;
    int red = 0, green = 0, blue = 0, alpha = 255;
};
struct Contents {
    std::vector<Vertex> vertices;
    std::vector<std::array<size_t, 3>> triangles;
};

double area(const Vertex& a, const Vertex& b, const Vertex& c) {
    return ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2;
}

Contents read_obj(const std::string& path) {
    Contents contents;
    std::istringstream lines(text_in(path));
    for (std::string line; std::getline(lines, line);) {
        std::istringstream in(line);
        std::string kind;
        in >> kind;
        if (kind == "v") {
            Vertex v;
            double r = 0, g = 0, b = 0;
            in >> v.x >> v.y >> v.z >> r >> g >> b;
            v.red = int(std::lround(r * 255));
            v.green = int(std::lround(g * 255));
            v.blue = int(std::lround(b * 255));
            contents.vertices.push_back(v);
        } else if (kind == "f") {
            size_t a = 0, b = 0, c = 0;
            in >> a >> b >> c;
            contents.triangles.push_back({a - 1, b - 1, c - 1});
        }
        EXPECT_FALSE(in.fail()) << line;
    }
    return contents;
}

Contents read_ply(const std::string& path) {
    const std::string text = text_in(path);
    const size_t end = text.find("end_header\n");
    const std::string header = text.substr(0, end);
    EXPECT_EQ(header.rfind("ply\nformat binary_little_endian 1.0\n", 0), 0u);
    const auto count = [&](const char* element) {
        const size_t at = header.find(element);
        EXPECT_NE(at, std::string::npos);
        return size_t(std::atoi(header.c_str() + at + std::strlen(element)));
    };
    const bool alpha = header.find("property uchar alpha") != std::string::npos;
    const char* at = text.data() + end + std::strlen("end_header\n");
    const auto take = [&](auto& value) {
        std::memcpy(&value, at, sizeof value);
        at += sizeof value;
    };
    Contents contents;
    contents.vertices.resize(count("element vertex "));
    for (Vertex& v : contents.vertices) {
        float position[3];
        take(position);
        v.x = double(position[0]);
        v.y = double(position[1]);
        v.z = double(position[2]);
        unsigned char colour[4] = {0, 0, 0, 255};
        for (int k = 0; k < (alpha ? 4 : 3); ++k)
            take(colour[k]);
        v.red = colour[0];
        v.green = colour[1];
        v.blue = colour[2];
        v.alpha = colour[3];
    }
    contents.triangles.resize(count("element face "));
    for (auto& t : contents.triangles) {
        unsigned char corners = 0;
        take(corners);
        EXPECT_EQ(corners, 3);
        for (size_t& v : t) {
            int32_t index = 0;
            take(index);
            v = size_t(index);
        }
    }
    EXPECT_EQ(at, text.data() + text.size());
    return contents;
}

struct SvgTriangle {
    Vertex corner[3];
    std::string fill;
};

std::vector<SvgTriangle> read_svg(const std::string& path) {
    const std::string text = text_in(path);
    EXPECT_NE(text.find("</svg>"), std::string::npos);
    const std::regex path_element("<path(?: fill=\"([^\"]*)\")?(?: fill-opacity=\"[^\"]*\")? "
                                  "d=\"M(\\d+) (\\d+)L(\\d+) (\\d+)L(\\d+) (\\d+)Z\"/>");
    std::vector<SvgTriangle> triangles;
    for (std::sregex_iterator i(text.begin(), text.end(), path_element), none; i != none; ++i) {
        SvgTriangle t;
        t.fill = (*i)[1];
        for (size_t k = 0; k < 3; ++k) {
            t.corner[k].x = std::stod((*i)[2 + 2 * k]);
            t.corner[k].y = std::stod((*i)[3 + 2 * k]);
        }
        triangles.push_back(t);
    }
    return triangles;
}

class MeshFile : public testing::Test {
protected:
    static constexpr int w = 17, h = 12;

    MeshFile() {
        m_picture.width = w;
        m_picture.height = h;
        for (int i = 0; i < w * h; ++i) {
            // Some structure, so that edges flip.
            const int x = i % w, y = i / w;
            const float v = 2 * x > y + 9 ? 0.8f : 0.1f;
            m_picture.colours.push_back({v, float(x) / w, float(y) / h, 0.5f});
            m_picture.guide.push_back(v);
            m_picture.heights.push_back(1000.0f * v + 0.123456f * float(x));
        }
        EXPECT_TRUE(build_mesh(m_picture.guide.data(), w, h, {}, m_mesh));
    }

    std::string write(const char* extension, const MeshStyle& style = {}) {
        const std::string path = temporary(std::string("mesh_file_test") + extension);
        Failure failure;
        float last = 0;
        const auto progress = [&](float share) {
            EXPECT_GE(share, last);
            EXPECT_LE(share, 1.0f);
            last = share;
            return true;
        };
        EXPECT_TRUE(write_mesh(path, m_mesh, m_picture, style, progress, failure)) << failure.why;
        return path;
    }

    void check(const Contents& contents, double height) const {
        ASSERT_EQ(contents.vertices.size(), size_t(w * h));
        ASSERT_EQ(contents.triangles.size(), 2u * (w - 1) * (h - 1));
        for (size_t i = 0; i < contents.vertices.size(); ++i) {
            const Vertex& v = contents.vertices[i];
            const Colour& c = m_picture.colours[i];
            EXPECT_EQ(v.x, double(i % w));
            EXPECT_EQ(v.y, double(h - 1 - int(i) / w));
            EXPECT_EQ(float(v.z), float(double(m_picture.heights[i]) * height)) << i;
            EXPECT_EQ(v.red, byte_of(c.red));
            EXPECT_EQ(v.green, byte_of(c.green));
            EXPECT_EQ(v.blue, byte_of(c.blue));
        }
        for (const auto& t : contents.triangles)
            EXPECT_EQ(area(contents.vertices.at(t[0]), contents.vertices.at(t[1]),
                           contents.vertices.at(t[2])),
                      0.5);
    }

    Mesh m_mesh;
    Picture m_picture;
};

TEST_F(MeshFile, Obj) {
    check(read_obj(write(".obj")), 0);
    MeshStyle style;
    style.height = 25;
    check(read_obj(write(".OBJ", style)), 25);
}

TEST_F(MeshFile, Ply) {
    check(read_ply(write(".ply")), 0);
    m_picture.has_alpha = true;
    MeshStyle style;
    style.height = -3;
    const Contents contents = read_ply(write(".ply", style));
    check(contents, -3);
    for (const Vertex& v : contents.vertices)
        EXPECT_EQ(v.alpha, 128);
}

TEST_F(MeshFile, HeightsThatAreNotFiniteAreNone) {
    const float infinity = std::numeric_limits<float>::infinity();
    m_picture.heights[0] = std::nanf("");
    m_picture.heights[1] = -infinity;
    m_picture.heights[2] = std::numeric_limits<float>::max();
    MeshStyle style;
    style.height = 25;
    for (const Contents& contents :
         {read_obj(write(".obj", style)), read_ply(write(".ply", style))}) {
        for (size_t i = 0; i < 3; ++i)
            EXPECT_EQ(contents.vertices[i].z, 0) << i;
        EXPECT_NE(contents.vertices[3].z, 0);
    }
    m_picture.heights.clear();
    for (const Vertex& v : read_ply(write(".ply", style)).vertices)
        EXPECT_EQ(v.z, 0);
}

TEST_F(MeshFile, SvgInAllFills) {
    for (const Fill fill : {Fill::flat, Fill::gradient, Fill::none}) {
        MeshStyle style;
        style.fill = fill;
        style.lines = fill == Fill::none ? 0.1 : 0;
        const auto triangles = read_svg(write(".svg", style));
        ASSERT_EQ(triangles.size(), 2u * (w - 1) * (h - 1));
        for (const SvgTriangle& t : triangles) {
            EXPECT_EQ(area(t.corner[0], t.corner[1], t.corner[2]), 0.5);
            EXPECT_EQ(t.fill.empty(), fill == Fill::none);
        }
    }
}

TEST_F(MeshFile, SvgFlatIsTheMeanOfTheCorners) {
    MeshStyle style;
    style.fill = Fill::flat;
    for (const SvgTriangle& t : read_svg(write(".svg", style))) {
        double mean[3] = {};
        for (const Vertex& v : t.corner) {
            const Colour& c = m_picture.colours[size_t(v.y) * w + size_t(v.x)];
            mean[0] += double(c.red) / 3;
            mean[1] += double(c.green) / 3;
            mean[2] += double(c.blue) / 3;
        }
        unsigned r = 0, g = 0, b = 0;
        ASSERT_EQ(std::sscanf(t.fill.c_str(), "#%2x%2x%2x", &r, &g, &b), 3) << t.fill;
        EXPECT_NEAR(r, mean[0] * 255, 0.51);
        EXPECT_NEAR(g, mean[1] * 255, 0.51);
        EXPECT_NEAR(b, mean[2] * 255, 0.51);
    }
}

TEST_F(MeshFile, SvgGradientShowsAPlaneOfGreyExactly) {
    for (size_t i = 0; i < m_picture.colours.size(); ++i) {
        const float v = 0.02f * float(i % w) + 0.03f * float(i / w);
        m_picture.colours[i] = {v, v, v, 1};
    }
    const std::string text = text_in(write(".svg"));
    const std::regex gradient("x1=\"([^\"]*)\" y1=\"([^\"]*)\" x2=\"([^\"]*)\" y2=\"([^\"]*)\">"
                              "<stop stop-color=\"#(..)[^\"]*\"/>"
                              "<stop offset=\"1\" stop-color=\"#(..)");
    int found = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), gradient), none; i != none;
         ++i, ++found) {
        const auto plane = [&](size_t k) {
            return 0.02 * std::stod((*i)[k]) + 0.03 * std::stod((*i)[k + 1]);
        };
        EXPECT_NEAR(std::stoi((*i)[5], nullptr, 16), plane(1) * 255, 0.6);
        EXPECT_NEAR(std::stoi((*i)[6], nullptr, 16), plane(3) * 255, 0.6);
    }
    EXPECT_EQ(found, 2 * (w - 1) * (h - 1));
}

TEST_F(MeshFile, SvgIsFlatWhereNothingChangesVisibly) {
    for (size_t i = 0; i < m_picture.colours.size(); ++i) {
        const float v = i % 3 ? 0.0f : 2e-8f;
        m_picture.colours[i] = {v, v, v, 1};
    }
    const std::string path = write(".svg"), text = text_in(path);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("linearGradient"), std::string::npos);
    const auto triangles = read_svg(path);
    ASSERT_EQ(triangles.size(), 2u * (w - 1) * (h - 1));
    for (const SvgTriangle& t : triangles)
        EXPECT_EQ(t.fill, "#000000");
}

TEST_F(MeshFile, SvgGradientsAreWhereTheyShouldBeInWidePictures) {
    m_picture = {};
    m_picture.width = 1206;
    m_picture.height = 4;
    const auto shade = [](double x, double y) { return 0.05 * (x - 1190) + 0.03 * y; };
    for (int i = 0; i < m_picture.width * m_picture.height; ++i) {
        const int x = i % m_picture.width, y = i / m_picture.width;
        const auto v = float(x < 1190 ? 0 : shade(x, y));
        m_picture.colours.push_back({v, v, v, 1});
        m_picture.guide.push_back(v);
    }
    ASSERT_TRUE(build_mesh(m_picture.guide.data(), m_picture.width, m_picture.height, {}, m_mesh));
    const std::string text = text_in(write(".svg"));
    const std::regex gradient("x1=\"(1[^\"]*)\" y1=\"([^\"]*)\"[^>]*><stop stop-color=\"#(..)");
    int found = 0;
    for (std::sregex_iterator i(text.begin(), text.end(), gradient), none; i != none; ++i) {
        const double x = std::stod((*i)[1]), y = std::stod((*i)[2]);
        if (x < 1192)
            continue;
        EXPECT_NEAR(std::stoi((*i)[3], nullptr, 16), shade(x, y) * 255, 0.6);
        ++found;
    }
    EXPECT_GT(found, 60);
}

TEST_F(MeshFile, WhatCannotBeWrittenIsAnErrorThatNamesTheFile) {
    const auto progress = [](float) { return true; };
    Failure failure;
    EXPECT_FALSE(write_mesh("/no/such/folder/a.ply", m_mesh, m_picture, {}, progress, failure));
    EXPECT_NE(failure.why.find("/no/such/folder/a.ply"), std::string::npos) << failure.why;
    EXPECT_FALSE(write_mesh("a.stl", m_mesh, m_picture, {}, progress, failure));
    EXPECT_NE(failure.why.find(".svg, .ply or .obj"), std::string::npos) << failure.why;

    // A disk without room.
    const std::string full = temporary("mesh_file_test_full.obj");
    std::remove(full.c_str());
    ASSERT_EQ(symlink("/dev/full", full.c_str()), 0);
    EXPECT_FALSE(write_mesh(full, m_mesh, m_picture, {}, progress, failure));
    EXPECT_NE(failure.why.find("No space left"), std::string::npos) << failure.why;
    EXPECT_EQ(failure.code, exit_resources);
}

} // namespace
} // namespace ddt::tool

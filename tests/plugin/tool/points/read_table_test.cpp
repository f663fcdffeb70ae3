// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "plugin/tool/points/point_file.h"

namespace ddt::tool {
namespace {

std::string table_error(const std::string& text) {
    PointFile points;
    std::string error;
    EXPECT_FALSE(read_table(text, points, error));
    return error;
}

TEST(PointTable, SeparatorsAndComments) {
    for (const char* text :
         {"x,y,z\n1,2,3\n4,5,6\n", "//X Y Z\n1 2 3\n//4 4 4\n4 5 6\n", "x,y,z,\n1,2,3,\n4,5,6,\n",
          "x;y;z;;\r\n1;2;3; ;\r\n4;5;6;;\r\n", "# X Y Z\n1 2 3\n\n# more\n4\t5  6\n",
          "x;y;z\r\n1;2;3\r\n4;5;6", "x,y,z\r1,2,3\r4,5,6\r",
          "# of 2010, by hand; more\n#\nx,y,z\n1,2,3\n#\n4,5,6\n",
          "\"z\", \"x\",\"y\"\n3, 1, 2\n6,4,5\n", "\xEF\xBB\xBFx,y,z\n1,2,3\n4,5,6\n"}) {
        PointFile points;
        std::string error;
        ASSERT_TRUE(read_table(text, points, error)) << error;
        EXPECT_EQ(points.mesh.x, (std::vector<double>{1, 4}));
        EXPECT_EQ(points.mesh.y, (std::vector<double>{2, 5}));
        ASSERT_EQ(points.columns.size(), 1u);
        EXPECT_EQ(points.columns[0].name, "z");
        EXPECT_EQ(points.columns[0].values, (std::vector<double>{3, 6}));
    }
}

TEST(PointTable, EmptyCellsAreNoNumbers) {
    PointFile points;
    std::string error;
    ASSERT_TRUE(read_table("x,y,z,,red,green,blue,\n9,1,,7,255,0,0,\n5,6,7,,,,,\n", points, error))
        << error;
    EXPECT_EQ(points.mesh.x, (std::vector<double>{9, 5}));
    ASSERT_EQ(points.columns.size(), 5u); // a column of numbers without a name is one
    EXPECT_TRUE(std::isnan(points.columns[0].values[0]));
    EXPECT_EQ(points.columns[0].values[1], 7);
    EXPECT_EQ(points.columns[1].values[0], 7);
    EXPECT_EQ(points.columns[2].scale, 255);
    for (size_t k = 1; k < 5; ++k)
        EXPECT_TRUE(std::isnan(points.columns[k].values[1])) << k;
    EXPECT_EQ(table_error("x,y,z\n,1,2\n"), "line 2: \"\" is no number");
    EXPECT_EQ(table_error("x,y,z\n1,2,3,\n"), "line 2: there are 4 columns, not 3");
}

TEST(PointTable, SaysWhichLineIsWrong) {
    EXPECT_EQ(table_error("1,2,3\n"),
              "line 1: the first line must name the columns, x and y among them");
    EXPECT_EQ(table_error("x,y,z\n1,2,3\n1,2\n"), "line 3: there are 2 columns, not 3");
    EXPECT_EQ(table_error("x,y,z\n1,2,three\n"), "line 2: \"three\" is no number");
    EXPECT_EQ(table_error(std::string("x,y,z\n1,2,3\0 4\n", 14)).substr(0, 8), "line 2: ");
    EXPECT_EQ(table_error("x;y;z\n0,5;1;2\n"), "line 2: \"0,5\" is no number");
    EXPECT_EQ(table_error("# a,b\n1,2,3\n"),
              "line 2: the first line must name the columns, x and y among them");
    EXPECT_EQ(table_error("x,y,z\n1,2,3\n\n1,nan,3\n"), "line 4: a position that is not finite");
    EXPECT_EQ(table_error("x,y,z\ninf,2,3\n"), "line 2: a position that is not finite");
    EXPECT_EQ(table_error("x,y,z\n"), "there are no points");
    EXPECT_EQ(table_error(""), "there are no points");
}

TEST(PointTable, WholeNumberColoursAreBytes) {
    PointFile points;
    std::string error;
    const auto read = [&](const std::string& text) {
        EXPECT_TRUE(read_table("x,y,red,green,blue,alpha\n" + text, points, error)) << error;
    };
    read("0,0,255,0,1,1\n1,0,51,0,nan,0.5\n");
    EXPECT_EQ(points.find("red")->values, (std::vector<double>{1, 0.2}));
    EXPECT_EQ(points.find("blue")->values[0], 1.0 / 255);
    EXPECT_EQ(points.find("blue")->scale, 255);
    EXPECT_EQ(points.find("alpha")->values, (std::vector<double>{1, 0.5}));
    read("0,0,255,0,0,255\n1,0,51,0,0,51\n");
    EXPECT_EQ(points.find("alpha")->values, (std::vector<double>{1, 0.2}));
    for (const char* other :
         {"0,0,1,0,1,1\n", "0,0,2,0.5,0,1\n", "0,0,256,0,0,1\n", "0,0,-1,2,0,1\n"}) {
        read(other);
        for (const char* name : {"red", "green", "blue", "alpha"})
            EXPECT_EQ(points.find(name)->scale, 1) << other << name;
    }
}

TEST(PointTable, ColoursMayBeCalledByTheirLetters) {
    const auto names = [](const std::string& line) {
        PointFile points;
        std::string error;
        const auto columns = std::count(line.begin(), line.end(), ',');
        std::string numbers = "255";
        for (int i = 0; i < columns; ++i)
            numbers += ",255";
        EXPECT_TRUE(read_table(line + "\n" + numbers, points, error)) << error;
        std::string all;
        for (const Column& column : points.columns)
            all += column.name + (column.scale == 255 ? "! " : " ");
        return all;
    };
    EXPECT_EQ(names("X,Y,R,G,B"), "red! green! blue! ");
    EXPECT_EQ(names("a,b,g,r,y,x"), "alpha! blue! green! red! ");
    EXPECT_EQ(names("x,y,Red,GREEN,blue,Alpha"), "red! green! blue! alpha! ");
    EXPECT_EQ(names("x,y,A,z"), "alpha! z ");
    EXPECT_EQ(names("x,y,A,alpha"), "A alpha! ");
    // Letters that stand for something else, and names that mean nothing.
    EXPECT_EQ(names("x,y,R,Theta,a"), "R Theta a ");
    EXPECT_EQ(names("x,y,r,g,b,red"), "r g b red! ");
}

} // namespace
} // namespace ddt::tool

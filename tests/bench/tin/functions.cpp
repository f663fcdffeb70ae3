// SPDX-License-Identifier: Apache-2.0
#include "functions.h"

#include <cmath>

namespace ddt::bench {

namespace {

double square(double v) {
    return v * v;
}

} // namespace

const std::vector<TestFunction>& test_functions() {
    static const std::vector<TestFunction> functions{
        {"exponential", false,
         [](double x, double y) {
             return 0.75 * std::exp(-(square(9 * x - 2) + square(9 * y - 2)) / 4) +
                    0.75 * std::exp(-square(9 * x + 1) / 49 - (9 * y + 1) / 10) +
                    0.5 * std::exp(-(square(9 * x - 7) + square(9 * y - 3)) / 4) -
                    0.2 * std::exp(-square(9 * x - 4) - square(9 * y - 7));
         }},
        {"cliff", true, [](double x, double y) { return (std::tanh(9 * y - 9 * x) + 1) / 9; }},
        {"saddle", false,
         [](double x, double y) {
             return (1.25 + std::cos(5.4 * y)) / (6 * (1 + square(3 * x - 1)));
         }},
        {"gentle", false,
         [](double x, double y) {
             return std::exp(-81.0 / 16 * (square(x - 0.5) + square(y - 0.5))) / 3;
         }},
        {"steep", false,
         [](double x, double y) {
             return std::exp(-81.0 / 4 * (square(x - 0.5) + square(y - 0.5))) / 3;
         }},
        {"sphere", false,
         [](double x, double y) {
             return std::sqrt(64 - 81 * (square(x - 0.5) + square(y - 0.5))) / 9 - 0.5;
         }},
        {"step", true,
         [](double x, double y) { return std::tanh(40 * (0.4 * x + y - 0.7)) / 2 + 0.5; }},
        {"ridge", true,
         [](double x, double y) { return std::exp(-200 * square(0.8 * x - 0.6 * y - 0.1)); }},
        {"curved cliff", true,
         [](double x, double y) { return std::tanh(20 * (y - square(x) - 0.1)) / 2 + 0.5; }},
    };
    return functions;
}

} // namespace ddt::bench

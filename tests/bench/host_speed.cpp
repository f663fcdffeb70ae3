// SPDX-License-Identifier: Apache-2.0
// The core's own time for a picture, and that of the OpenFX effect in the tests' small host, in
// milliseconds of processor time of all threads: the best of so many rounds, taken in turns.
// tests/bench/hosts calls it.
//
//     host_speed FLOATS WIDTH HEIGHT SCALE ROUNDS       FLOATS: a file of RGB, native float32
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <vector>

#include "ddt/core.h"
#include "tests/bench/arguments.h"
#include "tests/plugin/openfx/kinds.h"

namespace {

template <class Work>
double milliseconds(Work&& work) {
    const std::clock_t begin = std::clock();
    work();
    return 1e3 * double(std::clock() - begin) / double(CLOCKS_PER_SEC);
}

mini::Picture picture(const ddt::Rect& box) {
    mini::Picture p;
    p.box = box;
    p.channels = 3;
    p.allocate();
    return p;
}

} // namespace

int main(int argc, char** argv) {
    int width = 0, height = 0, scale = 0, rounds = 0;
    if (argc != 6 || !bench::parse_argument("WIDTH", argv[2], 2, 8192, width) ||
        !bench::parse_argument("HEIGHT", argv[3], 2, 8192, height) ||
        !bench::parse_argument("SCALE", argv[4], 1, 16, scale) ||
        !bench::parse_argument("ROUNDS", argv[5], 1, 1000, rounds)) {
        std::fprintf(stderr, "host_speed FLOATS WIDTH HEIGHT SCALE ROUNDS\n");
        return 2;
    }
    std::vector<float> small(size_t(3 * width) * size_t(height));
    std::ifstream file(argv[1], std::ios::binary);
    const auto bytes = std::streamsize(small.size() * sizeof(float));
    if (!file.read(reinterpret_cast<char*>(small.data()), bytes)) {
        std::fprintf(stderr, "host_speed: \"%s\" does not have %lld bytes\n", argv[1],
                     static_cast<long long>(bytes));
        return 1;
    }
    std::vector<float> large(small.size() * size_t(scale * scale));

    mini::Host host(mini::natron, DDT_OFX_BUNDLE); // whose pixels are floats, and may be RGB
    host.plugin().set_host(host.abi());
    host.act("OfxActionLoad");
    mini::Effect effect(host);
    effect.describe();
    effect.set("scale", scale);
    effect.source = picture({0, 0, width, height});
    std::copy_n(reinterpret_cast<const char*>(small.data()), bytes, effect.source.bytes.begin());
    effect.source_region = {0, 0, double(width), double(height)};
    effect.output = picture({0, 0, scale * width, scale * height});

    double core = 1e30, openfx = 1e30;
    for (int round = 0; round < rounds; ++round) {
        core = std::min(core, milliseconds([&] {
                            ddt::enlarge(small.data(), width, height, 3, nullptr, large.data(),
                                         scale * width, scale * height);
                        }));
        int status = -1;
        openfx = std::min(openfx, milliseconds([&] { status = effect.render(effect.output.box); }));
        if (status != ddt::ofx::ok) {
            std::fprintf(stderr, "host_speed: the effect fails: %d\n", status);
            return 1;
        }
    }
    std::printf("core %.1f\nOpenFX %.1f\n", core, openfx);
    return 0;
}

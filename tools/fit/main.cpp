// SPDX-License-Identifier: Apache-2.0
// Fits the weights of core/surface/fitted/weights.inc and prints that file.
//
//   fit_weights PHOTOGRAPHS DRAWINGS [options] > weights.inc
//
// PHOTOGRAPHS and DRAWINGS are folders of pictures of 8 bits. Each is reduced by 2 and by 4 in
// encoded and in linear light, and the surface's weights are those with which the enlarged pictures
// come closest to the originals: exact least squares on the finished pictures, but that the limits
// are left out. What is cut off at black and white is found in passes: each leaves out the pixels
// that the one before had put there rightly. The same folders and options give the same numbers.
// What is done goes to stderr.
#include <cstdio>
#include <filesystem>
#include <set>
#include <string>

#include <OpenImageIO/argparse.h>
#include <tbb/parallel_for.h>

#include "metrics/psnr.h"
#include "metrics/ssim.h"
#include "tests/bench/arguments.h"
#include "tests/bench/reference.h"
#include "tools/fit/normal_equations.h"

namespace {

struct Set {
    const char* name;
    std::string folder;
    int scale;
    bench::Light light;
    double weight;
};

struct Figures {
    double psnr = 0, ssim = 0;
    int pictures = 0;
};

/// left_out: those that cannot be used are added. False if none is left.
bool add(const Set& set, unsigned every, const ddt::FittedWeights* so_far,
         fit::NormalEquations& sum, std::set<std::string>& left_out) {
    const std::vector<std::string> files = bench::image_files(set.folder);
    std::vector<fit::NormalEquations> parts(files.size());
    std::vector<std::string> errors(files.size());
    tbb::parallel_for(size_t(0), files.size(), [&](size_t i) {
        fit::Scene scene;
        if (fit::make_scene(files[i], set.scale, set.light, scene, errors[i]))
            parts[i].add(scene, set.weight, every, uint32_t(i + 1), so_far);
    });
    size_t used = 0;
    for (size_t i = 0; i < files.size(); ++i) {
        if (!errors[i].empty()) {
            std::fprintf(stderr, "%s is left out: %s\n", files[i].c_str(), errors[i].c_str());
            left_out.insert(files[i]);
            continue;
        }
        sum.add(parts[i]);
        ++used;
    }
    std::fprintf(stderr, "%s, %dx: %zu pictures\n", set.name, set.scale, used);
    return used > 0;
}

void report(const Set& set, const ddt::FittedWeights& weights) {
    const std::vector<std::string> files = bench::image_files(set.folder);
    std::vector<Figures> all(files.size());
    tbb::parallel_for(size_t(0), files.size(), [&](size_t i) {
        fit::Scene scene;
        std::string error;
        if (!fit::make_scene(files[i], set.scale, set.light, scene, error))
            return;
        const metrics::Image a = metrics::without_border(scene.original, set.scale);
        const metrics::Image b = metrics::without_border(
            bench::stored(fit::enlarge(scene, weights), set.light), set.scale);
        all[i] = {metrics::psnr(a, b), metrics::ssim(metrics::luma(a), metrics::luma(b)), 1};
    });
    Figures sum;
    for (const Figures& f : all)
        sum = {sum.psnr + f.psnr, sum.ssim + f.ssim, sum.pictures + f.pictures};
    std::fprintf(stderr, "%-30s %dx %7.3f %.4f\n", set.name, set.scale, sum.psnr / sum.pictures,
                 sum.ssim / sum.pictures);
}

template <size_t n>
void print(const float (&row)[n], bool last) {
    std::printf("{");
    for (size_t i = 0; i < n; ++i)
        std::printf(i == 0 ? "%#.9gf" : ", %#.9gf", double(row[i]));
    std::printf(last ? "}" : "},\n");
}

template <size_t n, size_t m>
void print(const float (&nodes)[m][n], const char* after) {
    std::printf("{");
    for (size_t k = 0; k < m; ++k)
        print(nodes[k], k + 1 == m);
    std::printf("%s\n", after);
}

/// The file weights.inc.
void print(const ddt::FittedWeights& w, const std::vector<std::string>& folders,
           const std::set<std::string>& left_out, int every, double ridge, double drawings,
           int passes) {
    std::printf("// SPDX-License-Identifier: Apache-2.0\n"
                "// FittedWeights (weights.h), as this printed them (tools/fit):\n"
                "//     fit_weights PHOTOGRAPHS DRAWINGS --every %d --ridge %g --drawings %g "
                "--passes %d\n",
                every, ridge, drawings, passes);
    const char* const kinds[] = {"Photographs", "Drawings"};
    for (size_t f = 0; f < 2; ++f) {
        std::printf("// %s:\n", kinds[f]);
        for (const std::string& file : bench::image_files(folders[f]))
            if (!left_out.count(file))
                std::printf("//     %s\n", std::filesystem::path(file).filename().c_str());
    }
    std::printf("{\n// Vertices, a row a node of the index.\n");
    print(w.vertex, "},");
    std::printf("// What they count beside that at black or white.\n");
    print(w.bound, "},");
    std::printf("// Edges: what their features that do not vanish count.\n");
    print(w.shared, "},\n{");
    for (int length = 0; length < ddt::fitted_lengths; ++length) {
        std::printf("{");
        for (int kind = 0; kind < ddt::fitted_kinds; ++kind) {
            const char* const names[] = {"cannot be flipped", "would lose much by it",
                                         "what a gain of 0 adds"};
            std::printf("// |v|^2 %s: %s.\n",
                        length == 2   ? "> 2"
                        : length == 1 ? "= 2"
                                      : "= 1",
                        names[kind]);
            print(w.null[length][kind], kind + 1 == ddt::fitted_kinds ? "}" : "},");
        }
        std::printf(length + 1 == ddt::fitted_lengths ? "}\n" : "},\n");
    }
    std::printf("}}\n");
}

} // namespace

int main(int argc, char** argv) {
    int every = 0, passes = 0;
    double ridge = 0, drawings = 0;
    std::string every_text = "24", passes_text = "4", ridge_text = "1e-5", drawings_text = "0.3";
    bool reported = false;
    std::vector<std::string> folders;
    OIIO::ArgParse args;
    args.usage("fit_weights PHOTOGRAPHS DRAWINGS [options]");
    args.arg("folder").hidden().action(
        [&](OIIO::cspan<const char*> a) { folders.push_back(a[0]); });
    args.arg("--every %s:N", &every_text).help("use one in N pixels (default: 24)");
    args.arg("--ridge %s:R", &ridge_text).help("add this share to the diagonal (default: 1e-5)");
    args.arg("--drawings %s:W", &drawings_text).help("what a drawing weighs (default: 0.3)");
    args.arg("--passes %s:N", &passes_text).help("solve so often (default: 4)");
    args.arg("--report", &reported).help("then measure every picture");
    if (args.parse_args(argc, const_cast<const char**>(argv)) < 0 || folders.size() != 2 ||
        !bench::parse_argument("--every", every_text, 1, 1000000, every) ||
        !bench::parse_argument("--passes", passes_text, 1, 1000, passes) ||
        !bench::parse_argument("--ridge", ridge_text, 0.0, 1.0, ridge) ||
        !bench::parse_argument("--drawings", drawings_text, 0.0, 1e6, drawings)) {
        args.print_help();
        return 2;
    }
    std::vector<Set> sets;
    for (const auto light : {bench::Light::encoded, bench::Light::linear})
        for (const int scale : {2, 4}) {
            const bool is_linear = light == bench::Light::linear;
            sets.push_back({is_linear ? "photographs, linear" : "photographs, encoded", folders[0],
                            scale, light, 1});
            sets.push_back({is_linear ? "drawings, linear" : "drawings, encoded", folders[1], scale,
                            light, drawings});
        }
    ddt::FittedWeights w;
    std::set<std::string> left_out;
    for (int pass = 0; pass < passes; ++pass) {
        fit::NormalEquations equations;
        for (const Set& set : sets)
            if (!add(set, unsigned(every), pass > 0 ? &w : nullptr, equations, left_out))
                return 1;
        if (pass == 0)
            equations.solve_plain(ridge, w);
        equations.solve_bound(ridge, w);
    }
    print(w, folders, left_out, every, ridge, drawings, passes);
    for (const Set& set : sets)
        if (reported)
            report(set, w);
    return 0;
}

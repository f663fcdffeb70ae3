// SPDX-License-Identifier: Apache-2.0
// The GPU's results against the CPU's, bit for bit.
#include "ddt/names.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"
#include "tests/core/helpers.h"

namespace ddt::test {
namespace {

std::string name_of(const SurfaceOptions& s) {
    return (s.kind == Surface::linear ? "linear consistency " : "patch consistency ") +
           std::to_string(s.consistency) + " soft " + std::to_string(s.soft) +
           (s.fitted ? " fitted" : "");
}

class SameBits : public OnDevice {};

constexpr Scheme schemes[] = {Scheme::one_round,
                              Scheme::lawson,
                              Scheme::basic,
                              Scheme::exproi,
                              Scheme::maxgain,
                              Scheme::exproi_maxgain,
                              Scheme::exproi_n_maxgain,
                              Scheme::look_ahead,
                              Scheme::annealing,
                              Scheme::pixel};
constexpr Cost costs[] = {Cost::abn, Cost::scf, Cost::jnd, Cost::dlp, Cost::dp};

TEST_P(SameBits, EverySchemeAndCost) {
    for (const Scheme scheme : schemes)
        for (const Cost cost : costs)
            for (int content = 0; content < int(Content::count); ++content) {
                const Picture p = make_picture(Content(content), 61, 43, 1, 7u + unsigned(content));
                Order order;
                order.job.mesh.scheme = scheme;
                order.job.mesh.cost = cost;
                order.out_width = 150;
                order.out_height = 101;
                expect_same(GetParam(), p, order,
                            std::string(name_of(Content(content))) + " " +
                                scheme_name(order.job.mesh) + " " + cost_name(cost));
            }
}

TEST_P(SameBits, EverySurface) {
    for (const SurfaceOptions& surface : surfaces_with({0, 1, 2}))
        for (int content = 0; content < int(Content::count); ++content) {
            const Picture p = make_picture(Content(content), 61, 43, 4, 7u + unsigned(content));
            Order order;
            order.job.surface = surface;
            order.job.kinds = {Channel::blend, Channel::blend, Channel::nearest, Channel::alpha};
            order.out_width = 150;
            order.out_height = 101;
            expect_same(GetParam(), p, order,
                        std::string(name_of(Content(content))) + " " + name_of(surface));
        }
}

TEST_P(SameBits, SeveralMeshes) {
    for (const int channels : {3, 4})
        for (const Scheme scheme : {Scheme::one_round, Scheme::lawson})
            for (int content = 0; content < int(Content::count); ++content) {
                const Picture p =
                    make_picture(Content(content), 61, 43, channels, 7u + unsigned(content));
                Order order;
                order.job.mesh.scheme = scheme;
                order.job.mesh.blur = 0.05f;
                order.job.mesh.meshes = 2 + content % 3;
                order.job.surface.consistency = 1;
                order.job.surface.soft = 0.3f;
                if (channels == 4)
                    order.job.kinds = {Channel::blend, Channel::blend, Channel::nearest,
                                       Channel::alpha};
                order.out_width = 150;
                order.out_height = 101;
                expect_same(GetParam(), p, order,
                            std::string(name_of(Content(content))) + " " +
                                std::to_string(order.job.mesh.meshes) + " meshes");
            }
}

INSTANTIATE_TEST_SUITE_P(Devices, SameBits, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test

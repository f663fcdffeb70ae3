// The GPU's results against the CPU's, bit for bit.
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"

namespace ddt::test {
namespace {

std::vector<SurfaceOptions> surfaces() {
    std::vector<SurfaceOptions> all;
    for (const Surface kind : {Surface::linear, Surface::patch})
        for (const int consistency : {0, 1, 2})
            for (const float soft : {0.0f, 0.3f}) {
                SurfaceOptions s(kind);
                s.consistency = consistency;
                s.soft = soft;
                all.push_back(s);
            }
    return all;
}

std::string name_of(const SurfaceOptions& s) {
    return (s.kind == Surface::linear ? "linear consistency " : "patch consistency ") +
           std::to_string(s.consistency) + " soft " + std::to_string(s.soft);
}

class SameBits : public OnDevice {};

TEST_P(SameBits, EverySchemeCostSurfaceAndPicture) {
    for (const Scheme scheme : {Scheme::one_round, Scheme::pixel, Scheme::lawson})
        for (const Cost cost : {Cost::abn, Cost::scf})
            for (const SurfaceOptions& surface : surfaces())
                for (int content = 0; content < int(Content::count); ++content) {
                    const Picture p =
                        make_picture(Content(content), 61, 43, 4, 7u + unsigned(content));
                    Order order;
                    order.job.mesh.scheme = scheme;
                    order.job.mesh.cost = cost;
                    order.job.surface = surface;
                    order.out_width = 150;
                    order.out_height = 101;
                    expect_same(GetParam(), p, order,
                                std::string(name_of(Content(content))) + " scheme " +
                                    std::to_string(int(scheme)) + " cost " +
                                    std::to_string(int(cost)) + " surface " +
                                    name_of(surface));
                }
}

INSTANTIATE_TEST_SUITE_P(Devices, SameBits, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test

// The GPU's results against the CPU's, bit for bit.
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"

namespace ddt::test {
namespace {

class SameBits : public OnDevice {};

TEST_P(SameBits, EverySchemeCostSurfaceAndPicture) {
    for (const Scheme scheme : {Scheme::one_round, Scheme::pixel, Scheme::lawson})
        for (const Cost cost : {Cost::abn, Cost::scf})
            for (const Surface surface : {Surface::linear, Surface::patch})
                for (int content = 0; content < int(Content::count); ++content) {
                    const Picture p = make_picture(Content(content), 61, 43, 4, 7u + unsigned(content));
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
                                    std::to_string(int(surface)));
                }
}

INSTANTIATE_TEST_SUITE_P(Devices, SameBits, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test

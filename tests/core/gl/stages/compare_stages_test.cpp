// SPDX-License-Identifier: Apache-2.0
// The stage dump finds nothing where there is nothing, and what there is where it is.
#include "tests/core/gl/stages/compare_stages.h"

#include "core/gl/context/faults.h"
#include "ddt/names.h"
#include "ddt/option_table.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"

namespace ddt::test {
namespace {

class Stages : public OnDevice {
protected:
    void TearDown() override {
        gl::change_constant("", "", "");
        gl::forget_devices();
    }
    std::vector<StageResult> compared(const Job& job) {
        gl::forget_devices();
        std::string why;
        bool forked = false;
        return compare_stages(*gl::open(GetParam(), why, forked), m_picture, job);
    }
    /// "stage: what" of the first that differs.
    std::string first_difference(const Job& job) {
        for (const StageResult& r : compared(job))
            if (r.differing > 0)
                return r.name + ": " + r.what;
        return "";
    }
    static Job job_of(const std::string& filter) {
        FilterOptions options;
        std::string error;
        EXPECT_TRUE(parse_filter(filter, options, error)) << error;
        Job job;
        job.mesh = options.mesh;
        job.surface = options.surface;
        return job;
    }

    Picture m_picture = make_picture(Content::photo, 40, 30, 4, 6);
};

TEST_P(Stages, AreTheSameHere) {
    for (const char* filter : {"ddt", "ddt-linear", "ddt-sharp"})
        for (const char* scheme : {"one-round", "maxgain", "pixel", "lawson"}) {
            const std::string spec = std::string(filter) + ",scheme=" + scheme;
            for (const StageResult& r : compared(job_of(spec))) {
                EXPECT_EQ(r.differing, 0u) << spec << ": " << line_of(r);
                EXPECT_GE(r.compared, size_t(40 * 30)) << r.name << ", " << r.what;
            }
        }
}

TEST_P(Stages, GoThroughEveryIterationAndRound) {
    const Job job = job_of("ddt-sharp,consistency=2");
    int iterations = 0, rounds = 0;
    for (const StageResult& r : compared(job)) {
        iterations += r.name.find("after iteration") == 0 && r.what == "edges";
        rounds += r.name.find("surface") == 0 && r.what == "vertices";
    }
    EXPECT_GT(iterations, 2);
    EXPECT_EQ(rounds, 3);
}

TEST_P(Stages, NameWhereAFaultIs) {
    const Job job = job_of("ddt-sharp");
    const std::string cost = std::string(" COST_") + cost_name(job.mesh.cost) +
                             (job.mesh.contour != 0 ? " CONTOURS" : "");
    struct {
        std::string program, constant, value, stage;
    } const faults[] = {
        {"start.comp" + cost, "rsqrt_magic", "1597460000", "starting mesh: gains"},
        {"evaluate.comp" + cost + " DENSE", "rsqrt_magic", "1597460000",
         "starting mesh, found alone: gains"},
        {"flip.comp", "longest_edge", "1", "after iteration 1: gains"},
        {"gradients.comp", "gradient_epsilon", "0.000401", "surface: gradients"},
        // How far walks may go; a software renderer ends every loop, so that one without an end
        // cannot be seen here.
        {"gradients.comp", "longest_walk", "3", "surface: gradients"},
        {"edges.comp QUADRATIC SOFT BOUNDS_DARK", "bend_strength", "1.76", "surface: bends"},
        {"correct.comp QUADRATIC SOFT BOUNDS_DARK STORED_EDGES", "across_beside", "0.2501",
         "surface after 1 corrections: vertices"},
        {"sample.comp QUADRATIC SOFT BOUNDS_DARK WHOLE_GROUPS", "bend_strength", "1.76",
         "result: samples"},
        {"sample.comp QUADRATIC SOFT BOUNDS_DARK WHOLE_GROUPS", "longest_walk", "1",
         "result: samples"},
    };
    for (const auto& fault : faults) {
        gl::change_constant(fault.program, fault.constant, fault.value);
        EXPECT_EQ(first_difference(job), fault.stage) << fault.program;
    }
}

INSTANTIATE_TEST_SUITE_P(Devices, Stages, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test

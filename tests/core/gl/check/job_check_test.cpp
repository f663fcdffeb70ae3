// SPDX-License-Identifier: Apache-2.0
// Every program of a job is checked before it is used, and a check that fails is heeded. Software
// renderers are checked here as hardware is elsewhere.
#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "core/gl/context/faults.h"
#include "core/gl/gpu.h"
#include "core/gl/job_programs.h"
#include "core/gl/program_interface.h"
#include "core/surface/corrections.h"
#include "ddt/names.h"
#include "tests/core/gl/devices.h"
#include "tests/core/gl/pictures.h"
#include "tests/environment.h"

namespace ddt::test {
namespace {

struct Change {
    const char *constant, *value;
};

/// A constant of the program, and another value that is not right.
Change change_of(const std::string& program) {
    const auto has = [&](const char* part) { return program.find(part) != program.npos; };
    if (has("contours.comp"))
        return {"contour_square_bias", "6.5"};
    if (has("anneal_select.comp"))
        return {"natural_log_2", "0.5"};
    if (has("anneal_"))
        return {"GAINS_GROUP_X", "16"};
    // Gains are found anew for the check: flips must differ.
    if (has("finish.comp")) // the few late ones
        return {"rsqrt_magic", "1000000000"};
    if (has("accept_reject.comp"))
        return {"rsqrt_magic", "1590000000"};
    if (has("COST_")) // by 1 part in 3000 at the first guess
        return {"rsqrt_magic", "1597460000"};
    if (has("select.comp"))
        return {"LIST_GROUP", "32"};
    if (has("fitted_bends.comp"))
        return {"GAINS_GROUP_X", "16"};
    if (has("flip.comp"))
        return {"longest_edge", "1"};
    if (has("unpack"))
        return {"SURFACE_GROUP_X", "8"};
    if (has("gradients.comp"))
        return {"gradient_epsilon", "0.000401"};
    if (has("correct.comp"))
        return {"across_beside", "0.2501"};
    if (has("SOFT"))
        return {"soft_share", "0.501"};
    if (has("QUADRATIC") && !has("STORED_BENDS"))
        return {"bend_strength", "1.751"};
    return {"SAMPLE_GROUP_X", "8"};
}

/// One job for each set of programs that a job can want.
std::vector<Order> orders() {
    std::vector<Order> all;
    Order order;
    order.out_width = 60;
    order.out_height = 50;
    order.job.surface.soft = 0.2f;
    for (const std::string& name : cost_names())
        for (const Scheme scheme : {Scheme::one_round, Scheme::maxgain, Scheme::annealing,
                                    Scheme::pixel, Scheme::lawson}) {
            order.job.mesh.scheme = scheme;
            order.job.mesh.max_iterations = scheme == Scheme::annealing ? 4 : 64;
            find_cost(name, order.job.mesh.cost);
            all.push_back(order);
        }
    order.job.mesh = plain_mesh();
    order.job.mesh.max_iterations = 0;
    all.push_back(order);
    order.job.mesh.contour = 0.4f;
    for (const Scheme scheme : {Scheme::one_round, Scheme::annealing, Scheme::pixel}) {
        order.job.mesh.scheme = scheme;
        order.job.mesh.max_iterations = scheme == Scheme::annealing ? 4 : 64;
        all.push_back(order);
    }
    order.job.mesh = plain_mesh();
    for (const Surface kind : {Surface::linear, Surface::patch})
        for (const float soft : {0.0f, 0.2f})
            for (const int consistency : {0, 1})
                for (const int meshes : {1, 3}) {
                    order.job.surface.kind = kind;
                    order.job.surface.soft = soft;
                    order.job.surface.consistency = consistency;
                    order.job.surface.fitted = false;
                    order.job.mesh.meshes = meshes;
                    all.push_back(order);
                    order.job.surface.fitted = true;
                    if (is_fitted(order.job.surface))
                        all.push_back(order);
                }
    return all;
}

class JobCheck : public OnDevice {
protected:
    void SetUp() override {
        OnDevice::SetUp();
        m_verbose.emplace("DDT_VERBOSE", "1");
    }
    void TearDown() override {
        gl::change_constant("", "", "");
        gl::forget_devices();
    }

    /// Do the job; true if on the device. `lines`: what was said of checks that failed.
    bool on_device(const Picture& picture, const Order& order, std::vector<std::string>& lines) {
        const Result cpu = enlarge_on(Device::cpu, picture, order);
        testing::internal::CaptureStderr();
        const Result result = enlarge_on(GetParam(), picture, order);
        std::istringstream said(testing::internal::GetCapturedStderr());
        for (std::string line; std::getline(said, line);)
            if (line.find("does not compute as the CPU does") != line.npos)
                lines.push_back(line);
        EXPECT_EQ(result.outcome, Outcome::done) << result.error;
        EXPECT_EQ(result.bits, cpu.bits);
        return result.statistics.device == GetParam();
    }

private:
    std::optional<Environment> m_verbose; ///< once the device is known
};

/// What is begun before it is used.
std::set<std::string> expected_of(const Job& job) {
    std::set<std::string> all;
    for (const gl::JobProgram& program : gl::job_programs(job, gl::Transfer()))
        EXPECT_TRUE(all.insert(gl::program_name(program.file, program.macros)).second);
    return all;
}

TEST_P(JobCheck, EveryProgramIsCheckedBeforeItIsUsedAndAWrongOneIsNot) {
    std::set<std::string> proved;
    for (const int channels : {3, 4}) {
        const Picture picture = make_picture(Content::photo, 24, 20, channels, 4);
        for (Order order : orders()) {
            order.job.channels = channels;
            std::vector<std::string> lines;
            gl::Gpu& right = fresh_device();
            right.thread.post([&] { EXPECT_EQ(right.checks.differs(right, order.job), ""); }).get();
            const std::set<std::string> checked = programs_of(right);
            EXPECT_TRUE(on_device(picture, order, lines));
            const std::set<std::string> used = programs_of(right);
            EXPECT_EQ(used, checked) << "a program was used that the check did not";
            EXPECT_EQ(used, expected_of(order.job));
            EXPECT_TRUE(lines.empty());
            for (const std::string& program : used) {
                if (!proved.insert(program).second)
                    continue;
                const Change change = change_of(program);
                gl::change_constant(program, change.constant, change.value);
                fresh_device();
                EXPECT_FALSE(on_device(picture, order, lines)) << program << " is wrong and used";
                EXPECT_EQ(lines.size(), 1u) << program;
                // What is known is not checked again; another job's programs may be right.
                EXPECT_FALSE(on_device(picture, order, lines)) << program;
                lines.clear();
                gl::change_constant("", "", "");
            }
        }
    }
    // 7 programs a cost, 6 with contours, what finds those, select, flip, the 2 others of
    // annealing, 2 that unpack, gradients, 3 of edges, 4 that correct, 2 that bend, 16 that sample.
    EXPECT_GE(proved.size(), 7 * cost_names().size() + 6 + 1 + 2 + 2 + 2 + 1 + 3 + 4 + 2 + 16);
}

// A program is known by what it alone is told: accept_reject.comp of its progress.
int g_dropped;
bool g_dropping;
PFNGLUSEPROGRAMPROC g_use_program;
PFNGLUNIFORM2IPROC g_uniform_2i;
PFNGLDISPATCHCOMPUTEPROC g_dispatch;

void APIENTRY use_program(GLuint program) {
    g_dropping = false;
    g_use_program(program);
}

void APIENTRY uniform_2i(GLint location, GLint x, GLint y) {
    g_dropping |= location == gl::at_progress;
    g_uniform_2i(location, x, y);
}

void APIENTRY dispatch_some(GLuint x, GLuint y, GLuint z) {
    g_dropped += g_dropping;
    if (!g_dropping)
        g_dispatch(x, y, z);
}

// What repeats a dispatch until all is done would repeat it for ever.
TEST_P(JobCheck, ADeviceOnWhichADispatchDoesNothingIsNotUsed) {
    const Picture picture = make_picture(Content::photo, 24, 20, 3, 4);
    Order order;
    order.out_width = 60;
    order.out_height = 50;
    order.job.mesh.scheme = Scheme::maxgain;
    for (const bool in_the_check : {true, false}) {
        gl::Gpu& device = fresh_device();
        device.thread
            .post([&] {
                if (!in_the_check) {
                    EXPECT_EQ(device.checks.differs(device, order.job), "");
                }
                gl::Functions& gl = device.context->gl;
                g_use_program = std::exchange(gl.UseProgram, use_program);
                g_uniform_2i = std::exchange(gl.Uniform2i, uniform_2i);
                g_dispatch = std::exchange(gl.DispatchCompute, dispatch_some);
            })
            .get();
        g_dropped = 0;
        std::vector<std::string> lines;
        EXPECT_FALSE(on_device(picture, order, lines));
        EXPECT_EQ(g_dropped, 1);
    }
}

/// What a compiler or a hasty editor might make of a program.
struct Wrong {
    const char *what, *file, *macros, *before, *after;
    void (*wanted_of)(Order&);
};

void of_contours(Order& order) {
    order.job.mesh.contour = 0.4f;
}
void of_the_default_cost(Order&) {}
void of_three_meshes(Order& order) {
    order.job.mesh.meshes = 3;
}
/// What is checked for them counts for more meshes, too.
void of_two_meshes(Order& order) {
    order.job.mesh.meshes = 2;
}
void of_fitted_vertices(Order& order) {
    order.job.surface.consistency = 1;
    order.job.surface.fitted = true;
    order.job.surface.clipped = true;
}
void of_soft_edges(Order& order) {
    of_fitted_vertices(order);
    order.job.surface.soft = 0.3f;
    order.job.surface.clipped = false;
}
void of_corrected_vertices(Order& order) {
    of_soft_edges(order);
    order.job.surface.fitted = false;
}
// In the first the vertex is the source's pixel.
void of_two_rounds(Order& order) {
    of_corrected_vertices(order);
    order.job.surface.consistency = 2;
}
void of_the_papers_scheme(Order& order) {
    order.job.mesh.scheme = Scheme::maxgain;
}

// Contractions are written with doubles, in which products of floats are exact.
constexpr Wrong all_wrong[] = {
    {"where contours do not decide", "start.comp", "COST_abn CONTOURS",
     "rising = abs(z(x + 1, y) - z(x, y + 1))", "rising = z(x + 1, y) - z(x, y + 1)", of_contours},
    {"where contours do not decide, ties", "start.comp", "COST_abn CONTOURS", "falling <= rising",
     "falling < rising", of_contours},
    {"where contours decide alone", "start.comp", "COST_abn CONTOURS", "xy == 0 ? flatter : xy < 0",
     "xy < 0", of_contours},
    {"sum of squares, contracted", "evaluate.comp", "COST_abn", "((gx * gx) + (gy * gy))",
     "float(double(gx) * double(gx) + double(gy * gy))", of_the_default_cost},
    {"mean of meshes, contracted", "sample.comp", "QUADRATIC BOUNDS_VERTICES MEAN",
     "mean * others + last * share", "vec4(dvec4(mean) * double(others) + dvec4(last * share))",
     of_three_meshes},
    {"mean of meshes, contracted the other way", "sample.comp", "QUADRATIC BOUNDS_VERTICES MEAN",
     "mean * others + last * share", "vec4(dvec4(mean * others) + dvec4(last) * double(share))",
     of_three_meshes},
    {"mean of meshes, contracted, of two", "sample.comp", "QUADRATIC BOUNDS_VERTICES MEAN",
     "mean * others + last * share", "vec4(dvec4(mean) * double(others) + dvec4(last * share))",
     of_two_meshes},
    {"mean of meshes, contracted the other way, of two", "sample.comp",
     "QUADRATIC BOUNDS_VERTICES MEAN", "mean * others + last * share",
     "vec4(dvec4(mean * others) + dvec4(last) * double(share))", of_two_meshes},
    {"mean of meshes, beyond them", "sample.comp", "QUADRATIC BOUNDS_VERTICES MEAN",
     "f = if_less(f, low, low, f);\n    return if_less(high, f, high, f);", "return f;",
     of_three_meshes},
    {"black and white about a pixel, contracted", "correct.comp", "QUADRATIC STORED_EDGES FITTED",
     "(s.high - z) * dark + (z - s.low) * bright",
     "vec4(dvec4((s.high - z) * dark) + dvec4(z - s.low) * dvec4(bright))", of_fitted_vertices},
    {"alpha beyond 0 to 1", "sample.comp", "QUADRATIC STORED_BENDS", "lower(upper(f, low), high)",
     "f", of_fitted_vertices},
    {"alpha beyond 0 to 1 where pixels are", "sample.comp", "QUADRATIC STORED_BENDS",
     "high = upper(high, s)", "high = vec4(1.0)", of_fitted_vertices},
    {"what greys keep where it is cut off", "correct.comp", "QUADRATIC STORED_EDGES FITTED",
     "low * 0.5 - upper", "low * 0.25 - upper", of_fitted_vertices},
    {"limit above, contracted", "correct.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_EDGES",
     "raised = high + margin", "raised = vec4(dvec4(high) + dvec4(limit) * dvec4(high - low))",
     of_corrected_vertices},
    {"limit below, contracted", "correct.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_EDGES",
     "wide = low - margin", "wide = vec4(dvec4(low) - dvec4(limit) * dvec4(high - low))",
     of_corrected_vertices},
    {"limit above black, contracted", "correct.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_EDGES",
     "dim = low - limit * low", "dim = vec4(dvec4(low) - dvec4(limit) * dvec4(low))",
     of_corrected_vertices},
    {"correction, contracted", "correct.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_EDGES",
     "step_ = (source - z) - sum * share",
     "step_ = vec4(dvec4(source - z) - dvec4(sum) * double(share))", of_two_rounds},
    {"fitted correction, contracted", "correct.comp", "QUADRATIC STORED_EDGES FITTED",
     "moved = z + strength * finite_or(step_, vec4(0.0))",
     "moved = vec4(dvec4(z) + double(strength) * dvec4(finite_or(step_, vec4(0.0))))",
     of_fitted_vertices},
    {"what is left beside lights", "correct.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_EDGES",
     "dim = upper(dim, left)", "dim = dim", of_corrected_vertices},
    {"what is left beside faint lights", "correct.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_EDGES",
     "lower(vec4(1.0), above_white)", "vec4(above_white.x < 0.0 ? 0.0 : 1.0)",
     of_corrected_vertices},
    {"limit at black and white, contracted", "correct.comp", "QUADRATIC STORED_EDGES FITTED",
     "widened = limit + limit * (bound * bound_limit)",
     "widened = vec4(dvec4(limit) + dvec4(limit) * dvec4(bound * bound_limit))",
     of_fitted_vertices},
    {"blends that leave less than half", "sample.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_BENDS",
     "upper(blend, least), blend)", "blend, blend)", of_soft_edges},
    {"blends that leave all", "sample.comp", "QUADRATIC SOFT BOUNDS_DARK STORED_BENDS",
     "2.0 * dark_share * low", "2.0 * low", of_soft_edges},
    {"candidates of one gain", "select.comp", "", "g == own && other < m", "g == own && other > m",
     of_the_default_cost},
    {"late candidates of one gain", "finish.comp", "COST_abn", "g == own && other < m",
     "g == own && other > m", of_the_default_cost},
    {"candidates that wait, not kept between dispatches", "accept_reject.comp", "COST_abn",
     "waiting = mark[at + 4]", "waiting = 0u", of_the_papers_scheme},
    {"candidates of whom half are kept between dispatches", "accept_reject.comp", "COST_abn",
     "n_candidates = mark[at + 7]", "n_candidates = mark[at + 7] / 2u", of_the_papers_scheme},
};

// Each makes other bits of some picture, and is to make some of the check's.
TEST_P(JobCheck, WhatFewPicturesShowIsSeen) {
    for (const Wrong& wrong : all_wrong) {
        Order order;
        order.job.channels = 3;
        wrong.wanted_of(order);
        gl::change_text(gl::program_name(wrong.file, wrong.macros), wrong.before, wrong.after);
        gl::Gpu& device = fresh_device();
        device.thread
            .post([&] {
                const std::string& difference = device.checks.differs(device, order.job);
                const auto tells = [&](const char* what) {
                    return difference.find(what) != difference.npos;
                };
                // Of other failures there is, first of all, that there is no such text.
                EXPECT_TRUE(tells(" does not compute as the CPU does ") ||
                            tells("no edge of a round was accepted"))
                    << wrong.what << ": " << difference;
            })
            .get();
        EXPECT_TRUE(programs_of(device).count(gl::program_name(wrong.file, wrong.macros)))
            << wrong.what;
    }
}

int g_linked, g_linked_when_asked;
PFNGLLINKPROGRAMPROC g_link_program;
PFNGLGETSHADERIVPROC g_get_shader;

void APIENTRY link_program(GLuint program) {
    ++g_linked;
    g_link_program(program);
}

void APIENTRY get_shader(GLuint shader, GLenum what, GLint* answer) {
    g_linked_when_asked = std::min(g_linked_when_asked, g_linked);
    g_get_shader(shader, what, answer);
}

// Drivers compile one beside the other only as long as nobody waits for one.
TEST_P(JobCheck, AllProgramsAreBegunBeforeOneIsWaitedFor) {
    gl::Gpu& device = fresh_device();
    device.thread
        .post([&] {
            gl::Functions& gl = device.context->gl;
            g_link_program = std::exchange(gl.LinkProgram, link_program);
            g_get_shader = std::exchange(gl.GetShaderiv, get_shader);
        })
        .get();
    g_linked = 0;
    g_linked_when_asked = 1000;
    Order order;
    order.out_width = 60;
    order.out_height = 50;
    order.job.surface = SurfaceOptions();
    order.job.surface.fitted = true;
    order.job.surface.clipped = true;
    order.job.surface.consistency = 2;
    std::vector<std::string> lines;
    EXPECT_TRUE(on_device(make_picture(Content::photo, 24, 20, 3, 4), order, lines));
    EXPECT_EQ(g_linked_when_asked, g_linked);
    EXPECT_GE(g_linked, 11);
}

// What one of the paper's schemes proves of its program another may have no use for.
TEST_P(JobCheck, SchemesThatTakeOtherBranchesAreCheckedEach) {
    gl::Gpu& device = fresh_device();
    Job job = plain_job();
    const auto check = [&] {
        device.thread.post([&] { EXPECT_EQ(device.checks.differs(device, job), ""); }).get();
        return device.programs->uses().at("accept_reject.comp");
    };
    int before = 0;
    for (const Scheme scheme : {Scheme::basic, Scheme::exproi, Scheme::maxgain,
                                Scheme::exproi_maxgain, Scheme::exproi_n_maxgain}) {
        job.mesh.scheme = scheme;
        const int first = check();
        EXPECT_GT(first, before) << scheme_name(job.mesh);
        EXPECT_EQ(check(), first) << scheme_name(job.mesh);
        before = first;
    }
    job.mesh.wide_iterations = 5; // the same branches
    EXPECT_EQ(check(), before);
}

// Of what is not cut off a check proves nothing for what is, nor the other way round.
TEST_P(JobCheck, VerticesThatAreClippedAreCheckedApart) {
    const Picture picture = make_picture(Content::photo, 24, 20, 3, 4);
    Order order;
    order.out_width = 60;
    order.out_height = 50;
    order.job.channels = 3;
    for (const bool fitted : {false, true})
        for (const bool wrong_is_clipped : {false, true}) {
            SurfaceOptions& surface = order.job.surface;
            surface = SurfaceOptions();
            surface.consistency = 1;
            surface.fitted = fitted;
            const std::string what = std::string(fitted ? "fitted" : "plain") +
                                     (wrong_is_clipped ? ", clipped" : ", not clipped");
            surface.clipped = wrong_is_clipped;
            gl::change_constant(gl::program_name("correct.comp", gl::correct_macros(surface)),
                                "bound",
                                wrong_is_clipped ? "if_less(dim, zero, zero, dim)" : "grey");
            fresh_device();
            std::vector<std::string> lines;
            // The right one first: were it to count for the other, that would be used.
            for (const bool wrong : {false, true, false}) {
                surface.clipped = wrong == wrong_is_clipped;
                EXPECT_EQ(on_device(picture, order, lines), !wrong) << what;
            }
            EXPECT_EQ(lines.size(), 1u) << what;
        }
}

// The same of how cells are divided at first.
TEST_P(JobCheck, DiagonalStartsAreCheckedApart) {
    const Picture picture = make_picture(Content::photo, 24, 20, 3, 4);
    Order order;
    order.out_width = 60;
    order.out_height = 50;
    order.job.channels = 3;
    for (const Scheme scheme : {Scheme::one_round, Scheme::pixel})
        for (const Start wrong_start : {Start::flat, Start::diagonal}) {
            order.job.mesh.scheme = scheme;
            gl::change_constant("start.comp COST_abn", "is_down",
                                wrong_start == Start::flat ? "true" : "flatter");
            fresh_device();
            std::vector<std::string> lines;
            for (const bool wrong : {false, true, false}) {
                order.job.mesh.start =
                    wrong == (wrong_start == Start::diagonal) ? Start::diagonal : Start::flat;
                EXPECT_EQ(on_device(picture, order, lines), !wrong) << scheme_name(order.job.mesh);
            }
            EXPECT_EQ(lines.size(), 1u) << scheme_name(order.job.mesh);
        }
}

// On one device: what is checked is the same code on all, and compiles for most of the time.
INSTANTIATE_TEST_SUITE_P(Devices, JobCheck, testing::Values(Device::egl), device_name);

} // namespace
} // namespace ddt::test

// SPDX-License-Identifier: Apache-2.0
// The compiled part of the Python module; oiio_ddt/__init__.py gives it arrays of three dimensions.
#include <algorithm>
#include <cxxabi.h>
#include <exception>
#include <functional>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "core/base/one_line.h"
#include "core/base/progress.h"
#include "core/enlarge/build_mesh.h"
#include "core/fill/fill.h"
#include "ddt/mesh.h"
#include "plugin/host/enlargement.h"
#include "plugin/host/pixels.h"
#include "plugin/host/request.h"

namespace py = pybind11;

namespace {

using namespace ddt::host;

/// Raised when the caller's progress() says to stop.
struct Cancelled : std::runtime_error {
    using std::runtime_error::runtime_error;
};

Sample sample_of(const std::string& name) {
    constexpr std::pair<const char*, Sample> samples[] = {
        {"uint8", Sample::uint8},     {"int8", Sample::int8}, {"uint16", Sample::uint16},
        {"int16", Sample::int16},     {"half", Sample::half}, {"float32", Sample::float32},
        {"float64", Sample::float64}, {"id32", Sample::id32},
    };
    for (const auto& [known, sample] : samples)
        if (name == known)
            return sample;
    throw py::value_error("ddt: unknown kind of number " + name);
}

Buffer buffer_of(const py::array& array, void* data, Sample sample, int x0, int y0) {
    const auto height = int(array.shape(0)), width = int(array.shape(1));
    return {data,
            ptrdiff_t(array.strides(0)),
            ptrdiff_t(array.strides(1)),
            ptrdiff_t(array.strides(2)),
            {x0, y0, x0 + width, y0 + height},
            sample};
}

/// While the interpreter ends, Python up to 3.13 ends threads that ask for its lock by unwinding
/// them, which passes neither `catch (...)` nor destructors: the process would be aborted. They
/// wait instead until it ends, as from 3.14 on. Call it from a handler that is never left.
[[noreturn]] void wait_for_the_end() {
    for (;;)
        pause();
}

/// Whether the interpreter ends, or has ended. A thread may crash then where it asks for the lock:
/// from 3.14 on it may be given a state of what is gone.
bool is_ending() {
#if PY_VERSION_HEX >= 0x030d0000
    return !Py_IsInitialized() || Py_IsFinalizing();
#else
    return !Py_IsInitialized() || _Py_IsFinalizing();
#endif
}

/// Without the interpreter's lock.
class Unlocked {
public:
    Unlocked() : m_thread(PyEval_SaveThread()) {}
    ~Unlocked() {
        try {
            PyEval_RestoreThread(m_thread);
        } catch (abi::__forced_unwind&) {
            wait_for_the_end();
        }
    }
    Unlocked(const Unlocked&) = delete;
    Unlocked& operator=(const Unlocked&) = delete;

private:
    PyThreadState* m_thread;
};

/// Asks Python from time to time whether work goes on that runs without the interpreter's lock. It
/// asks on the thread that it was made on alone, which works with the others: there the caller may
/// hold what no other thread is given, a lock, a connection to a database or a context, and there
/// signals are seen if it is Python's main thread.
class Watch {
public:
    explicit Watch(py::object progress) : m_progress(std::move(progress)) {}

    /// False: there is an exception, or the caller's function said so. Called on any thread, one at
    /// a time.
    bool operator()(float share) {
        if (is_ending())
            wait_for_the_end();
        m_share = share;
        m_untold = std::this_thread::get_id() != m_thread;
        return m_untold || ask();
    }

    /// Once all threads have ended, with the interpreter's lock: tell the last share if another
    /// thread reached it, and raise what there is to raise.
    void finish(bool done) {
        if (done && m_untold)
            ask();
        if (m_exception)
            std::rethrow_exception(m_exception);
    }

private:
    bool ask() {
        std::optional<py::gil_scoped_acquire> lock;
        try {
            lock.emplace();
            if (PyErr_CheckSignals() != 0)
                throw py::error_already_set();
            if (m_progress.is_none())
                return true;
            // numpy's False is not Python's; functions without a return say None.
            const py::object answer = m_progress(m_share);
            const int on = answer.is_none() ? 1 : PyObject_IsTrue(answer.ptr());
            if (on < 0)
                throw py::error_already_set();
            if (on == 0)
                throw Cancelled("ddt: cancelled");
            return true;
        } catch (abi::__forced_unwind&) {
            wait_for_the_end();
        } catch (...) {
            m_exception = std::current_exception();
            return false;
        }
    }

    py::object m_progress;
    const std::thread::id m_thread = std::this_thread::get_id();
    float m_share = 0;
    bool m_untold = false; ///< the last share, which another thread reached
    std::exception_ptr m_exception;
};

[[noreturn]] void raise(ddt::Outcome outcome, const std::string& error) {
    if (outcome == ddt::Outcome::out_of_memory)
        throw std::bad_alloc();
    if (outcome == ddt::Outcome::bad_job)
        throw py::value_error(error);
    throw std::runtime_error(error);
}

Enlargement work_on(const py::array& pixels, const std::string& sample, const std::string& filter,
                    const std::string& light, bool associated) {
    Enlargement work;
    // Only read: that the memory may be written is not asked for.
    work.from = buffer_of(pixels, const_cast<void*>(pixels.data()), sample_of(sample), 0, 0);
    work.place.window = work.from.box;
    const auto channels = int(pixels.shape(2));
    work.layout = work.from.sample == Sample::id32 ? Layout::ids(channels)
                                                   : Layout::usual(channels, associated);
    std::string error;
    if (!set_filter(filter, light, work, error))
        throw py::value_error(error);
    return work;
}

void enlarge_array(const py::array& pixels, py::array& result, const std::string& sample,
                   std::pair<int, int> full, std::pair<int, int> origin, const std::string& filter,
                   const std::string& light, bool associated, int threads, py::object progress) {
    Enlargement work = work_on(pixels, sample, filter, light, associated);
    work.to =
        buffer_of(result, result.mutable_data(), work.from.sample, origin.first, origin.second);
    work.place = onto(work.from.box, {0, 0, full.first, full.second});
    // Integers in memory, as of an ImageBuf.
    work.surface.clipped |= is_unsigned(work.to.sample);
    work.threads = threads;
    Watch watch(std::move(progress));
    work.progress = std::ref(watch);
    std::string error;
    ddt::Outcome outcome;
    {
        const Unlocked unlocked;
        outcome = enlarge(work, error);
    }
    watch.finish(outcome == ddt::Outcome::done);
    if (outcome != ddt::Outcome::done)
        raise(outcome, error);
}

/// Some rows at once: their values are not needed.
void read_guide(const Enlargement& work, std::vector<float>& guide) {
    constexpr int rows = 16;
    const ddt::Rect& all = work.place.window;
    const auto width = size_t(all.width());
    std::vector<float> values(size_t(rows) * width * size_t(work.layout.channels));
    HostSource source(work);
    for (int y = all.y0; y < all.y1; y += rows)
        (void)source.read({all.x0, y, all.x1, std::min(y + rows, all.y1)}, values.data(),
                          &guide[size_t(y - all.y0) * width]);
}

/// Let the work have pixels of its own, in `memory`, in which what its filter says is filled. Not
/// Outcome::done: with one line in `error`.
ddt::Outcome fill_pixels(Enlargement& work, std::vector<char>& memory,
                         const ddt::ProgressCallback& progress, std::string& error) {
    const ddt::Rect& box = work.from.box;
    const auto channels = size_t(work.layout.channels), number = size_of(work.from.sample);
    memory.resize(box.area() * channels * number);
    const auto pixel = ptrdiff_t(channels * number);
    work.to = {memory.data(), pixel * box.width(), pixel, ptrdiff_t(number), box, work.from.sample};
    work.progress = progress;
    const ddt::Outcome outcome = enlarge(work, error);
    work.from = work.to;
    return outcome;
}

/// On the CPU. Not Outcome::done: with one line in `error`.
ddt::Outcome make_mesh(Enlargement& work, const ddt::ProgressCallback& progress, ddt::Mesh& mesh,
                       std::string& error) {
    std::vector<char> memory;
    float filled = 0;
    if (work.holes != ddt::Holes::keep) {
        filled = ddt::share_of_filling;
        const ddt::Outcome outcome =
            fill_pixels(work, memory, ddt::part_of(progress, 0, filled), error);
        if (outcome != ddt::Outcome::done)
            return outcome;
    }
    const ddt::Rect& window = work.place.window;
    std::vector<float> guide(window.area());
    read_guide(work, guide);
    if (ddt::build_mesh(guide.data(), window.width(), window.height(), work.mesh, mesh, nullptr,
                        &error, ddt::part_of(progress, filled, 1)))
        return ddt::Outcome::done;
    const bool no_memory = error == ddt::with_prefix(ddt::out_of_memory_text);
    return no_memory ? ddt::Outcome::out_of_memory : ddt::Outcome::bad_job;
}

py::array mesh_of(const py::array& pixels, const std::string& sample, const std::string& filter,
                  const std::string& light, bool associated, py::object progress) {
    Enlargement work = work_on(pixels, sample, filter, light, associated);
    std::string error;
    if (!ddt::check_mesh_size(work.from.box.width(), work.from.box.height(), error))
        throw py::value_error(error);
    work.place = onto(work.from.box, work.from.box);
    work.device = ddt::Device::cpu;
    Watch watch(std::move(progress));
    ddt::Mesh mesh;
    ddt::Outcome outcome;
    {
        const Unlocked unlocked;
        const ddt::ProgressCallback told = std::ref(watch);
        outcome = make_mesh(work, told, mesh, error);
    }
    watch.finish(outcome == ddt::Outcome::done);
    if (outcome != ddt::Outcome::done)
        raise(outcome, error);
    py::array_t<int32_t> triangles({py::ssize_t(mesh.triangles.size()), py::ssize_t(3)});
    std::copy_n(mesh.triangles.data()->data(), 3 * mesh.triangles.size(), triangles.mutable_data());
    return triangles;
}

} // namespace

PYBIND11_MODULE(_ddt, m) {
    m.doc() = "The compiled part of oiio_ddt.";
    m.attr("__version__") = DDT_VERSION;
    py::register_exception<Cancelled>(m, "Cancelled");
    m.def("enlarge", &enlarge_array);
    m.def("mesh", &mesh_of);
}

// SPDX-License-Identifier: Apache-2.0
#include "core/gl/device_mesh.h"

#include <algorithm>
#include <vector>

#include "core/gl/transfer.h"
#include "ddt/names.h"
#include "tests/core/gl/devices.h"

namespace ddt::test {
namespace {

PFNGLBUFFERSTORAGEPROC g_storage = nullptr;
std::vector<size_t> g_sizes; ///< of buffers that were made

void storage_that_counts(GLenum target, GLsizeiptr size, const void* data, GLbitfield flags) {
    g_sizes.push_back(size_t(size));
    g_storage(target, size, data, flags);
}

class DeviceMeshes : public OnDevice {
protected:
    void TearDown() override { gl::forget_devices(); }

    struct Made {
        size_t bytes = 0, largest = 0;
    };
    /// What is made to make the meshes of so many tiles.
    static Made make(gl::Gpu& gpu, const gl::SlotShape& shape, const MeshOptions& options,
                     int tiles) {
        const gl::TileSize size{shape.width, shape.height};
        const std::vector<float> guide(shape.pixels(), 0.5f);
        gl::HostBuffer memory(gpu.context->gl, gl::guide_room(shape.pixels()));
        const size_t bytes = gl::encode_guide(guide, memory.data());
        g_sizes.clear();
        gl::DeviceMesh mesh(gpu, shape, tiles);
        mesh.set_tiles(std::vector<gl::TileSize>(size_t(tiles), size));
        for (int slot = 0; slot < tiles; ++slot)
            mesh.write_guide(slot, memory, 0, bytes);
        mesh.unpack_guides();
        if (gl::DeviceMesh::knows(options))
            mesh.triangulate(options);
        gl::finish(gpu.context->gl, "a test");
        Made made;
        for (const size_t one : g_sizes) {
            made.bytes += one;
            made.largest = std::max(made.largest, one);
        }
        return made;
    }
};

TEST_P(DeviceMeshes, TakeTheBytesThatAreCountedOnForATile) {
    gl::Gpu& gpu = fresh_device();
    const gl::SlotShape shape{96, 64};
    gpu.thread
        .post([&] {
            gl::Functions& gl = gpu.context->gl;
            ASSERT_NE(gl.BufferStorage, nullptr);
            g_storage = gl.BufferStorage;
            gl.BufferStorage = storage_that_counts;
            for (const Scheme scheme : {Scheme::one_round, Scheme::annealing, Scheme::maxgain,
                                        Scheme::exproi_n_maxgain, Scheme::lawson}) {
                MeshOptions options;
                options.scheme = scheme;
                options.contour = 0;
                options.max_iterations = 2;
                const Made two = make(gpu, shape, options, 2), five = make(gpu, shape, options, 5);
                EXPECT_EQ(five.bytes - two.bytes, 3 * gl::DeviceMesh::bytes(shape, options))
                    << scheme_name(options);
                EXPECT_EQ(five.largest, 5 * gl::DeviceMesh::largest_bytes(shape))
                    << scheme_name(options);
            }
            gl.BufferStorage = g_storage;
        })
        .get();
}

INSTANTIATE_TEST_SUITE_P(Devices, DeviceMeshes, testing::Values(Device::egl, Device::osmesa),
                         device_name);

} // namespace
} // namespace ddt::test

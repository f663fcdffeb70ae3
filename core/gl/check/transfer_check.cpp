// SPDX-License-Identifier: Apache-2.0
#include "core/gl/check/transfer_check.h"

#include <algorithm>
#include <cstring>

#include "core/base/float_bits.h"
#include "core/base/half.h"
#include "core/gl/check/difference.h"
#include "core/gl/gpu.h"
#include "core/gl/surfaces.h"
#include "core/surface/control_net.h"

namespace ddt::gl {

namespace {

/// Floats of every size: those that 16 bits hold, and their neighbours on both sides of what lies
/// halfway to the next.
std::vector<float> checked_floats() {
    std::vector<float> floats;
    for (uint32_t high = 0; high < 65536; high += 7)
        for (const uint32_t low : {0u, 0x0fffu, 0x1000u, 0x1001u, 0x8000u, 0xf000u})
            floats.push_back(float_of(high << 16 | low));
    return floats;
}

std::string unpacking_differs(Gpu& gpu, const Numbers& numbers) {
    const Functions& gl = gpu.context->gl;
    constexpr int width = 61, height = 43, channels = group_size + 1;
    const SlotShape shape{64, 44};
    const size_t count = size_t(width) * height * channels;
    HostBuffer memory(gl, count * size_t(numbers.bytes));
    std::vector<uint32_t> wanted(count);
    for (size_t i = 0; i < count; ++i) {
        const uint32_t code = uint32_t(i) * 0x9e3779b9u >> 8; // of any size
        const uint32_t bits =
            numbers.coded() ? bits_of(numbers.table[code % numbers.table.size()]) : code << 7;
        wanted[i] = bits;
        const uint32_t sent = numbers.coded() ? code : bits; // its first bytes
        std::memcpy(memory.data() + i * size_t(numbers.bytes), &sent, size_t(numbers.bytes));
    }
    DeviceMesh mesh(gpu, shape, 1);
    Surfaces surfaces(gpu, shape, 1, std::vector<GroupKinds>(2), SurfaceOptions(), 1);
    const TileSize size{width, height};
    surfaces.expect(numbers, channels, 1);
    mesh.set_tiles({size});
    surfaces.write_numbers(0, size, memory, 0);
    surfaces.unpack(mesh);
    finish(gl, "unpacking");
    std::vector<uint32_t> found(count);
    for (int g = 0; g < 2; ++g) {
        std::vector<uint32_t> group(shape.pixels() * group_size);
        surfaces.vertices(g).read(0, group.size() * sizeof(uint32_t), group.data());
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                for (int c = g * group_size; c < std::min(channels, (g + 1) * group_size); ++c)
                    found[size_t(y * width + x) * channels + size_t(c)] =
                        group[size_t(y * shape.width + x) * group_size + size_t(c % group_size)];
    }
    return difference("unpacked numbers", wanted, found);
}

std::string guides_differ(Gpu& gpu) {
    const Functions& gl = gpu.context->gl;
    const SlotShape shape{64, 44};
    const TileSize size{61, 43};
    const size_t count = 61 * 43;
    std::vector<float> guides[2];
    for (size_t i = 0; i < count; ++i) {
        guides[0].push_back(float(uint16_t(i * 6553)) * guide_unit + guide_of_nothing);
        guides[1].push_back(float(i) * 0.37f - 100.0f);
    }
    DeviceMesh mesh(gpu, shape, 2);
    HostBuffer memory(gl, 2 * guide_room(count));
    mesh.set_tiles({size, size});
    for (int k = 0; k < 2; ++k) {
        const size_t at = size_t(k) * guide_room(count);
        const size_t bytes = encode_guide(guides[k], memory.data() + at);
        mesh.write_guide(k, memory, at, bytes);
    }
    mesh.unpack_guides();
    std::vector<uint32_t> wanted, found;
    for (int k = 0; k < 2; ++k) {
        std::vector<float> slot(shape.pixels());
        mesh.read_guide(k, slot.data());
        for (int y = 0; y < size.height; ++y)
            for (int x = 0; x < size.width; ++x) {
                wanted.push_back(bits_of(guides[k][size_t(y * size.width + x)]));
                found.push_back(bits_of(slot[size_t(y * shape.width + x)]));
            }
    }
    finish(gl, "guides");
    return difference("numbers of guides", wanted, found);
}

std::string packing_differs(Gpu& gpu, const Transfer& transfer) {
    const Functions& gl = gpu.context->gl;
    const std::vector<float> floats = checked_floats();
    const size_t count = floats.size(), bytes = count * transfer.download_bytes();
    SampleMemory memory;
    HostBuffer packed(gl, bytes);
    Surfaces surfaces(gpu, {2, 2}, 1, {}, SurfaceOptions(), 1);
    surfaces.make_room(1, count, transfer, memory);
    memory.results->write(0, count * sizeof(float), floats.data());
    surfaces.download(count, transfer, memory, packed);
    finish(gl, "packing");
    std::vector<uint8_t> wanted(bytes), found(bytes);
    std::memcpy(found.data(), packed.data(), bytes);
    if (transfer.download == Transfer::Download::codes)
        transfer.download_codes->encode(floats.data(), wanted.data(), count);
    for (size_t i = 0; transfer.download == Transfer::Download::halfs && i < count; ++i) {
        const uint16_t half = half_of_float(floats[i]);
        std::memcpy(&wanted[i * sizeof half], &half, sizeof half);
    }
    return difference("packed bytes", wanted, found);
}

} // namespace

std::string transfer_differs(Gpu& gpu, const Transfer& transfer) {
    std::string what = guides_differ(gpu);
    if (what.empty())
        what = unpacking_differs(gpu, transfer.upload);
    if (what.empty() && transfer.packed())
        what = packing_differs(gpu, transfer);
    return difference_of(gpu.context->renderer, transfer_key_of(transfer), what);
}

std::string transfer_key_of(const Transfer& transfer) {
    return std::to_string(transfer.upload.bytes) + " bytes there, " +
           std::to_string(transfer.download_bytes()) + " back";
}

} // namespace ddt::gl

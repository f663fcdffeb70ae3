// SPDX-License-Identifier: Apache-2.0
// Names of virtual images, and sidecars: the first byte tells which the rest is. What parses gives
// windows within bounds, or one line.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <unistd.h>

#include "plugin/reader/request.h"
#include "tests/fuzz/bytes.h"
#include "tests/fuzz/require.h"

using namespace ddt;
using namespace ddt::fuzz;

namespace {

/// A sidecar in a folder of this process.
std::string sidecar(const std::string& text) {
    static const std::string folder = [] {
        std::string name = (std::filesystem::temp_directory_path() / "ddt-fuzz-XXXXXX").string();
        return std::string(mkdtemp(name.data()));
    }();
    static const int at_end = std::atexit([] { std::filesystem::remove_all(folder); });
    (void)at_end;
    const std::string name = folder + "/sidecar.ddt";
    std::ofstream(name, std::ios::binary) << text;
    return name;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    Bytes bytes(data, size);
    const bool in_a_file = bytes.coin();
    OIIO::ImageSpec from(bytes.between(1, 9000), bytes.between(1, 9000), 3, OIIO::TypeDesc::UINT8);
    from.x = bytes.take<int16_t>();
    from.full_x = bytes.take<int16_t>();
    from.full_width = bytes.between(1, 20000);
    const std::string text = bytes.rest();
    const std::string name = in_a_file ? sidecar(text) : text;
    if (!is_request_name(name))
        return 0;
    Request request;
    std::string error;
    if (!parse_request(name, request, error)) {
        require_error_line(error);
        return 0;
    }
    OIIO::ImageSpec to = from;
    if (!request.windows(from, to, error)) {
        require_error_line(error);
        return 0;
    }
    require(to.width > 0 && to.height > 0 && to.full_width > 0 && to.full_height > 0,
            "a size that is granted is one");
    return 0;
}

// SPDX-License-Identifier: Apache-2.0
#include "print.h"

#include <cstdio>

namespace speed {

const char* name_of(Memory memory) {
    return memory == Memory::warm ? "warm " : "fresh";
}

void heading(const char* what, const OIIO::ImageBuf& image, Format format, int threads) {
    std::printf("\n%s: %dx%d RGB, %s, %d thread%s\n", what, image.spec().width, image.spec().height,
                name_of(format), threads, threads == 1 ? "" : "s");
}

void print_ratio(const Times& sorted) {
    const size_t n = sorted.size(), quarter = n / 4;
    char text[48];
    std::snprintf(text, sizeof text, "%.2f %.2f-%.2f", median(sorted), sorted[quarter],
                  sorted[n - 1 - quarter]);
    std::printf(" %15s", text);
}

} // namespace speed

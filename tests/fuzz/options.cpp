// SPDX-License-Identifier: Apache-2.0
// Specifications of filters: what parses passes the check, prints as it was set, and parses again
// to the same; what does not leaves the options as they were.
#include "ddt/option_table.h"
#include "tests/fuzz/require.h"

using namespace ddt;
using namespace ddt::fuzz;

namespace {

std::string print(const FilterOptions& options) {
    std::string text;
    for (const Option& option : option_table())
        text += std::string(option.key) + "=" + option.get(options) + ",";
    return text;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
    const std::string spec(data, data + size);
    FilterOptions options;
    const std::string before = print(options);
    std::string error;
    if (!parse_filter(spec, options, error)) {
        require_error_line(error);
        require(print(options) == before, "a failure changes nothing");
        return 0;
    }
    require(is_filter_name(spec), "what parses is a filter's name");
    require(check_options(options, error), "what parses is allowed: " + error);
    FilterOptions again;
    for (const Option& option : option_table()) {
        const std::string text = option.get(options);
        require(text.find(',') == std::string::npos, "a value has no comma");
        require(option.set(again, text), std::string(option.key) + "=" + text + " is taken");
    }
    require(print(again) == print(options), "the same comes back");
    return 0;
}

// SPDX-License-Identifier: Apache-2.0
#include "ddt/resize.h"
#include "plugin/message/format.h"
#include "rows.h"

namespace bench {

namespace {

const std::string to_integers = " to integers";

} // namespace

Row ddt_row(const std::string& name, Light light) {
    std::string specification = name;
    OIIO::TypeDesc type = OIIO::TypeFloat;
    if (name.size() > to_integers.size() &&
        name.compare(name.size() - to_integers.size(), std::string::npos, to_integers) == 0) {
        specification.resize(name.size() - to_integers.size());
        type = OIIO::TypeUInt16;
    }
    ddt::Options options;
    std::string error;
    if (!ddt::parse_filter(specification, options, error))
        return {name, [error](const OIIO::ImageBuf&, int) {
                    OIIO::ImageBuf failed;
                    ddt::set_error(failed, error);
                    return failed;
                }};
    options.light = light == Light::linear ? "auto" : "encoded";
    return {name, [options, type](const OIIO::ImageBuf& image, int scale) {
                OIIO::ImageSpec spec = image.spec();
                spec.width = spec.full_width = image.spec().width * scale;
                spec.height = spec.full_height = image.spec().height * scale;
                spec.set_format(type);
                OIIO::ImageBuf result(spec);
                ddt::resize(result, image, options);
                return result;
            }};
}

std::vector<Row> ddt_rows(Light light) {
    std::vector<Row> rows;
    for (const std::string& name : ddt::filter_names())
        rows.push_back(ddt_row(name, light));
    if (light != Light::scene) // which integers cannot hold
        rows.push_back(ddt_row("ddt-sharp" + to_integers, light));
    return rows;
}

} // namespace bench

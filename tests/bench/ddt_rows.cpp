#include "ddt/resize.h"
#include "rows.h"

namespace bench {

Row ddt_row(const std::string& specification, Light light) {
    ddt::Options options;
    std::string error;
    if (!ddt::parse_filter(specification, options, error))
        return {specification, [error](const OIIO::ImageBuf&, int) {
                    OIIO::ImageBuf failed;
                    failed.errorfmt("{}", error);
                    return failed;
                }};
    options.light = light == Light::linear ? "auto" : "encoded";
    return {specification, [options](const OIIO::ImageBuf& image, int scale) {
                OIIO::ROI roi(0, image.spec().width * scale, 0, image.spec().height * scale, 0, 1,
                              0, 3);
                OIIO::ImageBuf result;
                ddt::resize(result, image, options, roi);
                return result;
            }};
}

std::vector<Row> ddt_rows(Light light) {
    std::vector<Row> rows;
    for (const std::string& name : ddt::filter_names())
        rows.push_back(ddt_row(name, light));
    return rows;
}

} // namespace bench

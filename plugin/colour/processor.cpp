// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/processor.h"

#include <algorithm>
#include <cmath>

namespace ddt {
namespace {

namespace OCIO = OCIO_NAMESPACE;

double determinant(const Matrix& m) {
    return m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) +
           m[2] * (m[3] * m[7] - m[4] * m[6]);
}

} // namespace

OCIO::ConstCPUProcessorRcPtr processor_of(const OCIO::ConstConfigRcPtr& config,
                                          const OCIO::ConstTransformRcPtr& transform,
                                          OCIO::TransformDirection direction) {
    return config->getProcessor(transform, direction)
        ->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_F32,
                                   OCIO::OPTIMIZATION_LOSSLESS);
}

void run(const OCIO::ConstCPUProcessorRcPtr& processor, float* rgb, size_t count) {
    OCIO::PackedImageDesc pixels(rgb, long(count), 1, 3);
    processor->apply(pixels);
}

std::array<float, 3> run(const OCIO::ConstCPUProcessorRcPtr& processor, std::array<float, 3> rgb) {
    run(processor, rgb.data(), 1);
    return rgb;
}

Matrix primaries(const OCIO::ConstCPUProcessorRcPtr& processor) {
    const Matrix unit{1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::array<float, 3> black = run(processor, {0, 0, 0});
    Matrix m{};
    for (size_t c = 0; c < 3; ++c) {
        std::array<float, 3> pure{0, 0, 0};
        pure[c] = 1;
        const std::array<float, 3> out = run(processor, pure);
        for (size_t r = 0; r < 3; ++r)
            m[3 * r + c] = double(out[r]) - double(black[r]);
    }
    const bool is_unit = std::equal(m.begin(), m.end(), unit.begin(),
                                    [](double a, double b) { return std::fabs(a - b) <= 1e-6; });
    const double det = determinant(m);
    return is_unit || !std::isfinite(det) || std::fabs(det) < 1e-9 ? unit : m;
}

OCIO::MatrixTransformRcPtr matrix_transform(const Matrix& m, OCIO::TransformDirection direction) {
    auto transform = OCIO::MatrixTransform::Create();
    const double m44[16] = {m[0], m[1], m[2], 0, m[3], m[4], m[5], 0,
                            m[6], m[7], m[8], 0, 0,    0,    0,    1};
    transform->setMatrix(m44);
    transform->setDirection(direction);
    return transform;
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
// Conversions of packed float RGB by OpenColorIO's processors, and the matrices among them.
#pragma once

#include <array>
#include <cstddef>

#include <OpenColorIO/OpenColorIO.h>

namespace ddt {

using Matrix = std::array<double, 9>; ///< row by row

/// Lossless: no approximations of pow, so that machines agree as far as their libm does. Throws
/// OCIO::Exception, as do all that make processors.
OCIO_NAMESPACE::ConstCPUProcessorRcPtr
processor_of(const OCIO_NAMESPACE::ConstConfigRcPtr& config,
             const OCIO_NAMESPACE::ConstTransformRcPtr& transform,
             OCIO_NAMESPACE::TransformDirection direction);

/// Convert `count` packed triples in place.
void run(const OCIO_NAMESPACE::ConstCPUProcessorRcPtr& processor, float* rgb, size_t count);
std::array<float, 3> run(const OCIO_NAMESPACE::ConstCPUProcessorRcPtr& processor,
                         std::array<float, 3> rgb);

/// The matrix that an otherwise separable conversion ends with: what it makes of pure red, green
/// and blue, above black. The unit matrix when it has no such meaning or is all but that.
Matrix primaries(const OCIO_NAMESPACE::ConstCPUProcessorRcPtr& processor);

OCIO_NAMESPACE::MatrixTransformRcPtr matrix_transform(const Matrix& m,
                                                      OCIO_NAMESPACE::TransformDirection direction);

} // namespace ddt

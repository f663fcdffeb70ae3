// SPDX-License-Identifier: Apache-2.0
// The OpenColorIO config that the project carries: the colour spaces images commonly say they are
// in, for machines where neither the user nor OpenColorIO provides one. Curves are extended oddly
// below zero, so that conversions have an inverse everywhere.
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace ddt {

/// Called under colour_lock(). Throws OCIO::Exception.
OCIO_NAMESPACE::ConstConfigRcPtr bundled_config();

/// number^gamma, as its curves are.
OCIO_NAMESPACE::TransformRcPtr mirrored_power(double gamma);

} // namespace ddt

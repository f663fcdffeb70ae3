// SPDX-License-Identifier: Apache-2.0
// The config that comes with OpenColorIO.
#pragma once

#include <OpenColorIO/OpenColorIO.h>

namespace ddt {

/// OpenColorIO's default config, which is another in each of its versions; null before 2.2. Called
/// under colour_lock(). Throws OCIO::Exception.
OCIO_NAMESPACE::ConstConfigRcPtr ocio_builtin_config();

} // namespace ddt

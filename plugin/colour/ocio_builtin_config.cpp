// SPDX-License-Identifier: Apache-2.0
#include "plugin/colour/ocio_builtin_config.h"

namespace ddt {

// A file of its own, so that a test can put another config in its place.
OCIO_NAMESPACE::ConstConfigRcPtr ocio_builtin_config() {
#if OCIO_VERSION_HEX >= 0x02020000
    // Never destroyed: hosts may resize while static objects are being torn down.
    static const auto* config = new OCIO_NAMESPACE::ConstConfigRcPtr(
        OCIO_NAMESPACE::Config::CreateFromBuiltinConfig("ocio://default"));
    return *config;
#else
    return nullptr;
#endif
}

} // namespace ddt

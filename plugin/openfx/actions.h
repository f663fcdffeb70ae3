// SPDX-License-Identifier: Apache-2.0
// What the effect does when the host asks. Each returns a Status.
#pragma once

#include "plugin/openfx/abi.h"

namespace ddt::ofx {

int describe(Effect effect);
/// Of the contexts Filter and General; a Status that says so for others.
int describe_in_context(Effect effect, Properties in);
int region_of_definition(Effect effect, Properties in, Properties out);
int regions_of_interest(Effect effect, Properties in, Properties out);
int is_identity(Effect effect, Properties in, Properties out);
int render(Effect effect, Properties in);

/// What an action returns that cannot go on as a call of the host's failed: actions may return no
/// more than these two.
inline int failure(int status_of_call) {
    return status_of_call == out_of_memory ? out_of_memory : failed;
}

/// True in hosts whose effects cannot change the size of the picture.
bool zooms();

} // namespace ddt::ofx

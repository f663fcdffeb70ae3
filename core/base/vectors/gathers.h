// SPDX-License-Identifier: Apache-2.0
// How a processor had best read words from places that are lanes of a vector.
#pragma once

namespace ddt {

/// Whether this processor gathers words sooner than it loads them one by one, which gives the same
/// bits: Intel's do that are not slowed against Gather Data Sampling, those since Alder Lake and
/// Sapphire Rapids. docs/speed.md, "Gathers or loads".
bool gathers_are_quick();

/// Have it be so, or not, from now on: for tests of both.
void set_gathers_are_quick(bool quick);

} // namespace ddt

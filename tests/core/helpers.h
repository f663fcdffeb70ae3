// SPDX-License-Identifier: Apache-2.0
// What most tests of the core share.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/differing.h"
#include "tests/core/each_target.h"
#include "tests/core/guides.h"
#include "tests/core/lattice/faces.h"
#include "tests/core/lattice/flipping.h"
#include "tests/core/lattice/is_triangulation.h"
#include "tests/core/lattice/positions.h"
#include "tests/core/lists.h"
#include "tests/core/plain.h"
#include "tests/core/random.h"
#include "tests/core/random_values.h"

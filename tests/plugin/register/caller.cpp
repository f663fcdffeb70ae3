// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/register/answer.h"

extern "C" DDT_TEST_EXPORT int call_answer() {
    return answer();
}

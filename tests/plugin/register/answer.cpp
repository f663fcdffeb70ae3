// SPDX-License-Identifier: Apache-2.0
#include "tests/plugin/register/answer.h"

int answer() {
    return 42;
}

int answer_from_within() {
    return answer();
}

static int (*const pointer)() = answer;

int answer_by_pointer() {
    // Volatile: the compiler shall read the pointer, not take its value as known.
    int (*const volatile* place)() = &pointer;
    return (*place)();
}

const void* pointer_address() {
    return &pointer;
}

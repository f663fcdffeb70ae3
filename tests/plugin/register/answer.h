// SPDX-License-Identifier: Apache-2.0
// Two shared libraries for got_test: one defines a function, the other calls it.
#pragma once

#define DDT_TEST_EXPORT __attribute__((visibility("default")))

extern "C" {

/// 42, if nobody redirects it.
DDT_TEST_EXPORT int answer();

/// answer(), called within the library that defines it.
DDT_TEST_EXPORT int answer_from_within();

/// answer(), through a pointer in that library's read-only data, and where the pointer is.
DDT_TEST_EXPORT int answer_by_pointer();
DDT_TEST_EXPORT const void* pointer_address();
}

/// The type of caller.cpp's call_answer(): answer(), called from another library.
using CallAnswer = int();

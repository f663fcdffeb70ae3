// SPDX-License-Identifier: Apache-2.0
// The functions of OpenImageIO that are redirected, and what stands in for them.
//
// A stand-in takes over when it is given one of our filters and otherwise calls the function that
// it stands in for: this module's own calls are not redirected (see got.h).
#pragma once

#include <string>
#include <vector>

#include "plugin/register/got.h"

namespace ddt {

using Redirects = std::vector<got::Redirect>;

/// `from` may name a set of overloads: `to` chooses among them.
template <typename F>
void add(Redirects& list, const char* label, F* from, F* to) {
    list.push_back({label, reinterpret_cast<void*>(from), reinterpret_cast<void*>(to)});
}

/// Filter2D's list of filters and their creation: --help, maketx and others follow.
void add_filter_list(Redirects& list);

/// ImageBufAlgo's functions that take filters: all of the following.
void add_algorithms(Redirects& list);
void add_warp(Redirects& list);
void add_rotate(Redirects& list);
void add_st_warp(Redirects& list);

/// Redirect all of them, once, and keep what that changed.
void redirect_all();

/// False if OpenImageIO's own calls of its algorithms do not reach ours: it was linked with
/// -Bsymbolic-functions.
bool own_calls_redirected();

/// What redirect_all() changed and what it could not, a line each, for people.
std::string describe_redirects();

} // namespace ddt

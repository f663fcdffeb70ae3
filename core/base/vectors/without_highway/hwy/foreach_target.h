// SPDX-License-Identifier: Apache-2.0
// Stands in for Highway's header of this name (highway.h beside this says for what): there is one
// target, so the file that includes this is compiled once.
#pragma once

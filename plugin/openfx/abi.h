// SPDX-License-Identifier: Apache-2.0
// The part of OpenFX's C interface that the effect uses, in own words: the interface itself is
// tables of functions of version 1, status numbers and strings (openeffects.org, API 1.4).
#pragma once

namespace ddt::ofx {

// Handles, of which only the host knows what is behind.
using Properties = struct PropertiesBehind*;
using Effect = struct EffectBehind*;
using Clip = struct ClipBehind*;
using ParamSet = struct ParamSetBehind*;
using Param = struct ParamBehind*;

enum Status : int {
    ok = 0,
    failed = 1,
    missing_host_feature = 4,
    out_of_memory = 8,
    bad_handle = 9,
    reply_no = 13,
    reply_default = 14, ///< the host is to do what it does by itself
};

struct RectD {
    double x1, y1, x2, y2;
};

/// What a host hands over before the first action.
struct Host {
    Properties host;
    const void* (*fetch_suite)(Properties host, const char* name, int version);
};

using Entry = int (*)(const char* action, const void* handle, Properties in, Properties out);

struct Plugin {
    const char* api;
    int api_version;
    const char* identifier;
    unsigned major, minor;
    void (*set_host)(Host*);
    Entry main_entry;
};

struct PropertySuite {
    int (*set_pointer)(Properties, const char*, int, void*);
    int (*set_string)(Properties, const char*, int, const char*);
    int (*set_double)(Properties, const char*, int, double);
    int (*set_int)(Properties, const char*, int, int);
    void* set_n[4];
    int (*get_pointer)(Properties, const char*, int, void**);
    int (*get_string)(Properties, const char*, int, char**);
    int (*get_double)(Properties, const char*, int, double*);
    int (*get_int)(Properties, const char*, int, int*);
    void* get_n[4];
    void* reset;
    int (*get_dimension)(Properties, const char*, int*);
};

struct EffectSuite {
    int (*get_property_set)(Effect, Properties*);
    int (*get_param_set)(Effect, ParamSet*);
    int (*clip_define)(Effect, const char*, Properties*);
    int (*clip_get_handle)(Effect, const char*, Clip*, Properties*);
    int (*clip_get_property_set)(Clip, Properties*);
    int (*clip_get_image)(Clip, double time, const RectD*, Properties*);
    int (*clip_release_image)(Properties);
    int (*clip_get_region_of_definition)(Clip, double time, RectD*);
    int (*abort)(Effect);
    void* memory[4];
};

struct ParamSuite {
    int (*define)(ParamSet, const char* type, const char* name, Properties*);
    int (*get_handle)(ParamSet, const char*, Param*, Properties*);
    int (*set_get_property_set)(ParamSet, Properties*);
    int (*get_property_set)(Param, Properties*);
    int (*get_value)(Param, ...);
    int (*get_value_at_time)(Param, double time, ...);
    void* rest[11];
};

struct ProgressSuite {
    int (*start)(void* effect, const char* label);
    int (*update)(void* effect, double share);
    int (*end)(void* effect);
};

struct MultiThreadSuite {
    void* multi_thread;
    int (*number_of_cpus)(unsigned int* cpus);
    void* rest[7];
};

struct MessageSuite {
    int (*message)(void* handle, const char* type, const char* id, const char* format, ...);
};

} // namespace ddt::ofx

// SPDX-License-Identifier: Apache-2.0
// The two functions that hosts look for, and the way from actions to what is done.
#include <string_view>

#include "core/base/guarded.h"
#include "plugin/openfx/actions.h"
#include "plugin/openfx/suites.h"

namespace ddt::ofx {
namespace {

int act(std::string_view action, Effect effect, Properties in, Properties out) {
    if (action == "OfxActionLoad") {
        load_suites();
        return suites.complete() ? ok : missing_host_feature;
    }
    if (action == "OfxActionUnload") {
        Host* host = suites.host;
        suites = {};
        suites.host = host;
        return ok;
    }
    if (!suites.complete())
        return failed; // no Load before
    if (action == "OfxActionCreateInstance" || action == "OfxActionDestroyInstance")
        return ok; // instances have no state
    if (!effect)
        return action.substr(0, 3) == "Ofx" ? int(reply_default) : int(bad_handle);
    if (action == "OfxActionDescribe")
        return describe(effect);
    if (action == "OfxImageEffectActionDescribeInContext")
        return describe_in_context(effect, in);
    if (action == "OfxImageEffectActionGetRegionOfDefinition")
        return region_of_definition(effect, in, out);
    if (action == "OfxImageEffectActionGetRegionsOfInterest")
        return regions_of_interest(effect, in, out);
    if (action == "OfxImageEffectActionIsIdentity")
        return is_identity(effect, in, out);
    if (action == "OfxImageEffectActionRender")
        return render(effect, in);
    return reply_default;
}

/// Nothing may be thrown into the host.
int entry(const char* action, const void* handle, Properties in, Properties out) {
    int status = failed;
    const Caught caught = guarded_call(nullptr, [&] {
        status = act(action ? action : "", static_cast<Effect>(const_cast<void*>(handle)), in, out);
    });
    return caught == Caught::out_of_memory ? out_of_memory
           : caught == Caught::nothing     ? status
                                           : failed;
}

void set_host(Host* host) {
    suites.host = host;
}

Plugin plugin = {"OfxImageEffectPluginAPI", 1, "oiio-ddt:Enlarge", 1, 0, set_host, entry};

} // namespace
} // namespace ddt::ofx

#define DDT_SHOWN __attribute__((visibility("default")))

extern "C" {
DDT_SHOWN int OfxGetNumberOfPlugins();
DDT_SHOWN ddt::ofx::Plugin* OfxGetPlugin(int index);

int OfxGetNumberOfPlugins() {
    return 1;
}
ddt::ofx::Plugin* OfxGetPlugin(int index) {
    return index == 0 ? &ddt::ofx::plugin : nullptr;
}
}

// SPDX-License-Identifier: Apache-2.0
#include "plugin/register/hooks.h"

namespace ddt {
namespace {

/// What one list of functions came to.
struct Done {
    size_t asked = 0;
    got::Report report;
};
Done filters, algorithms;

void redirect(void (*fill)(Redirects&), Done& done) {
    Redirects list;
    fill(list);
    done.asked = list.size();
    done.report = got::redirect(list.data(), list.size());
}

std::string number(int n, const char* what) {
    return std::to_string(n) + " " + what + (n == 1 ? "" : "s");
}

std::string describe(const char* what, const Done& done) {
    const got::Report& r = done.report;
    std::string text = std::to_string(done.asked - size_t(r.missed)) + " of " +
                       number(int(done.asked), what) + " redirected in " +
                       number(r.slots, "place") + " and " + number(r.exports, "symbol");
    if (r.missed)
        text += "; missed: " + number(r.missed, "function") + ", one of them " + r.last_missed;
    if (r.refused)
        text += "; missed: " + number(r.refused, "place") + " that the system keeps locked";
    if (r.others)
        text +=
            std::string("; missed: the same in ") + r.other + (r.others > 1 ? " and others" : "");
    return text + "\n";
}

} // namespace

void redirect_all() {
    redirect(add_filter_list, filters);
    redirect(add_algorithms, algorithms);
}

bool own_calls_redirected() {
    return algorithms.report.own_slots > 0;
}

std::string describe_redirects() {
    std::string text = describe("filter function", filters);
    text += describe("ImageBufAlgo function", algorithms);
    const bool by_another = algorithms.report.missed == int(algorithms.asked);
    if (!own_calls_redirected() && !by_another)
        text += "missed: calls within OpenImageIO, which is linked with -Bsymbolic-functions: "
                "maketx cannot use these filters\n";
    return text;
}

} // namespace ddt

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/part_job.h"

#include <algorithm>
#include <set>

#include "plugin/message/format.h"
#include "plugin/tool/file/check_image.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/part/fingerprint.h"

namespace ddt::tool {

namespace {

constexpr int cache_megabytes = 192;

bool check_part(const OIIO::ImageSpec& from, const OIIO::ImageSpec& to, const Grid& grid,
                const Part& part, Failure& failure) {
    const std::vector<std::string>& names = from.channelnames;
    if (to.full_width < from.full_width || to.full_height < from.full_height)
        failure = {"--part is for enlarging; allowed are sizes of " +
                       format("{} x {} and more", from.full_width, from.full_height),
                   exit_usage};
    else if (part.count > grid.count())
        failure = {format("--part {}/{} is not allowed; allowed are at most {} parts of this image",
                          part.index, part.count, grid.count()),
                   exit_usage};
    else if (stored_type(to.format) == OIIO::TypeUnknown)
        failure = {format("pixels of {} cannot be kept in parts; choose another --type",
                          to.format.c_str()),
                   exit_usage};
    else if (std::set<std::string>(names.begin(), names.end()).size() < names.size())
        failure = {"several channels have one name, which cannot be kept in parts"};
    else if (const auto name = std::find_if_not(names.begin(), names.end(), is_kept_name);
             name != names.end())
        failure = {"the name of the channel \"" + *name +
                   "\" has a line break, which cannot be kept in parts; allowed are names in one "
                   "line"};
    else
        return true;
    return false;
}

} // namespace

PartJob::PartJob(const std::string& in)
    : path(in), state(in), file(in, 0, {cache_megabytes, true}) {}

bool PartJob::plan(const ResizeSettings& settings, const Part& part, Failure& failure) {
    if (!begin_image(path, 0, file.image(), failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    // Of whose image neither the bytes nor the time of its last change are looked at.
    if (image().file_format_name() == "ddt") {
        failure = {"\"" + path + "\" asks for another image, enlarged; --part needs that image",
                   exit_usage};
        return false;
    }
    if (!check_image(image(), image_name(path), settings.options, failure))
        return false;
    if (!file.make_room(settings.threads, failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    from = spec_of_file(image());
    if (!plan_result(from, settings, whole, failure))
        return false;
    if (!check_part(from, whole, grid(), part, failure))
        return false;
    const std::string job = fingerprint(path, from, whole, settings, failure);
    if (job.empty())
        return false;
    header = header_of(job, part, whole);
    return true;
}

} // namespace ddt::tool

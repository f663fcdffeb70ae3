// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/resize/resize_file.h"

#include <algorithm>
#include <memory>
#include <vector>

#include <OpenImageIO/filesystem.h>

#include "core/tiles/crew_size.h"
#include "ddt/devices.h"
#include "plugin/image/lazy_file.h"
#include "plugin/image/oiio_defects.h"
#include "plugin/image/prepare.h"
#include "plugin/image/reading.h"
#include "plugin/imagebuf/resize.h"
#include "plugin/message/format.h"
#include "plugin/tool/command/command.h"
#include "plugin/tool/file/check_image.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/file/fit_format.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/ids/mixed_ids.h"
#include "plugin/tool/resize/exr_buffers.h"
#include "plugin/tool/resize/resize_image.h"

namespace ddt::tool {

namespace {

/// What a process has once.
constexpr int64_t memory_of_process = int64_t(56) << 20;

/// What an image becomes.
bool plan_image(const OIIO::ImageBuf& image, const std::string& name,
                const ResizeSettings& settings, OIIO::ImageSpec& spec, Failure& failure) {
    if (!check_image(image, name, settings.options, failure) ||
        !plan_result(spec_of_file(image), settings, spec, failure))
        return false;
    if (!enlarges(image.roi_full(), spec.roi_full()))
        return true;
    if (!check_device(settings.options.device, failure.why))
        return false;
    if (check_light(image.spec(), image.nativespec(), settings.options, failure.why))
        return true;
    // OpenColorIO may have had no memory for its config.
    failure.code = code_of_message(failure.why);
    failure.why = name + ": " + failure.why;
    return false;
}

/// What the images of a file become, of which the first is there.
bool plan_images(const std::string& in, const OIIO::ImageBuf& first, const ResizeSettings& settings,
                 std::vector<OIIO::ImageSpec>& specs, Failure& failure) {
    if (!plan_image(first, image_name(in), settings, specs[0], failure))
        return false;
    for (int number = 1; number < int(specs.size()); ++number) {
        const LazyFile other(in, number, {});
        if (!plan_image(other.image(), image_name(in, number), settings, specs[size_t(number)],
                        failure))
            return false;
    }
    return true;
}

/// Open the file for what of the results its format has room for: `specs` become that.
bool open_file(const std::string& path, std::vector<OIIO::ImageSpec>& specs, ImageFile& file,
               Failure& failure) {
    std::vector<std::string> left_out;
    if (!file.create(path, failure))
        return false;
    for (OIIO::ImageSpec& spec : specs) {
        if (!fit_format(file.output(), path, spec, failure))
            return false;
        left_out.push_back(fit_channels(file.output(), spec));
        if (!check_size_of(spec, failure))
            return false;
    }
    if (!file.open(specs, failure))
        return false;
    left_out.erase(std::unique(left_out.begin(), left_out.end()), left_out.end());
    for (const std::string& channels : left_out)
        note_left_out(path, channels);
    return true;
}

/// Write the results into `file`, all but its name.
bool write_results(const std::string& in, const std::string& out, const ResizeSettings& settings,
                   ImageFile& file, const ProgressCallback& progress, Failure& failure) {
    auto source = std::make_unique<ArrivingImage>(in, 0);
    if (!source->begin(failure))
        return false;
    // Before the file is open: writers complain by themselves when they get no pixels (PNG).
    std::vector<OIIO::ImageSpec> specs(settings.all_images ? size_t(std::max(1, count_images(in)))
                                                           : 1);
    if (!plan_images(in, source->image, settings, specs, failure))
        return false;
    std::vector<OIIO::ImageSpec> fitting = specs;
    if (!open_file(out, fitting, file, failure))
        return false;
    for (size_t i = 0; i < specs.size(); ++i) {
        const auto share = [&](float of_image) {
            return progress((float(i) + of_image) / float(specs.size()));
        };
        if (i > 0) {
            source = std::make_unique<ArrivingImage>(in, int(i));
            if (!source->begin(failure) || !file.open_next(failure))
                return false;
        }
        if (!resize_image(*source, OIIO::get_roi(specs[i]), fitting[i], file, settings, share,
                          failure))
            return false;
    }
    return true;
}

/// Bytes that an image of this spec and its result take, and what reads and writes them; 0 if that
/// cannot be told.
int64_t memory_of_image(OIIO::ImageSpec from, const std::string& format, const std::string& in,
                        const std::string& out, const ResizeSettings& settings) {
    OIIO::ImageSpec spec;
    Failure failure;
    if (!check_source_spec(from, failure.why) || !plan_result(from, settings, spec, failure))
        return 0;
    int64_t buffers = format == "openexr" ? exr_buffers(from, settings.threads) : 0;
    const auto writer = OIIO::ImageOutput::create(out);
    if (writer && writer->format_name() == std::string("openexr"))
        buffers += exr_buffers(spec, settings.threads);
    const int64_t ids =
        count_mixed_ids(from, spec) * int64_t(from.image_pixels() * sizeof(uint32_t));
    // Another format than the source's may not hold its numbers (see resize_image.cpp).
    if (!settings.type.empty() || !spec.channelformats.empty() ||
        OIIO::Filesystem::extension(in) != OIIO::Filesystem::extension(out))
        spec.set_format(OIIO::TypeFloat);
    if (is_associated_when_read(from))
        from.set_format(OIIO::TypeFloat);
    return int64_t(from.image_bytes() + spec.image_bytes()) + ids + buffers;
}

} // namespace

bool resize_file(const std::string& in, const std::string& out, const ResizeSettings& settings,
                 const ProgressCallback& progress, Failure& failure) {
    const FileState source(in);
    ImageFile file;
    if (!source.confirm(write_results(in, out, settings, file, progress, failure), failure))
        return false;
    const std::string type = file.output().spec().format.c_str();
    const std::vector<std::string> beside =
        settings.all_images ? levels_beside(in) : images_beside(in, "--all-images");
    if (!file.commit(failure))
        return false;
    note_instead(out, "type", settings.type, type);
    note_instead(out, "compression", settings.compression.substr(0, settings.compression.find(':')),
                 file.compression());
    note(beside);
    return true;
}

int64_t memory_to_resize(const std::string& in, const std::string& out,
                         const ResizeSettings& settings) {
    if (Failure ignored; !check_reader(in, 0, ignored))
        return 0;
    const auto file = OIIO::ImageInput::open(in);
    int64_t most = 0; // of the images, which follow one another
    for (int i = 0; file && file->seek_subimage(i, 0) && (i == 0 || settings.all_images); ++i) {
        const int64_t image = memory_of_image(file->spec(), file->format_name(), in, out, settings);
        if (image == 0)
            return 0;
        most = std::max(most, image);
    }
    if (most == 0)
        return 0;
    return most + int64_t(memory_limit(size_t(settings.threads), settings.options.mesh.meshes)) +
           memory_of_process;
}

} // namespace ddt::tool

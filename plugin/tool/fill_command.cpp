// SPDX-License-Identifier: Apache-2.0
#include <vector>

#include "plugin/image/channels.h"
#include "plugin/image/memory.h"
#include "plugin/image/metadata.h"
#include "plugin/image/pixels.h"
#include "plugin/image/windows.h"
#include "plugin/tool/command/filter_flag.h"
#include "plugin/tool/command/filter_keys.h"
#include "plugin/tool/command/progress.h"
#include "plugin/tool/command/threads.h"
#include "plugin/tool/commands.h"
#include "plugin/tool/file/check_image.h"
#include "plugin/tool/file/file_state.h"
#include "plugin/tool/file/fit_format.h"
#include "plugin/tool/file/image_file.h"
#include "plugin/tool/file/open_image.h"
#include "plugin/tool/file/other_images.h"
#include "plugin/tool/file/unassociated.h"
#include "plugin/tool/ids/lost_ids.h"
#include "plugin/tool/ids/mixed_ids.h"
#include "plugin/tool/resize/row_writer.h"

namespace ddt::tool {

namespace {

/// Of the image in the file's window, in memory.
OIIO::ImageSpec spec_in_window(const OIIO::ImageBuf& image, const OIIO::ImageSpec& file) {
    OIIO::ImageSpec spec = file;
    spec.set_format(image.spec().format);
    forget_tiles(spec);
    return spec;
}

/// Decide on what of the image the file's format has room for, each channel in the type it had. Its
/// window may be another than the image's, and of any size: it is asked for before the work.
bool plan_file(const OIIO::ImageBuf& image, const std::string& path, ImageFile& file,
               OIIO::ImageSpec& spec, Failure& failure) {
    spec = spec_of_file(image);
    forget_pixels(spec);
    if (!fit_format(file.output(), path, spec, failure))
        return false;
    const std::string left_out = fit_channels(file.output(), spec);
    if (spec.roi() != image.roi() && !check_size_of(spec_in_window(image, spec), failure))
        return false;
    note_left_out(path, left_out);
    return true;
}

/// Have the image as its file does, if that and the result's format keep colour unassociated: the
/// products with alpha that were read are rounded, and what is there is to stay as it is. Then
/// `image` becomes associated floats.
bool read_unassociated(const std::string& path, ImageFile& file, OIIO::ImageBuf& image,
                       Unassociated& in_file, Failure& failure) {
    if (std::string(image.file_format_name()) != file.output().format_name() ||
        !may_be_unassociated(image))
        return true;
    if (!in_file.read(path, failure.why)) {
        failure = unreadable(path, failure.why);
        return false;
    }
    if (!in_file || in_file.associate(image, failure.why))
        return true;
    failure.code = code_of_message(failure.why);
    return false;
}

/// The image in the file's window, black where it has no pixels. (OpenImageIO's crop() ends the
/// program where there is no memory.)
bool put_in_window(const OIIO::ImageBuf& image, const OIIO::ImageSpec& file, OIIO::ImageBuf& put,
                   Failure& failure) {
    if (!make_image(put, spec_in_window(image, file), failure.why)) {
        failure.code = code_of_message(failure.why);
        return false;
    }
    const Rect both = intersection(rect_of(image.roi()), rect_of(put.roi()));
    const OIIO::TypeDesc type = image.spec().format;
    if (both.empty())
        return true;
    std::vector<char> row(size_t(both.width()) * type.size() * size_t(put.nchannels()));
    for (int y = both.y0; y < both.y1; ++y) {
        const Rect r{both.x0, y, both.x1, y + 1};
        if (!read_pixels(image, r, 0, put.nchannels(), type, row.data(), failure.why))
            return false;
        write_pixels(put, r, 0, put.nchannels(), type, row.data());
    }
    return true;
}

/// Write the filled image as the file has it, all but its name: in its window, with the IDs that
/// are not to be filled.
bool write_filled(const OIIO::ImageBuf& filled, const OIIO::ImageSpec& spec,
                  const OIIO::ImageSpec& of_file, MixedIds& ids, ImageFile& file,
                  Failure& failure) {
    const bool whole = spec.roi() == filled.roi();
    OIIO::ImageBuf put;
    if (!whole && !put_in_window(filled, spec, put, failure))
        return false;
    const OIIO::ImageBuf& image = whole ? filled : put;
    if (!file.open(spec, failure))
        return false;
    note_lost_ids(of_file, file.output().spec(), file.path());
    RowWriter writer(image, file, ids);
    writer.ready(image.yend());
    return writer.finish({}, failure);
}

class FillCommand final : public Command {
public:
    FillCommand() {
        name = "fill";
        summary = "Fill the missing pixels of an image";
        paragraphs = {
            "Pixels that are missing, those with a NaN, are interpolated over triangles of the "
            "pixels about them, whose edges are flipped so that the image's own edges run on "
            "across the hole; more than a pixel inside they are smoothed where there are no edges. "
            "All other pixels stay as they are (of PNG, TIFF and TGA with alpha where both files "
            "are of one format). Beyond the outermost pixels that are there the nearest goes on. "
            "Of a file with several images the first is taken. The filter's scheme one-round, "
            "which is meant for pictures, is look-ahead here; its min_gain does not count."};
        operands = {{"IN", "any image OpenImageIO reads"}, {"OUT", "any image OpenImageIO writes"}};
        flags = {
            choice_flag("--missing", {"nan", "alpha"},
                        "what is missing besides pixels with a NaN: nothing (nan), or those whose "
                        "alpha is 0 (default: nan; with the filter's holes=fill-alpha alpha, where "
                        "the image has one)",
                        m_missing),
            filter_flag(
                "how to flip edges, as the filter's name and options: ddt,scheme=lawson,cost=jnd",
                m_options, m_filter_error, nullptr, fill_keys()),
        };
    }

    ExitCode run(const std::vector<std::string>& values) override {
        if (!m_filter_error.empty())
            return fail(m_filter_error, exit_usage);
        planned_threads(0); // fill() asks for no more than may be at work
        const FileState source(values[0]);
        ImageFile file;
        Failure failure;
        if (!source.confirm(fill(values[0], values[1], file, failure), failure))
            return fail(failure);
        const std::vector<std::string> beside = images_beside(values[0]);
        if (!file.commit(failure))
            return fail(failure);
        note(beside);
        return exit_done;
    }

private:
    /// Fill the image of one file into the other, all but its name.
    bool fill(const std::string& in, const std::string& out, ImageFile& file,
              Failure& failure) const {
        OIIO::ImageBuf image, filled;
        if (!open_image(in, image, failure.why)) {
            failure = unreadable(in, failure.why);
            return false;
        }
        if (!check_image(image, image_name(in), m_options, failure))
            return false;
        if (m_missing == "alpha" && channels_of(image.spec(), image.nativespec()).alpha < 0) {
            failure = {"\"" + in + "\" has no alpha"};
            return false;
        }
        const bool by_filter = m_missing.empty() && m_options.holes == Holes::fill_alpha;
        const Missing missing = m_missing == "alpha" || by_filter ? Missing::alpha : Missing::nan;
        Unassociated in_file;
        if (!file.create(out, failure) || !read_unassociated(in, file, image, in_file, failure))
            return false;
        const OIIO::ImageBuf& shown = in_file ? in_file.image() : image;
        OIIO::ImageSpec spec;
        if (!plan_file(shown, out, file, spec, failure))
            return false;
        MixedIds ids(in, 0, image, spec);
        if ((ids && !ids.put_into(image, failure.why)) ||
            !fill_pixels(image, missing, filled, failure.why)) {
            failure.code = code_of_message(failure.why);
            return false;
        }
        if (in_file)
            in_file.put(image, filled);
        return write_filled(in_file ? in_file.image() : filled, spec, shown.nativespec(), ids, file,
                            failure);
    }

    bool fill_pixels(const OIIO::ImageBuf& image, Missing missing, OIIO::ImageBuf& filled,
                     std::string& error) const {
        Progress progress("filling");
        Options options = m_options;
        options.progress = std::ref(progress);
        if (ddt::fill(filled, image, options, missing))
            return true;
        error = filled.geterror();
        return false;
    }

    Options m_options;
    std::string m_missing, m_filter_error;
};

} // namespace

std::unique_ptr<Command> make_fill_command() {
    return std::make_unique<FillCommand>();
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/image_file.h"

#include <algorithm>
#include <cstring>
#include <vector>

#include <linux/magic.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <OpenImageIO/strutil.h>

#include "plugin/image/oiio_defects.h"
#include "plugin/message/format.h"
#include "plugin/tool/file/fit_format.h"
#include "plugin/tool/file/format_limits.h"
#include "plugin/tool/file/readable_pixels.h"
#include "plugin/tool/file/reading_errors.h"
#include "plugin/tool/file/truncated.h"

namespace ddt::tool {

namespace {

/// The JPEG library ends the program when a write to a FILE* of its own fails; OpenImageIO gives it
/// one of streams that say they are files.
class Stream final : public OIIO::Filesystem::IOFile {
public:
    explicit Stream(std::FILE* file) : IOFile(file, Write) {}
    const char* proxytype() const override { return "whole file"; }
};

/// Formats that leave no file to be read.
bool is_file_format(const std::string& format) {
    return format != "null" && format != "term";
}

bool is_regular(std::FILE* file) {
    struct stat there {};
    return fstat(fileno(file), &there) == 0 && S_ISREG(there.st_mode);
}

/// Whether there are parts of a file, from one place on, that take no room.
bool has_holes(std::FILE* file, off_t begin) {
    struct stat there {};
    const off_t hole = lseek(fileno(file), begin, SEEK_HOLE);
    return hole >= 0 && fstat(fileno(file), &there) == 0 && hole < there.st_size;
}

/// From where on no part of a file is left out. FITS's writer leaves out a row before the first, as
/// its reader does (OpenImageIO 2.4.7), and the pixels come last.
off_t begin_of_what_is_written(std::FILE* file, const OIIO::ImageOutput& output) {
    struct stat there {};
    if (output.format_name() != std::string("fits") || fstat(fileno(file), &there) != 0)
        return 0;
    return std::max<off_t>(0, there.st_size - off_t(output.spec().image_bytes()));
}

/// OpenImageIO's DPX reader takes the sides of a turned image for each other, and mixes its rows.
std::string why_sides_are_swapped(const OIIO::ImageSpec& asked, const OIIO::ImageSpec& made) {
    const int orientation = asked.get_int_attribute("Orientation", 1);
    if (orientation < 5 || made.width != asked.height || made.height != asked.width)
        return "";
    return format(", whose Orientation is {}; upright ones can be written (oiiotool --reorient)",
                  orientation);
}

/// Whether a file's system is known to make no holes of zeros that were written. ZFS does, over NFS
/// or under another too.
bool keeps_zeros(std::FILE* file) {
    struct statfs system {};
    if (fstatfs(fileno(file), &system) != 0)
        return false;
    switch (uint32_t(system.f_type)) {
    case EXT4_SUPER_MAGIC:
    case XFS_SUPER_MAGIC:
    case BTRFS_SUPER_MAGIC:
    case F2FS_SUPER_MAGIC:
    case TMPFS_MAGIC:
        return true;
    default:
        return false;
    }
}

/// Whether parts of a file were never written. A writer that goes from row to row of a full disk
/// (SGI, RLA, FITS) leaves them, and they read as zeros.
bool was_left_out(std::FILE* file, const OIIO::ImageOutput& output) {
    return has_holes(file, begin_of_what_is_written(file, output)) && keeps_zeros(file);
}

} // namespace

bool ImageFile::create(const std::string& path, Failure& failure) {
    m_path = path;
    if (path.empty()) {
        failure = {"\"\" is no name of a file"};
        return false;
    }
    if (path.find('?') != std::string::npos) {
        failure = {"cannot write \"" + path +
                   "\": OpenImageIO takes what follows a ? in a name for arguments, and would not "
                   "find it again"};
        return false;
    }
    m_output = OIIO::ImageOutput::create(path);
    if (!m_output) {
        const std::string why(OIIO::Strutil::strip(OIIO::geterror()));
        // Nothing is said of what a writer throws as it begins.
        failure = why.empty()
                      ? Failure{"cannot write \"" + path + "\": out of memory or of threads",
                                exit_resources}
                      : Failure{why};
        return false;
    }
    return m_whole.open(path, failure) && check_stream(failure);
}

/// Before anything is made: whoever reads from a pipe has what was written, right or wrong.
bool ImageFile::check_stream(Failure& failure) const {
    const std::string type = m_output->format_name();
    if (m_whole.can_seek() || may_be_streamed(type) || !is_file_format(type))
        return true;
    failure = {
        format("cannot write \"{}\": it is a stream, such as a pipe, and the format {} needs a "
               "file; allowed are {}",
               m_path, type, OIIO::Strutil::join(streamed_formats, ", ")),
        exit_usage};
    return false;
}

/// Look for what the format's writer does not.
bool ImageFile::check_allowed(const OIIO::ImageSpec& spec, Failure& failure) const {
    const std::string type = m_output->format_name();
    if (const int most = largest_side_of(type);
        most > 0 && std::max(spec.width, spec.height) > most) {
        failure = {format(
            "cannot write \"{}\": {} x {} pixels are too many for the format {}; allowed are {} a "
            "side",
            m_path, spec.width, spec.height, type, most)};
        return false;
    }
    if (const char* allowed = other_channels(type, spec.nchannels)) {
        failure = {format(
            "cannot write \"{}\": the format {} has no {} channels ({}); allowed are {}", m_path,
            type, spec.nchannels, OIIO::Strutil::join(spec.channelnames, ", "), allowed)};
        return false;
    }
    return true;
}

bool ImageFile::open(std::vector<OIIO::ImageSpec> specs, Failure& failure) {
    m_specs = std::move(specs);
    m_current = 0;
    const std::string type = m_output->format_name();
    const bool several = m_specs.size() > 1;
    if (several && !holds_several(*m_output)) {
        failure = {format("cannot write \"{}\": the format {} holds one image, not {}", m_path,
                          type, m_specs.size())};
        return false;
    }
    if (several && type == "openexr" && !m_whole.can_seek()) {
        failure = {
            format("cannot write \"{}\": it is a stream, such as a pipe; allowed is one image "
                   "of the format {}, not {}",
                   m_path, type, m_specs.size()),
            exit_usage};
        return false;
    }
    if (const char* what = unlike(type, m_specs)) {
        failure = {format("cannot write \"{}\": the images of a file of the format {} have one {}; "
                          "allowed is a SIZE that gives them one, as 640x480",
                          m_path, type, what)};
        return false;
    }
    for (const OIIO::ImageSpec& spec : m_specs)
        if (!check_allowed(spec, failure))
            return false;
    // TIFF's rows make a broken file that way (OpenImageIO 2.4.7), and EXR's writer of several
    // images opens the file by its name.
    if (m_output->supports("ioproxy") && type != "tiff" && !several) {
        m_stream = std::make_unique<Stream>(m_whole.file());
        m_output->set_ioproxy(m_stream.get());
    }
    if (several && type == "tiff")
        allow_large_tiff(m_specs);
    if (type == "pnm")
        std::for_each(m_specs.begin(), m_specs.end(), keep_order_of_rows);
    if (type == "tiff")
        m_tiff_errors = std::make_unique<TiffWriteErrors>(fileno(m_whole.file()));
    if (!m_whole.check_kept(failure)) // which writers without a stream empty
        return false;
    // OpenImageIO's writer of EXR takes the first image's kind for that of all, and ends the
    // program.
    const auto has_no_tiles = [](const OIIO::ImageSpec& spec) { return spec.tile_width == 0; };
    if (several && std::any_of(m_specs.begin(), m_specs.end(), has_no_tiles))
        std::for_each(m_specs.begin(), m_specs.end(), forget_tiles);
    if (several ? m_output->open(temporary(), int(m_specs.size()), m_specs.data())
                : m_output->open(temporary(), m_specs[0]))
        return true;
    failure = failed();
    return false;
}

bool ImageFile::open_next(Failure& failure) {
    ++m_current;
    if (m_output->open(temporary(), m_specs[m_current], OIIO::ImageOutput::AppendSubimage))
        return true;
    failure = failed();
    return false;
}

bool ImageFile::wants_all_rows() const {
    return is_pfm(m_output->format_name(), m_output->spec());
}

bool ImageFile::write_rows(int begin, int end, OIIO::TypeDesc type, const void* pixels,
                           OIIO::stride_t stride) {
    const OIIO::ROI roi = m_specs[m_current].roi();
    OIIO::stride_t row = OIIO::AutoStride;
    if (wants_all_rows()) { // from the last to the first
        OIIO::stride_t all = OIIO::AutoStride;
        OIIO::ImageSpec::auto_stride(stride, row, all, type, m_output->spec().nchannels,
                                     roi.width(), end - begin);
        pixels = static_cast<const char*>(pixels) + row * (end - begin - 1);
        row = -row;
    }
    const bool written =
        m_output->spec().tile_width > 0
            ? m_output->write_tiles(roi.xbegin, roi.xend, begin, end, 0, 1, type, pixels, stride)
            : m_output->write_scanlines(begin, end, 0, type, pixels, stride, row);
    if (written)
        m_whole.begin_writeback();
    return written;
}

std::string ImageFile::with_its_name(const std::string& said) const {
    return OIIO::Strutil::replace(said, temporary(), m_path, true);
}

/// A write of which libtiff said that it failed, or nothing.
std::string ImageFile::error_of_tiff() const {
    return m_tiff_errors ? m_tiff_errors->first() : std::string();
}

Failure ImageFile::failed() const {
    if (Failure lost; !m_whole.check_kept(lost))
        return lost;
    std::string why(OIIO::Strutil::strip(m_output->geterror()));
    if (const std::string said = error_of_tiff(); !said.empty())
        return {"cannot write \"" + m_path + "\": " + said, exit_resources};
    why = with_its_name(why.substr(0, why.find('\n')));
    const bool of_stream = m_whole.file() && std::ferror(m_whole.file());
    ExitCode code = of_stream ? exit_resources : code_of_message(why);
    if (m_whole.file() && (code == exit_failed || why.empty())) { // writers may not say why
        const int number = m_whole.write_error();
        // Others than these tell of the asking, as that nobody goes back in a pipe.
        if (code_of_errno(number) == exit_resources) {
            code = exit_resources;
            if (why.empty())
                why = std::strerror(number);
        }
    }
    if (code == exit_failed) // as where there are no more descriptors
        code = code_of_reading(temporary());
    return {"cannot write \"" + m_path + "\"" + (why.empty() ? "" : ": " + why), code};
}

/// Look at the file as its readers will. compression: what they name, where they are asked.
bool ImageFile::check_written(std::string& compression, Failure& failure) {
    if (m_stream && (std::fflush(m_whole.file()) != 0 || std::ferror(m_whole.file())))
        return true; // commit() tells what a write said
    const auto refuse = [&](const std::string& why, ExitCode code) {
        OIIO::geterror();
        failure = {"cannot write \"" + m_path + "\": " + why, code};
        return false;
    };
    // Writers that open the file themselves may not look at the last writes (RLA, TIFF): what they
    // left need not even look broken. So it is asked whether the disk is full.
    if (const int number = m_stream ? 0 : m_whole.write_error())
        return refuse(std::strerror(number), code_of_errno(number));
    const ExitCode code = m_stream ? exit_failed : exit_resources;
    // Readers may lack memory of their own.
    const auto refuse_reading = [&](const std::string& said) {
        const std::string why(OIIO::Strutil::strip(said.substr(0, said.find('\n'))));
        const ExitCode by_text = code_of_message(why);
        return refuse("what was written cannot be read back" +
                          (why.empty() ? "" : ": " + with_its_name(why)),
                      by_text == exit_failed ? code_of_reading(temporary(), code) : by_text);
    };
    if (const std::string said = error_of_tiff(); !said.empty())
        return refuse(said, exit_resources);
    const auto in = OIIO::ImageInput::open(temporary());
    if (!in)
        return refuse_reading(OIIO::geterror());
    wait_for_tiles(*in);
    compression = in->spec().get_string_attribute("compression");
    compression.resize(std::min(compression.size(), compression.find(':')));
    // Reading the pixels of small icons ends the program (OpenImageIO 2.4.7).
    const bool enough = m_stream || m_output->format_name() == std::string("ico");
    if (!enough && was_left_out(m_whole.file(), *m_output))
        return refuse("what was written cannot be read back", code);
    for (size_t i = 0; i < m_specs.size(); ++i) {
        if ((i > 0 && !in->seek_subimage(int(i), 0)) ||
            is_truncated(temporary(), in->format_name(), int(i)))
            return refuse_reading(in->geterror());
        const OIIO::ImageSpec &asked = m_specs[i], &made = in->spec();
        if (made.width != asked.width || made.height != asked.height)
            return refuse(format("the format {} made {} x {} pixels of {} x {}{}",
                                 m_output->format_name(), made.width, made.height, asked.width,
                                 asked.height, why_sides_are_swapped(asked, made)),
                          exit_failed);
        if (!enough && !can_be_read(*in))
            return refuse_reading(in->geterror());
    }
    return true;
}

bool ImageFile::commit(Failure& failure) {
    if (!m_output->close()) {
        failure = failed();
        return false;
    }
    std::string compression;
    if (is_regular(m_whole.file()) && is_file_format(m_output->format_name()) &&
        !check_written(compression, failure)) {
        m_whole.check_kept(failure); // or another's file was looked at
        return false;
    }
    m_output.reset();
    m_stream.reset();
    if (!m_whole.commit(failure))
        return false;
    m_compression.swap(compression);
    return true;
}

bool write_image(const OIIO::ImageBuf& image, ImageFile& file, Failure& failure) {
    const bool written = file.wants_all_rows()
                             ? file.write_rows(image.ybegin(), image.yend(), image.spec().format,
                                               image.localpixels(), image.pixel_stride())
                             : image.write(&file.output());
    if (!written) {
        failure = file.failed();
        if (const std::string why(OIIO::Strutil::strip(image.geterror()));
            !why.empty() && failure.why.find(':') == std::string::npos) {
            failure.why += ": " + file.with_its_name(why.substr(0, why.find('\n')));
            if (failure.code == exit_failed)
                failure.code = code_of_message(why);
        }
        return false;
    }
    return file.commit(failure);
}

} // namespace ddt::tool

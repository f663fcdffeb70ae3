// SPDX-License-Identifier: Apache-2.0
// Writing images: whole, or not at all.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebuf.h>
#include <OpenImageIO/imageio.h>

#include "plugin/tool/file/tiff_write_errors.h"
#include "plugin/tool/file/whole_file.h"

namespace ddt::tool {

/// An image file to be written, which appears under its name only when whole and checked. Writers
/// of many formats do not look whether what they write arrives (PNG: a full disk), so their stream
/// is ours where they let us; of the others' files, and those of several images, it is asked
/// whether the disk is full, they are read back, and of TIFF it is listened to what libtiff says.
/// The size of every image is read back, which some writers do not look at either (GIF: 66000
/// becomes 464).
class ImageFile {
public:
    /// Decide on the format by the name's extension and open a temporary file.
    bool create(const std::string& path, Failure& failure);
    const std::string& path() const { return m_path; }
    /// The writer, for open() with a spec under the name temporary().
    OIIO::ImageOutput& output() { return *m_output; }
    const std::string& temporary() const { return m_whole.temporary(); }
    bool open(const OIIO::ImageSpec& spec, Failure& failure) {
        return open(std::vector{spec}, failure);
    }
    /// For images of these specs, at least one: the first is written to, until open_next().
    bool open(std::vector<OIIO::ImageSpec> specs, Failure& failure);
    /// The image before is whole: write to the next.
    bool open_next(Failure& failure);
    /// Whether write_rows() must be called once, with all rows: PFM begins with the last.
    bool wants_all_rows() const;
    /// Write the rows [begin, end) of the image that is open, as scanlines or, of a file that has
    /// them, whole tiles, with `stride` bytes from a pixel to the next; and let them go to the disk
    /// meanwhile. After a failure write no more: OpenEXR waits for ever for the tile that follows.
    bool write_rows(int begin, int end, OIIO::TypeDesc type, const void* pixels,
                    OIIO::stride_t stride = OIIO::AutoStride);
    /// Close the writer, check, and give the file its name.
    bool commit(Failure& failure);
    /// The compression of the file that was committed, as its reader names it, without a level: the
    /// writer may have chosen another than the spec's without a word (TIFF: jpeg). Empty where it
    /// is not known.
    const std::string& compression() const { return m_compression; }
    /// A message about the temporary file, as one about the file that it becomes.
    std::string with_its_name(const std::string& said) const;
    /// What the writer said, as a failure.
    Failure failed() const;

private:
    bool check_stream(Failure& failure) const;
    bool check_allowed(const OIIO::ImageSpec& spec, Failure& failure) const;
    std::string error_of_tiff() const;
    bool check_written(std::string& compression, Failure& failure);

    std::string m_path, m_compression;
    std::vector<OIIO::ImageSpec> m_specs; ///< what it was opened with
    size_t m_current = 0;                 ///< of them
    WholeFile m_whole;
    std::unique_ptr<TiffWriteErrors> m_tiff_errors; ///< of a TIFF
    // Before the writer that uses it: it goes after that.
    std::unique_ptr<OIIO::Filesystem::IOFile> m_stream;
    std::unique_ptr<OIIO::ImageOutput> m_output;
};

/// Write an image in local memory into a file without tiles that was opened for its windows, and
/// commit it. (OpenImageIO goes on after a tile that could not be written, and OpenEXR then waits
/// for ever.)
bool write_image(const OIIO::ImageBuf& image, ImageFile& file, Failure& failure);

} // namespace ddt::tool

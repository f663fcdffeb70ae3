// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/truncated.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <map>
#include <utility>
#include <vector>

namespace ddt::tool {

namespace {

/// Whole numbers that stand in a file, in one of both byte orders.
class NumberFile {
public:
    explicit NumberFile(const std::string& path) : m_file(path, std::ios::binary) {
        m_file.seekg(0, std::ios::end);
        m_length = uint64_t(std::max(std::streamoff(m_file.tellg()), std::streamoff(0)));
    }

    bool big_endian = false;

    uint64_t length() const { return m_length; }

    bool has(uint64_t begin, uint64_t count, uint64_t size = 1) const {
        return begin <= m_length && count <= (m_length - begin) / size;
    }

    /// Nothing if the file ends before.
    std::vector<uint8_t> bytes(uint64_t begin, uint64_t count) {
        std::vector<uint8_t> all;
        if (!has(begin, count))
            return all;
        all.resize(size_t(count));
        m_file.clear();
        m_file.seekg(std::streamoff(begin));
        if (!m_file.read(reinterpret_cast<char*>(all.data()), std::streamsize(count)))
            all.clear();
        return all;
    }

    /// One of `size` bytes.
    uint64_t number(const uint8_t* from, int size) const {
        uint64_t n = 0;
        for (int i = 0; i < size; ++i)
            n = n << 8 | from[big_endian ? i : size - 1 - i];
        return n;
    }

private:
    std::ifstream m_file;
    uint64_t m_length = 0;
};

/// The directories of a TIFF, one for each image. Source: Adobe, TIFF Revision 6.0; of files beyond
/// 4 GiB: the BigTIFF File Format Proposal.
class TiffTables {
public:
    explicit TiffTables(const std::string& path) : m_file(path) {}

    /// Of the image of this number from 0.
    bool are_beyond_end(int number) {
        const std::vector<uint8_t> head = m_file.bytes(0, 16);
        if (head.empty() || head[0] != head[1] || (head[0] != 'I' && head[0] != 'M'))
            return false;
        m_file.big_endian = head[0] == 'M';
        const uint64_t version = m_file.number(&head[2], 2);
        m_word = version == 43 ? 8 : 4;
        uint64_t next = m_file.number(&head[size_t(m_word)], m_word);
        for (int n = 0; n <= number && next != 0; ++n)
            if (!read_directory(next, n == number))
                return true;
        return pieces_are_beyond_end();
    }

private:
    enum Tag : uint64_t {
        width_tag = 256,
        height_tag = 257,
        bits_tag = 258,
        compression_tag = 259,
        strip_offsets_tag = 273,
        samples_tag = 277,
        rows_per_strip_tag = 278,
        strip_bytes_tag = 279,
        planes_tag = 284,
        tile_width_tag = 322,
        tile_height_tag = 323,
        tile_offsets_tag = 324,
        tile_bytes_tag = 325,
    };
    enum Compression : uint64_t { uncompressed = 1, old_jpeg = 6 };

    /// Numbers of one kind.
    struct Field {
        int size = 0; ///< bytes of each
        uint64_t count = 0, begin = 0;
    };

    /// Of whole numbers of a type; 0: no such.
    static int size_of_type(uint64_t type) {
        return type == 1 ? 1 : type == 3 ? 2 : type == 4 ? 4 : type == 16 ? 8 : 0;
    }

    /// Read the fields of a directory if it is the wanted one, or else go to the next. False if the
    /// file ends before; some writers leave out that there is no next.
    bool read_directory(uint64_t& at, bool wanted) {
        const int before = m_word == 8 ? 8 : 2, each = 4 + 2 * m_word;
        const std::vector<uint8_t> head = m_file.bytes(at, uint64_t(before));
        if (head.empty())
            return false;
        const uint64_t count = m_file.number(head.data(), before), begin = at + uint64_t(before);
        if (!m_file.has(begin, count, uint64_t(each)))
            return false;
        const uint64_t bytes = count * uint64_t(each);
        if (!wanted) {
            const std::vector<uint8_t> next = m_file.bytes(begin + bytes, uint64_t(m_word));
            at = next.empty() ? 0 : m_file.number(next.data(), m_word);
            return !next.empty();
        }
        if (count > UINT16_MAX)
            return true;
        const std::vector<uint8_t> all = m_file.bytes(begin, bytes);
        for (uint64_t k = 0; k < all.size(); k += uint64_t(each))
            read_field(&all[size_t(k)], begin + k);
        return true;
    }

    void read_field(const uint8_t* entry, uint64_t at) {
        Field field;
        field.size = size_of_type(m_file.number(entry + 2, 2));
        field.count = m_file.number(entry + 4, m_word);
        const auto word = uint64_t(m_word);
        const bool here = field.size > 0 && field.count <= word / uint64_t(field.size);
        field.begin = here ? at + 4 + word : m_file.number(entry + 4 + m_word, m_word);
        if (field.size > 0) // of a tag that is there twice the first counts
            m_fields.emplace(m_file.number(entry, 2), field);
    }

    /// Some of a field's numbers; none if the file ends before.
    std::vector<uint64_t> numbers(const Field& field, uint64_t first, uint64_t count) {
        const auto size = uint64_t(field.size);
        std::vector<uint64_t> all;
        if (!m_file.has(field.begin, first + count, size))
            return all;
        const std::vector<uint8_t> bytes = m_file.bytes(field.begin + first * size, count * size);
        for (size_t k = 0; k < bytes.size(); k += size_t(size))
            all.push_back(m_file.number(&bytes[k], field.size));
        return all;
    }

    /// The first number of a field, or what it is without.
    uint64_t value(Tag tag, uint64_t otherwise) {
        const auto found = m_fields.find(tag);
        const std::vector<uint64_t> all =
            found == m_fields.end() ? std::vector<uint64_t>() : numbers(found->second, 0, 1);
        return all.empty() ? otherwise : all[0];
    }

    bool pieces_are_beyond_end() {
        const uint64_t compression = value(compression_tag, uncompressed);
        // Of old JPEG the numbers of bytes mean nothing.
        if (compression == old_jpeg)
            return false;
        const bool tiled = m_fields.count(tile_offsets_tag) > 0;
        const Field offsets = m_fields[tiled ? tile_offsets_tag : strip_offsets_tag];
        const Field bytes = m_fields[tiled ? tile_bytes_tag : strip_bytes_tag];
        const Pieces pieces = find_pieces(tiled);
        // Some writers count the last strip as whole that has fewer rows.
        const bool rows_tell = !tiled && compression == uncompressed;
        constexpr uint64_t at_once = 4096;
        const uint64_t count = std::min({offsets.count, bytes.count, pieces.count()});
        for (uint64_t first = 0; first < count; first += at_once) {
            const uint64_t some = std::min(at_once, count - first);
            const auto begins = numbers(offsets, first, some), sizes = numbers(bytes, first, some);
            if (begins.empty() || sizes.empty())
                return true;
            for (uint64_t k = 0; k < some; ++k) {
                const uint64_t most = rows_tell ? pieces.strip_bytes(first + k) : UINT64_MAX;
                const uint64_t size = std::min(sizes[k], most);
                if (size > 0 && !m_file.has(begins[k], size))
                    return true;
            }
        }
        return false;
    }

    /// The strips or tiles that an image lies in, in pixels; none of tags that no image has.
    struct Pieces {
        uint64_t width = 0, height = 0, piece_width = 0, piece_height = 0;
        uint64_t planes = 0, samples = 0, bits = 0; ///< samples of a pixel in a plane, bits of each

        uint64_t across() const { return (width + piece_width - 1) / piece_width; }
        uint64_t down() const { return (height + piece_height - 1) / piece_height; }
        /// How many there are, whatever the tables have room for.
        uint64_t count() const {
            return planes == 0 ? 0 : whole(double(across()) * double(down()) * double(planes));
        }
        /// What a strip of this number has without compression.
        uint64_t strip_bytes(uint64_t number) const {
            const uint64_t above = number % down() * piece_height;
            const uint64_t row = (width * bits * samples + 7) / 8;
            return whole(double(row) * double(std::min(piece_height, height - above)));
        }

    private:
        /// A number, or the largest.
        static uint64_t whole(double n) { return n < 1e18 ? uint64_t(n) : UINT64_MAX; }
    };

    Pieces find_pieces(bool tiled) {
        Pieces p;
        p.width = value(width_tag, 0), p.height = value(height_tag, 0);
        p.piece_width = tiled ? std::min(value(tile_width_tag, p.width), p.width) : p.width;
        p.piece_height =
            std::min(value(tiled ? tile_height_tag : rows_per_strip_tag, p.height), p.height);
        p.samples = value(samples_tag, 1), p.bits = value(bits_tag, 1);
        p.planes = value(planes_tag, 1) == 2 ? std::exchange(p.samples, 1) : 1;
        const bool possible = std::max(p.width, p.height) <= INT32_MAX &&
                              std::min(p.piece_width, p.piece_height) > 0 &&
                              std::max({p.planes, p.samples, p.bits}) <= UINT16_MAX;
        return possible ? p : Pieces();
    }

    NumberFile m_file;
    int m_word = 4;                     ///< bytes of an offset
    std::map<uint64_t, Field> m_fields; ///< of the directory that is wanted, once it was found
};

/// A DPX's header, of one element. Source: SMPTE 268M.
struct DpxHeader {
    uint64_t data, size; ///< where pixels begin, and the file's length; 0 and all bits: unknown
    uint64_t width, height;
    uint64_t descriptor, bits, packing, encoding;

    DpxHeader(NumberFile& file, const std::vector<uint8_t>& head)
        : data(file.number(&head[4], 4)), size(file.number(&head[16], 4)),
          width(file.number(&head[772], 4)), height(file.number(&head[776], 4)),
          descriptor(head[800]), bits(head[803]), packing(file.number(&head[804], 2)),
          encoding(file.number(&head[806], 2)) {}

    /// What the pixels take at least, lines without what fills them up.
    uint64_t least_bytes() const {
        constexpr uint64_t largest = 1 << 28;
        if (encoding != 0 || width > largest || height > largest)
            return 0;
        const uint64_t rgb = 50, rgba = 51, abgr = 52;
        const uint64_t samples = width * height *
                                 (descriptor == rgb                          ? 3
                                  : descriptor == rgba || descriptor == abgr ? 4
                                                                             : 1);
        if (packing != 0 && bits == 10)
            return (samples + 2) / 3 * 4;
        return packing != 0 && bits == 12 ? samples * 2 : samples * bits / 8;
    }
};

/// Some writers say another size than the file's: its pixels must be lacking too.
bool is_short_dpx(const std::string& path) {
    NumberFile file(path);
    const std::vector<uint8_t> head = file.bytes(0, 808);
    if (head.empty())
        return false;
    file.big_endian = std::memcmp(head.data(), "SDPX", 4) == 0;
    const DpxHeader header(file, head);
    return header.size != UINT32_MAX && header.size > file.length() &&
           !file.has(header.data, header.least_bytes());
}

} // namespace

bool is_truncated(const std::string& path, const std::string& format, int number) {
    if (format == "tiff")
        return TiffTables(path).are_beyond_end(number);
    return format == "dpx" && is_short_dpx(path);
}

} // namespace ddt::tool

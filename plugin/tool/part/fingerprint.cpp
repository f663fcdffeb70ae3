// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/part/fingerprint.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <OpenImageIO/hash.h>
#include <OpenImageIO/strutil.h>

#include "ddt/option_table.h"
#include "plugin/colour/space_light.h"
#include "plugin/image/lazy_file.h"
#include "plugin/message/format.h"

namespace ddt::tool {

namespace {

/// What the config that is in use makes of numbers, and how edges are sought in them.
std::vector<float> light_of(const std::string& option, const std::string& space) {
    std::string ignored; // resizing tells
    const auto light = find_light(option, space, ignored);
    if (!light)
        return {};
    std::vector<float> all(light->luma().begin(), light->luma().end());
    all.push_back(float(light->known()));
    all.push_back(float(light->converts()));
    if (!light->converts() || option == "encoded")
        return all;
    std::vector<float> ramp;
    for (int i = -8; i <= 64; ++i)
        for (int c = 0; c < 3; ++c)
            ramp.push_back(float(i + c) / 32);
    light->to_light(ramp.data(), ramp.size() / 3);
    all.insert(all.end(), ramp.begin(), ramp.end());
    return all;
}

constexpr uint64_t pieces = 1024;
constexpr size_t piece = size_t(64) << 10;

/// A file's bytes.
class Bytes {
public:
    explicit Bytes(const std::string& path)
        : m_path(path), m_file(open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK)) {}
    ~Bytes() {
        if (m_file >= 0)
            close(m_file);
    }
    Bytes(const Bytes&) = delete;
    Bytes& operator=(const Bytes&) = delete;

    bool find_size(uint64_t& size, Failure& failure) const {
        struct stat there {};
        if (m_file < 0 || fstat(m_file, &there) != 0)
            return fail(errno, failure);
        size = uint64_t(there.st_size);
        return true;
    }

    bool read(char* to, size_t count, uint64_t at, Failure& failure) const {
        for (size_t done = 0; done < count;) {
            const ssize_t n = pread(m_file, to + done, count - done, off_t(at + done));
            if (n < 0)
                return fail(errno, failure);
            if (n == 0) { // it was longer
                failure.why = why_changed(m_path);
                failure.code = code_of_message(failure.why);
                return false;
            }
            done += size_t(n);
        }
        return true;
    }

private:
    bool fail(int number, Failure& failure) const {
        failure = {"\"" + m_path + "\"" +
                       (number == ENOENT
                            ? " is no file that can be read as bytes, which --part needs"
                            : std::string(": ") + std::strerror(number)),
                   code_of_errno(number)};
        return false;
    }

    const std::string& m_path;
    const int m_file;
};

} // namespace

std::string fingerprint(const std::string& source, const OIIO::ImageSpec& source_spec,
                        const OIIO::ImageSpec& result, const ResizeSettings& settings,
                        Failure& failure) {
    OIIO::SHA1 hash;
    const auto add = [&](const std::string& text) { hash.append(text.data(), text.size() + 1); };
    const auto windows = [&](const OIIO::ImageSpec& s) {
        add(format("{} {} {} {} {} {} {} {} {} {}", s.x, s.y, s.width, s.height, s.full_x, s.full_y,
                   s.full_width, s.full_height, s.nchannels, s.format));
    };
    add(DDT_VERSION);
    add(std::to_string(int(settings.options.surface.kind)));
    for (const Option& option : option_table())
        if (option.group != OptionGroup::device) // which gives the same bits
            add(option.key + ("=" + option.get(settings.options)));
    windows(source_spec);
    windows(result);
    // Without --type some may have another than the widest, which is that of all with it.
    for (const OIIO::TypeDesc& type : result.channelformats)
        add(type.c_str());
    add(result.get_string_attribute("compression"));
    for (const std::string& channel : source_spec.channelnames)
        add(channel);
    const std::string space = source_spec.get_string_attribute("oiio:ColorSpace");
    add(space);
    const std::vector<float> light = light_of(settings.options.light, space);
    hash.append(light.data(), light.size() * sizeof(float));

    const Bytes file(source);
    uint64_t size = 0;
    if (!file.find_size(size, failure))
        return {};
    add(std::to_string(size));
    std::vector<char> bytes(size_t(std::min<uint64_t>(size, piece)));
    const uint64_t count = std::min((size + piece - 1) / piece, pieces);
    const uint64_t last = size - bytes.size();
    for (uint64_t i = 0; i < count; ++i) {
        if (!file.read(bytes.data(), bytes.size(), count > 1 ? last * i / (count - 1) : 0, failure))
            return {};
        hash.append(bytes.data(), bytes.size());
    }
    return hash.digest();
}

} // namespace ddt::tool

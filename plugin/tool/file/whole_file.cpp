// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/file/whole_file.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "plugin/message/format.h"
#include "plugin/tool/file/unfinished.h"

namespace ddt::tool {

namespace {

namespace fs = std::filesystem;

constexpr int most_writers = 100; ///< of one file at a time
constexpr size_t longest_name = 255;
/// Bytes that are handed to the system at once: a C library's own few are a call for every row.
constexpr size_t buffered = size_t(1) << 18;

fs::path folder_of(const std::string& path) {
    const fs::path folder = fs::path(path).parent_path();
    return folder.empty() ? fs::path(".") : folder;
}

std::string temporary_name(const fs::path& target, int number) {
    const std::string extension = target.extension();
    const std::string rest = ".ddt-" + std::to_string(number) + extension;
    std::string stem = target.stem();
    if (rest.size() < longest_name)
        stem.resize(std::min(stem.size(), longest_name - 1 - rest.size()));
    return (folder_of(target) / ("." + stem + rest)).string();
}

/// Whether it is the folder, not the file, that the system did not let us write.
bool is_of_the_folder(int number) {
    return number == EACCES || number == EPERM || number == EROFS;
}

/// Whether the name still is that of the open file. Descriptors that are open keep an inode's
/// number from being another's.
bool still_named(int descriptor, const std::string& path) {
    struct stat open {
    }, named{};
    return fstat(descriptor, &open) == 0 && lstat(path.c_str(), &named) == 0 &&
           open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

/// Remove what a process of this owner left when it was killed: a file of no other name, on which
/// nobody has a lock. Another's, in a folder for all, would stay another's under the name of the
/// result.
bool remove_left_over(const std::string& path, uid_t owner) {
    const int descriptor = open(path.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK);
    if (descriptor < 0)
        return false;
    struct stat there {};
    const bool left = fstat(descriptor, &there) == 0 && S_ISREG(there.st_mode) &&
                      there.st_uid == owner && there.st_nlink == 1 &&
                      flock(descriptor, LOCK_EX | LOCK_NB) == 0 && still_named(descriptor, path) &&
                      unlink(path.c_str()) == 0;
    close(descriptor);
    return left;
}

/// A new file, also in place of one that was left; less than 0 with errno, EEXIST where there is
/// somebody's.
int create_new(const std::string& path, mode_t mode) {
    const auto create = [&] {
        return open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    };
    const int descriptor = create();
    if (descriptor >= 0 || errno != EEXIST)
        return descriptor;
    if (remove_left_over(path, geteuid()))
        return create();
    errno = EEXIST;
    return -1;
}

/// Remove what others left that were killed while this number's name was taken: of the numbers
/// before, and of those that follow, up to two in a row that are not there. File systems may give a
/// user's files another owner (NFS with root_squash), so theirs is that of the file made here.
void remove_those_left(const fs::path& target, int number, int made) {
    struct stat own {};
    if (fstat(made, &own) != 0)
        return;
    std::error_code ignored;
    for (int i = 0, missing = 0; i < most_writers && missing < 2; ++i) {
        if (i == number)
            continue;
        const std::string name = temporary_name(target, i);
        const bool is_there = fs::exists(fs::symlink_status(name, ignored));
        missing = is_there || i < number ? 0 : missing + 1;
        remove_left_over(name, own.st_uid);
    }
}

} // namespace

fs::path followed(fs::path path) {
    std::error_code error;
    for (int links = 0; links < 40 && fs::is_symlink(path, error); ++links) {
        const fs::path target = fs::read_symlink(path, error);
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

WholeFile::~WholeFile() {
    discard();
}

void WholeFile::discard() {
    if (m_file && !m_direct) {
        const SignalsWait until_unlisted;
        if (still_named(fileno(m_file), m_temporary))
            unlink(m_temporary.c_str()); // while the lock is held
        unlist();
    }
    if (m_file)
        std::fclose(m_file);
    m_file = nullptr;
}

/// Before the lock is given back: from then on another may have a file of that name.
void WholeFile::unlist() {
    unlist_unfinished(m_listed);
    m_listed = -1;
}

bool WholeFile::refuse(int number, Failure& failure) const {
    failure = {"cannot write \"" + m_path + "\": " + std::strerror(number), code_of_errno(number)};
    return false;
}

/// `how`: what is wrong with the folder.
bool WholeFile::refuse_folder(const char* how, int number, Failure& failure) const {
    failure = {"cannot write \"" + m_path + "\": its folder \"" + folder_of(m_target).string() +
                   "\" " + how + ": " + std::strerror(number),
               code_of_errno(number)};
    return false;
}

bool WholeFile::refuse_taken(Failure& failure) const {
    failure = {format("cannot write \"{}\": the names of unfinished files, \"{}\" to \"{}\", are "
                      "taken; allowed are {} runs at a time, and what another user's left is for "
                      "that user to remove",
                      m_path, temporary_name(m_target, 0),
                      temporary_name(m_target, most_writers - 1), most_writers),
               exit_resources};
    return false;
}

bool WholeFile::check_kept(Failure& failure) const {
    if (!m_file || m_direct || still_named(fileno(m_file), m_temporary))
        return true;
    failure = {format("cannot write \"{}\": its unfinished file, \"{}\", was removed or replaced "
                      "meanwhile, as by a run that does not see this one's lock",
                      m_path, m_temporary),
               exit_resources};
    return false;
}

/// Whether the file that is there may be written and, where its folder lets only owners do that,
/// have another take its place: the system would say so only in the end. (Who has the right by a
/// capability is not known here.)
bool WholeFile::check_replaceable(Failure& failure) const {
    if (faccessat(AT_FDCWD, m_target.c_str(), W_OK, AT_EACCESS) != 0)
        return refuse(errno, failure);
    struct stat folder {};
    const uid_t user = geteuid();
    if (S_ISREG(m_before.st_mode) && stat(folder_of(m_target).c_str(), &folder) == 0 &&
        (folder.st_mode & S_ISVTX) && user != 0 && user != folder.st_uid && user != m_before.st_uid)
        return refuse_folder("is sticky, where only the owner of a file replaces it", EPERM,
                             failure);
    return true;
}

/// Make the new temporary file this one's, unless another was quick to take it for left over.
bool WholeFile::take(int descriptor) {
    const bool locked = flock(descriptor, LOCK_EX | LOCK_NB) == 0;
    // There are file systems without locks, where nobody takes it.
    const bool ours = locked || errno != EWOULDBLOCK;
    errno = 0;
    if (ours && still_named(descriptor, m_temporary) && (m_file = fdopen(descriptor, "w+b")))
        return true;
    const int number = errno == ENOENT ? 0 : errno;
    if (number != 0 && still_named(descriptor, m_temporary))
        unlink(m_temporary.c_str());
    close(descriptor);
    errno = number;
    return false;
}

/// Which a umask may withhold, while writers open the file by its name and it is read back.
void WholeFile::give_owner_rights(int descriptor) {
    struct stat made {};
    constexpr mode_t needed = S_IRUSR | S_IWUSR;
    if (fstat(descriptor, &made) != 0 || (made.st_mode & needed) == needed)
        return;
    m_withheld = needed & ~made.st_mode;
    (void)fchmod(descriptor, (made.st_mode & 07777) | needed);
}

/// Of a file that takes no other's place.
void WholeFile::withhold_rights(int descriptor) const {
    struct stat made {};
    if (m_withheld != 0 && fstat(descriptor, &made) == 0)
        (void)fchmod(descriptor, made.st_mode & 07777 & ~m_withheld);
}

bool WholeFile::open_temporary() {
    // What takes the place of a file has its rights at the end, and until then none that it may not
    // have.
    const mode_t mode = m_exists ? 0600 : 0666;
    for (int i = 0; i < most_writers; ++i) {
        m_temporary = temporary_name(m_target, i);
        const int descriptor = create_new(m_temporary, mode);
        if (descriptor < 0 && errno == EEXIST)
            continue;
        if (descriptor < 0)
            return false;
        if (take(descriptor)) {
            give_owner_rights(descriptor);
            remove_those_left(m_target, i, descriptor);
            return true;
        }
        if (errno != 0)
            return false;
    }
    errno = EEXIST;
    return false;
}

bool WholeFile::open(const std::string& path, Failure& failure) {
    m_path = path;
    m_target = followed(path).string();
    if (std::error_code ignored; fs::is_symlink(m_target, ignored))
        return refuse(ELOOP, failure);
    struct stat there {};
    // A link to /dev/stdout leads on to a pipe, which has no path.
    if (stat(path.c_str(), &there) == 0 && !S_ISREG(there.st_mode))
        m_target = path;
    m_exists = stat(m_target.c_str(), &m_before) == 0;
    if (m_exists && S_ISDIR(m_before.st_mode))
        return refuse(EISDIR, failure);
    if (m_exists && !check_replaceable(failure))
        return false;
    m_direct = m_exists && !S_ISREG(m_before.st_mode);
    if (m_exists && !m_direct)
        m_attributes = Attributes(m_target);
    if (m_direct) {
        m_temporary = m_path;
        m_file = std::fopen(m_path.c_str(), "wb");
    } else {
        const SignalsWait until_listed;
        if (open_temporary())
            m_listed = list_unfinished(m_temporary);
    }
    if (!m_file && !m_direct && errno == EEXIST)
        return refuse_taken(failure);
    if (!m_file)
        return !m_direct && is_of_the_folder(errno)
                   ? refuse_folder("cannot be written", errno, failure)
                   : refuse(errno, failure);
    m_buffer.resize(buffered);
    std::setvbuf(m_file, m_buffer.data(), _IOFBF, m_buffer.size());
    return true;
}

bool WholeFile::can_seek() const {
    return lseek(fileno(m_file), 0, SEEK_CUR) >= 0;
}

void WholeFile::begin_writeback() {
    // That it fails, of a pipe or where there is no such thing, is no matter.
    if (!m_direct)
        sync_file_range(fileno(m_file), 0, 0, SYNC_FILE_RANGE_WRITE);
}

int WholeFile::write_error() const {
    const char more[4096] = {};
    const off_t end = std::max<off_t>(lseek(fileno(m_file), 0, SEEK_END), 0);
    int error = 0;
    // A disk that fills up takes some, and tells at the next.
    for (ssize_t done = 0; done < ssize_t(sizeof more);) {
        errno = 0;
        const ssize_t n = pwrite(fileno(m_file), more, sizeof more - size_t(done), end + done);
        if (n <= 0) {
            error = errno;
            break;
        }
        done += n;
    }
    return m_direct || ftruncate(fileno(m_file), end) == 0 ? error : errno;
}

/// As the file that it takes the place of: whose it is and who may do what. Another's owner is
/// root's alone to give; a group those who are in it may give. Where that is not had, its rights
/// are not either.
bool WholeFile::take_after(const struct stat& there, const Attributes& attributes) const {
    const int descriptor = fileno(m_file);
    mode_t mode = there.st_mode & 07777;
    if (fchown(descriptor, there.st_uid, there.st_gid) != 0) {
        mode &= ~mode_t(S_ISUID);
        if (fchown(descriptor, uid_t(-1), there.st_gid) != 0) {
            const mode_t others = (mode & S_IRWXO) << 3;
            mode &= ~mode_t(S_ISGID | (S_IRWXG & ~others));
        }
    }
    attributes.give_notes(descriptor);
    if (!attributes.give_rights(descriptor, mode))
        mode &= ~mode_t(S_IRWXG | S_IRWXO);
    // Where a file system has no rights of single files there are none to take over.
    return fchmod(descriptor, mode) == 0 || errno == EPERM || errno == ENOTSUP || errno == ENOSYS;
}

bool WholeFile::commit(Failure& failure) {
    const int descriptor = fileno(m_file);
    struct stat there {};
    errno = 0;
    // The stream's error flag stays from the first write that failed, whoever made it.
    bool done = std::fflush(m_file) == 0 && !std::ferror(m_file);
    if (done && !m_direct) {
        if (stat(m_target.c_str(), &there) == 0)
            done = take_after(there, Attributes(m_target));
        else if (m_exists)
            done = take_after(m_before, m_attributes);
        else
            withhold_rights(descriptor);
        done = done && fsync(descriptor) == 0;
        const SignalsWait until_unlisted;
        done =
            done && check_kept(failure) && std::rename(m_temporary.c_str(), m_target.c_str()) == 0;
        if (done)
            unlist();
    }
    if (!done) {
        int number = errno;
        if (check_kept(failure)) {
            if (number == 0) // it may be another's by now
                number = write_error();
            refuse(number ? number : EIO, failure);
            if (std::ferror(m_file))
                failure.code = exit_resources;
        }
        discard();
        return false;
    }
    std::fclose(m_file);
    m_file = nullptr;
    if (!m_direct) {
        const int folder = ::open(folder_of(m_target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        if (folder >= 0) {
            fsync(folder); // the name too
            close(folder);
        }
    }
    return true;
}

} // namespace ddt::tool

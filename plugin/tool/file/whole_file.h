// SPDX-License-Identifier: Apache-2.0
// A file that appears under its name only when it is whole.
#pragma once

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include <sys/stat.h>

#include "plugin/tool/command/exit_code.h"
#include "plugin/tool/file/attributes.h"

namespace ddt::tool {

/// The name of the file that a name leads to: that name itself unless it is one of a symbolic link,
/// whose target need not exist. Links among its folders stay.
std::filesystem::path followed(std::filesystem::path path);

/// Write to file(), or to what temporary() names; then commit(). Until then what was there under
/// the file's name stays there; without commit() it stays for good.
///
/// The temporary file lies in the same folder, its name hidden and with the same extension:
/// .NAME.ddt-0.exr. A signal that can be caught removes it (see unfinished.h). After one that
/// cannot (SIGKILL) it stays, and the next process of this user, as the file system has users, that
/// writes the file removes it, and those of others that were killed with it: a process at work
/// holds a lock on its temporary file, and nobody holds one on what is left over. Where processes
/// do not see each other's locks (NFS mounted with nolock, a lease that ran out) one may be taken
/// for killed, and another's half-written file has its name then: nothing is done to a name that no
/// longer is the file's.
///
/// A symbolic link stays one: the file that it leads to is replaced. A file that was there keeps
/// its permissions, access control list (POSIX's) and `user.*` attributes, and its owner and group
/// where that is allowed; where a right cannot be kept, nobody gains one. A file that may not be
/// written is not replaced either. What is no file (/dev/null, a pipe) is written directly.
class WholeFile {
public:
    WholeFile() = default;
    ~WholeFile(); ///< removes the temporary file unless it was committed
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    /// False with a failure if the file could not be written. Once.
    bool open(const std::string& path, Failure& failure);

    const std::string& temporary() const { return m_temporary; }
    /// False with a failure, after which trying again may help, if that name no longer is the
    /// file's: it was removed, or another has taken its place. To be asked before the name is used.
    bool check_kept(Failure& failure) const;
    /// Open for writing and reading.
    std::FILE* file() const { return m_file; }
    /// Whether a writer can go back in it: not in a pipe, a socket or a terminal.
    bool can_seek() const;

    /// Let what was written so far go to the disk meanwhile, so that commit() waits for less.
    void begin_writeback();

    /// The error's number that a write gives now, or 0. It writes beyond the end, and takes that
    /// back; where there is no temporary file it cannot, and is for what is to be given up.
    int write_error() const;

    /// Put all of it on the disk, then under its name. False with a failure, and no file, if a
    /// write to file() failed at any time, or one of these does, or the file was not kept.
    bool commit(Failure& failure);

private:
    bool open_temporary();
    bool take(int descriptor);
    void give_owner_rights(int descriptor);
    void withhold_rights(int descriptor) const;
    bool refuse(int number, Failure& failure) const;
    bool refuse_folder(const char* how, int number, Failure& failure) const;
    bool refuse_taken(Failure& failure) const;
    bool check_replaceable(Failure& failure) const;
    bool take_after(const struct stat& there, const Attributes& attributes) const;
    void unlist();
    void discard();

    std::string m_path, m_target, m_temporary;
    std::FILE* m_file = nullptr;
    std::vector<char> m_buffer; ///< the stream's
    int m_listed = -1;
    struct stat m_before {}; ///< of the file that it takes the place of
    Attributes m_attributes; ///< of that file
    mode_t m_withheld = 0;   ///< rights of the owner that the file has until it is whole
    bool m_exists = false;   ///< there was one
    bool m_direct = false;
};

} // namespace ddt::tool

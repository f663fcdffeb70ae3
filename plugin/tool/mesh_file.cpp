// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/mesh_file.h"

#include <cerrno>
#include <cstring>

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

namespace ddt::tool {

MeshWriter writer_for(const std::string& path) {
    const std::string extension = OIIO::Strutil::lower(OIIO::Filesystem::extension(path));
    return extension == ".svg"   ? write_svg
           : extension == ".ply" ? write_ply
           : extension == ".obj" ? write_obj
                                 : nullptr;
}

bool write_mesh(const std::string& path, const Mesh& mesh, const Picture& picture,
                const MeshStyle& style, const std::function<bool(float)>& progress,
                std::string& error) {
    const MeshWriter write = writer_for(path);
    if (!write) {
        error = "\"" + path + "\": allowed are names that end in .svg, .ply or .obj";
        return false;
    }
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (!file) {
        error = "\"" + path + "\": " + std::strerror(errno);
        return false;
    }
    errno = 0;
    const bool written = write(file, mesh, picture, style, progress) && !std::ferror(file);
    const int why = errno;
    if (std::fclose(file) == 0 && written)
        return true;
    error = "cannot write \"" + path + "\": " + std::strerror(why ? why : errno);
    std::remove(path.c_str());
    return false;
}

} // namespace ddt::tool

// SPDX-License-Identifier: Apache-2.0
#include "plugin/tool/mesh/mesh_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/strutil.h>

#include "plugin/tool/file/whole_file.h"

namespace ddt::tool {

MeshWriter writer_for(const std::string& path) {
    const std::string extension = OIIO::Strutil::lower(OIIO::Filesystem::extension(path));
    return extension == ".svg"   ? write_svg
           : extension == ".ply" ? write_ply
           : extension == ".obj" ? write_obj
                                 : nullptr;
}

std::string wrong_mesh_name(const std::string& path) {
    return "\"" + path + "\" is not allowed; allowed are names that end in .svg, .ply or .obj";
}

bool write_mesh(const std::string& path, const Mesh& mesh, const Picture& picture,
                const MeshStyle& style, const ProgressCallback& progress, Failure& failure) {
    const MeshWriter write = writer_for(path);
    if (!write) {
        failure = {wrong_mesh_name(path), exit_usage};
        return false;
    }
    WholeFile file;
    return file.open(path, failure) && write(file.file(), mesh, picture, style, progress) &&
           file.commit(failure);
}

} // namespace ddt::tool

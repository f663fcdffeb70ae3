# SPDX-License-Identifier: Apache-2.0
"""A rez package of oiio-ddt. Not run: a sample to start from."""

name = "oiio_ddt"
version = "0.1.0"
description = "Image enlargement by data-dependent triangulation, as an OpenImageIO filter"
# A package for each minor version of OpenImageIO: the plugin looks at the version it was built for.
variants = [["OpenImageIO-2.4"], ["OpenImageIO-2.5"]]
requires = ["tbb", "OpenColorIO-2.1+", "highway-1+"]
# Without the headers of EGL and OpenGL no GPU is used.
build_requires = ["cmake-3.20+"]
# Modules for other programs would be built for those of the machine that builds.
build_command = ("cmake -S {root} -B . -DDDT_TESTS=OFF -DDDT_HOSTS=OFF -DCMAKE_INSTALL_LIBDIR=lib "
                 "-DCMAKE_INSTALL_PREFIX=$REZ_BUILD_INSTALL_PATH "
                 "&& cmake --build . && if [ $REZ_BUILD_INSTALL = 1 ]; then cmake --install .; fi")


def commands():
    env.PATH.append("{root}/bin")
    env.OIIO_LIBRARY_PATH.append("{root}/lib/oiio-ddt")
    env.CMAKE_PREFIX_PATH.append("{root}")

# SPDX-License-Identifier: Apache-2.0
# The programs and the Python module of the OpenImageIO that was found, not those of another that PATH
# has first: below the folder that its CMake files are in. Sets
#   oiio_python        a Python that has its module, or nothing
#   oiio_modules       the folders to add to PYTHONPATH for it
#   with_oiio          what a test's command begins with, for its programs to come first
set(prefix ${OpenImageIO_DIR})
while(NOT EXISTS ${prefix}/bin/oiiotool AND NOT prefix STREQUAL "/")
  cmake_path(GET prefix PARENT_PATH prefix)
endwhile()
find_program(DDT_OIIOTOOL oiiotool PATHS ${prefix}/bin NO_DEFAULT_PATH)
set(with_oiio)
if(DDT_OIIOTOOL)
  cmake_path(GET DDT_OIIOTOOL PARENT_PATH programs)
  set(with_oiio ${CMAKE_COMMAND} -E env PATH=${programs}:$ENV{PATH})
endif()

# The first python3 that has its module: other Pythons may come before the system's.
string(REGEX MATCH "^[0-9]+[.][0-9]+" release ${OpenImageIO_VERSION})
file(GLOB modules ${prefix}/lib*/python3*/site-packages)
list(JOIN modules ":" oiio_modules)
set(oiio_python)
foreach(candidate ${prefix}/bin/python3 /usr/bin/python3 python3)
  execute_process(
    COMMAND ${CMAKE_COMMAND} -E env PYTHONPATH=${oiio_modules}
      ${candidate} -c "import OpenImageIO; assert OpenImageIO.VERSION_STRING.startswith('${release}.')"
    RESULT_VARIABLE result OUTPUT_QUIET ERROR_QUIET)
  if(result EQUAL 0)
    set(oiio_python ${candidate})
    break()
  endif()
endforeach()

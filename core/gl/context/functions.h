// SPDX-License-Identifier: Apache-2.0
// The OpenGL functions in use, loaded at run time: nothing links a GL library.
#pragma once

#include <string>

#include <GL/glcorearb.h>

namespace ddt::gl {

// X(function) for every function of OpenGL 4.3 core that is called, without its gl prefix.
#define DDT_GL_FUNCTIONS(X)                                                                        \
    X(GETSTRING, GetString)                                                                        \
    X(GETSTRINGI, GetStringi)                                                                      \
    X(GETINTEGERV, GetIntegerv)                                                                    \
    X(GETINTEGER64V, GetInteger64v)                                                                \
    X(GETERROR, GetError)                                                                          \
    X(CREATESHADER, CreateShader)                                                                  \
    X(SHADERSOURCE, ShaderSource)                                                                  \
    X(COMPILESHADER, CompileShader)                                                                \
    X(GETSHADERIV, GetShaderiv)                                                                    \
    X(GETSHADERINFOLOG, GetShaderInfoLog)                                                          \
    X(DELETESHADER, DeleteShader)                                                                  \
    X(CREATEPROGRAM, CreateProgram)                                                                \
    X(ATTACHSHADER, AttachShader)                                                                  \
    X(LINKPROGRAM, LinkProgram)                                                                    \
    X(GETPROGRAMIV, GetProgramiv)                                                                  \
    X(GETPROGRAMINFOLOG, GetProgramInfoLog)                                                        \
    X(DELETEPROGRAM, DeleteProgram)                                                                \
    X(USEPROGRAM, UseProgram)                                                                      \
    X(UNIFORM1I, Uniform1i)                                                                        \
    X(UNIFORM2I, Uniform2i)                                                                        \
    X(UNIFORM3I, Uniform3i)                                                                        \
    X(UNIFORM1UI, Uniform1ui)                                                                      \
    X(UNIFORM2UI, Uniform2ui)                                                                      \
    X(UNIFORM4UI, Uniform4ui)                                                                      \
    X(UNIFORM1F, Uniform1f)                                                                        \
    X(UNIFORM4F, Uniform4f)                                                                        \
    X(GENBUFFERS, GenBuffers)                                                                      \
    X(DELETEBUFFERS, DeleteBuffers)                                                                \
    X(BINDBUFFER, BindBuffer)                                                                      \
    X(BINDBUFFERBASE, BindBufferBase)                                                              \
    X(BUFFERDATA, BufferData)                                                                      \
    X(BUFFERSUBDATA, BufferSubData)                                                                \
    X(GETBUFFERSUBDATA, GetBufferSubData)                                                          \
    X(COPYBUFFERSUBDATA, CopyBufferSubData)                                                        \
    X(MAPBUFFERRANGE, MapBufferRange)                                                              \
    X(CLEARBUFFERDATA, ClearBufferData)                                                            \
    X(DISPATCHCOMPUTE, DispatchCompute)                                                            \
    X(DISPATCHCOMPUTEINDIRECT, DispatchComputeIndirect)                                            \
    X(MEMORYBARRIER, MemoryBarrier)                                                                \
    X(FLUSH, Flush)                                                                                \
    X(FENCESYNC, FenceSync)                                                                        \
    X(CLIENTWAITSYNC, ClientWaitSync)                                                              \
    X(DELETESYNC, DeleteSync)                                                                      \
    X(GENQUERIES, GenQueries)                                                                      \
    X(DELETEQUERIES, DeleteQueries)                                                                \
    X(QUERYCOUNTER, QueryCounter)                                                                  \
    X(GETQUERYOBJECTUI64V, GetQueryObjectui64v)

struct Functions {
#define DDT_DECLARE(TYPE, NAME) PFNGL##TYPE##PROC NAME = nullptr;
    DDT_GL_FUNCTIONS(DDT_DECLARE)
#undef DDT_DECLARE
    // These are describe_current()'s affair.
    /// OpenGL 4.5, KHR_robustness or ARB_robustness; null where there is none of them.
    PFNGLGETGRAPHICSRESETSTATUSPROC GetGraphicsResetStatus = nullptr;
    /// OpenGL 4.4; null before.
    PFNGLBUFFERSTORAGEPROC BufferStorage = nullptr;
};

/// Finds a GL function by its full name; null if there is none.
using Lookup = void* (*)(const void* library, const char* name);

/// Load all functions of OpenGL 4.3. Returns the name of the first that is missing, empty if none
/// is.
std::string load_functions(const void* library, Lookup lookup, Functions& gl);

/// The name of a GL error: "GL_OUT_OF_MEMORY".
std::string error_name(GLenum error);

} // namespace ddt::gl

// Table of OpenGL 3.3 core functions. They are loaded at run time, so that the program starts on machines without GL.
#pragma once

#include <GL/glcorearb.h>
#include <functional>

namespace server::render {

// Calls X(NAME, TYPE) for each function. NAME: its name without "gl". TYPE: the type of its pointer.
#define CIEL_GL_FUNCTIONS(X)                                                                                           \
    X(ActiveTexture, PFNGLACTIVETEXTUREPROC)                                                                           \
    X(AttachShader, PFNGLATTACHSHADERPROC)                                                                             \
    X(BeginQuery, PFNGLBEGINQUERYPROC)                                                                                 \
    X(BindBuffer, PFNGLBINDBUFFERPROC)                                                                                 \
    X(BindFramebuffer, PFNGLBINDFRAMEBUFFERPROC)                                                                       \
    X(BindRenderbuffer, PFNGLBINDRENDERBUFFERPROC)                                                                     \
    X(BindTexture, PFNGLBINDTEXTUREPROC)                                                                               \
    X(BindVertexArray, PFNGLBINDVERTEXARRAYPROC)                                                                       \
    X(BlendEquation, PFNGLBLENDEQUATIONPROC)                                                                           \
    X(BlendEquationSeparate, PFNGLBLENDEQUATIONSEPARATEPROC)                                                           \
    X(BlendFuncSeparate, PFNGLBLENDFUNCSEPARATEPROC)                                                                   \
    X(BlitFramebuffer, PFNGLBLITFRAMEBUFFERPROC)                                                                       \
    X(BufferData, PFNGLBUFFERDATAPROC)                                                                                 \
    X(BufferSubData, PFNGLBUFFERSUBDATAPROC)                                                                           \
    X(CheckFramebufferStatus, PFNGLCHECKFRAMEBUFFERSTATUSPROC)                                                         \
    X(Clear, PFNGLCLEARPROC)                                                                                           \
    X(ClearColor, PFNGLCLEARCOLORPROC)                                                                                 \
    X(ClearDepth, PFNGLCLEARDEPTHPROC)                                                                                 \
    X(ColorMask, PFNGLCOLORMASKPROC)                                                                                   \
    X(CompileShader, PFNGLCOMPILESHADERPROC)                                                                           \
    X(CreateProgram, PFNGLCREATEPROGRAMPROC)                                                                           \
    X(CreateShader, PFNGLCREATESHADERPROC)                                                                             \
    X(CullFace, PFNGLCULLFACEPROC)                                                                                     \
    X(DepthFunc, PFNGLDEPTHFUNCPROC)                                                                                   \
    X(DepthMask, PFNGLDEPTHMASKPROC)                                                                                   \
    X(Disable, PFNGLDISABLEPROC)                                                                                       \
    X(DisableVertexAttribArray, PFNGLDISABLEVERTEXATTRIBARRAYPROC)                                                     \
    X(DrawArrays, PFNGLDRAWARRAYSPROC)                                                                                 \
    X(DrawBuffer, PFNGLDRAWBUFFERPROC)                                                                                 \
    X(DrawBuffers, PFNGLDRAWBUFFERSPROC)                                                                               \
    X(DrawElementsBaseVertex, PFNGLDRAWELEMENTSBASEVERTEXPROC)                                                         \
    X(Enable, PFNGLENABLEPROC)                                                                                         \
    X(EnableVertexAttribArray, PFNGLENABLEVERTEXATTRIBARRAYPROC)                                                       \
    X(EndQuery, PFNGLENDQUERYPROC)                                                                                     \
    X(Finish, PFNGLFINISHPROC)                                                                                         \
    X(FramebufferRenderbuffer, PFNGLFRAMEBUFFERRENDERBUFFERPROC)                                                       \
    X(FramebufferTexture2D, PFNGLFRAMEBUFFERTEXTURE2DPROC)                                                             \
    X(GenBuffers, PFNGLGENBUFFERSPROC)                                                                                 \
    X(GenFramebuffers, PFNGLGENFRAMEBUFFERSPROC)                                                                       \
    X(GenQueries, PFNGLGENQUERIESPROC)                                                                                 \
    X(GenRenderbuffers, PFNGLGENRENDERBUFFERSPROC)                                                                     \
    X(GenTextures, PFNGLGENTEXTURESPROC)                                                                               \
    X(GenVertexArrays, PFNGLGENVERTEXARRAYSPROC)                                                                       \
    X(GetError, PFNGLGETERRORPROC)                                                                                     \
    X(GetIntegerv, PFNGLGETINTEGERVPROC)                                                                               \
    X(GetMultisamplefv, PFNGLGETMULTISAMPLEFVPROC)                                                                     \
    X(GetProgramInfoLog, PFNGLGETPROGRAMINFOLOGPROC)                                                                   \
    X(GetProgramiv, PFNGLGETPROGRAMIVPROC)                                                                             \
    X(GetQueryObjectuiv, PFNGLGETQUERYOBJECTUIVPROC)                                                                   \
    X(GetShaderInfoLog, PFNGLGETSHADERINFOLOGPROC)                                                                     \
    X(GetShaderiv, PFNGLGETSHADERIVPROC)                                                                               \
    X(GetString, PFNGLGETSTRINGPROC)                                                                                   \
    X(GetUniformLocation, PFNGLGETUNIFORMLOCATIONPROC)                                                                 \
    X(LinkProgram, PFNGLLINKPROGRAMPROC)                                                                               \
    X(PixelStorei, PFNGLPIXELSTOREIPROC)                                                                               \
    X(ProvokingVertex, PFNGLPROVOKINGVERTEXPROC)                                                                       \
    X(ReadPixels, PFNGLREADPIXELSPROC)                                                                                 \
    X(RenderbufferStorageMultisample, PFNGLRENDERBUFFERSTORAGEMULTISAMPLEPROC)                                         \
    X(Scissor, PFNGLSCISSORPROC)                                                                                       \
    X(ShaderSource, PFNGLSHADERSOURCEPROC)                                                                             \
    X(StencilFunc, PFNGLSTENCILFUNCPROC)                                                                               \
    X(StencilOpSeparate, PFNGLSTENCILOPSEPARATEPROC)                                                                   \
    X(TexImage2D, PFNGLTEXIMAGE2DPROC)                                                                                 \
    X(TexParameteri, PFNGLTEXPARAMETERIPROC)                                                                           \
    X(TexSubImage2D, PFNGLTEXSUBIMAGE2DPROC)                                                                           \
    X(Uniform1f, PFNGLUNIFORM1FPROC)                                                                                   \
    X(Uniform1i, PFNGLUNIFORM1IPROC)                                                                                   \
    X(Uniform2f, PFNGLUNIFORM2FPROC)                                                                                   \
    X(Uniform2fv, PFNGLUNIFORM2FVPROC)                                                                                 \
    X(Uniform3f, PFNGLUNIFORM3FPROC)                                                                                   \
    X(Uniform4f, PFNGLUNIFORM4FPROC)                                                                                   \
    X(Uniform4fv, PFNGLUNIFORM4FVPROC)                                                                                 \
    X(UniformMatrix4fv, PFNGLUNIFORMMATRIX4FVPROC)                                                                     \
    X(UseProgram, PFNGLUSEPROGRAMPROC)                                                                                 \
    X(VertexAttrib1f, PFNGLVERTEXATTRIB1FPROC)                                                                         \
    X(VertexAttrib3f, PFNGLVERTEXATTRIB3FPROC)                                                                         \
    X(VertexAttrib4f, PFNGLVERTEXATTRIB4FPROC)                                                                         \
    X(VertexAttribPointer, PFNGLVERTEXATTRIBPOINTERPROC)                                                               \
    X(Viewport, PFNGLVIEWPORTPROC)

class Pacing; // pacing.hpp

struct Gl {
#define CIEL_GL_MEMBER(name, type) type name = nullptr;
    CIEL_GL_FUNCTIONS(CIEL_GL_MEMBER)
#undef CIEL_GL_MEMBER
    PFNGLGETGRAPHICSRESETSTATUSPROC GetGraphicsResetStatus = nullptr; // null if the context cannot report resets

    Pacing* pacing = nullptr; // null: draws and uploads are not divided into pieces (pacing.hpp)

    using Loader = std::function<void (*(const char* name))()>;
    // Throws Error with the name of the first missing function. `loader`: returns the address of a function, or null.
    [[nodiscard]] static Gl load(const Loader& loader);
};

} // namespace server::render

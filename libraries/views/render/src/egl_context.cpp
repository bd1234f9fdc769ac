#include "egl_context.h"

#include <array>
#include <cstdlib>
#include <string>
#include <string_view>
#include <vector>

#include <dlfcn.h>

#include "elsie/render/renderer.h"

namespace elsie::render {
namespace {

[[noreturn]] void refuse(const std::string& why) {
  throw RenderError("cameras take their pictures with OpenGL through EGL, but " + why +
                    ". On Debian, install the packages libegl1, libegl-mesa0, libgl1 and "
                    "libgl1-mesa-dri; worlds without cameras run without them");
}

// Checked first, because libepoxy ends the process when one of its libraries is missing.
void require_library(const char* name) {
  // Never closed: libepoxy keeps it open, too.
  if (!dlopen(name, RTLD_LAZY | RTLD_LOCAL)) {
    const char* problem = dlerror();
    refuse("the library " + std::string(name) + " cannot be loaded (" +
           (problem ? problem : "no reason given") + ")");
  }
}

/// True if a list of extensions, separated by spaces, contains this one.
bool lists(const char* extensions, std::string_view wanted) {
  const std::string_view all = extensions ? extensions : "";
  for (std::size_t at = all.find(wanted); at != all.npos; at = all.find(wanted, at + 1)) {
    const std::size_t end = at + wanted.size();
    if ((at == 0 || all[at - 1] == ' ') && (end == all.size() || all[end] == ' ')) {
      return true;
    }
  }
  return false;
}

template <class Function>
Function extension(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool software_wanted() {
  const char* wish = std::getenv("LIBGL_ALWAYS_SOFTWARE");
  const std::string_view value = wish ? wish : "";
  return !(value.empty() || value == "0" || value == "false" || value == "no");
}

/// Displays that need no screen, the best first: graphics cards, then those of the platform without
/// a surface (with Mesa, at least its software rasteriser).
std::vector<EGLDisplay> candidates() {
  std::vector<EGLDisplay> displays;
  const auto get_display = extension<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
  const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
  if (!get_display || !lists(client, "EGL_EXT_platform_base")) {
    return displays;
  }
  const auto query_devices = extension<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
  const auto query_device = extension<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
  if (query_devices && query_device && lists(client, "EGL_EXT_platform_device") &&
      !software_wanted()) {
    std::array<EGLDeviceEXT, 16> devices{};
    EGLint count = 0;
    if (query_devices(static_cast<EGLint>(devices.size()), devices.data(), &count)) {
      for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
        if (!lists(query_device(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software")) {
          displays.push_back(get_display(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
        }
      }
    }
  }
  displays.push_back(get_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr));
  return displays;
}

}  // namespace

EglContext::EglContext() {
  require_library("libEGL.so.1");
  if (!dlopen("libOpenGL.so.0", RTLD_LAZY | RTLD_LOCAL)) {
    require_library("libGL.so.1");
  }
  const EGLenum api_before = eglQueryAPI();
  bool opened = false;
  if (eglBindAPI(EGL_OPENGL_API)) {
    for (const EGLDisplay display : candidates()) {
      if (open(display)) {
        opened = true;
        break;
      }
    }
  }
  eglBindAPI(api_before);
  if (!opened) {
    refuse("no driver of EGL offers OpenGL 3.3 without a screen");
  }
}

// The display stays initialised: the process has only one, and other code may be using it.
bool EglContext::open(EGLDisplay display) {
  if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) {
    return false;
  }
  const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
  if (!lists(extensions, "EGL_KHR_surfaceless_context") ||
      !lists(extensions, "EGL_KHR_create_context") ||
      !lists(extensions, "EGL_KHR_no_config_context")) {
    return false;
  }
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION_KHR,
                               3,
                               EGL_CONTEXT_MINOR_VERSION_KHR,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK_KHR,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT_KHR,
                               EGL_NONE};
  context_ = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes);
  display_ = display;
  return context_ != EGL_NO_CONTEXT;
}

EglContext::~EglContext() { eglDestroyContext(display_, context_); }

EglContext::Current::Current(const EglContext& context)
    : display_(context.display_),
      api_before_(eglQueryAPI()),
      display_before_(eglGetCurrentDisplay()),
      draw_before_(eglGetCurrentSurface(EGL_DRAW)),
      read_before_(eglGetCurrentSurface(EGL_READ)),
      context_before_(eglGetCurrentContext()) {
  eglBindAPI(EGL_OPENGL_API);
  if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context.context_)) {
    eglBindAPI(api_before_);
    throw RenderError(
        "the pictures of cameras cannot be drawn: EGL does not let this thread use the renderer's "
        "context; it is perhaps in use by another thread, or the thread draws with GLX");
  }
}

EglContext::Current::~Current() {
  if (context_before_ == EGL_NO_CONTEXT) {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  } else {
    eglMakeCurrent(display_before_, draw_before_, read_before_, context_before_);
  }
  eglBindAPI(api_before_);
}

}  // namespace elsie::render

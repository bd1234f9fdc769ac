// Contexts, threads, and other users of OpenGL.
#include <thread>

#include <catch2/catch.hpp>
#include <epoxy/egl.h>

#include "darkroom.h"

using namespace elsie;
using namespace elsie::render;
using namespace elsie::render::test;

namespace {

Scene scene_of(const Colour& colour) {
  Scene scene;
  scene.boxes = {cube({1, 0, 1}, 0.2, colour)};
  return scene;
}

}  // namespace

TEST_CASE("A renderer may be used from one thread after the other") {
  Renderer here;
  const auto views = std::vector{view_from({0, 0, 1})};
  const Image first = take(scene_of(kRed), views, here).front();
  for (int i = 0; i < 3; ++i) {
    Image other;
    std::thread([&] { other = take(scene_of(kRed), views, here).front(); }).join();
    CHECK(other.bytes == first.bytes);
  }
  CHECK(take(scene_of(kRed), views, here).front().bytes == first.bytes);
  // Made in one thread, destroyed in another.
  std::unique_ptr<Renderer> elsewhere;
  std::thread([&] { elsewhere = std::make_unique<Renderer>(); }).join();
  CHECK(take(scene_of(kRed), views, *elsewhere).front().bytes == first.bytes);
  std::thread([&] { elsewhere.reset(); }).join();
  CHECK(take(scene_of(kRed), views, here).front().bytes == first.bytes);
}

TEST_CASE("Two renderers take pictures at the same time") {
  constexpr int kPictures = 200;
  int wrong[2] = {0, 0};
  const auto work = [&wrong](int which) {
    const Colour mine = which == 0 ? kRed : kBlue, others = which == 0 ? kBlue : kRed;
    Renderer own;
    for (int i = 0; i < kPictures; ++i) {
      const Image picture = take(scene_of(mine), {view_from({0, 0, 1})}, own).front();
      wrong[which] += find(picture, mine).area < 100 || find(picture, others).area > 0;
    }
  };
  std::thread first(work, 0), second(work, 1);
  first.join();
  second.join();
  CHECK(wrong[0] == 0);
  CHECK(wrong[1] == 0);
}

TEST_CASE("A destroyed renderer does not disturb others") {
  Renderer first;
  CHECK(find(take(scene_of(kRed), {view_from({0, 0, 1})}, first).front(), kRed).area > 100);
  { const Renderer second; }
  CHECK(find(take(scene_of(kRed), {view_from({0, 0, 1})}, first).front(), kRed).area > 100);
  CHECK_FALSE(first.device().empty());
}

TEST_CASE("The caller's own context is current again afterwards, and none if there was none") {
  take(scene_of(kRed), {view_from({0, 0, 1})});
  CHECK(eglGetCurrentContext() == EGL_NO_CONTEXT);

  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  REQUIRE(eglInitialize(display, nullptr, nullptr));
  REQUIRE(eglQueryAPI() == EGL_OPENGL_ES_API);  // as in a new thread
  const EGLint version[] = {EGL_CONTEXT_CLIENT_VERSION, 2, EGL_NONE};
  const EGLContext own = eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version);
  REQUIRE(own != EGL_NO_CONTEXT);
  REQUIRE(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, own));
  take(scene_of(kRed), {view_from({0, 0, 1})});
  CHECK(eglGetCurrentContext() == own);
  { const Renderer another; }
  CHECK(eglGetCurrentContext() == own);
  CHECK(eglQueryAPI() == EGL_OPENGL_ES_API);
  eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, own);
}

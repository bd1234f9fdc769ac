// Machines that cannot take pictures. EGL stays loaded until the process ends, so each case is a
// process of its own, which runs this test program again.
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <catch2/catch.hpp>
#include <sys/wait.h>
#include <unistd.h>

#include "elsie/render/renderer.h"

#include "folder.h"

using elsie::render::Renderer;
namespace fs = std::filesystem;

namespace {

struct Outcome {
  int exit_code = -1;
  std::string output;
};

/// Runs the hidden test case below with this environment.
Outcome make_renderer_with(const std::string& environment) {
  const std::string self = fs::read_symlink("/proc/self/exe").string();
  FILE* const pipe =
      popen(("env " + environment + " '" + self + "' '[makes-a-renderer]' 2>&1").c_str(), "r");
  REQUIRE(pipe);
  Outcome outcome;
  std::array<char, 4096> buffer{};
  while (const std::size_t count = fread(buffer.data(), 1, buffer.size(), pipe)) {
    outcome.output.append(buffer.data(), count);
  }
  const int status = pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

/// A folder with files that are no libraries, which the loader searches first.
class BrokenLibraries {
 public:
  explicit BrokenLibraries(const std::vector<std::string>& names) {
    for (const std::string& name : names) {
      folder_.write(name, "this is no library");
    }
  }

  std::string environment() const { return "LD_LIBRARY_PATH='" + folder_.path().string() + "'"; }

 private:
  elsie::test::Folder folder_;
};

}  // namespace

TEST_CASE("makes a renderer, or prints why it cannot", "[.][makes-a-renderer]") {
  try {
    const Renderer renderer;
    std::printf("draws with %s\n", renderer.device().c_str());
  } catch (const elsie::render::RenderError& error) {
    std::printf("REFUSED: %s\n", error.what());
  }
}

TEST_CASE("Where EGL works, a renderer says what it draws with") {
  const Outcome outcome = make_renderer_with("LIBGL_ALWAYS_SOFTWARE=1");
  CAPTURE(outcome.output);
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.output, Catch::Contains("draws with llvmpipe"));
}

TEST_CASE("Without a driver of EGL the error says what to install") {
  const Outcome outcome = make_renderer_with("__EGL_VENDOR_LIBRARY_FILENAMES=/nowhere.json");
  CAPTURE(outcome.output);
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.output,
             Catch::Contains("REFUSED: cameras take their pictures with OpenGL") &&
                 Catch::Contains("no driver of EGL") && Catch::Contains("install the packages") &&
                 Catch::Contains("libegl-mesa0") && Catch::Contains("libgl1-mesa-dri"));
}

TEST_CASE("Without Mesa's drivers it also says what to install") {
  const Outcome outcome = make_renderer_with("LIBGL_DRIVERS_PATH=/nowhere GALLIUM_DRIVER=nothing");
  CAPTURE(outcome.output);
  CHECK(outcome.exit_code == 0);
  CHECK_THAT(outcome.output,
             Catch::Contains("no driver of EGL") && Catch::Contains("libgl1-mesa-dri"));
}

TEST_CASE("Without the library of EGL or OpenGL the error names it") {
  const BrokenLibraries no_egl({"libEGL.so.1"});
  const Outcome first = make_renderer_with(no_egl.environment());
  CAPTURE(first.output);
  CHECK(first.exit_code == 0);
  CHECK_THAT(first.output, Catch::Contains("the library libEGL.so.1 cannot be loaded") &&
                               Catch::Contains("install the packages libegl1"));

  const BrokenLibraries no_gl({"libOpenGL.so.0", "libGL.so.1"});
  const Outcome second = make_renderer_with(no_gl.environment());
  CAPTURE(second.output);
  CHECK(second.exit_code == 0);
  CHECK_THAT(second.output, Catch::Contains("the library libGL.so.1 cannot be loaded") &&
                                Catch::Contains("libgl1"));
}

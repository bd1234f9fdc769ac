#include "elsie/render/renderer.h"

#include <algorithm>
#include <cstring>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "elsie/base/number_text.h"

#include "atlas.h"
#include "egl_context.h"
#include "instances.h"
#include "painter.h"
#include "show_painter.h"

namespace elsie::render {
namespace {

/// Copies `count` pixels of four bytes each without the fourth byte.
void drop_alpha(const std::uint8_t* from, std::uint8_t* to, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    to[3 * i] = from[4 * i];
    to[3 * i + 1] = from[4 * i + 1];
    to[3 * i + 2] = from[4 * i + 2];
  }
}

}  // namespace

class Renderer::Impl {
 public:
  Impl() {
    const EglContext::Current current(context_);
    painter_.emplace();
    GLint largest_buffer = 0, largest_viewport[2] = {0, 0};
    glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &largest_buffer);
    glGetIntegerv(GL_MAX_VIEWPORT_DIMS, largest_viewport);
    largest_ = std::min({largest_buffer, largest_viewport[0], largest_viewport[1]});
    const auto* name = reinterpret_cast<const char*>(glGetString(GL_RENDERER));
    device_ = name ? name : "";
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &colour_);
    glGenRenderbuffers(1, &depth_);
  }

  void render(const Scene& scene, std::span<const View> views, std::span<Image* const> pictures) {
    check(views, pictures.size());
    const EglContext::Current current(context_);
    while (!views.empty()) {
      const Atlas atlas = pack(views, largest_);
      const std::size_t count = atlas.tiles.size();
      for (auto& instances : list_) instances.clear();
      for (std::size_t i = 0; i < count; ++i) {
        add_view(scene, views[i], atlas, atlas.tiles[i], list_);
      }
      make_room(atlas.width, atlas.height);
      glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
      painter_->paint(list_, scene, atlas.width, atlas.height);
      read_back(atlas, pictures.first(count));
      views = views.subspan(count);
      pictures = pictures.subspan(count);
    }
  }

  void compose(const Scene& scene, const View& view, const Style& style) {
    check(std::span(&view, 1), 1);
    const EglContext::Current current(context_);
    if (!show_painter_) show_painter_.emplace();
    show_painter_->compose(scene, view, style);
  }

  void expose(Shadows shadows, Exposure& exposure) {
    const Camera& camera = show_painter_.value().camera();
    if (exposure.passes() == 0) exposure.begin(camera.width, camera.height);
    const EglContext::Current current(context_);
    // Mesa's software clears a whole framebuffer at once, but draws a rectangle to clear a part.
    if (camera.width != width_ || camera.height != height_) resize(camera.width, camera.height);
    show_painter_->paint(framebuffer_, shadows, exposure.passes());
    read(camera.width, camera.height, exposure.next());
    exposure.add();
  }

  int largest() const { return largest_; }
  const std::string& device() const { return device_; }

 private:
  void check(std::span<const View> views, std::size_t pictures) const {
    if (pictures != views.size()) {
      throw std::invalid_argument("there are " + std::to_string(views.size()) + " views, but " +
                                  std::to_string(pictures) + " pictures to be taken");
    }
    for (const View& view : views) {
      const Camera& camera = view.camera;
      if (camera.width < 1 || camera.height < 1 || camera.width > largest_ ||
          camera.height > largest_) {
        throw std::invalid_argument(
            "a picture of " + std::to_string(camera.width) + " x " + std::to_string(camera.height) +
            " pixels cannot be taken; here, both may be from 1 to " + std::to_string(largest_));
      }
      if (!(camera.horizontal_fov_rad > 0.0 && camera.horizontal_fov_rad < std::numbers::pi)) {
        throw std::invalid_argument("a camera with a horizontal field of view of " +
                                    base::number_text(degrees(camera.horizontal_fov_rad), 6) +
                                    " degrees takes no picture; it must be above 0 and below 180");
      }
    }
  }

  /// Makes the framebuffer at least this large.
  void make_room(int width, int height) {
    if (width > width_ || height > height_) {
      resize(std::max(width, width_), std::max(height, height_));
    }
  }

  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    while (glGetError() != GL_NO_ERROR) {
    }
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glBindRenderbuffer(GL_RENDERBUFFER, colour_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH24_STENCIL8, width_, height_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_STENCIL_ATTACHMENT, GL_RENDERBUFFER, depth_);
    if (glGetError() != GL_NO_ERROR ||
        glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
      const std::string size = std::to_string(width_) + " x " + std::to_string(height_);
      width_ = height_ = 0;
      throw RenderError("the OpenGL driver (" + device_ + ") has no room for pictures of " + size +
                        " pixels; take smaller ones");
    }
  }

  /// Reads the first rows and columns of the framebuffer, four bytes for each pixel.
  void read(int width, int height, std::uint8_t* pixels) const {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    if (const GLenum error = glGetError(); error != GL_NO_ERROR) {
      throw RenderError("the OpenGL driver (" + device_ +
                        ") failed to draw the pictures of cameras"
                        " (error " +
                        std::to_string(error) + ")");
    }
  }

  void read_back(const Atlas& atlas, std::span<Image* const> pictures) {
    const auto row_bytes = static_cast<std::size_t>(atlas.width) * 4;
    pixels_.resize(row_bytes * static_cast<std::size_t>(atlas.height));
    read(atlas.width, atlas.height, pixels_.data());
    for (std::size_t i = 0; i < pictures.size(); ++i) {
      const Tile& tile = atlas.tiles[i];
      Image& picture = *pictures[i];
      picture.width = tile.width;
      picture.height = tile.height;
      picture.channels = 3;
      const auto width = static_cast<std::size_t>(tile.width);
      picture.bytes.resize(3 * width * static_cast<std::size_t>(tile.height));
      for (int row = 0; row < tile.height; ++row) {
        const auto from = static_cast<std::size_t>(tile.y + row) * row_bytes +
                          static_cast<std::size_t>(tile.x) * 4;
        drop_alpha(&pixels_[from], &picture.bytes[3 * width * static_cast<std::size_t>(row)],
                   width);
      }
    }
  }

  EglContext context_;
  std::optional<Painter> painter_;
  std::optional<ShowPainter> show_painter_;  // made for the first picture for people
  GLuint framebuffer_ = 0, colour_ = 0, depth_ = 0;
  int width_ = 0, height_ = 0;  // of the framebuffer, px
  int largest_ = 0;
  std::string device_;
  DrawList list_;
  std::vector<std::uint8_t> pixels_;
};

Renderer::Renderer() : impl_(std::make_unique<Impl>()) {}
Renderer::~Renderer() = default;

void Renderer::render(const Scene& scene, std::span<const View> views,
                      std::span<Image* const> pictures) {
  impl_->render(scene, views, pictures);
}

void Renderer::compose(const Scene& scene, const View& view, const Style& style) {
  impl_->compose(scene, view, style);
}

void Renderer::expose(Shadows shadows, Exposure& exposure) { impl_->expose(shadows, exposure); }

int Renderer::largest_size() const { return impl_->largest(); }
const std::string& Renderer::device() const { return impl_->device(); }

}  // namespace elsie::render

// A recorded run as one self-contained HTML file that plays it: the world in three dimensions, who
// decided when, numbers, sketches and events, on one axis of time.
//
//   recording ──> Poses, Sketches ... (what changed when, rounded) ──> JSON, deflated ──> page
//   world ─────> render::WorldScene (the scene of cameras and viewers) ──┘               ▲
//                                        page.html, page.css, inflate.js ... viewer.js ──┘
//
// The page makes no request, and its policy lets the browser run the viewer's script alone. Texts
// of a world can therefore not run anything, and are escaped besides.
#pragma once

#include <filesystem>
#include <string>

#include "elsie/page/viewer.h"
#include "elsie/plugin/host.h"

namespace elsie::page {

struct RunPage {
  std::string html;
  double poses_every_s = 0.0;  // between two poses in the page
};

/// The page of a recording. The world needs no plugins but drives, as in save_picture(). The same
/// recording gives the same bytes.
///
/// Throws mcap::McapError for a file that cannot be read or is damaged; base::BadInput for a
/// recording without a world, which Elsie did not make or which breaks off before its first second;
/// world::WorldError when its world cannot be read (a file of a later version).
RunPage run_page(const std::filesystem::path& recording, const plugin::Host& drives,
                 const PageOptions& options = {});

}  // namespace elsie::page

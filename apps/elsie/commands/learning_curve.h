// Draws the learning curve of a training.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "elsie/neural/training.h"

namespace elsie::program {

/// The mean error over the presentations, on a linear and on a logarithmic axis. Throws as
/// picture::save_page().
void draw_learning_curve(const neural::Training& training, const std::string& title,
                         const std::vector<std::string>& subtitles,
                         const std::filesystem::path& file);

/// The reward of each episode, and the mean of each with those before it, `window` in all. Throws
/// as picture::save_page().
void draw_rewards(std::span<const double> rewards, std::size_t window, const std::string& title,
                  const std::vector<std::string>& subtitles, const std::filesystem::path& file);

}  // namespace elsie::program

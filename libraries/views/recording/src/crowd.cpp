#include "crowd.h"

#include <bit>
#include <cstring>

#include "elsie/files/base64.h"

#include "messages.h"
#include "reading.h"

namespace elsie::recording {
namespace {

constexpr const char* kNumbers[] = {"x", "y", "heading_rad"};
constexpr std::size_t kPointBytes = std::size(kNumbers) * sizeof(double);
constexpr int kFloat64 = 8;  // foxglove.NumericType

static_assert(std::endian::native == std::endian::little, "the order of bytes in the file");

Json cloud(std::uint64_t time_ns) {
  Json fields = Json::array();
  for (std::size_t i = 0; i < std::size(kNumbers); ++i) {
    fields.push_back({{"name", kNumbers[i]}, {"offset", i * sizeof(double)}, {"type", kFloat64}});
  }
  return {{"timestamp", time_json(time_ns)},
          {"frame_id", kWorldFrame},
          {"pose", {{"position", position_json({})}, {"orientation", rotation_json({})}}},
          {"point_stride", kPointBytes},
          {"fields", std::move(fields)}};
}

}  // namespace

std::string crowd_text(std::uint64_t time_ns, const simulation::Simulation& simulation,
                       std::span<const std::size_t> robots) {
  std::string bytes(robots.size() * kPointBytes, '\0');
  char* next = bytes.data();
  for (const std::size_t place : robots) {
    const Pose& pose = simulation.robot(place).pose;
    for (const double number : {pose.x, pose.y, pose.heading_rad}) {
      std::memcpy(next, &number, sizeof(number));
      next += sizeof(number);
    }
  }
  std::string text = text_of(cloud(time_ns));
  text.pop_back();
  return text + ",\"data\":\"" + files::base64(bytes) + "\"}";
}

std::vector<Pose> crowd_poses(const Json& message) {
  const auto bytes = files::from_base64(message.at("data").get_ref<const std::string&>());
  if (!bytes || bytes->size() % kPointBytes != 0 || message.at("point_stride") != kPointBytes) {
    throw Unexpected("its data are not points of " + std::to_string(kPointBytes) + " bytes");
  }
  std::vector<Pose> poses(bytes->size() / kPointBytes);
  const char* next = bytes->data();
  for (Pose& pose : poses) {
    for (double* const number : {&pose.x, &pose.y, &pose.heading_rad}) {
      std::memcpy(number, next, sizeof(*number));
      next += sizeof(*number);
    }
  }
  return poses;
}

}  // namespace elsie::recording

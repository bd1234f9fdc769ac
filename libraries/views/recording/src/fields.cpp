#include "fields.h"

#include "elsie/files/base64.h"

#include "messages.h"
#include "reading.h"

namespace elsie::recording {
namespace {

constexpr int kFloat32 = 7;       // foxglove.NumericType
constexpr double kAbove = 0.003;  // m, so that viewers draw it over the floor

}  // namespace

std::string field_text(std::uint64_t time_ns, const picture::FloorField& field, double length,
                       double width) {
  const std::size_t row = field.columns * sizeof(float);
  Json elements = Json::array();
  elements.push_back({{"name", "value"}, {"offset", 0}, {"type", kFloat32}});
  const Vector3 corner{-0.5 * length, -0.5 * width, kAbove};
  const Json message{
      {"timestamp", time_json(time_ns)},
      {"frame_id", kWorldFrame},
      {"pose", {{"position", position_json(corner)}, {"orientation", rotation_json({})}}},
      {"column_count", field.columns},
      {"cell_size",
       {{"x", length / static_cast<double>(field.columns)},
        {"y", width / static_cast<double>(field.rows)}}},
      {"row_stride", row},
      {"cell_stride", sizeof(float)},
      {"fields", std::move(elements)}};
  std::string text = text_of(message);
  text.pop_back();
  return text + ",\"data\":\"" + files::packed(field.values) + "\"}";
}

picture::FloorField recorded_field(const std::string& topic, const Json& message) {
  auto values = files::unpacked<float>(message.at("data").get_ref<const std::string&>());
  const auto columns = message.at("column_count").get<std::size_t>();
  if (!values || columns == 0 || values->empty() || values->size() % columns != 0) {
    throw Unexpected("its data are not rows of " + std::to_string(columns) + " numbers");
  }
  const std::size_t rows = values->size() / columns;
  return {topic.substr(field_topic("").size()), {}, {}, columns, rows, std::move(*values)};
}

}  // namespace elsie::recording

#include "elsie/mcap/reader.h"

#include <cstdio>
#include <fstream>
#include <utility>

#include "elsie/base/read_whole.h"
#include "elsie/base/words.h"

#include "bytes.h"
#include "compression.h"
#include "format.h"
#include "input_file.h"

namespace elsie::mcap {
namespace {

/// Thrown for bytes that do not follow the format; what() says how.
class Damage : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The name in a sentence: "the chunk".
std::string name_of(Opcode opcode) {
  switch (opcode) {
    case Opcode::header:
      return "the header";
    case Opcode::footer:
      return "the footer";
    case Opcode::schema:
      return "the schema";
    case Opcode::channel:
      return "the channel";
    case Opcode::message:
      return "the message";
    case Opcode::chunk:
      return "the chunk";
    case Opcode::attachment:
      return "the attachment";
    case Opcode::metadata:
      return "the metadata";
    case Opcode::data_end:
      return "the end of the data";
    default:
      return "the record";
  }
}

std::string hexadecimal(std::uint32_t value) {
  char digits[16];
  std::snprintf(digits, sizeof(digits), "%08x", static_cast<unsigned>(value));
  return digits;
}

/// Zero means no checksum.
void verify(std::uint32_t expected, std::uint32_t found) {
  if (expected != 0 && expected != found) {
    throw Damage("its checksum is " + hexadecimal(found) + " and should be " +
                 hexadecimal(expected));
  }
}

struct Record {
  std::uint64_t at = 0;  // in the file, or in its chunk
  Opcode opcode{};
  std::string_view content;
};

}  // namespace

class Reader::Impl {
 public:
  explicit Impl(const std::filesystem::path& file) : path_(file), in_(file) {
    const std::string magic = in_.take(kMagic.size());
    if (magic != kMagic) {
      const bool other = magic.size() == kMagic.size() &&
                         magic.substr(0, kVersionAt) == kMagic.substr(0, kVersionAt) &&
                         magic.substr(kVersionAt + 1) == kMagic.substr(kVersionAt + 1);
      throw McapError("'" + path_.string() + "' " +
                      (other ? "is an MCAP file of another version, '" +
                                   magic.substr(kVersionAt, 1) + "'; expected version '0'"
                             : "is not an MCAP file: it does not begin with the format's mark"));
    }
    const auto record = take();
    if (!record) {
      throw McapError("'" + path_.string() + "' breaks off in its header: " + missing_end_);
    }
    if (record->opcode != Opcode::header) {
      damaged(*record, "expected the header");
    }
    understand(*record, [&] {
      Bytes bytes(record->content);
      header_.profile = bytes.text();
      header_.library = bytes.text();
    });
  }

  std::optional<Message> next() {
    if (!failure_.empty()) {
      throw McapError(failure_);
    }
    while (!ended_) {
      if (const auto message = next_in_chunk()) {
        return message;
      }
      const auto record = take();
      if (!record) {
        ended_ = true;
        break;
      }
      std::optional<Message> message;
      understand(*record, [&] { message = read(*record); });
      if (message) {
        return message;
      }
    }
    return std::nullopt;
  }

  std::filesystem::path path_;
  InputFile in_;
  Header header_;
  std::map<std::uint16_t, Schema> schemas_;
  std::map<std::uint16_t, Channel> channels_;
  std::vector<Metadata> metadata_;
  std::uint64_t chunk_count_ = 0;
  std::string missing_end_;

 private:
  /// The next record of the file; none where it breaks off.
  std::optional<Record> take() {
    Record record;
    record.at = in_.at();
    checksum_before_ = in_.checksum();
    if (in_.left() < kPrefix) {
      return broken_off(record);
    }
    const std::string prefix_bytes = in_.take(kPrefix);
    Bytes prefix(prefix_bytes);
    record.opcode = Opcode{prefix.number<std::uint8_t>()};
    const auto length = prefix.number<std::uint64_t>();
    if (record.opcode == Opcode{0}) {
      damaged(record, "found a record of kind 0, which does not exist");
    }
    if (length > in_.left()) {
      return broken_off(record);
    }
    bytes_ = in_.take(length);
    record.content = bytes_;
    return record;
  }

  std::optional<Record> broken_off(const Record& record) {
    if (in_.ends_whole()) {
      damaged(record, "it is longer than the rest of the file");
    }
    missing_end_ = "the end is missing: the file breaks off at byte " +
                   std::to_string(in_.at() + in_.left()) + ", after " +
                   base::counted(chunk_count_, "complete chunk") +
                   "; the program that wrote it was killed, or is still at work";
    return std::nullopt;
  }

  [[noreturn]] void damaged(const Record& record, const std::string& problem) {
    failure_ = "'" + path_.string() + "' is damaged: " + name_of(record.opcode) + " at byte " +
               std::to_string(record.at) + ": " + problem;
    throw McapError(failure_);
  }

  template <class Reading>
  void understand(const Record& record, Reading reading) {
    try {
      reading();
    } catch (const TooShort&) {
      damaged(record, "it is shorter than the contents that it declares");
    } catch (const Damage& damage) {
      damaged(record, damage.what());
    }
  }

  /// A record of the file.
  std::optional<Message> read(const Record& record) {
    Bytes bytes(record.content);
    switch (record.opcode) {
      case Opcode::chunk:
        open_chunk(record.at, bytes);
        return std::nullopt;
      case Opcode::metadata:
        if (!data_ended_) {
          Metadata metadata{std::string(bytes.text()), {}};
          metadata.values = bytes.texts();
          metadata_.push_back(std::move(metadata));
        }
        return std::nullopt;
      case Opcode::attachment:
        check_attachment(record.content);
        return std::nullopt;
      case Opcode::data_end:
        verify(bytes.number<std::uint32_t>(), checksum_before_);
        data_ended_ = true;
        return std::nullopt;
      case Opcode::footer:
        finish(record, bytes);
        return std::nullopt;
      case Opcode::schema:
      case Opcode::channel:
      case Opcode::message:
        note_summary(record);
        return read_within(record);
      default:
        note_summary(record);
        return std::nullopt;
    }
  }

  /// The checksum of the summary covers everything after the data.
  void note_summary(const Record& record) {
    if (data_ended_) {
      if (summary_start_ == 0) {
        summary_start_ = record.at;
      }
      add_to_summary(record, record.content);
    }
  }

  void add_to_summary(const Record& record, std::string_view content) {
    std::string prefix;
    put(prefix, static_cast<std::uint8_t>(record.opcode));
    put(prefix, std::uint64_t{record.content.size()});
    summary_checksum_ = crc(content, crc(prefix, summary_checksum_));
  }

  void finish(const Record& record, Bytes bytes) {
    const auto summary_start = bytes.number<std::uint64_t>();
    bytes.number<std::uint64_t>();
    if (summary_start != summary_start_) {
      throw Damage("it says that the summary begins at byte " + std::to_string(summary_start) +
                   ", but that is at byte " + std::to_string(summary_start_));
    }
    add_to_summary(record, record.content.substr(0, kFooterPlaces));
    verify(bytes.number<std::uint32_t>(), summary_checksum_);
    const std::uint64_t left = in_.left();
    if (left < kMagic.size() && !in_.ends_whole()) {
      broken_off(record);
    } else if (in_.take(left) != kMagic) {
      throw Damage("expected nothing but the format's mark behind it");
    }
    ended_ = true;
  }

  static void check_attachment(std::string_view content) {
    constexpr std::size_t kChecksum = sizeof(std::uint32_t);
    if (content.size() < kChecksum) {
      throw TooShort();
    }
    const std::size_t size = content.size() - kChecksum;
    verify(Bytes(content.substr(size)).number<std::uint32_t>(), crc(content.substr(0, size)));
  }

  void open_chunk(std::uint64_t at, Bytes bytes) {
    bytes.number<std::uint64_t>();  // times, which its messages also have
    bytes.number<std::uint64_t>();
    const auto size = bytes.number<std::uint64_t>();
    const auto checksum = bytes.number<std::uint32_t>();
    const std::string_view compression = bytes.text();
    const std::string_view content = bytes.take(bytes.number<std::uint64_t>());
    if (compression == "zstd") {
      std::string problem;
      chunk_ = decompressed(content, size, problem);
      if (!problem.empty()) {
        throw Damage("it cannot be decompressed: " + problem);
      }
    } else if (compression.empty()) {
      if (content.size() != size) {
        throw Damage("it holds " + std::to_string(content.size()) + " bytes and should hold " +
                     std::to_string(size));
      }
      chunk_ = content;
    } else {
      throw Damage("it is compressed with '" + std::string(compression) +
                   "'; this program reads 'zstd', or no compression");
    }
    verify(checksum, crc(chunk_));
    chunk_at_ = at;
    in_chunk_ = 0;
    ++chunk_count_;
  }

  std::optional<Message> next_in_chunk() {
    const Record chunk{chunk_at_, Opcode::chunk, {}};
    std::optional<Message> message;
    understand(chunk, [&] {
      while (!message && in_chunk_ < chunk_.size()) {
        Bytes bytes(std::string_view(chunk_).substr(in_chunk_));
        Record record;
        record.opcode = Opcode{bytes.number<std::uint8_t>()};
        record.content = bytes.take(bytes.number<std::uint64_t>());
        in_chunk_ += kPrefix + record.content.size();
        message = read_within(record);
      }
    });
    return message;
  }

  /// A record that may be in a chunk or outside of one.
  std::optional<Message> read_within(const Record& record) {
    Bytes bytes(record.content);
    if (record.opcode == Opcode::schema) {
      Schema schema;
      schema.id = bytes.number<std::uint16_t>();
      schema.name = bytes.text();
      schema.encoding = bytes.text();
      schema.data = bytes.text();
      if (schema.id != 0) {  // 0: the format says to ignore it
        const std::uint16_t id = schema.id;
        schemas_.insert_or_assign(id, std::move(schema));
      }
    } else if (record.opcode == Opcode::channel) {
      Channel channel;
      channel.id = bytes.number<std::uint16_t>();
      channel.schema = bytes.number<std::uint16_t>();
      channel.topic = bytes.text();
      channel.encoding = bytes.text();
      channel.metadata = bytes.texts();
      if (channel.schema != 0 && !schemas_.contains(channel.schema)) {
        throw Damage("channel '" + channel.topic + "' names schema " +
                     std::to_string(channel.schema) + ", which is not there");
      }
      const std::uint16_t id = channel.id;
      channels_.insert_or_assign(id, std::move(channel));
    } else if (record.opcode == Opcode::message) {
      Message message;
      message.channel = bytes.number<std::uint16_t>();
      message.sequence = bytes.number<std::uint32_t>();
      message.log_time_ns = bytes.number<std::uint64_t>();
      message.publish_time_ns = bytes.number<std::uint64_t>();
      message.data = bytes.rest();
      if (!channels_.contains(message.channel)) {
        throw Damage("a message is of channel " + std::to_string(message.channel) +
                     ", which is not there");
      }
      return message;
    }
    return std::nullopt;
  }

  std::string bytes_;                  // of the record that was last taken
  std::uint32_t checksum_before_ = 0;  // of everything before it
  std::string chunk_;
  std::uint64_t chunk_at_ = 0;
  std::size_t in_chunk_ = 0;  // how much was read
  bool data_ended_ = false;
  bool ended_ = false;
  std::uint64_t summary_start_ = 0;
  std::uint32_t summary_checksum_ = 0;
  std::string failure_;
};

Reader::Reader(const std::filesystem::path& file) : impl_(std::make_unique<Impl>(file)) {}
Reader::~Reader() = default;

const Header& Reader::header() const { return impl_->header_; }
std::optional<Message> Reader::next() { return impl_->next(); }
const std::map<std::uint16_t, Schema>& Reader::schemas() const { return impl_->schemas_; }
const std::map<std::uint16_t, Channel>& Reader::channels() const { return impl_->channels_; }
const std::vector<Metadata>& Reader::metadata() const { return impl_->metadata_; }
std::uint64_t Reader::chunks() const { return impl_->chunk_count_; }
const std::string& Reader::missing_end() const { return impl_->missing_end_; }

bool may_be_mcap(const std::filesystem::path& file) {
  if (!base::why_unreadable(file).empty()) {
    return false;
  }
  std::ifstream in(file, std::ios::binary);
  std::string start(kVersionAt, '\0');
  in.read(start.data(), static_cast<std::streamsize>(start.size()));
  return in && start == kMagic.substr(0, kVersionAt);
}

}  // namespace elsie::mcap

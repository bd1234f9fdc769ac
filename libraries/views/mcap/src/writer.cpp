#include "elsie/mcap/writer.h"

#include <algorithm>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "elsie/files/output_file.h"

#include "bytes.h"
#include "compression.h"
#include "record_writing.h"

namespace elsie::mcap {
namespace {

// A chunk's record without the names of compressions and without its records: prefix, two times,
// size, checksum, length of the compression's name, length of the records.
constexpr std::size_t kChunkHead =
    kPrefix + 3 * sizeof(std::uint64_t) + 2 * sizeof(std::uint32_t) + sizeof(std::uint64_t);

constexpr std::size_t kMostKept = 4;     // chunks, of the memory that a large message has taken
constexpr std::size_t kTimeDigits = 20;  // of the time in the last words

void check_count(std::size_t count, const char* what) {
  if (count >= std::numeric_limits<std::uint16_t>::max()) {
    throw std::length_error(std::string("MCAP: more than 65535 ") + what);
  }
}

[[noreturn]] void refuse(const std::string& sentence) { throw McapError(sentence); }

}  // namespace

class Writer::Impl {
 public:
  Impl(const std::filesystem::path& file, WriterOptions options)
      : options_(std::move(options)),
        compress_(options_.level),
        out_("recording '" + file.string() + "'", refuse) {
    out_.create(file);
    std::string head(kMagic);
    append(head, Header{options_.profile, options_.library});
    add(head);
    emergency_head_.reserve(kChunkHead);
  }

  std::uint16_t add_schema(std::string name, std::string encoding, std::string data) {
    check_count(schemas_.size(), "schemas");
    schemas_.push_back({static_cast<std::uint16_t>(schemas_.size() + 1), std::move(name),
                        std::move(encoding), std::move(data)});
    append(records_, schemas_.back());
    return schemas_.back().id;
  }

  std::uint16_t add_channel(Channel channel) {
    check_count(channels_.size(), "channels");
    if (channel.schema > schemas_.size()) {
      throw std::invalid_argument("MCAP: channel '" + channel.topic + "' names schema " +
                                  std::to_string(channel.schema) + ", which is not there");
    }
    channel.id = static_cast<std::uint16_t>(channels_.size() + 1);
    append(records_, channel);
    channels_.push_back(std::move(channel));
    places_.emplace_back();
    sequences_.push_back(0);
    return channels_.back().id;
  }

  void write(Message message) {
    if (message.channel == 0 || message.channel > channels_.size()) {
      throw std::invalid_argument("MCAP: there is no channel " + std::to_string(message.channel));
    }
    pass(message.log_time_ns);
    const std::size_t channel = message.channel - 1U;
    message.sequence = sequences_[channel]++;
    places_[channel].push_back({message.log_time_ns, records_.size()});
    append(records_, message);
    first_ns_ = messages_ == 0 ? message.log_time_ns : std::min(first_ns_, message.log_time_ns);
    last_ns_ = messages_ == 0 ? message.log_time_ns : std::max(last_ns_, message.log_time_ns);
    ++messages_;
  }

  void pass(std::uint64_t now_ns) {
    now_ns_ = std::max(now_ns_, now_ns);
    if (full(now_ns)) {
      flush();
    }
  }

  void write(const Metadata& metadata) {
    flush();
    std::string piece;
    append(piece, metadata);
    metadata_.push_back({out_.size(), piece.size(), metadata.name});
    add(piece);
  }

  void flush() {
    if (records_.empty()) {
      return;
    }
    const bool compressed = options_.compression == Compression::zstd;
    const std::string packed = compressed ? compress_(records_) : std::string();
    const std::string_view content = compressed ? packed : records_;
    ChunkPlace chunk = begun();
    chunk.compression = compressed ? "zstd" : "";
    chunk.compressed_size = content.size();
    chunk.length = kChunkHead + chunk.compression.size() + content.size();
    std::string piece;
    append_chunk_head(piece, chunk, crc(records_));
    piece += content;
    append_message_indexes(piece, chunk);
    const std::uint64_t messages = std::exchange(messages_, 0);
    records_.clear();
    if (records_.capacity() > kMostKept * options_.chunk_bytes) {
      records_.shrink_to_fit();
    }
    for (auto& places : places_) {
      places.clear();
    }
    add(piece);
    count(chunk, messages);
    chunks_.push_back(std::move(chunk));
  }

  void close() {
    flush();
    std::string end;
    append_data_end(end, checksum_);
    const std::uint64_t start = out_.size() + end.size();
    std::string summary;
    std::vector<Group> groups;
    const auto add_group = [&]<class Record>(Opcode opcode, std::span<const Record> records) {
      const std::size_t before = summary.size();
      for (const Record& record : records) {
        append(summary, record);
      }
      if (!records.empty()) {
        groups.push_back({opcode, start + before, summary.size() - before});
      }
    };
    add_group(Opcode::schema, std::span<const Schema>(schemas_));
    add_group(Opcode::channel, std::span<const Channel>(channels_));
    add_group(Opcode::statistics, std::span<const Statistics>(&statistics(), 1));
    add_group(Opcode::chunk_index, std::span<const ChunkPlace>(chunks_));
    add_group(Opcode::metadata_index, std::span<const MetadataPlace>(metadata_));
    const std::uint64_t offsets = start + summary.size();
    for (const Group& group : groups) {
      append(summary, group);
    }
    append_footer(summary, start, offsets);
    out_.write_piece(end + summary + std::string(kMagic));
    out_.close();
  }

  void set_last_words(Metadata metadata, const std::string& time) {
    const std::string digits(kTimeDigits, '#');
    metadata.values[time] = digits;
    last_words_.clear();
    append(last_words_, metadata);
    time_at_ = last_words_.find(digits);
  }

  bool write_in_emergency() noexcept {
    if (!out_.is_open()) {
      return false;
    }
    if (!last_words_.empty()) {
      // "0000000012.340000000"
      std::uint64_t rest = now_ns_;
      for (std::size_t i = kTimeDigits; i-- > 0;) {
        const bool point = i == kTimeDigits - 10;
        last_words_[time_at_ + i] = point ? '.' : static_cast<char>('0' + rest % 10);
        rest = point ? rest : rest / 10;
      }
    }
    emergency_head_.clear();
    if (!records_.empty()) {
      ChunkPlace chunk = begun();
      chunk.compressed_size = records_.size();
      chunk.length = kChunkHead + records_.size();
      append_chunk_head(emergency_head_, chunk, crc(records_));
    }
    out_.write_now({emergency_head_, records_, last_words_});
    return true;
  }

  bool is_open() const { return out_.is_open(); }

 private:
  void add(const std::string& piece) {
    out_.write_piece(piece);
    checksum_ = crc(piece, checksum_);
  }

  bool full(std::uint64_t log_time_ns) const {
    return messages_ > 0 &&
           (records_.size() >= options_.chunk_bytes ||
            (log_time_ns >= first_ns_ && log_time_ns - first_ns_ >= options_.chunk_ns));
  }

  /// The current chunk, as far as it is known. Allocates no memory.
  ChunkPlace begun() const {
    ChunkPlace chunk;
    chunk.first_ns = messages_ > 0 ? first_ns_ : 0;
    chunk.last_ns = messages_ > 0 ? last_ns_ : 0;
    chunk.start = out_.size();
    chunk.size = records_.size();
    return chunk;
  }

  void append_message_indexes(std::string& piece, ChunkPlace& chunk) const {
    const std::size_t before = piece.size();
    for (std::size_t i = 0; i < places_.size(); ++i) {
      if (!places_[i].empty()) {
        chunk.message_indexes[channels_[i].id] = chunk.start + piece.size();
        append(piece, channels_[i].id, places_[i]);
      }
    }
    chunk.message_indexes_length = piece.size() - before;
  }

  void count(const ChunkPlace& chunk, std::uint64_t messages) {
    if (messages > 0) {
      statistics_.first_ns = statistics_.messages > 0
                                 ? std::min(statistics_.first_ns, chunk.first_ns)
                                 : chunk.first_ns;
      statistics_.last_ns = std::max(statistics_.last_ns, chunk.last_ns);
      statistics_.messages += messages;
    }
    ++statistics_.chunks;
  }

  const Statistics& statistics() {
    statistics_.schemas = static_cast<std::uint16_t>(schemas_.size());
    statistics_.channels = static_cast<std::uint32_t>(channels_.size());
    statistics_.metadata = static_cast<std::uint32_t>(metadata_.size());
    for (const Channel& channel : channels_) {
      statistics_.by_channel[channel.id] = sequences_[channel.id - 1U];
    }
    return statistics_;
  }

  WriterOptions options_;
  Compressor compress_;
  files::OutputFile out_;
  std::uint32_t checksum_ = 0;  // of everything written
  std::vector<Schema> schemas_;
  std::vector<Channel> channels_;
  std::vector<std::uint32_t> sequences_;  // messages of each channel so far
  // The current chunk.
  std::string records_;
  std::uint64_t messages_ = 0;
  std::uint64_t first_ns_ = 0, last_ns_ = 0;
  std::vector<std::vector<MessagePlace>> places_;  // of each channel
  std::string emergency_head_, last_words_;
  std::size_t time_at_ = 0;  // in the last words
  std::uint64_t now_ns_ = 0;
  // For the summary.
  std::vector<ChunkPlace> chunks_;
  std::vector<MetadataPlace> metadata_;
  Statistics statistics_;
};

Writer::Writer(const std::filesystem::path& file, WriterOptions options)
    : impl_(std::make_unique<Impl>(file, std::move(options))) {}

Writer::~Writer() {
  try {
    if (impl_->is_open()) {
      impl_->flush();
    }
  } catch (const std::exception&) {
    // Callers that need the error call flush() or close().
  }
}

std::uint16_t Writer::add_schema(std::string name, std::string encoding, std::string data) {
  return impl_->add_schema(std::move(name), std::move(encoding), std::move(data));
}
std::uint16_t Writer::add_channel(std::string topic, std::uint16_t schema, std::string encoding,
                                  std::map<std::string, std::string> metadata) {
  return impl_->add_channel(
      {0, schema, std::move(topic), std::move(encoding), std::move(metadata)});
}
void Writer::write(std::uint16_t channel, std::uint64_t log_time_ns, std::string_view data,
                   std::optional<std::uint64_t> publish_time_ns) {
  impl_->write({channel, 0, log_time_ns, publish_time_ns.value_or(log_time_ns), data});
}
void Writer::write(const Metadata& metadata) { impl_->write(metadata); }
void Writer::pass(std::uint64_t now_ns) { impl_->pass(now_ns); }
void Writer::flush() { impl_->flush(); }
void Writer::close() { impl_->close(); }
void Writer::set_last_words(Metadata metadata, const std::string& time) {
  impl_->set_last_words(std::move(metadata), time);
}
bool Writer::write_in_emergency() noexcept { return impl_->write_in_emergency(); }

}  // namespace elsie::mcap

#include "outbox.h"

#include <algorithm>
#include <utility>

namespace elsie::live {

void Outbox::push(Frame frame) {
  if (!frame.stream) {
    answer_bytes_ += frame.size();
    if (!is_flooded()) frames_.push_back(std::move(frame));
    return;
  }
  message_bytes_ += frame.size();
  ++waiting_[*frame.stream];
  frames_.push_back(std::move(frame));
  while (message_bytes_ > kMostBytes) {
    const auto oldest = std::find_if(frames_.begin(), frames_.end(), [&](const Frame& each) {
      return each.stream && waiting_[*each.stream] > 1;
    });
    if (oldest == frames_.end()) return;
    remove(oldest);
    ++dropped_;
  }
}

std::optional<Frame> Outbox::pop() {
  if (frames_.empty()) return std::nullopt;
  Frame frame = frames_.front();  // its body is shared
  remove(frames_.begin());
  return frame;
}

void Outbox::forget(std::uint64_t stream) {
  for (auto at = frames_.begin(); at != frames_.end();) {
    if (at->stream == stream) {
      message_bytes_ -= at->size();
      at = frames_.erase(at);
    } else {
      ++at;
    }
  }
  waiting_.erase(stream);
}

void Outbox::remove(const std::deque<Frame>::iterator& at) {
  if (at->stream) {
    message_bytes_ -= at->size();
    --waiting_[*at->stream];
  } else {
    answer_bytes_ -= at->size();
  }
  frames_.erase(at);
}

}  // namespace elsie::live

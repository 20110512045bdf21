#include "gateway/send_queue.hpp"

#include "ciel/types.hpp"

#include <algorithm>
#include <utility>

namespace server::gateway {

SendQueue::SendQueue(std::size_t most_bytes, limits::Memory& memory, std::function<void()> on_push)
    : on_push_(std::move(on_push)), share_(most_bytes / 2), held_(memory, limits::Held::unsent) {}

void SendQueue::push_text(std::string text) {
    const std::lock_guard lock(mutex_);
    if (!on_push_ || overflowed_) return;
    if (text_bytes_ > share_) {
        overflowed_ = true;
        forget();
    } else {
        text_bytes_ += text.size();
        texts_.push_back(std::move(text));
    }
    count();
    on_push_();
}

void SendQueue::push_frame(FrameBytes bytes) {
    const wire::FrameHeader header = wire::read_frame_header(*bytes);
    if (header.payload_bytes != header.whole_bytes) throw ciel::Error("a frame was given to the send queue in pieces");
    const std::lock_guard lock(mutex_);
    if (!on_push_ || overflowed_) return;
    if (header.kind == wire::FrameKind::image || (header.flags & wire::first_of_frame) != 0)
        dropped_ += std::erase_if(frames_, [&](const Waiting& other) {
            if (other.header.view != header.view) return false;
            frame_bytes_ -= other.bytes->size();
            return true;
        });
    frame_bytes_ += bytes->size();
    frames_.push_back({std::move(bytes), header});
    count();
    on_push_();
}

void SendQueue::close() {
    const std::lock_guard lock(mutex_);
    on_push_ = nullptr;
    forget();
    count();
}

void SendQueue::forget() {
    texts_.clear();
    frames_.clear();
    text_bytes_ = frame_bytes_ = 0;
}

void SendQueue::count() { held_.note(text_bytes_ + text_taken_ + frame_bytes_ + frame_taken_); }

bool SendQueue::has_room(std::size_t bytes) {
    const std::lock_guard lock(mutex_);
    const std::size_t frames = frame_bytes_ + frame_taken_;
    if (frames == 0 || frames + bytes <= share_) return true;
    had_no_room_ = true;
    return false;
}

bool SendQueue::sent() {
    const std::lock_guard lock(mutex_);
    text_taken_ = frame_taken_ = 0;
    count();
    return frame_bytes_ <= share_ / 2 && std::exchange(had_no_room_, false);
}

std::uint32_t SendQueue::Waiting::next_piece_bytes() const {
    const bool measures = (header.flags & wire::first_of_frame) != 0 && header.whole_bytes >= measuring_bytes;
    return measures && sent == 0 ? first_piece_bytes : piece_bytes;
}

std::optional<SendQueue::Message> SendQueue::pop() {
    const std::lock_guard lock(mutex_);
    Message message{};
    if (!texts_.empty()) {
        message.text = std::move(texts_.front());
        texts_.pop_front();
        text_taken_ = message.text.size();
        text_bytes_ -= text_taken_;
        return message;
    }
    if (frames_.empty()) return std::nullopt;
    Waiting& frame = frames_.front();
    const wire::FrameHeader piece = wire::piece_of(frame.header, frame.sent, frame.next_piece_bytes());
    wire::write_frame_header(piece, message.header);
    message.frame = frame.bytes;
    message.payload = std::span(*frame.bytes).subspan(wire::frame_header_bytes + frame.sent, piece.payload_bytes);
    frame.sent += piece.payload_bytes;
    if (frame.sent == frame.header.whole_bytes) {
        frame_taken_ = frame.bytes->size();
        frame_bytes_ -= frame_taken_;
        frames_.pop_front();
    }
    return message;
}

bool SendQueue::overflowed() const {
    const std::lock_guard lock(mutex_);
    return overflowed_;
}

std::uint64_t SendQueue::dropped_frames() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
}

} // namespace server::gateway

#include "gateway/outbox.hpp"

#include "ciel/types.hpp"

#include <algorithm>

namespace ciel::gateway {

Outbox::Outbox(std::size_t text_limit_bytes, std::function<void()> on_push)
    : on_push_(std::move(on_push)), text_limit_(text_limit_bytes) {}

void Outbox::push_text(std::string text) {
    const std::lock_guard lock(mutex_);
    if (!on_push_ || overflowed_) return;
    if (text_bytes_ > text_limit_) {
        overflowed_ = true;
        texts_.clear();
        frames_.clear();
    } else {
        text_bytes_ += text.size();
        texts_.push_back(std::move(text));
    }
    on_push_();
}

void Outbox::push_frame(FrameBytes bytes) {
    const wire::FrameHeader header = wire::read_frame_header(*bytes);
    if (header.payload_bytes != header.whole_bytes) throw Error("a frame was given to the outbox in pieces");
    const std::lock_guard lock(mutex_);
    if (!on_push_ || overflowed_) return;
    if (header.kind == wire::FrameKind::image || (header.flags & wire::first_of_frame) != 0)
        dropped_ += std::erase_if(frames_, [&](const Waiting& other) { return other.header.view == header.view; });
    frames_.push_back({std::move(bytes), header});
    on_push_();
}

void Outbox::close() {
    const std::lock_guard lock(mutex_);
    on_push_ = nullptr;
    texts_.clear();
    frames_.clear();
}

std::optional<Outbox::Message> Outbox::pop() {
    const std::lock_guard lock(mutex_);
    Message message{};
    if (!texts_.empty()) {
        message.text = std::move(texts_.front());
        texts_.pop_front();
        text_bytes_ -= message.text.size();
        return message;
    }
    if (frames_.empty()) return std::nullopt;
    Waiting& frame = frames_.front();
    const wire::FrameHeader piece = wire::piece_of(frame.header, frame.sent, piece_bytes);
    wire::write_frame_header(piece, message.header);
    message.frame = frame.bytes;
    message.payload = std::span(*frame.bytes).subspan(wire::frame_header_bytes + frame.sent, piece.payload_bytes);
    frame.sent += piece.payload_bytes;
    if (frame.sent == frame.header.whole_bytes) frames_.pop_front();
    return message;
}

bool Outbox::overflowed() const {
    const std::lock_guard lock(mutex_);
    return overflowed_;
}

std::uint64_t Outbox::dropped_frames() const {
    const std::lock_guard lock(mutex_);
    return dropped_;
}

} // namespace ciel::gateway

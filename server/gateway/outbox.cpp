#include "gateway/outbox.hpp"

#include "wire/frame_header.hpp"

#include <algorithm>

namespace ciel::gateway {

Outbox::Outbox(std::size_t text_limit_bytes, std::function<void()> on_push)
    : on_push_(std::move(on_push)), text_limit_(text_limit_bytes) {}

void Outbox::push_text(std::string text) {
    const std::lock_guard lock(mutex_);
    if (!on_push_ || overflowed_) return;
    if (text_bytes_ > text_limit_) {
        overflowed_ = true;
        waiting_.clear();
    } else {
        text_bytes_ += text.size();
        waiting_.push_back({{std::move(text), nullptr}, 0});
    }
    on_push_();
}

void Outbox::push_frame(FrameBytes bytes) {
    const wire::FrameHeader header = wire::read_frame_header(*bytes);
    const std::lock_guard lock(mutex_);
    if (!on_push_ || overflowed_) return;
    if (header.kind == wire::FrameKind::image || (header.flags & wire::first_of_frame) != 0)
        dropped_ += std::erase_if(
            waiting_, [&](const Waiting& other) { return other.message.frame && other.view == header.view; });
    waiting_.push_back({{{}, std::move(bytes)}, header.view});
    on_push_();
}

void Outbox::close() {
    const std::lock_guard lock(mutex_);
    on_push_ = nullptr;
    waiting_.clear();
}

std::optional<Outbox::Message> Outbox::pop() {
    const std::lock_guard lock(mutex_);
    if (waiting_.empty()) return std::nullopt;
    Message message = std::move(waiting_.front().message);
    waiting_.pop_front();
    if (!message.frame) text_bytes_ -= message.text.size();
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

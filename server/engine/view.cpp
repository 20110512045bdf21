#include "engine/view.hpp"

#include "engine/frame_loop.hpp"
#include "engine/schedule/run_job.hpp"
#include "frames/picture.hpp"
#include "limits/errors.hpp"
#include "logging/log.hpp"
#include "protocol/json.hpp"
#include "sessions/notify.hpp"

#include <algorithm>

namespace server::engine {
namespace {

constexpr double slow_frame_ms = 1000, slow_still_ms = 10'000; // slower frames are logged

} // namespace

View::View(std::uint32_t id, std::shared_ptr<OpenSession> session, std::shared_ptr<sessions::Connection> connection,
           const EngineServices& services, geometry::ViewSize size, Stream stream, wire::MovingCodec moving)
    : id_(id), session_(std::move(session)), connection_(std::move(connection)), services_(services), size_(size),
      window_(services.limits.unacknowledged_frames), stream_(stream), moving_(moving) {}

void View::offer(std::shared_ptr<const sessions::SceneVersion> version) {
    const std::scoped_lock lock(mutex_);
    schedule_.offer(std::move(version), Clock::now());
    post_job();
}

void View::again() {
    if (!schedule_.again()) return;
    content_.clear();
    ids_of_frame_.clear(); // all arrays are sent again, because the client may have lost some
    post_job();
}

void View::resize(std::uint32_t width, std::uint32_t height, std::optional<double> pixel_ratio) {
    const std::scoped_lock lock(mutex_);
    size_ = {width, height, pixel_ratio.value_or(size_.pixel_ratio)};
    again();
}

void View::set_stream(Stream stream, std::optional<wire::MovingCodec> moving) {
    const std::scoped_lock lock(mutex_);
    moving_ = moving.value_or(moving_);
    if (stream_ == stream) return;
    stream_ = stream;
    again();
}

void View::acknowledge(std::uint32_t frame) {
    const std::scoped_lock lock(mutex_);
    if (frame > sent_ || !window_.acknowledged(frame, Clock::now())) return;
    held_ = frame;
    ids_of_frame_.erase(ids_of_frame_.begin(), ids_of_frame_.lower_bound(frame));
    schedule_.acknowledged(Clock::now());
    post_job();
}

void View::look_again() {
    const std::scoped_lock lock(mutex_);
    post_job();
}

void View::close() {
    const std::scoped_lock lock(mutex_);
    schedule_.close();
}

void View::post_job() {
    if (!schedule_.may_post()) return;
    if (!window_.has_room()) {
        if (schedule_.has_change()) window_.held_back();
        return;
    }
    if (!connection_->may_send(frame_bytes_)) return; // look_again() is called when there is room
    const std::weak_ptr<View> weak = weak_from_this();
    const auto job = [&](bool still) {
        return [weak, still](Worker& worker) {
            if (const auto view = weak.lock()) show_frame(*view, worker, still);
        };
    };
    if (schedule_.has_change())
        schedule_.posted(false, services_.workers.post(job(false)));
    else if (schedule_.lacks_still())
        schedule_.posted(true, services_.workers.post_later(schedule_.still_due(), job(true)));
}

std::optional<FrameRequest> View::take(bool still) {
    const std::scoped_lock lock(mutex_);
    if (!schedule_.begin(still, has_room(), Clock::now())) {
        post_job();
        return {};
    }
    FrameRequest request;
    wire::PictureStream* const moving = !still && stream_ == Stream::image ? &pictures_now() : nullptr;
    request.size = size_;
    request.stream = stream_;
    if (moving != nullptr) {
        request.moving = moving;
        request.scale = preview_.scale(size_) * detail_.of(moving_).scale;
    }
    if (const auto held = ids_of_frame_.find(held_); stream_ == Stream::geometry && held != ids_of_frame_.end())
        request.held = {held_, held->second};
    // Last, so that an exception does not lose the version.
    static_cast<FrameTurn&>(request) = schedule_.take(still, Clock::now());
    return request;
}

wire::PictureStream& View::pictures_now() {
    const int quality = detail_.of(moving_).quality;
    if (!pictures_.stream || pictures_.codec != moving_ || pictures_.quality != quality)
        pictures_ = {moving_, quality, wire::make_picture_stream(moving_, quality)};
    return *pictures_.stream;
}

void View::deliver(const FrameRequest& request, std::vector<std::vector<std::uint8_t>> messages, wire::ArrayIds ids,
                   const FrameTimes& times) {
    std::unique_lock lock(mutex_);
    std::size_t bytes = 0;
    if (!schedule_.is_closed() && !messages.empty()) {
        for (const auto& message : messages) bytes += message.size();
        if (bytes > services_.memory.room()) throw limits::LimitReached(services_.memory.refusal());
        frame_bytes_ = bytes;
        if (!connection_->may_send(bytes)) return make_again_later(request);
        ++sent_;
        if (request.stream == Stream::geometry) ids_of_frame_[sent_] = std::move(ids);
        for (auto& message : messages) {
            frames::number_frame(message, sent_);
            connection_->send_binary(std::make_shared<const std::vector<std::uint8_t>>(std::move(message)));
        }
        window_.sent(sent_, bytes, request.still, Clock::now());
    }
    const bool was_interactive = !request.still && request.stream == Stream::image;
    if (was_interactive) {
        preview_.took(request.size, times.draw);
        detail_.sent(moving_, bytes, (times.extract + times.draw + times.encode) / 1000, window_.rate());
    }
    schedule_.made(request, was_interactive, Clock::now());
    post_job();
    lock.unlock();
    if (bytes == 0) return;
    run_job([&] { note(request, bytes, times); }); // must not throw, because the next frame may have begun
}

// Counts a frame, and writes a slow one to the log.
void View::note(const FrameRequest& request, std::size_t bytes, const FrameTimes& times) {
    services_.metrics.count_frame(request.still, bytes, times);
    const double made_ms = times.extract + times.draw + times.encode;
    if (made_ms > (request.still ? slow_still_ms : slow_frame_ms))
        logging::log_event(logging::LogLevel::warning, "slow frame",
                           {{"session", logging::short_id(session_->id())},
                            {"view", id_},
                            {"kind", request.still ? "still" : "interactive"},
                            {"request", request.version->request},
                            {"user", connection_->user},
                            {"remote", connection_->remote},
                            {"ms", times.wait + made_ms},
                            {"wait_ms", times.wait},
                            {"extract_ms", times.extract},
                            {"draw_ms", times.draw},
                            {"encode_ms", times.encode},
                            {"bytes", bytes}});
}

void View::make_again_later(const FrameRequest& request) {
    services_.metrics.count_cancelled_frame();
    schedule_.had_no_room(request);
    content_.clear();
    post_job();
}

void View::tell_lacking(const FrameRequest& request, std::vector<std::string> lacking,
                        const geometry::Geometry& geometry, const std::optional<std::vector<std::string>>& drawn) {
    std::vector<std::string> missing;
    for (const geometry::Drawable& drawable : geometry.drawables)
        if (drawable.missing && std::find(missing.begin(), missing.end(), drawable.layer) == missing.end())
            missing.push_back(drawable.layer);
    const std::scoped_lock lock(mutex_);
    if (drawn) drawn_lacking_ = *drawn;
    lacking.insert(lacking.end(), drawn_lacking_.begin(), drawn_lacking_.end());
    if (schedule_.is_closed() || (lacking == lacking_ && geometry.empty == empty_ && missing == missing_)) return;
    lacking_ = lacking;
    empty_ = geometry.empty;
    missing_ = std::move(missing);
    std::vector<protocol::EmptyLayer> told;
    for (const geometry::EmptyLayer& one : empty_) told.push_back({one.layer, geometry::why_text(one.why), one.reason});
    const protocol::ViewLacking note{id_, static_cast<std::int64_t>(request.version->revision), lacking_,
                                     std::move(told), missing_};
    connection_->send_text(sessions::notification_text(note));
}

void View::give_up() {
    services_.metrics.count_cancelled_frame();
    const std::scoped_lock lock(mutex_);
    schedule_.given_up();
    post_job();
}

void View::wait() {
    const std::scoped_lock lock(mutex_);
    schedule_.waits();
    post_job();
}

void View::give_way() {
    services_.metrics.count_cancelled_frame();
    const std::scoped_lock lock(mutex_);
    schedule_.gave_way(Clock::now());
    post_job();
}

// Uses run_job, so that the view goes on even if no memory is left for the log line.
void View::fail(const FrameRequest& request, const std::string& sentence) {
    services_.metrics.count_failed_frame();
    run_job([&] {
        logging::log_event(logging::LogLevel::warning, "frame failed",
                           {{"session", logging::short_id(session_->id())},
                            {"view", id_},
                            {"reason", sentence},
                            {"request", request.version->request},
                            {"user", connection_->user},
                            {"remote", connection_->remote},
                            {"ms", std::chrono::duration<double, std::milli>(Clock::now() - request.started).count()}});
    });
    const std::scoped_lock lock(mutex_);
    schedule_.failed();
    content_.clear();
    post_job();
    if (schedule_.is_closed()) return;
    const protocol::ViewFailed note{id_, static_cast<std::int64_t>(request.version->revision), sentence,
                                    request.version->request};
    connection_->send_text(sessions::notification_text(note));
}

bool View::shows(const frames::ContentKey& key, double grid) {
    const std::scoped_lock lock(mutex_);
    return key == content_ && grid_ > 0 && grid_ <= grid;
}

std::optional<double> View::grid_of_new(frames::ContentKey key, double needed) {
    constexpr double much_finer = 16; // a grid that is finer by more than this factor wastes bytes
    const std::scoped_lock lock(mutex_);
    const bool is_new = key != content_;
    const bool fine_enough = grid_ > 0 && grid_ <= needed && (!is_new || much_finer * grid_ >= needed);
    if (!is_new && fine_enough) return {};
    content_ = std::move(key);
    if (!fine_enough) grid_ = needed; // else keeps the grid, so that unchanged arrays are not sent again
    return grid_;
}

} // namespace server::engine

#include "methods/progress.hpp"

#include "engine/open_session.hpp"
#include "sessions/notify.hpp"

namespace server::methods {

namespace {
constexpr std::chrono::milliseconds pause{200};
} // namespace

Progress::Progress(const CallContext& context, std::optional<std::string> name,
                   const std::optional<std::string>& session)
    : context_(context), name_(std::move(name)),
      session_(name_ && session && !context.connection.is_streaming() ? context.session(*session) : nullptr) {}

void Progress::begin(const char* stage) { tell(stage, 0, 0); }

void Progress::count(const char* stage, std::size_t done, std::size_t of) {
    const auto now = std::chrono::steady_clock::now();
    if (now - told_ < pause) return;
    told_ = now;
    tell(stage, done, of);
}

void Progress::tell(const char* stage, std::size_t done, std::size_t of) const {
    if (!name_) return;
    const std::string text = sessions::notification_text(
        protocol::CallProgress{*name_, stage, static_cast<std::int64_t>(done), static_cast<std::int64_t>(of)});
    if (context_.connection.is_streaming())
        context_.connection.send_text(text);
    else if (session_)
        session_->tell(text);
}

} // namespace server::methods

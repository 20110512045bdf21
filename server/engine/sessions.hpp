// All sessions of the process, by id.
#pragma once

#include "engine/open_session.hpp"
#include "engine/view.hpp"

namespace ciel::engine {

// Who opens or closes a session, for the log.
struct Caller {
    const sessions::Connection& connection;
    const std::string& request;
};

// Thread-safe.
class Sessions {
public:
    explicit Sessions(const Services& services) : services_(services) {}
    ~Sessions() { close_all(); }

    // Throws NotFound with a sentence.
    [[nodiscard]] std::shared_ptr<OpenSession> find(const std::string& id);
    // The session of this id, or a new one of it that shows `document`; an empty id: a new one. Throws LimitReached,
    // and as make_version does. steps: of a new session.
    [[nodiscard]] std::shared_ptr<OpenSession> open(const std::string& id,
                                                    const std::function<nlohmann::json()>& document, const Caller& by,
                                                    const sessions::Steps& steps = {});
    void close(const std::string& id, const Caller& by); // throws NotFound

    // Views have ids of their own in the process; only the connection that opened one may use it.
    [[nodiscard]] std::shared_ptr<View> open_view(OpenSession& session,
                                                  const std::shared_ptr<sessions::Connection>& connection,
                                                  geometry::ViewSize size, Stream stream, wire::MovingCodec moving);
    [[nodiscard]] std::shared_ptr<View> view(std::uint32_t id, std::uint64_t connection); // throws NotFound
    void close_view(std::uint32_t id, std::uint64_t connection);                          // throws NotFound

    void connection_closed(std::uint64_t connection);
    void connection_has_room(std::uint64_t connection); // frames that had to wait can be sent
    void dataset_changed(const std::string& dataset);   // views of it are offered their scene again
    void expire(Clock::time_point now);                 // forgets sessions that have been idle for too long
    void stop_opening();                                // draining: no new sessions from here on
    void close_all();

    [[nodiscard]] std::vector<std::shared_ptr<OpenSession>> all() const;

private:
    bool drop_longest_left(); // REQUIRES: the lock

    const Services& services_;
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<OpenSession>> sessions_;
    std::map<std::uint32_t, std::weak_ptr<View>> views_;
    std::uint32_t last_view_ = 0;
    bool stopped_ = false;
};

} // namespace ciel::engine

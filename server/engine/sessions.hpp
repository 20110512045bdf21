// All sessions of the process, by id.
#pragma once

#include "engine/open_session.hpp"
#include "engine/view.hpp"

namespace server::engine {

// The caller that opens or closes a session. It is written to the log.
struct Caller {
    const sessions::Connection& connection;
    const std::string& request;
};

// All members of Sessions are thread-safe.
class Sessions {
public:
    explicit Sessions(const EngineServices& services) : services_(services) {}
    ~Sessions() { close_all(); }

    // Returns the session with this id. Throws NotFound if there is no such session.
    [[nodiscard]] std::shared_ptr<OpenSession> find(const std::string& id);
    // Returns the session with this id. If there is none, opens a session with this id, or with a random id if `id` is
    // empty. `document` and `steps` are used for a new session only. Throws LimitReached, and the exceptions of
    // accept_scene().
    [[nodiscard]] std::shared_ptr<OpenSession> open(const std::string& id,
                                                    const std::function<nlohmann::json()>& document, const Caller& by,
                                                    const sessions::UndoRedoSteps& steps = {});
    void close(const std::string& id, const Caller& by); // throws NotFound

    // The id of the view is unique in the process. Only the connection that opened the view may use it.
    [[nodiscard]] std::shared_ptr<View> open_view(OpenSession& session,
                                                  const std::shared_ptr<sessions::Connection>& connection,
                                                  geometry::ViewSize size, Stream stream, wire::MovingCodec moving);
    [[nodiscard]] std::shared_ptr<View> view(std::uint32_t id, std::uint64_t connection); // throws NotFound
    void close_view(std::uint32_t id, std::uint64_t connection);                          // throws NotFound

    void connection_closed(std::uint64_t connection);
    void connection_has_room(std::uint64_t connection); // sends frames that were held back
    void dataset_changed(const std::string& dataset);   // offers the scene again to all views of the dataset
    void expire(Clock::time_point now);                 // closes sessions that have been idle for too long
    // Frees the geometry of sessions that have no connection and have not been used since `unused_since`.
    void release_geometry(Clock::time_point unused_since);
    // If less than a quarter of the server's memory is free, frees the geometry of sessions that have no connection,
    // the longest unused first, until a quarter is free. Must be called without a lock of a session.
    void make_room();
    void stop_opening(); // refuses new sessions and views from now on
    void close_all();

    [[nodiscard]] std::vector<std::shared_ptr<OpenSession>> all() const;

private:
    bool drop_longest_left(); // requires mutex_ to be held

    const EngineServices& services_;
    mutable std::mutex mutex_;
    std::map<std::string, std::shared_ptr<OpenSession>> sessions_;
    std::map<std::uint32_t, std::weak_ptr<View>> views_;
    std::uint32_t last_view_ = 0;
    bool stopped_ = false;
};

} // namespace server::engine

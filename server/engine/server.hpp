// Everything that lives as long as the process: datasets, sessions, the render workers, limits, counters.
#pragma once

#include "ciel/extract.hpp"
#include "frames/still_samples.hpp"
#include "frames/test_picture.hpp"
#include "limits/limits.hpp"
#include "render/renderer.hpp"
#include "sessions/connection.hpp"
#include "store/catalog.hpp"

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

namespace ciel::limits {
class Memory; // limits/memory.hpp
}
namespace ciel::probe {
class Locators; // probe/locator.hpp
}

namespace ciel::engine {

struct ServerOptions {
    std::vector<std::filesystem::path> data;
    render::Backend backend = render::Backend::automatic;
    Extraction extraction;
    unsigned render_workers = 1;
    int still_samples = frames::default_still_samples; // of a pixel
    bool allow_append = false;                         // by clients, who need the token
    limits::Limits limits;
};

class Sessions;     // sessions.hpp
class FrameWorkers; // schedule/frame_workers.hpp
class Metrics;      // metrics.hpp
struct Services;    // services.hpp
class SlowCalls;    // schedule/slow_calls.hpp
class Uploads;      // uploads.hpp

// Thread-safe. The gateway calls connection_closed and drain; methods reach the rest.
class Server {
public:
    explicit Server(ServerOptions options);
    ~Server();

    [[nodiscard]] const limits::Limits& limits() const;
    [[nodiscard]] store::Catalog& catalog();
    [[nodiscard]] Sessions& sessions();
    [[nodiscard]] FrameWorkers& frame_workers();
    // For slow calls: somebody waits for a picture under way, so it is neither put off nor in the way of a frame.
    [[nodiscard]] FrameWorkers& picture_workers();
    [[nodiscard]] const ServerOptions& options() const;
    [[nodiscard]] Metrics& counters();
    [[nodiscard]] const Services& services() const;
    [[nodiscard]] probe::Locators& locators();
    [[nodiscard]] SlowCalls& slow_calls();
    [[nodiscard]] Uploads& uploads();
    [[nodiscard]] limits::Memory& memory();

    // Tells clients of steps that were appended to a dataset of the catalog, without waiting for its watch.
    void look_for_steps(const std::string& name, store::LoadedDataset& dataset);
    // Connections hear of appended steps (`dataset.changed`) while they are registered here.
    void connection_opened(std::shared_ptr<sessions::Connection> connection);
    void connection_closed(std::uint64_t connection_id);

    // Gives back what has not been used for long: sessions, datasets. Called every now and then by the server itself.
    void tidy(std::chrono::steady_clock::time_point now);

    // Draws a test picture and checks its pixels: waits for a frame worker.
    [[nodiscard]] frames::Readiness readiness();
    // Asks for test pictures of frame and picture workers, at most once a second, and waits for them for a moment:
    // while the workers draw for others the answer is that of the last one.
    [[nodiscard]] frames::Readiness readiness_by_now();
    [[nodiscard]] frames::Readiness
    last_readiness();                          // of the last test picture; draws one only when none was drawn yet
    [[nodiscard]] std::string metrics() const; // Prometheus text exposition format 0.0.4
    // SIGTERM, in this order. announce_end: no new sessions from here on, and clients are told; does not block.
    void announce_end();
    // No new frames. The drawing of those under way is given up: clients get them again where they go on.
    void drain_frames();
    // No new slow calls either; returns when those under way have been finished, or given up after give_up.
    void drain();
    // Slow calls under way end as soon as they look at call_stop(). Does not block.
    void give_up();
    [[nodiscard]] std::stop_token call_stop() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace ciel::engine

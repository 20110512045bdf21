// Owns everything that lives as long as the process: datasets, sessions, workers, limits, counters.
#pragma once

#include "ciel/extract.hpp"
#include "engine/schedule/late_step_queue.hpp"
#include "frames/picture.hpp"
#include "frames/test_picture.hpp"
#include "limits/limits.hpp"
#include "render/renderer.hpp"
#include "sessions/connection.hpp"
#include "store/catalog.hpp"

#include <chrono>
#include <memory>
#include <stop_token>
#include <string>

namespace server::limits {
class Memory; // limits/memory.hpp
}

namespace server::engine {

struct ServerOptions {
    std::vector<std::filesystem::path> data;
    std::optional<store::FileAccess> file_access; // nullopt: chosen by the file system of each dataset
    render::Backend backend = render::Backend::automatic;
    ciel::Extraction extraction;
    unsigned render_workers = 1;
    int still_samples = frames::default_still_samples; // per pixel
    bool allow_append = false;                         // clients may append steps if they have the token
    ReadLateStep read_late_step;                       // empty: late steps are not read
    std::filesystem::path late_folder;                 // for late arrays of datasets that cannot be written
    limits::Limits limits;
};

class Sessions;        // sessions.hpp
class FrameWorkers;    // schedule/frame_workers.hpp
class Metrics;         // metrics.hpp
struct EngineServices; // engine_services.hpp
class SlowCallQueue;   // schedule/slow_call_queue.hpp
class Uploads;         // uploads.hpp

// Thread-safe. The gateway's service opens and closes connections and drains the server; methods use the other members.
class Server {
public:
    explicit Server(ServerOptions options);
    ~Server();

    [[nodiscard]] const limits::Limits& limits() const;
    [[nodiscard]] store::Catalog& catalog();
    [[nodiscard]] Sessions& sessions();
    [[nodiscard]] FrameWorkers& frame_workers();
    // The picture workers are separate from the frame workers, so that pictures and frames do not wait for each other.
    [[nodiscard]] FrameWorkers& picture_workers();
    [[nodiscard]] const ServerOptions& options() const;
    [[nodiscard]] Metrics& counters();
    [[nodiscard]] const EngineServices& services() const;
    [[nodiscard]] SlowCallQueue& slow_calls();
    [[nodiscard]] Uploads& uploads();
    [[nodiscard]] limits::Memory& memory();

    // If steps were appended to the dataset, notifies clients at once, before the catalog's watch finds the steps.
    void look_for_steps(const std::string& name, store::LoadedDataset& dataset);
    // Until connection_closed(), the connection gets the notification `dataset.changed` when steps are appended.
    void connection_opened(std::shared_ptr<sessions::Connection> connection);
    void connection_closed(std::uint64_t connection_id);

    // Frees sessions, uploads and datasets that are unused for long. The server itself calls this every 10 seconds.
    void tidy(std::chrono::steady_clock::time_point now);

    // Draws a test picture on a frame worker and checks its pixels. Waits until a worker is free.
    [[nodiscard]] frames::TestPictureResult draw_test_picture();
    // Requests test pictures at most once a second. Returns the previous result if workers are busy for over 0.5 s.
    [[nodiscard]] frames::TestPictureResult test_picture_by_now();
    // Returns the result of the last test picture. Draws a test picture only if there is no result yet.
    [[nodiscard]] frames::TestPictureResult last_test_picture();
    [[nodiscard]] std::string metrics() const; // Prometheus text exposition format 0.0.4
    // On SIGTERM, announce_end(), drain_frames() and drain() are called in this order. announce_end() refuses new
    // sessions and views from now on, and notifies clients. It does not block.
    void announce_end();
    // Starts no new frames and cancels the frames that are being drawn. Returns when no frame is in progress.
    void drain_frames();
    // Starts no new slow calls. Returns when all running calls have finished, or have been cancelled after give_up().
    void drain();
    // Requests a stop on call_stop(). Running slow calls end when they next check this token. Does not block.
    void give_up();
    [[nodiscard]] std::stop_token call_stop() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace server::engine

#include "engine/server.hpp"

#include "engine/schedule/slow_call_queue.hpp"
#include "engine/sessions.hpp"
#include "engine/uploads.hpp"
#include "limits/machine_memory.hpp"
#include "limits/memory_reserve.hpp"
#include "logging/log.hpp"
#include "protocol/json.hpp"
#include "sessions/notify.hpp"
#include "store/files/files.hpp"
#include "wire/frame_header.hpp"

#include <algorithm>

namespace server::engine {

namespace {

constexpr std::chrono::seconds test_picture_lasts{1};
// Longest wait for a test picture, because probes of /readyz expect an answer within a second.
constexpr std::chrono::milliseconds test_picture_patience{500};

frames::TestPictureResult tested(Worker& worker) {
    try {
        return frames::draw_test_picture(worker.renderer());
    } catch (const std::exception& error) {
        return {.problem = store::sentence_for_clients(error)};
    }
}

} // namespace

struct Server::State {
    ServerOptions options;
    Metrics metrics;
    sessions::OpenConnections connections;
    store::Catalog catalog;
    limits::Memory memory;
    FrameWorkers workers, picture_workers;
    EngineServices services;
    Sessions sessions;
    Uploads uploads;
    SlowCallQueue slow_calls;
    LateStepQueue late_steps;
    std::stop_source calls; // a stop request cancels the slow calls in progress
    std::mutex test_picture_mutex;
    std::condition_variable test_picture_known;
    std::optional<frames::TestPictureResult> last_test_picture;
    bool test_picture_asked = false; // whether a test picture waits for a worker or is being drawn
    Clock::time_point asked_since;
    std::optional<Clock::time_point> test_picture_since;
    std::shared_ptr<void> watch;
    std::jthread housekeeping; // the last member, because its thread uses the other members

    explicit State(ServerOptions chosen)
        : options(std::move(chosen)),
          catalog(options.data, options.limits.field_cache_bytes, options.limits.dataset_memory_bytes,
                  options.file_access, late_steps_of_catalog()),
          memory(
              options.limits.memory_bytes, [this] { return dataset_bytes(); },
              [this] {
                  release_unused(Clock::now());
                  for (const auto& dataset : catalog.loaded()) dataset->drop_unused_fields();
              }),
          workers(options.render_workers, options.backend, memory, options.still_samples),
          picture_workers(1, options.backend, memory, options.still_samples),
          services{{options.limits, catalog, connections, memory}, options.extraction, workers, metrics, {}},
          sessions(services), uploads(options.limits, memory), slow_calls(options.limits),
          late_steps(options.read_late_step,
                     [this](const std::filesystem::path& dataset) { late_step_read(dataset); }) {
        services.make_room = [this] {
            constexpr std::uint64_t scarce = 16; // more is freed if less than 1/16 is left
            sessions.make_room();
            if (memory.room() < memory.most() / scarce) memory.release();
        };
        limits::keep_memory_in_reserve();
        watch = catalog.watch([this](const std::string& dataset) { tell_steps(dataset); });
        housekeeping = std::jthread([this](const std::stop_token& stop) {
            std::mutex mutex;
            std::condition_variable_any never;
            std::unique_lock lock(mutex);
            while (!never.wait_for(lock, stop, std::chrono::seconds(10), [&] { return stop.stop_requested(); }))
                tidy(Clock::now());
        });
    }

    ~State() {
        watch.reset();
        slow_calls.drain();
        picture_workers.drain();
        workers.drain();
    }

    void tidy(Clock::time_point now) {
        sessions.expire(now);
        uploads.expire(now);
        const auto unused_since = now - std::chrono::seconds(options.limits.dataset_idle_seconds);
        sessions.release_geometry(unused_since);
        release_unused(unused_since);
        const auto all = sessions.all();
        if (std::ranges::all_of(all, [](const auto& session) { return session->viewer_count() == 0; })) workers.rest();
        picture_workers.rest();
        limits::give_back_free_memory();
        limits::keep_memory_in_reserve();
    }

    store::LateSteps late_steps_of_catalog() {
        if (!options.read_late_step) return {options.late_folder, {}};
        return {options.late_folder,
                [this](const store::Dataset& dataset, std::size_t step) { return late_steps.ask(dataset, step); }};
    }

    void release_unused(Clock::time_point unused_since) { (void)catalog.give_back(unused_since); }

    [[nodiscard]] std::uint64_t dataset_bytes() const {
        std::uint64_t bytes = 0;
        for (const auto& dataset : catalog.loaded()) bytes += dataset->memory_bytes();
        return bytes;
    }

    void know(const frames::TestPictureResult& result) {
        const std::scoped_lock lock(test_picture_mutex);
        if (last_test_picture && last_test_picture->passed != result.passed)
            logging::log_event(result.passed ? logging::LogLevel::info : logging::LogLevel::error,
                               result.passed ? "draws again" : "cannot draw", {{"reason", result.problem}});
        last_test_picture = result;
        test_picture_since = Clock::now();
        test_picture_asked = false;
        test_picture_known.notify_all();
    }

    // The server is ready only if the pictures of all workers are right, because each worker has its own GL context.
    void draw_test_pictures(unsigned number = 0) {
        const bool draws_frames = number < workers.count();
        FrameWorkers& these = draws_frames ? workers : picture_workers;
        const auto test = [this, number](Worker& worker) {
            const frames::TestPictureResult result = tested(worker);
            if (result.passed && number + 1 < workers.count() + picture_workers.count())
                draw_test_pictures(number + 1);
            else
                know(result);
        };
        try {
            const unsigned among_these = draws_frames ? number : number - workers.count();
            if (!these.post_later_to(among_these, Clock::now(), test)) know_of_end();
        } catch (const std::exception& error) { // out of memory
            know({.problem = store::sentence_for_clients(error)});
        }
    }
    void know_of_end() { know({.problem = "the server is about to stop and draws no further pictures"}); }

    // Called when a late step was read or cannot be read. Draws the dataset's views again, with its present values.
    void late_step_read(const std::filesystem::path& dataset) noexcept {
        try {
            for (const auto& loaded : catalog.loaded()) {
                if (loaded->dataset()->directory() != dataset) continue;
                try {
                    (void)loaded->refresh();
                } catch (const ciel::Error&) { // the dataset was replaced or is damaged; the catalog's watch notices
                }
            }
            for (const auto& entry : catalog.list())
                if (entry.directory == dataset) tell_steps(entry.name);
        } catch (const std::exception&) { // memory is short; the catalog's watch notifies clients later
        }
    }

    void tell_steps(const std::string& dataset) {
        protocol::DatasetChanged note{dataset, std::vector<double>()};
        try {
            const auto opened = catalog.open(dataset)->dataset();
            note.times->assign(opened->steps().times().begin(), opened->steps().times().end());
        } catch (const ciel::Error&) {
            // The dataset was removed or is damaged. Clients are notified. Sessions keep the data that they have.
            connections.send_all(sessions::notification_text(note));
            return;
        }
        std::string text = sessions::notification_text(note);
        if (text.size() > wire::longest_message) {
            note.times.reset(); // too long for one message; clients call dataset.describe
            text = sessions::notification_text(note);
        }
        connections.send_all(text);
        sessions.dataset_changed(dataset);
    }
};

Server::Server(ServerOptions options) : state_(std::make_unique<State>(std::move(options))) {}
Server::~Server() = default;

const limits::Limits& Server::limits() const { return state_->options.limits; }
const ServerOptions& Server::options() const { return state_->options; }
store::Catalog& Server::catalog() { return state_->catalog; }
Sessions& Server::sessions() { return state_->sessions; }
FrameWorkers& Server::frame_workers() { return state_->workers; }
FrameWorkers& Server::picture_workers() { return state_->picture_workers; }
Metrics& Server::counters() { return state_->metrics; }
SlowCallQueue& Server::slow_calls() { return state_->slow_calls; }
Uploads& Server::uploads() { return state_->uploads; }
limits::Memory& Server::memory() { return state_->memory; }
const EngineServices& Server::services() const { return state_->services; }

void Server::connection_opened(std::shared_ptr<sessions::Connection> connection) {
    state_->connections.add(std::move(connection));
}

void Server::connection_closed(std::uint64_t connection_id) {
    state_->connections.remove(connection_id);
    state_->slow_calls.drop(connection_id);
    state_->sessions.connection_closed(connection_id);
}

void Server::look_for_steps(const std::string& name, store::LoadedDataset& dataset) {
    if (dataset.refresh()) state_->tell_steps(name);
}

void Server::tidy(std::chrono::steady_clock::time_point now) { state_->tidy(now); }

frames::TestPictureResult Server::draw_test_picture() {
    frames::TestPictureResult result;
    try {
        result = state_->workers.run([](Worker& worker) { return tested(worker); });
    } catch (const std::exception& error) { // the workers are drained
        result.problem = store::sentence_for_clients(error);
    }
    state_->know(result);
    return result;
}

frames::TestPictureResult Server::test_picture_by_now() {
    State& state = *state_;
    std::unique_lock lock(state.test_picture_mutex);
    const bool is_fresh = state.test_picture_since && Clock::now() - *state.test_picture_since < test_picture_lasts;
    if (!is_fresh && !state.test_picture_asked) {
        state.test_picture_asked = true;
        state.asked_since = Clock::now();
        lock.unlock();
        state.draw_test_pictures();
        lock.lock();
    }
    state.test_picture_known.wait_until(lock, state.asked_since + test_picture_patience,
                                        [&] { return !state.test_picture_asked; });
    const auto hang_seconds = state.options.limits.hang_seconds;
    if (state.test_picture_asked && Clock::now() - state.asked_since > std::chrono::seconds(hang_seconds))
        return {.problem =
                    "a drawing thread has not answered for " + std::to_string(hang_seconds) + " s; restart the server"};
    return state.last_test_picture.value_or(
        frames::TestPictureResult{.problem = "the server has not drawn its test picture yet; ask again in a second"});
}

frames::TestPictureResult Server::last_test_picture() {
    {
        const std::scoped_lock lock(state_->test_picture_mutex);
        if (state_->last_test_picture) return *state_->last_test_picture;
    }
    return draw_test_picture();
}

std::string Server::metrics() const {
    Gauges gauges;
    for (const auto& session : state_->sessions.all()) {
        ++gauges.sessions;
        gauges.views += session->viewer_count();
        gauges.session_bytes += session->geometry_bytes();
    }
    gauges.connections = state_->connections.size();
    gauges.datasets = state_->catalog.loaded().size();
    gauges.busy_workers = state_->workers.busy() + state_->picture_workers.busy();
    gauges.slow_calls = state_->slow_calls.running();
    gauges.slow_calls_waiting = state_->slow_calls.waiting();
    gauges.dataset_bytes = state_->dataset_bytes();
    for (std::size_t i = 0; i < limits::held_names.size(); ++i)
        gauges.held_bytes[i] = state_->memory.bytes(static_cast<limits::Held>(i));
    gauges.memory_limit = state_->memory.most();
    gauges.version = CIEL_VERSION;
    const std::scoped_lock lock(state_->test_picture_mutex);
    if (state_->last_test_picture) {
        gauges.gl_renderer = state_->last_test_picture->gl_renderer;
        gauges.backend = state_->last_test_picture->backend;
    }
    return state_->metrics.text(gauges);
}

void Server::announce_end() {
    state_->sessions.stop_opening();
    state_->connections.send_all(sessions::notification_text(protocol::ServerDraining{}));
}

void Server::give_up() { state_->calls.request_stop(); }

std::stop_token Server::call_stop() const { return state_->calls.get_token(); }

void Server::drain_frames() { state_->workers.drain(); }

void Server::drain() {
    state_->sessions.stop_opening();
    state_->slow_calls.drain(); // first, because running calls need the picture workers
    state_->picture_workers.drain();
    drain_frames();
}

} // namespace server::engine

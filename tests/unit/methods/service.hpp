// A complete server without a network, and clients that keep what they receive.
#pragma once

#include "engine/metrics.hpp"
#include "engine/schedule/slow_call_queue.hpp"
#include "engine/server.hpp"
#include "engine/sessions.hpp"
#include "methods/binary_message.hpp"
#include "methods/dispatcher.hpp"
#include "support/chosen_algorithm.hpp"
#include "support/small_dataset/small_dataset.hpp"
#include "wire/frame_header.hpp"

#include <condition_variable>
#include <future>
#include <gtest/gtest.h>
#include <mutex>
#include <nlohmann/json.hpp>

namespace ciel::test {
using namespace server;

using nlohmann::json;

// Fixed layers for the small dataset. The default scene would depend on its patches.
inline json scene_with_iso() {
    return json::parse(
        R"({"dataset": "box", "camera": {"position": [1003, -12, -44], "target": [1003, 3, -47], "up": [0, 0, 1]},
            "layers": {"outline": {"type": "outline", "order": 0},
                       "surface": {"type": "surface", "order": 1, "groups": ["body"]},
                       "iso": {"type": "iso", "order": 2, "array": "p", "values": [12]}}})");
}

class Client {
public:
    Client(engine::Server& server, bool streaming) : server_(server) {
        static std::atomic<std::uint64_t> last{0};
        connection_->id = ++last;
        connection_->stop = stop_.get_token();
        if (!streaming) return;
        connection_->send_text = [this](std::string text) { add(texts_, json::parse(text)); };
        connection_->send_binary = [this](std::shared_ptr<const std::vector<std::uint8_t>> bytes) {
            add(frames_, bytes);
        };
        server_.connection_opened(connection_);
    }
    ~Client() {
        hang_up();
        if (connection_->is_streaming()) server_.connection_closed(connection_->id);
        try { // waits until the worker has no job of a view that could call back
            server_.frame_workers().run([](engine::Worker&) { return 0; });
        } catch (const Error&) { // the worker has been drained and takes no jobs
        }
    }
    Client(const Client&) = delete;

    std::string send(std::string_view text) { return methods::dispatch(server_, *connection_, text); }
    void give_token() { connection_->has_token = true; }
    // Sends a binary message. Returns the reason to close the connection, or nullopt.
    std::optional<std::string> send_bytes(std::span<const std::uint8_t> bytes) {
        return methods::receive_binary(server_, *connection_, bytes);
    }
    // Sends a request without waiting. The future holds the answer's text.
    std::future<std::string> post(const json& request) {
        const auto answered = std::make_shared<std::promise<std::string>>();
        methods::dispatch(server_, connection_, request.dump(),
                          [answered](std::string text) { answered->set_value(std::move(text)); });
        return answered->get_future();
    }
    static json request_of(const std::string& method, json params) {
        return {{"jsonrpc", "2.0"}, {"id", 1}, {"method", method}, {"params", std::move(params)}};
    }
    void hang_up() {
        stop_.request_stop();
        server_.slow_calls().drop(connection_->id);
    }
    json request(const std::string& method, json params = json::object()) {
        return json::parse(send(request_of(method, std::move(params)).dump()));
    }
    json call(const std::string& method, json params = json::object()) {
        json answer = request(method, std::move(params));
        if (!answer.contains("result")) throw std::runtime_error(method + ": " + answer.dump());
        return answer["result"];
    }
    int error_code(const std::string& method, json params = json::object()) {
        const json answer = request(method, std::move(params));
        return answer.contains("error") ? answer["error"]["code"].get<int>() : 0;
    }

    // Waits for the next binary message, for at most one minute.
    wire::FrameHeader next_frame() { return wire::read_frame_header(*next(frames_)); }
    std::shared_ptr<const std::vector<std::uint8_t>> next_message() { return next(frames_); }
    json next_text() { return next(texts_); }
    void acknowledge(const wire::FrameHeader& frame) {
        call("view.ack", {{"view", frame.view}, {"frame", frame.frame}});
    }
    // Acknowledges frames up to the still of this revision, and returns all of them.
    std::vector<wire::FrameHeader> frames_until_still(std::uint64_t revision) {
        std::vector<wire::FrameHeader> seen;
        do {
            seen.push_back(next_frame());
            acknowledge(seen.back());
        } while (seen.back().revision < revision || (seen.back().flags & wire::still) == 0);
        return seen;
    }
    [[nodiscard]] std::uint64_t id() const { return connection_->id; }

private:
    template <class Queue, class Item>
    void add(Queue& queue, Item item) {
        const std::scoped_lock lock(mutex_);
        queue.push_back(std::move(item));
        changed_.notify_all();
    }
    template <class Item>
    Item next(std::deque<Item>& queue) {
        std::unique_lock lock(mutex_);
        if (!changed_.wait_for(lock, std::chrono::minutes(1), [&] { return !queue.empty(); }))
            throw std::runtime_error("nothing was sent");
        Item item = std::move(queue.front());
        queue.pop_front();
        return item;
    }

    engine::Server& server_;
    std::stop_source stop_;
    std::shared_ptr<sessions::Connection> connection_ = std::make_shared<sessions::Connection>();
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<json> texts_;
    std::deque<std::shared_ptr<const std::vector<std::uint8_t>>> frames_;
};

// A server with two datasets of the same content, "box" and "bax".
class Service : public testing::Test {
protected:
    static void SetUpTestSuite() {
        folder = std::make_unique<Folder>();
        write_small_dataset(folder->path() / "box.ciel");
        write_small_dataset(folder->path() / "bax.ciel");
    }
    static void TearDownTestSuite() { folder.reset(); }
    static engine::ServerOptions options(limits::Limits limits = {}) {
        engine::ServerOptions made;
        made.data = {folder->path()};
        made.extraction = chosen_algorithm();
        made.limits = limits;
        return made;
    }
    static inline std::unique_ptr<Folder> folder;
};

} // namespace ciel::test

#include "app/engine_service.hpp"

#include "engine/schedule/slow_call_queue.hpp"
#include "engine/sessions.hpp"
#include "methods/binary_message.hpp"
#include "methods/dispatcher.hpp"

#include <utility>

namespace server::app {
namespace {

std::shared_ptr<sessions::Connection> connection_of(gateway::Client client) {
    auto connection = std::make_shared<sessions::Connection>();
    connection->id = client.id;
    connection->remote = std::move(client.remote);
    connection->user = std::move(client.user);
    connection->request = std::move(client.request);
    connection->has_token = client.has_token;
    connection->stop = std::move(client.stop);
    connection->send_text = std::move(client.send_text);
    connection->send_binary = std::move(client.send_binary);
    connection->has_room = std::move(client.has_room);
    return connection;
}

class EnginePeer final : public gateway::Peer {
public:
    EnginePeer(engine::Server& server, gateway::Client client)
        : server_(server), connection_(connection_of(std::move(client))) {
        if (connection_->is_streaming()) server_.connection_opened(connection_);
    }

    void text(std::string_view text, gateway::Answer answer) override {
        methods::dispatch(server_, connection_, text, std::move(answer));
    }
    std::optional<std::string> binary(std::span<const std::uint8_t> message) override {
        return methods::receive_binary(server_, *connection_, message);
    }
    void has_room() override { server_.sessions().connection_has_room(connection_->id); }
    void closed() override {
        if (connection_->is_streaming())
            server_.connection_closed(connection_->id);
        else
            server_.slow_calls().drop(connection_->id);
    }

private:
    engine::Server& server_;
    std::shared_ptr<sessions::Connection> connection_;
};

} // namespace

const limits::Limits& EngineService::limits() const { return server_.limits(); }

limits::Memory& EngineService::memory() { return server_.memory(); }

std::shared_ptr<gateway::Peer> EngineService::connect(gateway::Client client) {
    return std::make_shared<EnginePeer>(server_, std::move(client));
}

gateway::Readiness EngineService::readiness() {
    const frames::TestPictureResult drawn = server_.test_picture_by_now();
    return {drawn.passed,
            drawn.problem,
            {{"gl_renderer", drawn.gl_renderer}, {"gl_version", drawn.gl_version}, {"backend", drawn.backend}}};
}

std::string EngineService::metrics() { return server_.metrics(); }

void EngineService::announce_end() { server_.announce_end(); }

void EngineService::drain_frames() { server_.drain_frames(); }

void EngineService::drain() { server_.drain(); }

void EngineService::give_up() { server_.give_up(); }

} // namespace server::app

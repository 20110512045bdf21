// Connects the engine to the gateway: texts become method calls, binary messages become upload pieces.
#pragma once

#include "engine/server.hpp"
#include "gateway/service.hpp"

namespace server::app {

// Does not own `server`. The server must outlive this object and all its peers.
class EngineService final : public gateway::Service {
public:
    explicit EngineService(engine::Server& server) : server_(server) {}

    [[nodiscard]] const limits::Limits& limits() const override;
    [[nodiscard]] limits::Memory& memory() override;
    [[nodiscard]] std::shared_ptr<gateway::Peer> connect(gateway::Client client) override;
    [[nodiscard]] gateway::Readiness readiness() override;
    [[nodiscard]] std::string metrics() override;

    void announce_end() override;
    void drain_frames() override;
    void drain() override;
    void give_up() override;

private:
    engine::Server& server_;
};

} // namespace server::app

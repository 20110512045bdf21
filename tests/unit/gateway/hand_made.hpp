// WebSocket client for tests that sends and receives single frames.
#pragma once

#include "running_server.hpp"

#include <utility>

namespace server::gateway {
using namespace ciel;

// WebSocket client without a library. Its masking key is zero, so the payload is sent unchanged.
class HandMade : public Socket {
public:
    explicit HandMade(const RunningServer& server, int receive_buffer = 0) : HandMade(server.port(), receive_buffer) {}
    explicit HandMade(unsigned short port, int receive_buffer = 0) : Socket(port, receive_buffer) {
        send("GET /ws HTTP/1.1\r\nHost: localhost\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
             "Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n"
             "Sec-WebSocket-Protocol: ciel.v1\r\n\r\n");
        const std::string head = receive_until("\r\n\r\n");
        EXPECT_TRUE(head.starts_with("HTTP/1.1 101 ")) << head;
    }
    // `payload` must be shorter than 65536 bytes.
    bool send_frame(char opcode, const std::string& payload) {
        std::string head{static_cast<char>(0x80 | opcode)};
        if (payload.size() < 126)
            head += static_cast<char>(0x80 | payload.size());
        else
            head += {static_cast<char>(0xFE), static_cast<char>(payload.size() >> 8),
                     static_cast<char>(payload.size() & 255)};
        return send(head + std::string(4, '\0') + payload);
    }
    // Opcode and payload of the next frame; opcode -1 at the end of the connection.
    std::pair<int, std::string> receive_frame() {
        const std::string head = receive(2);
        if (head.size() < 2) return {-1, {}};
        std::size_t length = static_cast<unsigned char>(head[1]);
        if (const std::size_t more = length == 126 ? 2 : length == 127 ? 8 : 0; more > 0) {
            length = 0;
            for (const char byte : receive(more)) length = length << 8 | static_cast<unsigned char>(byte);
        }
        return {head[0] & 15, receive(length)};
    }
};
inline constexpr char text = 1, close_frame = 8, ping = 9, pong = 10;

} // namespace server::gateway

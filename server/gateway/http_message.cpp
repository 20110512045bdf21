#include "gateway/http_message.hpp"

namespace server::gateway {

Response sentence(unsigned status, std::string text) {
    Response response;
    response.status = status;
    response.body = std::move(text) + "\n";
    response.headers.emplace_back("Cache-Control", "no-store");
    return response;
}

Response json(unsigned status, std::string text) {
    Response response;
    response.status = status;
    response.content_type = "application/json";
    response.body = std::move(text);
    response.headers.emplace_back("Cache-Control", "no-store");
    return response;
}

} // namespace server::gateway

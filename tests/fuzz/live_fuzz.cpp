// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// What a client of the live window sends, behind HTTP and WebSocket: the head of a request, JSON, calls of services.
#include <live/door/web_address.hpp>
#include <live/server/access.hpp>
#include <live/server/foxglove_text.hpp>
#include <live/server/text_depth.hpp>

#include <cstdint>
#include <cstdlib>
#include <string>

namespace {

/** The input up to the next line end. */
std::string line(std::string_view& rest) {
    const std::string_view found = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(found.size() == rest.size() ? found.size() : found.size() + 1);
    return std::string(found);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace OCL::live;
    const std::string_view all(reinterpret_cast<const char*>(data), size);
    std::string_view rest = all;
    const WebAccess access{"0123456789abcdef", (size & 1U) != 0};
    RequestHead head;
    head.isUpgrade = true;
    head.method = "GET";
    for (std::string* field : {&head.target, &head.host, &head.origin, &head.authorization, &head.protocols})
        *field = line(rest);
    // Nothing opens the door but the token.
    const bool knows = head.target.find(access.token) != std::string::npos ||
                       head.authorization.find(access.token) != std::string::npos;
    if (judgeRequest(head, access).status == 101 && !knows) std::abort();
    if (!isTooDeep(all)) {
        const nlohmann::json message = nlohmann::json::parse(all, nullptr, false);
        if (!message.is_discarded()) {
            if (message.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace).empty()) std::abort();
            if (message.is_object()) {
                const nlohmann::json copy = message;
                if (copy != message) std::abort();
            }
        }
    }
    FoxgloveCall call;
    if (parseFoxgloveCall(all, call) && call.encoding.size() + call.payload.size() + 13 != size) std::abort();
    WebAddress address;
    std::string error;
    (void)parseWebAddress(std::string(all), address, error);
    return 0;
}

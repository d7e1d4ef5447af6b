// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_ACCESS_HPP
#define OROFORGE_LIVE_ACCESS_HPP

#include "transport.hpp"

#include <string>
#include <vector>

namespace OCL::live {

// The subprotocols. The first is without the messages of Foxglove.
inline constexpr const char* kOro = "oro.v1";
inline constexpr const char* kFoxgloveSdk = "foxglove.sdk.v1";
inline constexpr const char* kFoxglove = "foxglove.websocket.v1";

/** What a client of the web must know and be. */
struct WebAccess {
    std::string token;
    bool isLoopback = true;            ///< then the host, and the origin of a page, must be this computer
    std::vector<std::string> origins;  ///< of further pages, "https://view.example:8443"
};

/**
 * Decides whether a client may open a WebSocket; another one gets a status and a line that says why. A browser sends
 * the page's host as Origin, and the host of the URL as Host; a page of a foreign site has another one, also if its
 * name leads here (DNS rebinding). So neither gets in, even with the token.
 */
Verdict judgeRequest(const RequestHead& head, const WebAccess& access);

}  // namespace OCL::live

#endif

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_WEB_ADDRESS_HPP
#define OROFORGE_LIVE_WEB_ADDRESS_HPP

#include <rtt/os/descriptor.hpp>

#include <string>

namespace OCL::live {

using RTT::os::detail::Descriptor;

/** Where a web server listens. */
struct WebAddress {
    std::string host = "127.0.0.1";  ///< as digits
    unsigned port = 8765;            ///< 0: any that is free

    /** Only programs of this computer can connect. */
    bool isLoopback() const;
    /** "127.0.0.1:8765", "[::1]:8765" */
    std::string text() const;
};

/** "ADDRESS:PORT", "ADDRESS", ":PORT" or "PORT"; the address is 127.0.0.1, [::1], localhost … False, with the reason,
    if it is none of these. */
bool parseWebAddress(const std::string& text, WebAddress& result, std::string& error);

/** Listens there, and sets the port that is used. Empty, with the reason, if that fails. */
Descriptor listenAt(WebAddress& address, std::string& error);

}  // namespace OCL::live

#endif

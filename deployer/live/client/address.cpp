// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "connection.hpp"

#include "failure.hpp"

#include <algorithm>
#include <cstdlib>

namespace oroforge::live_client {
namespace {

constexpr const char* kPort = "8765";  // of --web

[[noreturn]] void refuse(const std::string& url, const std::string& why) {
    throw Failure(Status::Usage, "'" + url + "' " + why +
                                     "; write an address as 'deployer --web' prints it, such as "
                                     "ws://127.0.0.1:8765/?token=…");
}

bool takePrefix(std::string& text, const std::string& prefix) {
    if (text.compare(0, prefix.size(), prefix) != 0) return false;
    text.erase(0, prefix.size());
    return true;
}

bool isPort(const std::string& text) {
    return !text.empty() && text.size() <= 5 && text.find_first_not_of("0123456789") == std::string::npos &&
           std::atoi(text.c_str()) > 0 && std::atoi(text.c_str()) <= 65535;
}

}  // namespace

Address parseAddress(const std::string& url) {
    std::string rest = url;
    for (const char c : url)
        if (static_cast<unsigned char>(c) <= ' ') refuse(url, "has a blank or control character");
    // A browser shows the page of the same server with http.
    if (!takePrefix(rest, "ws://") && !takePrefix(rest, "http://"))
        refuse(url, rest.find("://") == std::string::npos ? "is no address" : "has a protocol that oro does not speak");
    const std::size_t end = rest.find_first_of("/?#");
    Address address{rest.substr(0, end), kPort, end == std::string::npos ? "/" : rest.substr(end)};
    address.target.erase(std::min(address.target.find('#'), address.target.size()));
    if (address.target.empty() || address.target.front() != '/') address.target = "/" + address.target;
    const std::size_t bracket = address.host.rfind(']');  // of an IPv6 address, which has colons, too
    const std::size_t colon = address.host.find(':', bracket == std::string::npos ? 0 : bracket);
    if (colon != std::string::npos) {
        address.port = address.host.substr(colon + 1);
        address.host.erase(colon);
        if (!isPort(address.port)) refuse(url, "has no port between 1 and 65535 after the colon");
    }
    if (address.host.size() > 2 && address.host.front() == '[' && address.host.back() == ']')
        address.host = address.host.substr(1, address.host.size() - 2);
    if (address.host.empty()) refuse(url, "names no computer");
    return address;
}

}  // namespace oroforge::live_client

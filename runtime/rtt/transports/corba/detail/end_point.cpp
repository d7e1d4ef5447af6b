// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/transports/corba/detail/end_point.hpp>

#include <rtt/os/descriptor.hpp>

#include <atomic>
#include <memory>

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

namespace RTT::corba::detail {

std::string hostOfReference(const std::string& reference) {
    for (const char* const scheme : {"corbaloc:iiop:", "corbaloc::", "corbaname:iiop:", "corbaname::"}) {
        const std::size_t at = reference.find(scheme);
        if (at == std::string::npos) continue;
        std::string host = reference.substr(at + std::string(scheme).size());
        const std::size_t version = host.find('@');  // "1.2@host"
        if (version != std::string::npos) host.erase(0, version + 1);
        if (!host.empty() && host[0] == '[') return host.substr(1, host.find(']') - 1);
        return host.substr(0, host.find_first_of(":/#,"));
    }
    return {};
}

std::string addressTowards(const std::string& host) {
    addrinfo hints{};
    hints.ai_family = AF_INET;
    hints.ai_socktype = SOCK_DGRAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(host.c_str(), "2809", &hints, &found) != 0 || !found) return {};
    const std::unique_ptr<addrinfo, void (*)(addrinfo*)> owned(found, freeaddrinfo);
    // Nothing is sent: connecting only chooses the address.
    const os::detail::Descriptor plug(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0));
    sockaddr_in own{};
    socklen_t size = sizeof own;
    const bool known = plug && connect(plug.get(), found->ai_addr, found->ai_addrlen) == 0 &&
                       getsockname(plug.get(), reinterpret_cast<sockaddr*>(&own), &size) == 0;
    char text[INET_ADDRSTRLEN] = "";
    return known && inet_ntop(AF_INET, &own.sin_addr, text, sizeof text) ? text : std::string();
}

bool isLoopback(const std::string& address) {
    in_addr all{};  // "127.example.org" is no address
    return address.compare(0, 4, "127.") == 0 && inet_pton(AF_INET, address.c_str(), &all) == 1;
}

bool isLocalEndPoint(const std::string& endPoint) {
    if (endPoint.compare(0, 10, "giop:unix:") == 0) return true;
    for (const std::string scheme : {"giop:tcp:", "giop:ssl:"}) {
        if (endPoint.compare(0, scheme.size(), scheme) != 0) continue;
        const std::string place = endPoint.substr(scheme.size());
        if (place.compare(0, 5, "[::1]") == 0) return true;
        const std::string host = place.substr(0, place.find(':'));
        return host == "localhost" || isLoopback(host);
    }
    return false;
}

namespace {
std::atomic<bool> others{true};
}  // namespace

bool othersCanConnect() { return others; }
void setOthersCanConnect(bool can) { others = can; }

}  // namespace RTT::corba::detail

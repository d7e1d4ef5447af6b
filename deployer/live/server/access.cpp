// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "access.hpp"

#include "../door/token.hpp"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <string_view>

namespace OCL::live {
namespace {

std::string lower(std::string_view text) {
    std::string result(text);
    std::transform(result.begin(), result.end(), result.begin(), [](unsigned char c) { return std::tolower(c); });
    return result;
}

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && (text.front() == ' ' || text.front() == '\t')) text.remove_prefix(1);
    while (!text.empty() && (text.back() == ' ' || text.back() == '\t')) text.remove_suffix(1);
    return text;
}

/** "localhost" of "LocalHost:8765", "[::1]" of "[::1]:8765"; empty if anything else follows the host. */
std::string hostOf(std::string_view authority) {
    constexpr long kLastPort = 65535;
    const std::size_t bracket = authority.find(']');
    const std::size_t colon = authority.find(':', bracket == std::string_view::npos ? 0 : bracket);
    const std::string host = lower(authority.substr(0, colon));
    if (colon == std::string_view::npos) return host;
    const std::string port(authority.substr(colon + 1));
    const bool isPort = port.size() <= 5 && port.find_first_not_of("0123456789") == std::string::npos;
    return isPort && std::atol(port.c_str()) <= kLastPort ? host : "";
}

bool isThisComputer(const std::string& host) {
    if (host == "localhost" || host == "[::1]") return true;
    return host.compare(0, 4, "127.") == 0 && host.find_first_not_of("0123456789.") == std::string::npos;
}

/** A page of this computer, of Foxglove, or of the same host; or the program of Foxglove or Lichtblick, which is no
    page. */
bool mayAsk(const std::string& origin, const std::string& host, bool isLoopback) {
    const std::size_t scheme = origin.find("://");
    if (scheme == std::string::npos) return false;  // also "null": a sandboxed page or a local file
    const std::string kind = lower(origin.substr(0, scheme)), from = hostOf(origin.substr(scheme + 3));
    if (kind == "file" || origin == "https://app.foxglove.dev") return true;
    if (kind != "http" && kind != "https") return false;
    return isThisComputer(from) || (!isLoopback && !from.empty() && from == hostOf(host));
}

/** The user has named it. */
bool isNamed(const std::string& origin, const std::vector<std::string>& origins) {
    return std::any_of(origins.begin(), origins.end(), [&](const auto& each) { return lower(each) == lower(origin); });
}

/** The value of a parameter of the target, "/?token=…". */
std::string_view parameter(std::string_view target, std::string_view name) {
    const std::size_t mark = target.find('?');
    if (mark == std::string_view::npos) return {};
    target.remove_prefix(mark + 1);
    while (!target.empty()) {
        const std::size_t end = target.find('&');
        const std::string_view one = target.substr(0, end);
        if (one.size() > name.size() && one.substr(0, name.size()) == name && one[name.size()] == '=')
            return one.substr(name.size() + 1);
        if (end == std::string_view::npos) break;
        target.remove_prefix(end + 1);
    }
    return {};
}

bool knowsToken(const RequestHead& head, const std::string& token) {
    constexpr std::string_view bearer = "bearer ";
    const std::string_view given = head.authorization;
    if (given.size() > bearer.size() && lower(given.substr(0, bearer.size())) == bearer)
        return areEqual(trimmed(given.substr(bearer.size())), token);
    return areEqual(parameter(head.target, "token"), token);
}

Verdict chooseProtocol(std::string_view wanted) {
    if (trimmed(wanted).empty()) return {101, "", ""};
    while (!wanted.empty()) {
        const std::size_t comma = wanted.find(',');
        const std::string_view one = trimmed(wanted.substr(0, comma));
        for (const char* known : {kOro, kFoxgloveSdk, kFoxglove})
            if (one == known) return {101, "", known};
        if (comma == std::string_view::npos) break;
        wanted.remove_prefix(comma + 1);
    }
    return {400, std::string("the subprotocols are ") + kOro + ", " + kFoxgloveSdk + " and " + kFoxglove, ""};
}

}  // namespace

Verdict judgeRequest(const RequestHead& head, const WebAccess& access) {
    if (!head.isLocal && head.host.empty()) return {400, "the header Host is missing", ""};
    if (!head.isLocal && access.isLoopback && !isThisComputer(hostOf(head.host)))
        return {403, "this host has no live window; use 127.0.0.1 or localhost", ""};
    if (!head.origin.empty() && !mayAsk(head.origin, head.host, head.isLocal || access.isLoopback) &&
        (head.isLocal || !isNamed(head.origin, access.origins)))
        return {403,
                "pages of other sites have no access; the deployer's option --web-origin=https://HOST allows those of "
                "a site",
                ""};
    if (head.method != "GET") return {405, "only GET is allowed", ""};
    const std::string path = head.target.substr(0, head.target.find('?'));
    if (path != "/") return {404, "there is nothing here; the WebSocket is at /", ""};
    if (!head.isUpgrade) {
        if (head.isLocal || knowsToken(head, access.token))
            return {200, "This is the live window of a deployment: a WebSocket for Foxglove, Lichtblick and oro.", ""};
        return {401, "the token is missing or wrong; the deployer prints the URL with it", ""};
    }
    if (!head.isLocal && !knowsToken(head, access.token))
        return {401, "the token is missing or wrong; the deployer prints the URL with it", ""};
    return chooseProtocol(head.protocols);
}

}  // namespace OCL::live

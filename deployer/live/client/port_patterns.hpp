// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_CLIENT_PORT_PATTERNS_HPP
#define OROFORGE_LIVE_CLIENT_PORT_PATTERNS_HPP

#include <string>
#include <vector>

namespace oroforge::live_client {

/** Which ports are meant by words such as `arm.*`, `arm` (a component or service, with all its ports) or the topic
    `/arm/position`. */
class PortPatterns {
public:
    /** Without words, all ports are meant. */
    explicit PortPatterns(const std::vector<std::string>& words);

    bool matches(const std::string& port) const;
    /** The words that match none of the ports. */
    std::vector<std::string> unmatched(const std::vector<std::string>& ports) const;

private:
    static bool matches(const std::string& pattern, const std::string& port);

    const std::vector<std::string> words_;  // as they were given
    std::vector<std::string> patterns_;
};

}  // namespace oroforge::live_client

#endif

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_port.hpp"

#include "../requests/failure.hpp"
#include "oro_messages.hpp"

namespace OCL::live {

std::unique_ptr<PortWatch> watchPort(const Root& root, const std::string& path, const PortWatch::Options& options) {
    Visits visits;
    const Found found = find(root, visits, path);
    RTT::base::PortInterface* const port =
        found.component && found.rest.size() == 1 ? found.service->getPort(found.rest[0]) : nullptr;
    if (!port && found.rest.empty()) throw Failure(kUnknownName, "'" + path + "' is no port");
    if (!port) unknown(found, "port");
    const std::string begin = "port '" + path + "' cannot be watched: ";
    RTT::base::OutputPortInterface* const output = port->asOutput();
    if (!output) throw Failure(kNotWatchable, begin + "it is an input; watch the output that is connected to it");
    std::string why;
    std::unique_ptr<PortWatch> made = PortWatch::make(*output, options, why);
    if (!made) throw Failure(kNotWatchable, begin + why);
    return made;
}

}  // namespace OCL::live

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "find_port.hpp"

#include "../requests/failure.hpp"
#include "oro_messages.hpp"

namespace OCL::live {

namespace {

/** The port is there as long as the visits. */
RTT::base::PortInterface& portAt(const Root& root, Visits& visits, const std::string& path) {
    const Found found = find(root, visits, path);
    RTT::base::PortInterface* const port =
        found.component && found.rest.size() == 1 ? found.service->getPort(found.rest[0]) : nullptr;
    if (!port && found.rest.empty()) throw Failure(kUnknownName, "'" + path + "' is no port");
    if (!port) unknown(found, "port");
    return *port;
}

}  // namespace

std::unique_ptr<PortWatch> watchPort(const Root& root, const std::string& path, const PortWatch::Options& options) {
    Visits visits;
    RTT::base::PortInterface& port = portAt(root, visits, path);
    const std::string begin = "port '" + path + "' cannot be watched: ";
    RTT::base::OutputPortInterface* const output = port.asOutput();
    if (!output) throw Failure(kNotWatchable, begin + "it is an input; watch the output that is connected to it");
    std::string why;
    std::unique_ptr<PortWatch> made = PortWatch::make(*output, options, why);
    if (!made) throw Failure(kNotWatchable, begin + why);
    return made;
}

bool describePort(const Root& root, const std::string& path, RTT::encoding::SchemaText& schema, std::string& why) {
    Visits visits;
    const RTT::types::TypeInfo* const type = portAt(root, visits, path).getTypeInfo();
    if (type) return RTT::encoding::describeType(*type, RTT::encoding::SchemaLanguage::Auto, false, schema, why);
    why = "its type is unknown";
    return false;
}

}  // namespace OCL::live

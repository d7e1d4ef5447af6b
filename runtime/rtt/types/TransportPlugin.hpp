// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TRANSPORT_PLUGIN_HPP
#define ORO_TRANSPORT_PLUGIN_HPP

#include <rtt/types/TypeInfo.hpp>
#include <rtt/types/TypeTransporter.hpp>
#include <string>

namespace RTT {

class TaskContext;

namespace types {

/** A library that adds a transport to types. Lives until the process ends. */
class RTT_API TransportPlugin {
public:
    virtual ~TransportPlugin();

    /** Called for each known and each later type, "unknown_t" included; adds a TypeTransporter or returns false. */
    virtual bool registerTransport(std::string type_name, TypeInfo* info) = 0;
    virtual std::string getTransportName() const = 0;
    /** The typekit whose types it transports. */
    virtual std::string getTypekitName() const = 0;
    /** Unique name of the plugin. */
    virtual std::string getName() const = 0;
};

}  // namespace types
}  // namespace RTT

#include "TypekitRepository.hpp"

#endif

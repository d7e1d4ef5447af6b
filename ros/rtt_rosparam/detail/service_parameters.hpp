// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef RTT_ROSPARAM_DETAIL_SERVICE_PARAMETERS_HPP
#define RTT_ROSPARAM_DETAIL_SERVICE_PARAMETERS_HPP

#include <rtt/Service.hpp>

#include <string>

namespace rtt_rosparam {

/**
 * Reads and writes parameters of a component: all properties of a service with those of the services in it, or one
 * item, which is a property or else a service. Names are those of ROS. All block for the master; what goes wrong is
 * logged, and the result false.
 */
class ServiceParameters {
public:
    explicit ServiceParameters(RTT::Service& service) : service_(service) {}

    bool getAll(const std::string& name);
    bool setAll(const std::string& name);
    bool getItem(const std::string& name, const std::string& item);
    bool setItem(const std::string& name, const std::string& item);

private:
    RTT::Service& service_;
};

/** The same for a value that is not a property. */
bool readParameter(const std::string& name, const std::type_info& type, void* value);
bool writeParameter(const std::string& name, const std::type_info& type, const void* value);

}  // namespace rtt_rosparam

#endif

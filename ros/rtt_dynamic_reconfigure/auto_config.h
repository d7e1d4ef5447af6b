// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The properties that a component happens to have as a configuration of dynamic_reconfigure.
#ifndef RTT_DYNAMIC_RECONFIGURE_AUTO_CONFIG_H
#define RTT_DYNAMIC_RECONFIGURE_AUTO_CONFIG_H

#include <rtt_dynamic_reconfigure/server.h>

#include <memory>
#include <string>

namespace rtt_dynamic_reconfigure {

/**
 * Stands for a configuration in Server<AutoConfig>: all properties of types bool, int, unsigned int, float, double and
 * string. Those in bags, and such members of structs, are groups, and have names such as `outer__inner`. Others are left
 * out. At first the limits are those of the types; defaults are the values when the properties are looked at. The level
 * of the n-th parameter is bit n, counted from 0; all from the 32nd on have the last bit.
 */
class AutoConfig {
public:
    static std::unique_ptr<ConfigModel> makeModel();
};

template <>
class Server<AutoConfig> : public ServerBase {
public:
    explicit Server(RTT::TaskContext* owner) : Server("reconfigure", owner) {}
    Server(const std::string& name, RTT::TaskContext* owner) : ServerBase(name, owner, AutoConfig::makeModel()) {}
};

}  // namespace rtt_dynamic_reconfigure

#endif

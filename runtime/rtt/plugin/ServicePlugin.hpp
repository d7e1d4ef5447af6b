// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * Macros that make a library a service plugin. Put exactly one of them, once, in a source file of the plugin:
 *
 *     ORO_SERVICE_NAMED_PLUGIN(MyService, "myservice")         // a service that components load
 *     ORO_GLOBAL_SERVICE_NAMED_PLUGIN(MyService, "myservice")  // one instance in GlobalService, made at load
 *
 * The class derives from RTT::Service and is constructed from an RTT::TaskContext* (null for a global service). Write
 * it with its namespace; the macros without NAMED use that text as the name of the service.
 */
#ifndef ORO_SERVICE_PLUGIN_HPP
#define ORO_SERVICE_PLUGIN_HPP

#include <rtt/Service.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/GlobalService.hpp>
#include "Plugin.hpp"

/** Symbols common to all service plugins: name, target and a factory of unattached instances. */
#define ORO_SERVICE_PLUGIN_COMMON_(SERVICE, NAME)                                                                  \
    RTT_EXPORT RTT::Service::shared_ptr createService();                                                           \
    RTT_EXPORT RTT::Service::shared_ptr createService() { return RTT::Service::shared_ptr(new SERVICE(nullptr)); } \
    RTT_EXPORT std::string getRTTPluginName() { return NAME; }                                                     \
    RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }

/** A service that `loadService(NAME)` adds to a component, one instance per component. */
#define ORO_SERVICE_NAMED_PLUGIN(SERVICE, NAME)                                                     \
    ORO_PLUGIN_C_LINKAGE_BEGIN_                                                                     \
    RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {                                    \
        if (!component) return true;                                                                \
        return component->provides()->addService(RTT::Service::shared_ptr(new SERVICE(component))); \
    }                                                                                               \
    ORO_SERVICE_PLUGIN_COMMON_(SERVICE, NAME)                                                       \
    ORO_PLUGIN_C_LINKAGE_END_

/** As ORO_SERVICE_NAMED_PLUGIN; the service is named after the class. */
#define ORO_SERVICE_PLUGIN(SERVICE) ORO_SERVICE_NAMED_PLUGIN(SERVICE, #SERVICE)

/** A service of which one instance is added to GlobalService when the library is loaded; components cannot load it. */
#define ORO_GLOBAL_SERVICE_NAMED_PLUGIN(SERVICE, NAME)                                                         \
    ORO_PLUGIN_C_LINKAGE_BEGIN_                                                                                \
    RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* component) {                                               \
        if (component) return false;                                                                           \
        const auto global = RTT::internal::GlobalService::Instance();                                          \
        /* there already if the runtime was stopped and started again */                                       \
        return global->hasService(NAME) || global->addService(RTT::Service::shared_ptr(new SERVICE(nullptr))); \
    }                                                                                                          \
    ORO_SERVICE_PLUGIN_COMMON_(SERVICE, NAME)                                                                  \
    ORO_PLUGIN_C_LINKAGE_END_

/** As ORO_GLOBAL_SERVICE_NAMED_PLUGIN; the service is named after the class. */
#define ORO_GLOBAL_SERVICE_PLUGIN(SERVICE) ORO_GLOBAL_SERVICE_NAMED_PLUGIN(SERVICE, #SERVICE)

#endif

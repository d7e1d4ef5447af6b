// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_TYPEKIT_REPOSITORY_HPP
#define ORO_TYPEKIT_REPOSITORY_HPP

#include <rtt/plugin/Plugin.hpp>
#include <rtt/rtt-config.h>

#include <string>

namespace RTT {
namespace types {

class TypekitPlugin;
class TransportPlugin;

/** The typekits and transports of this process. Thread safe; not for real-time contexts. */
class RTT_API TypekitRepository {
public:
    /** Takes ownership and loads the types. A typekit of a name already known is deleted and counts as loaded. */
    static bool Import(TypekitPlugin* typekit);
    static bool Import(TypekitPlugin& typekit);
    /** Takes ownership and offers it all types. */
    static bool Import(TransportPlugin* transport);

    static bool hasTypekit(const std::string& name);
    static bool hasTransport(const std::string& name);
};

}  // namespace types
}  // namespace RTT

/** Makes the library a plugin that brings the typekit or transport CLASS, which must be default constructible. */
#define ORO_TYPEKIT_PLUGIN(CLASS)                                                      \
    ORO_PLUGIN_C_LINKAGE_BEGIN_                                                        \
    RTT_EXPORT bool loadRTTPlugin(RTT::TaskContext* owner) {                           \
        return owner == nullptr && RTT::types::TypekitRepository::Import(new CLASS()); \
    }                                                                                  \
    RTT_EXPORT std::string getRTTPluginName() { return CLASS().getName(); }            \
    RTT_EXPORT std::string getRTTTargetName() { return OROCOS_TARGET_NAME; }           \
    ORO_PLUGIN_C_LINKAGE_END_

#endif

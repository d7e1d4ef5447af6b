// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of what loads plugins.
#ifndef ORO_RTT_PLUGIN_FWD_HPP
#define ORO_RTT_PLUGIN_FWD_HPP

namespace RTT {
namespace plugin {
class PluginLoader;
}
}  // namespace RTT

#endif

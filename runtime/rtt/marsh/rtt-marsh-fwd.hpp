// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Forward declarations of what reads and writes property files.
#ifndef ORO_RTT_MARSH_FWD_HPP
#define ORO_RTT_MARSH_FWD_HPP

namespace RTT {
class Marshalling;
namespace marsh {
class DemarshallInterface;
class MarshallingService;
class MarshallInterface;
class PropertyDemarshaller;
class PropertyLoader;
class PropertyMarshaller;
}  // namespace marsh
}  // namespace RTT

#endif

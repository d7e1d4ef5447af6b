// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_REAL_TIME_TYPEKIT_HPP
#define ORO_REAL_TIME_TYPEKIT_HPP

#include <rtt/types/TypekitPlugin.hpp>

namespace RTT {
namespace types {

/** The typekit "rtt-types": numbers, texts, and the types of the runtime's own interfaces. */
class RTT_API RealTimeTypekitPlugin : public TypekitPlugin {
public:
    bool loadTypes() override;
    bool loadConstructors() override;
    bool loadOperators() override;
    bool loadGlobals() override;
    std::string getName() override;
};

}  // namespace types
}  // namespace RTT

#endif

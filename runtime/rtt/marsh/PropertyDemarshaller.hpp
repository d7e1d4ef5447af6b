// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PROPERTY_DEMARSHALLER_HPP
#define ORO_PROPERTY_DEMARSHALLER_HPP

#include "MarshallInterface.hpp"
#include <string>

namespace RTT {
namespace marsh {

/** Reads a property file and logs all errors with their places. */
class RTT_API PropertyDemarshaller : public DemarshallInterface {
public:
    explicit PropertyDemarshaller(const std::string& filename);
    /** Bags keep the type that the file gives them; see types::composePropertyBag(). */
    bool deserialize(PropertyBag& bag) override;

private:
    std::string filename_;
};

}  // namespace marsh
}  // namespace RTT

#endif

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "Property.hpp"

#include "Logger.hpp"

namespace RTT::internal::detail {

namespace {
const std::string& noText() {
    static const std::string empty;
    return empty;
}
}  // namespace

void logPropertyMismatch(const base::PropertyBase& from, const std::string& destination) {
    log(Error) << "property " << from.getName() << " has type " << from.getType()
               << " and cannot be used as a property of type " << destination << endlog();
}

const std::string& nameOf(const base::PropertyBase* property) { return property ? property->getName() : noText(); }

const std::string& descriptionOf(const base::PropertyBase* property) {
    return property ? property->getDescription() : noText();
}

}  // namespace RTT::internal::detail

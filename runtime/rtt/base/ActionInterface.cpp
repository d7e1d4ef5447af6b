// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "ActionInterface.hpp"

namespace RTT::base {

ActionInterface::~ActionInterface() = default;

void ActionInterface::reset() {}

bool ActionInterface::valid() const { return true; }

ActionInterface* ActionInterface::copy(std::map<const DataSourceBase*, DataSourceBase*>&) const { return clone(); }

}  // namespace RTT::base

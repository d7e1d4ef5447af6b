// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/base/DisposableInterface.hpp>
#include <rtt/base/ExecutableInterface.hpp>

namespace RTT::base {
DisposableInterface::~DisposableInterface() = default;
bool DisposableInterface::isError() const { return false; }
ExecutableInterface::~ExecutableInterface() = default;
}  // namespace RTT::base

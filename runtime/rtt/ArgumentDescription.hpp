// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The description of an argument of an operation.
#ifndef ORO_ARGUMENT_DESCRIPTION_HPP
#define ORO_ARGUMENT_DESCRIPTION_HPP
#include <rtt/OperationInterfacePart.hpp>
#endif

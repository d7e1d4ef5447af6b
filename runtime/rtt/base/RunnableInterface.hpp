// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_BASE_RUNNABLE_INTERFACE_HPP
#define ORO_BASE_RUNNABLE_INTERFACE_HPP
#include <rtt/os/RunnableInterface.hpp>
#endif

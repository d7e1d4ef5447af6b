// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_PORT_HPP
#define ORO_PORT_HPP

#include <rtt/ConnPolicy.hpp>
#include <rtt/InputPort.hpp>
#include <rtt/OutputPort.hpp>
#include <rtt/internal/ConnectionManager.hpp>

// Users rely on this include, which the header itself does not need.
#include <rtt/usual_includes.hpp>

#endif

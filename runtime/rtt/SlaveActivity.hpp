// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// The place of this activity before version 2.
#ifndef ORO_SLAVE_ACTIVITY_FORWARD_HPP
#define ORO_SLAVE_ACTIVITY_FORWARD_HPP
#include <rtt/extras/SlaveActivity.hpp>
#endif

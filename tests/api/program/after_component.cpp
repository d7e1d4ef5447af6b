// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Component.hpp>
#define PART after_component
#include "use_everything.hpp"

int check_after_component() { return after_component::Component("after_component").check(); }

ORO_CREATE_COMPONENT(after_component::Component)

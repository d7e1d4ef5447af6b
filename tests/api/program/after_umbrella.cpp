// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/RTT.hpp>
#define PART after_umbrella
#include "use_everything.hpp"

int check_after_umbrella() { return after_umbrella::Component("after_umbrella").check(); }

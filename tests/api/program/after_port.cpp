// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Port.hpp>
#define PART after_port
#include "use_usual.hpp"

int check_after_port() { return after_port::check(); }

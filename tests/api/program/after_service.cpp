// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/Service.hpp>
#define PART after_service
#include "use_usual.hpp"

int check_after_service() { return after_service::check(); }

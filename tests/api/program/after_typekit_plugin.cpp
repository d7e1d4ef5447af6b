// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/types/TypekitPlugin.hpp>
#define PART after_typekit_plugin
#include "use_usual.hpp"

int check_after_typekit_plugin() { return after_typekit_plugin::check(); }

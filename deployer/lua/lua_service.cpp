// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_service.hpp"

#include <rtt/plugin/ServicePlugin.hpp>

ORO_SERVICE_NAMED_PLUGIN(OCL::LuaService, "Lua")

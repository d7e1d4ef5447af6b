// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_DEPLOYER_LUA_PROMPT_HPP
#define OROFORGE_DEPLOYER_LUA_PROMPT_HPP

#include "../console/interrupts.hpp"
#include "../lua/interpreter.hpp"

namespace OCL::deploy {

/** Executes what is typed or piped, until that ends, os.exit() is called or `endsOn` becomes readable. Within
    Interpreter::run(). */
void promptForLua(lua::Interpreter& interpreter, console::Interrupts& interrupts, int endsOn);

}  // namespace OCL::deploy

#endif

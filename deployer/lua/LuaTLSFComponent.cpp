// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <ocl/LuaTLSFComponent.hpp>

#include "pool_functions.hpp"
#include "script.hpp"

#include <ocl/Component.hpp>

namespace OCL {

LuaTLSFComponent::LuaTLSFComponent(std::string name)
    : LuaTLSFComponent(name, std::make_unique<lua::PoolMemory>(lua::kPoolSize)) {}

LuaTLSFComponent::LuaTLSFComponent(const std::string& name, std::unique_ptr<lua::PoolMemory> memory)
    : LuaComponent(name, std::move(memory)), memory_(static_cast<lua::PoolMemory&>(script().state().memory())) {
    lua::addPoolFunctions(script().state());
    addOperation("tlsf_incmem", &LuaTLSFComponent::tlsf_incmem, this, RTT::OwnThread)
        .doc("Adds memory to the pool of the interpreter. False if the system does not have it.")
        .arg("size", "How many bytes");
}

LuaTLSFComponent::~LuaTLSFComponent() { stopForGood(); }

bool LuaTLSFComponent::tlsf_incmem(unsigned size) {
    const lua::State::Lock lock(script().state());
    return memory_.grow(size);
}

}  // namespace OCL

ORO_CREATE_COMPONENT(OCL::LuaTLSFComponent)

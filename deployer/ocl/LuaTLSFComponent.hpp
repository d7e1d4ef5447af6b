// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef ORO_OCL_LUA_TLSF_COMPONENT_HPP
#define ORO_OCL_LUA_TLSF_COMPONENT_HPP

#include <ocl/LuaComponent.hpp>

namespace OCL {

namespace lua {
class PoolMemory;
}

/**
 * A LuaComponent whose interpreter has its memory from a pool of 2 MiB, which the operation tlsf_incmem() enlarges.
 * It takes nothing from the system while it runs, and each request takes a constant time. When the pool is used up,
 * the Lua code that asks for more fails with "not enough memory".
 *
 * Lua code has the functions tlsf.stats(), tlsf.warn(part) and tlsf.trace(on), see docs/lua.md.
 */
class OCL_API LuaTLSFComponent : public LuaComponent {
public:
    explicit LuaTLSFComponent(std::string name);
    ~LuaTLSFComponent() override;

    /** Adds so many bytes. False if the system does not have them. Not real-time safe. */
    bool tlsf_incmem(unsigned size);

private:
    LuaTLSFComponent(const std::string& name, std::unique_ptr<lua::PoolMemory> memory);
    lua::PoolMemory& memory_;
};

}  // namespace OCL

#endif

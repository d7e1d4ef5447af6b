// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "lua_service.hpp"
#include "pool_functions.hpp"

#include <rtt/plugin/ServicePlugin.hpp>

namespace OCL {

/** The same with memory from a pool. */
class LuaTLSFService : public LuaService {
public:
    explicit LuaTLSFService(RTT::TaskContext* owner)
        : LuaService("LuaTLSF", owner, std::make_unique<lua::PoolMemory>(lua::kPoolSize)) {
        lua::addPoolFunctions(script_.state());
        addOperation("tlsf_incmem", &LuaTLSFService::tlsf_incmem, this)
            .doc("Adds memory to the pool of the interpreter. False if the system does not have it.")
            .arg("size", "How many bytes");
    }

private:
    bool tlsf_incmem(unsigned size) {
        const lua::State::Lock lock(script_.state());
        return static_cast<lua::PoolMemory&>(script_.state().memory()).grow(size);
    }
};

}  // namespace OCL

ORO_SERVICE_NAMED_PLUGIN(OCL::LuaTLSFService, "LuaTLSF")

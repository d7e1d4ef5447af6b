// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OCL_LUA_OPERATION_CALL_HPP
#define OCL_LUA_OPERATION_CALL_HPP

#include "life.hpp"

#include <rtt/OperationInterfacePart.hpp>
#include <rtt/internal/calls/operation_signature.hpp>

#include <lua.hpp>

#include <string>
#include <vector>

namespace OCL::lua {

class Conversion;
class State;

/** Calls one operation with arguments of Lua. The variables for the arguments are kept from one call to the next. */
class OperationCall {
public:
    typedef RTT::OperationInterfacePart Part;

    OperationCall(State& state, Part::shared_constptr part, Life life);

    const Part::shared_constptr& part() const { return part_; }
    const RTT::internal::OperationSignature& signature() const { return signature_; }

    /** Calls with the arguments from index `first` to the top; pushes the result and returns 1. Throws Failure. */
    int call(lua_State* lua, int first);
    /** Sends with these arguments; the handle. Throws Failure. */
    RTT::base::DataSourceBase::shared_ptr send(lua_State* lua, int first);

private:
    typedef RTT::base::DataSourceBase::shared_ptr Source;

    void prepare();
    void check(lua_State* lua, int first) const;
    bool canReuse(lua_State* lua, int first) const;
    /** New sources for the arguments: the Variables themselves for those that the operation assigns. */
    Part::Args arguments(lua_State* lua, int first) const;
    Source newArgument(std::size_t index) const;
    void evaluate(const Source& call);
    [[noreturn]] void fail(const std::string& why) const;

    State& state_;
    const Part::shared_constptr part_;
    const RTT::internal::OperationSignature signature_;
    const Life life_;
    Part::Args kept_;
    Source call_;  // with the kept arguments; null if one of them has no values
    const Conversion* result_;
    bool busy_ = false;  // the kept arguments are in use
};

}  // namespace OCL::lua

#endif

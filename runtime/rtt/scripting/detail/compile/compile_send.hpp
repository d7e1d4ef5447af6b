// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Compiles calls that are sent and collected, and calls whose failures are reported with reasons.
#ifndef ORO_SCRIPTING_DETAIL_COMPILE_SEND_HPP
#define ORO_SCRIPTING_DETAIL_COMPILE_SEND_HPP

#include <rtt/scripting/detail/compile/compile_call.hpp>

#include <set>

namespace RTT::scripting::detail {

class SendCompiler : private UnitPart {
public:
    explicit SendCompiler(UnitCompiler& unit) : UnitPart(unit) {}

    /** The call, or one that reports its place if it fails. */
    Source told(Source call, const Callable& called, const ast::Name& name, ast::Place at) const;
    /** Notes the calls in a statement whose values are ignored. */
    void ignore(const ast::Expression& statement);

    /** Sends a call that is not collected, unless the value is assigned to something. */
    Operand sent(const Callable& called, const ast::Name& name, ast::Place at);
    /** Sends the call; then the program yields until the call is done. The value is the SendStatus. */
    Operand command(const Callable& called, const ast::Name& name, ast::Place at);
    /** `handle.collect()` and `handle.collectIfDone()`. */
    bool handleCall(const ast::Name& name, ast::Place at, Operand& result);
    bool assignHandle(const ast::Assignment& assignment, ast::Place at, Operand& result);
    /** Sends what `value` says and keeps the call for the handle, which has that name. */
    Operand sendInto(Scope::Handle& handle, const std::string& name, const ast::Expression& value, ast::Place at);
    [[noreturn]] void failUnsent(const ast::Identifier& handle);

private:
    CallPlace placeOfCall(ast::Place at) const;
    std::shared_ptr<TrackedSend> trackedSend(const Callable& called, ast::Place at, std::shared_ptr<LastSent> last,
                                             bool forgotten);
    void sendTo(const Operand& handle, const Callable& called, const ast::Name& name, ast::Place at,
                const std::shared_ptr<TrackedSend>& told);
    Operand sent(OperationInterfacePart& part, const ast::Name& name, ast::Place at);

    std::set<const ast::Name*> ignored_;
};

}  // namespace RTT::scripting::detail

#endif

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/call_words.hpp>
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/FactoryExceptions.hpp>
#include <rtt/TaskContext.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/internal/calls/failure_report.hpp>
#include <rtt/internal/GlobalService.hpp>
#include <rtt/types/TypeInfo.hpp>
#include <rtt/base/OperationCallerInterface.hpp>
#include <rtt/scripting/detail/execute/instructions.hpp>
#include <rtt/scripting/detail/compile/find_calls.hpp>
#include <rtt/scripting/detail/compile/told_call.hpp>
#include <rtt/scripting/detail/compile/tracked_send.hpp>

#include <typeinfo>

namespace RTT::scripting::detail {

namespace {

/** True for the operation with which each component loads services. */
bool isLoadService(Service& of, const OperationInterfacePart& part) {
    return of.getOwner() && of.getOwner()->provides().get() == &of && part.getName() == "loadService";
}

bool givesReasons(const Callable& called) {
    if (!called.of) return called.part == internal::GlobalService::Instance()->getPart("require");
    return internal::FailureReport::comesFrom(*called.of) || isLoadService(*called.of, *called.part);
}

/** The type of the operation's result. */
const std::type_info& resultOf(const OperationInterfacePart& part) {
    const types::TypeInfo* const type = part.getArgumentType(0);
    return type ? *type->getTypeId() : typeid(void);
}

}  // namespace

void SendCompiler::ignore(const ast::Expression& statement) {
    ignored_.clear();
    forIgnored(statement, [this](const ast::Expression& each) {
        if (const auto* const name = std::get_if<ast::Name>(&each.what)) ignored_.insert(name);
    });
}

base::DataSourceBase::shared_ptr SendCompiler::told(Source call, const Callable& called, const ast::Name& name,
                                                    ast::Place at) const {
    if (!givesReasons(called)) return call;
    internal::DataSource<bool>* const success = internal::DataSource<bool>::narrow(call.get());
    if (!success) return call;
    return new ToldCall(success, placeOfCall(at), ignored_.count(&name) != 0);
}

CallPlace SendCompiler::placeOfCall(ast::Place at) const {
    // An alias may be from another file.
    const bool isHere = where_.text && !reporter_.alias().declared;
    return {reporter_.locate(at), isHere ? lineOf(*where_.text, at.line) : ""};
}

/** Reports the failure of the call; null if the operation gives no reasons. */
std::shared_ptr<TrackedSend> SendCompiler::trackedSend(const Callable& called, ast::Place at,
                                                       std::shared_ptr<LastSent> last, bool forgotten) {
    if (!givesReasons(called) || resultOf(*called.part) != typeid(bool)) return nullptr;
    const auto local = boost::dynamic_pointer_cast<base::OperationCallerInterface>(called.part->getLocalOperation());
    if (!local) return nullptr;
    if (last) last->use();
    return std::make_shared<TrackedSend>(local->callee(), placeOfCall(at), std::move(last), where_.sent, forgotten);
}

/** Sends the call and assigns its handle. */
void SendCompiler::sendTo(const Operand& handle, const Callable& called, const ast::Name& name, ast::Place at,
                          const std::shared_ptr<TrackedSend>& told) {
    const Operand call = sent(*called.part, name, at);
    if (told) {
        code_.keep(told);
        code_.add(&instructions::announce, nullptr, nullptr, told.get());
    }
    values_.store(handle, call, "the handle");
    if (told) code_.add(&instructions::announce);
}

Operand SendCompiler::sent(const Callable& called, const ast::Name& name, ast::Place at) {
    const auto told = trackedSend(called, at, nullptr, true);
    if (!told) return sent(*called.part, name, at);
    Operand result =
        values_.fromSource(unit_.calls.made(name, at, *called.part, [&] { return called.part->produceHandle(); }), at);
    sendTo(result, called, name, at, told);
    result.sent = true;
    return result;
}

Operand SendCompiler::sent(OperationInterfacePart& part, const ast::Name& name, ast::Place at) {
    const auto sources = unit_.calls.arguments(name, part);
    ++unit_.executions;
    code_.keep(OperationInterfacePart::hold(&part));
    Operand result = values_.fromSource(
        unit_.calls.made(name, at, part, [&] { return part.produceSend(sources, where_.caller); }), at);
    result.sent = true;
    return result;
}

Operand SendCompiler::command(const Callable& called, const ast::Name& name, ast::Place at) {
    const OperationInterfacePart& part = *called.part;
    const auto last = std::make_shared<LastSent>();
    const Source handle = unit_.calls.made(name, at, part, [&] { return part.produceHandle(); });
    const auto told = trackedSend(called, at, last, false);
    sendTo(values_.fromSource(handle, at), called, name, at, told);
    const Source status = unit_.calls.made(
        name, at, part, [&] { return part.produceCollect({handle}, new internal::ConstantDataSource<bool>(false)); });
    auto* polled = internal::DataSource<SendStatus>::narrow(code_.keepSource(status));
    if (!polled) reporter_.error(at, "OPS145", "cannot wait for '" + joined(name.parts) + "'");
    if (told) code_.keepSource(polled = new TrackedCollect(polled, last, true, false));
    code_.add(&instructions::await, nullptr, nullptr, polled);
    const Source value = new internal::ValueDataSource<SendStatus>(SendNotReady);
    // Evaluating the source would collect again, so its last value is used.
    Operand result = values_.fromSource(value, at);
    std::shared_ptr<base::ActionInterface> copy(
        value->updateAction(code_.keepSource(new internal::ConstReferenceDataSource<SendStatus>(polled->rvalue()))));
    code_.add(&instructions::perform, nullptr, nullptr, copy.get());
    code_.keep(std::move(copy));
    return result;
}

namespace {

/** What `make` makes. Its exceptions do not count the first argument, because the script does not write that. */
template <class Make>
auto withoutFirst(Make make) -> decltype(make()) {
    try {
        return make();
    } catch (wrong_types_of_args_exception& e) {
        --e.whicharg;
        throw;
    } catch (non_lvalue_args_exception& e) {
        --e.whicharg;
        throw;
    }
}

}  // namespace

bool SendCompiler::handleCall(const ast::Name& name, ast::Place at, Operand& result) {
    if (name.parts.size() != 2) return false;
    const std::string& what = name.parts[1].text;
    const bool blocking = what == "collect";
    if (!blocking && what != "collectIfDone") return false;
    const Scope::Entry* const entry = unit_.names.declared(name.parts[0].text);
    if (!entry) return false;
    const std::string handle = "'" + name.parts[0].text + "'";
    if (!entry->handle)
        reporter_.error(name.parts[0].at, "OPS147",
                        "expected a SendHandle before '." + what + "', " + handle + " is none");
    const auto operation = entry->handle->operation();
    const Source handleSource = entry->handle->source();
    if (!operation || !handleSource) failUnsent(name.parts[0]);
    OperationInterfacePart::Args sources{handleSource};
    for (const Operand& value : unit_.calls.values(name.arguments, [](std::size_t) { return true; }))
        sources.push_back(values_.sourceOf(value));
    const OperationInterfacePart& part = *operation;
    const unsigned wanted = part.collectArity();
    if (sources.size() != 1 && sources.size() != wanted + 1)
        reporter_.error(at, "OPS142",
                        "'" + joined(name.parts) + "' expects " + counted(wanted) + " or none, found " +
                            counted(sources.size() - 1));
    const auto collected = [&] {
        return withoutFirst(
            [&] { return part.produceCollect(sources, new internal::ConstantDataSource<bool>(blocking)); });
    };
    Source status = unit_.calls.made(name, at, part, collected);
    auto* const collect = internal::DataSource<SendStatus>::narrow(status.get());
    const auto& last = entry->handle->lastSent();
    if (collect && last->isUsed()) status = new TrackedCollect(collect, last, sources.size() == 1, true);
    result = values_.fromSource(status, at);
    ++unit_.executions;
    return true;
}

bool SendCompiler::assignHandle(const ast::Assignment& assignment, ast::Place at, Operand& result) {
    const auto* const to = std::get_if<ast::Name>(&assignment.to->what);
    if (!to || to->called || to->parts.size() != 1) return false;
    const Scope::Entry* const entry = unit_.names.declared(to->parts[0].text);
    if (!entry || !entry->handle) return false;
    result = sendInto(*entry->handle, to->parts[0].text, *assignment.value, at);
    return true;
}

Operand SendCompiler::sendInto(Scope::Handle& handle, const std::string& name, const ast::Expression& value,
                               ast::Place at) {
    const auto* const from = std::get_if<ast::Name>(&value.what);
    const std::size_t count = from ? from->parts.size() : 0;
    const bool sends = count > 1 && from->parts.back().text == "send";
    const Callable called =
        sends ? unit_.calls.callable(from->parts, count - 1, unit_.names.walk(from->parts, count), true) : Callable();
    if (!called.part) {
        if (sends) unit_.expressions.compile(value);  // reports what is unknown
        reporter_.error(value.at, "OPS149", "expected 'operation.send(...)' for the handle '" + name + "'");
    }
    Source source = handle.source();
    if (handle.operation().get() != called.part) {
        const Source own =
            unit_.calls.made(*from, value.at, *called.part, [&] { return called.part->produceHandle(); });
        // Keeps the variable for code that was compiled before, if possible; which operation was sent last is known at
        // run time.
        if (!source || !source->hasTypeOf(*own)) source = own;
        handle.set(OperationInterfacePart::hold(called.part), source);
    }
    const Operand result = values_.fromSource(source, at);
    const auto told = trackedSend(called, value.at, handle.lastSent(), false);
    sendTo(result, called, *from, value.at, told);
    if (!told && handle.lastSent()->isUsed()) {
        code_.keep(handle.lastSent());
        code_.add(&instructions::forgetSent, nullptr, nullptr, handle.lastSent().get());
    }
    return result;
}

void SendCompiler::failUnsent(const ast::Identifier& handle) {
    reporter_.error(handle.at, "OPS148", "nothing was sent with the handle '" + handle.text + "' before this line");
}

}  // namespace RTT::scripting::detail

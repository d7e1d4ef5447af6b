// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/PropertyBag.hpp>
#include <rtt/internal/DataSources.hpp>
#include <rtt/scripting/detail/compile/arithmetic.hpp>
#include <rtt/scripting/detail/compile/call_words.hpp>
#include <rtt/scripting/detail/execute/instructions.hpp>
#include <rtt/scripting/detail/compile/overloaded.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/Types.hpp>

#include <diag/nearest_match.hpp>

#include <algorithm>
#include <type_traits>

namespace RTT::scripting::detail {

namespace {

constexpr unsigned kDeepestSource = 100;

template <class T>
constexpr Kind kindFor() {
    if (std::is_same_v<T, bool>) return Kind::Bool;
    if (std::is_same_v<T, char>) return Kind::Char;
    if (std::is_same_v<T, int>) return Kind::Int;
    if (std::is_same_v<T, unsigned int>) return Kind::UInt;
    if (std::is_same_v<T, long long>) return Kind::LLong;
    if (std::is_same_v<T, unsigned long long>) return Kind::ULLong;
    return std::is_same_v<T, float> ? Kind::Float : Kind::Double;
}

/** The member that was meant; for example, sequences have `size` as in C++. */
std::string memberMeant(const std::string& name, const std::vector<std::string>& known) {
    const std::string near = oroforge::diag::didYouMean(name, known);
    const bool counts = name == "length" || name == "len" || name == "count";
    const bool sized = std::find(known.begin(), known.end(), "size") != known.end();
    return near.empty() && counts && sized ? "; did you mean 'size'?" : near;
}

}  // namespace

Operand ExpressionCompiler::compile(const ast::Expression& expression) {
    const ast::Place at = expression.at;
    return std::visit(Overloaded{[&](const ast::Literal& e) { return literal(e, at); },
                                 [&](const ast::CurrentTime&) {
                                     return values_.computedBy(&instructions::now, nullptr, nullptr, Kind::Double, at);
                                 },
                                 [&](const ast::Name& e) { return unit_.names.compile(e, at); },
                                 [&](const ast::Member& e) { return member(compile(*e.of), e.member); },
                                 [&](const ast::Index& e) { return element(e, at); },
                                 [&](const ast::Unary& e) { return negated(e, compile(*e.operand), at); },
                                 [&](const ast::Binary& e) { return binary(e); },
                                 [&](const ast::Assignment& e) { return assignment(e, at); }},
                      expression.what);
}

Operand ExpressionCompiler::literal(const ast::Literal& literal, ast::Place at) {
    return std::visit(
        [&](const auto& value) {
            typedef std::decay_t<decltype(value)> T;
            Operand operand;
            operand.at = at;
            if constexpr (std::is_same_v<T, std::string>) {
                operand.kind = Kind::Other;
                operand.source = new internal::ConstantDataSource<std::string>(value);
            } else {
                Cell* const cell = code_.newCell();
                *reinterpret_cast<T*>(cell) = value;
                operand.kind = kindFor<T>();
                operand.address = cell;
            }
            operand.constant = true;
            return operand;
        },
        literal.value);
}

Operand ExpressionCompiler::truth(const ast::Expression& condition) {
    if (std::holds_alternative<ast::Assignment>(condition.what))
        reporter_.warn(condition.at, "OPS153", "this condition assigns a value; '==' compares");
    const Operand value = values_.promoted(compile(condition));
    if (isDirect(value.kind) && conversion(value.kind, Kind::Bool) != Conversion::None)
        return values_.loadAs(value, Kind::Bool);
    if (value.kind != Kind::None && !isDirect(value.kind)) {
        const auto converted =
            reporter_.watched(condition.at, [&] { return types::Types()->getTypeInfo<bool>()->convert(value.source); });
        if (converted && kindOf(*converted) == Kind::Bool) return values_.load(values_.fromSource(converted, value.at));
    }
    reporter_.error(condition.at, "OPS121",
                    "expected a condition, which is true or false, found a value of type " + typeName(value));
}

Operand ExpressionCompiler::member(const Operand& of, const ast::Identifier& name) {
    if (of.kind == Kind::None)
        reporter_.error(name.at, "OPS122", "found '." + name.text + "' after something that has no value");
    const Source whole = values_.sourceOf(of);
    if (Source part = whole->getMember(name.text)) return values_.fromSource(part, of.at);
    if (base::DataSourceBase* const part = types::operators()->applyDot(name.text, whole.get()))
        return values_.fromSource(part, of.at);
    std::vector<std::string> known = whole->getMemberNames();
    if (const auto* const bag = internal::DataSource<PropertyBag>::narrow(whole.get())) known = bag->rvalue().list();
    if (std::find(known.begin(), known.end(), name.text) != known.end())
        reporter_.error(
            name.at, "OPS123",
            "member '" + name.text + "' of type " + typeName(of) + " has itself a type that no loaded typekit knows");
    reporter_.error(name.at, "OPS123",
                    "type " + typeName(of) + " has no member '" + name.text + "'" + memberMeant(name.text, known));
}

Operand ExpressionCompiler::element(const ast::Index& index, ast::Place at) {
    const Operand of = compile(*index.of);
    Operand which = values_.promoted(compile(*index.index));
    if (isDirect(which.kind)) which = values_.load(which);  // once, however often the element is used
    if (of.kind == Kind::None || which.kind == Kind::None)
        reporter_.error(at, "OPS122", "found '[...]' with something that has no value");
    const Source whole = values_.sourceOf(of);
    if (Source part = whole->getMember(values_.sourceOf(which))) return values_.fromSource(part, at);
    reporter_.error(
        at, "OPS124",
        "a value of type " + typeName(of) + " has no elements that an index of type " + typeName(which) + " selects");
}

Operand ExpressionCompiler::negated(const ast::Unary& operation, const Operand& operand, ast::Place at) {
    if (isDirect(operand.kind)) {
        const Operation direct = unaryOperation(operation.op, operand.kind);
        if (direct.act)
            return values_.computedBy(direct.act, values_.load(operand).address, nullptr, direct.result, at);
        if (operation.op == '!' && conversion(operand.kind, Kind::Bool) != Conversion::None)
            return values_.computedBy(unaryOperation('!', Kind::Bool).act, values_.loadAs(operand, Kind::Bool).address,
                                      nullptr, Kind::Bool, at);
    }
    if (operand.kind != Kind::None)
        if (auto* const made =
                types::operators()->applyUnary(std::string(1, operation.op), values_.sourceOf(operand).get()))
            return values_.fromSource(made, at);
    if (isSmallNumber(operand)) return negated(operation, values_.promoted(operand), at);
    reporter_.error(at, "OPS125",
                    std::string("operator '") + operation.op + "' does not exist for type " + typeName(operand));
}

Operand ExpressionCompiler::binary(const ast::Binary& row) {
    const unsigned first = unit_.executions;
    Operand left = compile(*row.first);
    unsigned depth = 0;
    for (const ast::Binary::Step& step : row.steps) {
        left = operation(std::move(left), step, first);
        // Nested sources are evaluated and destroyed by recursion.
        depth = isDirect(left.kind) ? 0 : depth + 1;
        if (depth < kDeepestSource) continue;
        left = values_.copied(left, code_.size());
        depth = 0;
    }
    return left;
}

/** `first` is what unit_.executions was where the row begins. */
Operand ExpressionCompiler::operation(Operand left, const ast::Binary::Step& step, unsigned first) {
    if (isDirect(left.kind)) left = values_.load(left);
    const std::size_t before = code_.size();
    const unsigned executions = unit_.executions;
    Operand right = compile(*step.right);
    // Calls on the right may change what is read on the left, and calls on the left must precede computations on the
    // right.
    if (unit_.executions != executions || (executions != first && code_.size() != before))
        left = values_.copied(left, before);
    return combined(left, right, step);
}

Operand ExpressionCompiler::combined(const Operand& left, Operand right, const ast::Binary::Step& step) {
    if (isDirect(right.kind)) right = values_.load(right);
    if (isDirect(left.kind) && isDirect(right.kind)) {
        const Operation direct = binaryOperation(step.op, left.kind);
        if (direct.act && conversion(right.kind, left.kind) != Conversion::None)
            return values_.computedBy(direct.act, left.address, values_.loadAs(right, left.kind).address, direct.result,
                                      step.at);
    }
    // Texts and values of enums are compared as texts.
    const bool compares = step.op == "==" || step.op == "!=";
    if (compares && left.constant && !isDirect(left.kind) && right.source && isEnum(right.source->getTypeInfo()))
        reporter_.watched(left.at, [&] { return right.source->getTypeInfo()->convert(left.source); });
    if (left.kind != Kind::None && right.kind != Kind::None)
        if (const Source made = reporter_.watched(right.at, [&]() -> Source {
                return types::operators()->applyBinary(step.op, values_.sourceOf(left).get(),
                                                       values_.sourceOf(right).get());
            }))
            return values_.fromSource(made, step.at);
    if (isSmallNumber(left) || isSmallNumber(right)) {
        const Operand wide = values_.promoted(left);
        return combined(isDirect(wide.kind) ? values_.load(wide) : wide, values_.promoted(right), step);
    }
    reporter_.error(
        step.at, "OPS126",
        "operator '" + step.op + "' does not exist for types " + typeName(left) + " and " + typeName(right));
}

Operand ExpressionCompiler::assignment(const ast::Assignment& assignment, ast::Place at) {
    Operand result;
    if (unit_.sends.assignHandle(assignment, at, result)) return result;
    const Operand to = compile(*assignment.to);
    if (!to.assignable())
        reporter_.error(
            assignment.to->at, "OPS127",
            to.source ? "this is a constant or a result and cannot be assigned to" : "this cannot be assigned to");
    const auto* const name = std::get_if<ast::Name>(&assignment.to->what);
    values_.store(to, compile(*assignment.value), name ? "'" + joined(name->parts) + "'" : "a variable");
    ++unit_.executions;
    return to;
}

}  // namespace RTT::scripting::detail

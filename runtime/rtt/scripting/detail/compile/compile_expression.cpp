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

Operand UnitCompiler::expression(const ast::Expression& expression) {
    const ast::Place at = expression.at;
    return std::visit(
        Overloaded{[&](const ast::Literal& e) { return literal(e, at); },
                   [&](const ast::CurrentTime&) { return currentTime(at); },
                   [&](const ast::Name& e) { return name(e, at); },
                   [&](const ast::Member& e) { return member(this->expression(*e.of), e.member); },
                   [&](const ast::Index& e) { return element(e, at); },
                   [&](const ast::Unary& e) { return unary(e, at); }, [&](const ast::Binary& e) { return binary(e); },
                   [&](const ast::Assignment& e) { return assignment(e, at); }},
        expression.what);
}

Operand UnitCompiler::literal(const ast::Literal& literal, ast::Place at) {
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

Operand UnitCompiler::currentTime(ast::Place at) {
    return computedBy(&instructions::now, nullptr, nullptr, Kind::Double, at);
}

Operand UnitCompiler::computedBy(Action act, const void* a, const void* b, Kind kind, ast::Place at) {
    Operand result;
    result.kind = kind;
    result.at = at;
    result.computed = true;
    Cell* const cell = code_.newCell();
    emit(act, a, b, cell);
    result.address = cell;
    return result;
}

Operand UnitCompiler::fromSource(Source source, ast::Place at) {
    Operand result;
    result.kind = kindOf(*source);
    if (isDirect(result.kind)) result.address = fixedAddress(*source, result.kind);
    if (result.address) keep(source);
    result.source = std::move(source);
    result.at = at;
    return result;
}

Operand UnitCompiler::load(Operand operand) {
    if (operand.address) return operand;
    const base::DataSourceBase* const source = keep(operand.source);
    return withType(operand.kind, [&](auto type) {
        return computedBy(&instructions::load<typename decltype(type)::type>, source, nullptr, operand.kind,
                          operand.at);
    });
}

Operand UnitCompiler::loadAs(Operand operand, Kind kind) {
    operand = load(operand);
    if (operand.kind == kind) return operand;
    if (conversion(operand.kind, kind) == Conversion::Warned) warnOfConversion(operand.at, typeName(operand), "int");
    if (!operand.constant)
        return computedBy(conversionAction(operand.kind, kind), operand.address, nullptr, kind, operand.at);
    Operand converted;
    converted.kind = kind;
    converted.constant = true;
    converted.at = operand.at;
    Cell* const cell = code_.newCell();
    convertValue(operand.kind, operand.address, kind, cell);
    converted.address = cell;
    return converted;
}

Operand UnitCompiler::promoted(Operand operand) {
    if (!isSmallNumber(operand)) return operand;
    return withType(widened(operand.source->getTypeId()), [&](auto type) {
        const Source wide = types::Types()->getTypeInfo<typename decltype(type)::type>()->convert(operand.source);
        return fromSource(wide, operand.at);
    });
}

Operand UnitCompiler::truth(const ast::Expression& condition) {
    if (std::holds_alternative<ast::Assignment>(condition.what))
        warn(condition.at, "OPS153", "this condition assigns a value; '==' compares");
    const Operand value = promoted(expression(condition));
    if (isDirect(value.kind) && conversion(value.kind, Kind::Bool) != Conversion::None)
        return loadAs(value, Kind::Bool);
    if (value.kind != Kind::None && !isDirect(value.kind)) {
        const auto converted =
            watched(condition.at, [&] { return types::Types()->getTypeInfo<bool>()->convert(value.source); });
        if (converted && kindOf(*converted) == Kind::Bool) return load(fromSource(converted, value.at));
    }
    error(condition.at, "OPS121",
          "expected a condition, which is true or false, found a value of type " + typeName(value));
}

base::DataSourceBase::shared_ptr UnitCompiler::sourceOf(const Operand& operand) {
    // An evaluated source must not be evaluated again.
    if (operand.source) return operand.source;
    return withType(operand.kind, [&](auto type) -> Source {
        typedef typename decltype(type)::type T;
        const T& value = *static_cast<const T*>(operand.address);
        if (operand.constant) return new internal::ConstantDataSource<T>(value);
        return new internal::ConstReferenceDataSource<T>(value);
    });
}

void UnitCompiler::discard(const Operand& operand) {
    if (operand.source && !operand.address) emit(&instructions::evaluate, nullptr, nullptr, keep(operand.source));
}

Operand UnitCompiler::member(const Operand& of, const ast::Identifier& name) {
    if (of.kind == Kind::None) error(name.at, "OPS122", "found '." + name.text + "' after something that has no value");
    const Source whole = sourceOf(of);
    if (Source part = whole->getMember(name.text)) return fromSource(part, of.at);
    if (base::DataSourceBase* const part = types::operators()->applyDot(name.text, whole.get()))
        return fromSource(part, of.at);
    std::vector<std::string> known = whole->getMemberNames();
    if (const auto* const bag = internal::DataSource<PropertyBag>::narrow(whole.get())) known = bag->rvalue().list();
    if (std::find(known.begin(), known.end(), name.text) != known.end())
        error(name.at, "OPS123",
              "member '" + name.text + "' of type " + typeName(of) + " has itself a type that no loaded typekit knows");
    error(name.at, "OPS123",
          "type " + typeName(of) + " has no member '" + name.text + "'" + memberMeant(name.text, known));
}

Operand UnitCompiler::element(const ast::Index& index, ast::Place at) {
    const Operand of = expression(*index.of);
    Operand which = promoted(expression(*index.index));
    if (isDirect(which.kind)) which = load(which);  // once, however often the element is used
    if (of.kind == Kind::None || which.kind == Kind::None)
        error(at, "OPS122", "found '[...]' with something that has no value");
    const Source whole = sourceOf(of);
    if (Source part = whole->getMember(sourceOf(which))) return fromSource(part, at);
    error(at, "OPS124",
          "a value of type " + typeName(of) + " has no elements that an index of type " + typeName(which) + " selects");
}

Operand UnitCompiler::unary(const ast::Unary& operation, ast::Place at) {
    return negated(operation, expression(*operation.operand), at);
}

Operand UnitCompiler::negated(const ast::Unary& operation, const Operand& operand, ast::Place at) {
    if (isDirect(operand.kind)) {
        const Operation direct = unaryOperation(operation.op, operand.kind);
        if (direct.act) return computedBy(direct.act, load(operand).address, nullptr, direct.result, at);
        if (operation.op == '!' && conversion(operand.kind, Kind::Bool) != Conversion::None)
            return computedBy(unaryOperation('!', Kind::Bool).act, loadAs(operand, Kind::Bool).address, nullptr,
                              Kind::Bool, at);
    }
    if (operand.kind != Kind::None)
        if (auto* const made = types::operators()->applyUnary(std::string(1, operation.op), sourceOf(operand).get()))
            return fromSource(made, at);
    if (isSmallNumber(operand)) return negated(operation, promoted(operand), at);
    error(at, "OPS125", std::string("operator '") + operation.op + "' does not exist for type " + typeName(operand));
}

Operand UnitCompiler::binary(const ast::Binary& row) {
    const unsigned first = executions_;
    Operand left = expression(*row.first);
    unsigned depth = 0;
    for (const ast::Binary::Step& step : row.steps) {
        left = operation(std::move(left), step, first);
        // Nested sources are evaluated and destroyed by recursion.
        depth = isDirect(left.kind) ? 0 : depth + 1;
        if (depth < kDeepestSource) continue;
        left = copied(left, code_.size());
        depth = 0;
    }
    return left;
}

/** `first` is what executions_ was where the row begins. */
Operand UnitCompiler::operation(Operand left, const ast::Binary::Step& step, unsigned first) {
    if (isDirect(left.kind)) left = load(left);
    const std::size_t before = code_.size();
    const unsigned executions = executions_;
    Operand right = expression(*step.right);
    // Calls on the right may change what is read on the left, and calls on the left must precede computations on the
    // right.
    if (executions_ != executions || (executions != first && code_.size() != before)) left = copied(left, before);
    return combined(left, right, step);
}

Operand UnitCompiler::combined(const Operand& left, Operand right, const ast::Binary::Step& step) {
    if (isDirect(right.kind)) right = load(right);
    if (isDirect(left.kind) && isDirect(right.kind)) {
        const Operation direct = binaryOperation(step.op, left.kind);
        if (direct.act && conversion(right.kind, left.kind) != Conversion::None)
            return computedBy(direct.act, left.address, loadAs(right, left.kind).address, direct.result, step.at);
    }
    // Texts and values of enums are compared as texts.
    const bool compares = step.op == "==" || step.op == "!=";
    if (compares && left.constant && !isDirect(left.kind) && right.source && isEnum(right.source->getTypeInfo()))
        watched(left.at, [&] { return right.source->getTypeInfo()->convert(left.source); });
    if (left.kind != Kind::None && right.kind != Kind::None)
        if (const Source made = watched(right.at, [&]() -> Source {
                return types::operators()->applyBinary(step.op, sourceOf(left).get(), sourceOf(right).get());
            }))
            return fromSource(made, step.at);
    if (isSmallNumber(left) || isSmallNumber(right)) {
        const Operand wide = promoted(left);
        return combined(isDirect(wide.kind) ? load(wide) : wide, promoted(right), step);
    }
    error(step.at, "OPS126",
          "operator '" + step.op + "' does not exist for types " + typeName(left) + " and " + typeName(right));
}

/** A copy of the value, taken before the instructions from `at` on, which belong to the present expression. */
Operand UnitCompiler::copied(const Operand& value, std::size_t at) {
    if (value.constant || value.computed || value.kind == Kind::None) return value;
    if (isDirect(value.kind)) {
        const Operand copy =
            computedBy(conversionAction(value.kind, value.kind), value.address, nullptr, value.kind, value.at);
        code_.moveLast(at);
        return copy;
    }
    const Source variable = value.source->getTypeInfo()->buildValue();
    if (!variable) return value;
    Operand copy = fromSource(variable, value.at);
    store(copy, value, "its copy");
    code_.moveLast(at);
    copy.computed = true;
    return copy;
}

/** As copied(), also for values that are evaluated only when they are used. */
Operand UnitCompiler::taken(const Operand& value, std::size_t at) {
    if (!isDirect(value.kind) || value.address) return copied(value, at);
    const Operand loaded = load(value);
    code_.moveLast(at);
    return loaded;
}

Operand UnitCompiler::assignment(const ast::Assignment& assignment, ast::Place at) {
    Operand result;
    if (assignHandle(assignment, at, result)) return result;
    const Operand to = expression(*assignment.to);
    if (!to.assignable())
        error(assignment.to->at, "OPS127",
              to.source ? "this is a constant or a result and cannot be assigned to" : "this cannot be assigned to");
    const auto* const name = std::get_if<ast::Name>(&assignment.to->what);
    store(to, expression(*assignment.value), name ? "'" + joined(name->parts) + "'" : "a variable");
    ++executions_;
    return to;
}

void UnitCompiler::store(const Operand& to, Operand value, const std::string& what) {
    const auto refuse = [&] {
        error(value.at, "OPS128",
              "expected a value of type " + typeName(to) + " for " + what + ", found " + typeName(value));
    };
    if (value.kind == Kind::None) refuse();
    const Kind wide = to.source ? widened(to.source->getTypeId()) : Kind::Other;
    const bool sameType = to.source && value.source && to.source->hasTypeOf(*value.source);
    if ((isDirect(to.kind) || isDirect(wide)) && !sameType) value = promoted(value);
    if (isDirect(wide) && isDirect(value.kind) && conversion(value.kind, wide) != Conversion::None)
        value = loadAs(value, wide);
    if (isDirect(to.kind) && isDirect(value.kind) && conversion(value.kind, to.kind) != Conversion::None) {
        value = loadAs(value, to.kind);
        if (!to.address) {
            withType(to.kind, [&](auto type) {
                typedef typename decltype(type)::type T;
                auto* const target = internal::AssignableDataSource<T>::narrow(keep(to.source));
                if (!target) refuse();
                emit(&instructions::store<T>, value.address, nullptr, target);
            });
        } else if (value.computed && code_.at(code_.size() - 1).to == value.address) {
            code_.at(code_.size() - 1).to = const_cast<void*>(to.address);
        } else {
            emit(conversionAction(to.kind, to.kind), value.address, nullptr, const_cast<void*>(to.address));
        }
        return;
    }
    try {
        auto action = watched(value.at, [&] {
            return std::shared_ptr<base::ActionInterface>(to.source->updateAction(sourceOf(value).get()));
        });
        if (!action) refuse();
        emit(&instructions::perform, nullptr, nullptr, action.get());
        code_.keep(std::move(action));
    } catch (const internal::bad_assignment&) {
        refuse();
    }
}

const types::TypeInfo& UnitCompiler::type(const ast::Identifier& name) {
    const types::TypeInfo* const found = types::Types()->type(name.text);
    if (!found)
        error(name.at, "OPS110",
              "type '" + name.text + "' is unknown" +
                  oroforge::diag::didYouMean(name.text, types::Types()->getDottedTypes()));
    return *found;
}

void UnitCompiler::warn(ast::Place at, const char* code, const std::string& message, const std::string& hint) const {
    if (aliases_ != 0 || state_.quiet != 0) return;
    auto& warning = where_.sink->warning(locate(at), code, message);
    if (!hint.empty()) warning.hint(hint);
}

void UnitCompiler::warnOfConversion(ast::Place at, const std::string& from, const std::string& to) {
    const bool textOfSize = from == "int" && (to == "string" || to == "rt_string");
    const bool fraction = (from == "double" || from == "float") && to == "int";
    warn(at, "OPS120",
         "a value of type " + from + " is converted to " + to +
             (textOfSize ? " and becomes a text of that many letters"
              : fraction ? " and loses its fraction"
                         : ""));
}

void UnitCompiler::error(ast::Place at, const char* code, const std::string& message, const std::string& hint) {
    auto& error = where_.sink->error(locate(at), code, message);
    if (!hint.empty()) error.hint(hint);
    if (alias_)
        error.note({where_.file, used_alias_->at.line, used_alias_->at.column},
                   "alias '" + used_alias_->text + "' is used here");
    throw Unresolved();
}

std::size_t UnitCompiler::emit(Action act, const void* a, const void* b, void* to) {
    Instruction instruction;
    instruction.act = act;
    instruction.a = a;
    instruction.b = b;
    instruction.to = to;
    return code_.add(instruction);
}

base::DataSourceBase* UnitCompiler::keep(Source source) {
    base::DataSourceBase* const plain = source.get();
    code_.keep(std::move(source));
    return plain;
}

}  // namespace RTT::scripting::detail

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <rtt/scripting/detail/compile/unit_compiler.hpp>

#include <rtt/internal/DataSources.hpp>
#include <rtt/scripting/detail/compile/arithmetic.hpp>
#include <rtt/scripting/detail/execute/instructions.hpp>
#include <rtt/types/Types.hpp>

namespace RTT::scripting::detail {

Operand ValueCompiler::computedBy(Action act, const void* a, const void* b, Kind kind, ast::Place at) {
    Operand result;
    result.kind = kind;
    result.at = at;
    result.computed = true;
    Cell* const cell = code_.newCell();
    code_.add(act, a, b, cell);
    result.address = cell;
    return result;
}

Operand ValueCompiler::fromSource(Source source, ast::Place at) {
    Operand result;
    result.kind = kindOf(*source);
    if (isDirect(result.kind)) result.address = fixedAddress(*source, result.kind);
    if (result.address) code_.keepSource(source);
    result.source = std::move(source);
    result.at = at;
    return result;
}

Operand ValueCompiler::load(Operand operand) {
    if (operand.address) return operand;
    const base::DataSourceBase* const source = code_.keepSource(operand.source);
    return withType(operand.kind, [&](auto type) {
        return computedBy(&instructions::load<typename decltype(type)::type>, source, nullptr, operand.kind,
                          operand.at);
    });
}

Operand ValueCompiler::loadAs(Operand operand, Kind kind, bool warns) {
    operand = load(operand);
    if (operand.kind == kind) return operand;
    if (warns && conversion(operand.kind, kind) == Conversion::Warned)
        reporter_.warnOfConversion(operand.at, typeName(operand), "int");
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

Operand ValueCompiler::promoted(Operand operand) {
    if (!isSmallNumber(operand)) return operand;
    return withType(widened(operand.source->getTypeId()), [&](auto type) {
        const Source wide = types::Types()->getTypeInfo<typename decltype(type)::type>()->convert(operand.source);
        return fromSource(wide, operand.at);
    });
}

base::DataSourceBase::shared_ptr ValueCompiler::sourceOf(const Operand& operand) {
    // An evaluated source must not be evaluated again.
    if (operand.source) return operand.source;
    return withType(operand.kind, [&](auto type) -> Source {
        typedef typename decltype(type)::type T;
        const T& value = *static_cast<const T*>(operand.address);
        if (operand.constant) return new internal::ConstantDataSource<T>(value);
        return new internal::ConstReferenceDataSource<T>(value);
    });
}

void ValueCompiler::discard(const Operand& operand) {
    if (operand.source && !operand.address)
        code_.add(&instructions::evaluate, nullptr, nullptr, code_.keepSource(operand.source));
}

Operand ValueCompiler::copied(const Operand& value, std::size_t at) {
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

Operand ValueCompiler::taken(const Operand& value, std::size_t at) {
    if (!isDirect(value.kind) || value.address) return copied(value, at);
    const Operand loaded = load(value);
    code_.moveLast(at);
    return loaded;
}

bool ValueCompiler::storeDirect(const Operand& to, const Operand& value) {
    if (!to.address)
        return withType(to.kind, [&](auto type) {
            typedef typename decltype(type)::type T;
            auto* const target = internal::AssignableDataSource<T>::narrow(code_.keepSource(to.source));
            if (target) code_.add(&instructions::store<T>, value.address, nullptr, target);
            return target != nullptr;
        });
    void* const address = const_cast<void*>(to.address);
    if (value.computed && code_.at(code_.size() - 1).to == value.address)
        code_.at(code_.size() - 1).to = address;
    else
        code_.add(conversionAction(to.kind, to.kind), value.address, nullptr, address);
    return true;
}

void ValueCompiler::store(const Operand& to, Operand value, const std::string& what) {
    const auto refuse = [&] {
        reporter_.error(value.at, "OPS128",
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
        if (!storeDirect(to, value)) refuse();
        return;
    }
    try {
        auto action = reporter_.watched(value.at, [&] {
            return std::shared_ptr<base::ActionInterface>(to.source->updateAction(sourceOf(value).get()));
        });
        if (!action) refuse();
        code_.add(&instructions::perform, nullptr, nullptr, action.get());
        code_.keep(std::move(action));
    } catch (const internal::bad_assignment&) {
        refuse();
    }
}

}  // namespace RTT::scripting::detail

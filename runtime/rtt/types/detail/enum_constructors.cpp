// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "enum_constructors.hpp"

#include <rtt/internal/DataSources.hpp>
#include <rtt/types/Operators.hpp>
#include <rtt/types/TemplateConstructor.hpp>
#include <rtt/types/refusal_watch.hpp>
#include "type_info_state.hpp"
#include <diag/nearest_match.hpp>
#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

namespace RTT::types::detail {

namespace {
using SourcePtr = base::DataSourceBase::shared_ptr;

/** What a conversion needs to know. */
struct NamedEnum {
    EnumNames names;
    std::string type;
};

/** Returns false and leaves the reason with the RefusalWatch. */
bool refuse(const NamedEnum& known, const std::string& found, bool isName) {
    auto* const watch = RefusalWatch::current();
    if (!watch) return false;
    std::vector<std::string> names;
    for (std::size_t i = 0; i != known.names.count; ++i) names.emplace_back(known.names.values[i].name);
    watch->note("'" + found + "' is no value of type " + known.type + "; expected " +
                (names.empty() ? "a number" : oroforge::diag::oneOf(names)) +
                (isName ? oroforge::diag::didYouMean(found, names) : std::string()));
    return false;
}

bool enumFromInt(const void* context, const void* const* arguments, void* result) {
    const auto& known = *static_cast<const NamedEnum*>(context);
    const int number = *static_cast<const int*>(arguments[0]);
    if (!known.names.takes(number)) return refuse(known, std::to_string(number), false);
    known.names.ops.set(result, number);
    return true;
}

bool intFromEnum(const void* names, const void* const* arguments, void* result) {
    *static_cast<int*>(result) = static_cast<int>(static_cast<const EnumNames*>(names)->ops.get(arguments[0]));
    return true;
}

bool enumFromText(const void* context, const void* const* arguments, void* result) {
    const auto& known = *static_cast<const NamedEnum*>(context);
    const std::string& text = *static_cast<const std::string*>(arguments[0]);
    if (!known.names.set(text, result)) return refuse(known, text, true);
    return known.names.takes(known.names.ops.get(result)) || refuse(known, text, false);
}

bool textFromEnum(const void* names, const void* const* arguments, void* result) {
    *static_cast<std::string*>(result) = static_cast<const EnumNames*>(names)->textOf(arguments[0]);
    return true;
}

bool areSame(const void* names, const void* const* arguments, void* result) {
    const EnumOps& ops = static_cast<const EnumNames*>(names)->ops;
    *static_cast<bool*>(result) = ops.get(arguments[0]) == ops.get(arguments[1]);
    return true;
}

bool areOthers(const void* names, const void* const* arguments, void* result) {
    areSame(names, arguments, result);
    *static_cast<bool*>(result) = !*static_cast<bool*>(result);
    return true;
}

bool isNumber(const void* names, const void* const* arguments, void* result) {
    const EnumOps& ops = static_cast<const EnumNames*>(names)->ops;
    *static_cast<bool*>(result) = ops.get(arguments[0]) == *static_cast<const int*>(arguments[1]);
    return true;
}

bool isOtherNumber(const void* names, const void* const* arguments, void* result) {
    isNumber(names, arguments, result);
    *static_cast<bool*>(result) = !*static_cast<bool*>(result);
    return true;
}

template <class Context>
ErasedFunction function(ComputeFunction call, const Context& context, TypeRef result, std::vector<TypeRef> arguments) {
    ErasedFunction made;
    made.call = call;
    made.context = std::make_shared<Context>(context);
    made.result = result;
    made.arity = arguments.size();
    std::copy(arguments.begin(), arguments.end(), made.arguments.begin());
    return made;
}

/// Checks constants at once: whether the enum has such a value.
class EnumConstructor : public TypeConstructor {
public:
    explicit EnumConstructor(const ErasedFunction& function) : erased_(newErasedConstructor(function, true)) {}

    SourcePtr build(const std::vector<SourcePtr>& arguments) const override {
        return tried(erased_->build(arguments), arguments);
    }
    SourcePtr convert(SourcePtr argument) const override { return tried(erased_->convert(argument), {argument}); }

private:
    static SourcePtr tried(SourcePtr made, const std::vector<SourcePtr>& arguments) {
        const auto isConstant = [](const SourcePtr& argument) {
            return dynamic_cast<const internal::ConstantDataSource<int>*>(argument.get()) ||
                   dynamic_cast<const internal::ConstantDataSource<std::string>*>(argument.get());
        };
        if (made && RefusalWatch::current() && std::all_of(arguments.begin(), arguments.end(), isConstant))
            made->evaluate();
        return made;
    }

    const std::unique_ptr<TypeConstructor> erased_;
};

/// A constructor that is tried after all others with the same arguments, even if they are added later.
class LastConstructor : public EnumConstructor, public AskedLast {
public:
    using EnumConstructor::EnumConstructor;
};
}  // namespace

bool EnumNames::set(const std::string& text, void* value) const {
    for (std::size_t i = 0; i != count; ++i) {
        if (text != values[i].name) continue;
        ops.set(value, values[i].value);
        return true;
    }
    char* end = nullptr;
    const long long number = ops.isUnsigned ? static_cast<long long>(std::strtoull(text.c_str(), &end, 10))
                                            : std::strtoll(text.c_str(), &end, 10);
    if (end == text.c_str() || *end != '\0') return false;
    ops.set(value, number);
    return true;
}

bool EnumNames::takes(long long number) const {
    if (count == 0) return true;  // the enum is a number with its own type
    unsigned long long all = 0;
    bool areFlags = true;
    for (std::size_t i = 0; i != count; ++i) {
        if (values[i].value == number) return true;
        const auto bits = static_cast<unsigned long long>(values[i].value);
        areFlags = areFlags && (bits & (bits - 1)) == 0;
        all |= bits;
    }
    // 0, 1 and 2 may be numbers of any kind.
    return areFlags && all > 3 && (static_cast<unsigned long long>(number) & ~all) == 0;
}

const char* EnumNames::nameOf(const void* value) const {
    const long long number = ops.get(value);
    for (std::size_t i = 0; i != count; ++i)
        if (values[i].value == number) return values[i].name;
    return nullptr;
}

std::string EnumNames::textOf(const void* value) const {
    if (const char* name = nameOf(value)) return name;
    const long long number = ops.get(value);
    return ops.isUnsigned ? std::to_string(static_cast<unsigned long long>(number)) : std::to_string(number);
}

bool readNumber(const std::string& text, int& number) {
    const char* const end = text.data() + text.size();
    const auto read = std::from_chars(text.data(), end, number);
    return read.ec == std::errc() && read.ptr == end;
}

void addEnumConstructors(TypeInfo& info, TypeRef enumType, const EnumNames& names) {
    const NamedEnum known{names, info.getTypeName()};
    info.addConstructor(new EnumConstructor(function(&enumFromInt, known, enumType, {&typeRef<int>})));
    info.addConstructor(new LastConstructor(function(&enumFromText, known, enumType, {&typeRef<std::string>})));
    if (TypeInfo* number = Types()->getTypeInfo<int>())
        number->addConstructor(newErasedConstructor(function(&intFromEnum, names, &typeRef<int>, {enumType}), true));
    if (TypeInfo* text = Types()->getTypeInfo<std::string>())
        text->addConstructor(new LastConstructor(function(&textFromEnum, names, &typeRef<std::string>, {enumType})));
    operators()->add(new BinaryOp{"==", function(&areSame, names, &typeRef<bool>, {enumType, enumType})});
    operators()->add(new BinaryOp{"!=", function(&areOthers, names, &typeRef<bool>, {enumType, enumType})});
    // Compares with any number, even if it is not a value of the enum.
    operators()->add(new BinaryOp{"==", function(&isNumber, names, &typeRef<bool>, {enumType, &typeRef<int>})});
    operators()->add(new BinaryOp{"!=", function(&isOtherNumber, names, &typeRef<bool>, {enumType, &typeRef<int>})});
}

}  // namespace RTT::types::detail

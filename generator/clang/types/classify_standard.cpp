// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <map>
#include <set>

#include <clang/base/type_names.hpp>

#include "classify.hpp"

namespace oroforge::cxx {

namespace {

using model::TypeKind;

const std::map<std::string, Reason>& rejectedTypes() {
    static const std::map<std::string, Reason> all = {
        {"array", Reason::UnboundedArray},
        {"basic_string_view", Reason::View},
        {"span", Reason::View},
        {"reference_wrapper", Reason::Reference},
        {"unique_ptr", Reason::SmartPointer},
        {"shared_ptr", Reason::SmartPointer},
        {"weak_ptr", Reason::SmartPointer},
        {"auto_ptr", Reason::SmartPointer},
        {"function", Reason::Callable},
        {"mutex", Reason::Synchronisation},
        {"recursive_mutex", Reason::Synchronisation},
        {"timed_mutex", Reason::Synchronisation},
        {"shared_mutex", Reason::Synchronisation},
        {"condition_variable", Reason::Synchronisation},
        {"condition_variable_any", Reason::Synchronisation},
        {"atomic", Reason::Synchronisation},
        {"atomic_flag", Reason::Synchronisation},
        {"thread", Reason::Synchronisation},
        {"future", Reason::Synchronisation},
        {"promise", Reason::Synchronisation},
        {"queue", Reason::OtherSequence},
        {"stack", Reason::OtherSequence},
        {"priority_queue", Reason::OtherSequence},
        {"any", Reason::AnyType},
    };
    return all;
}

/// A class template of the standard library that typekits support: its kind, and how many of its arguments are values.
/// Later arguments (allocators, comparisons) only make the name longer, unless they are the defaults.
struct Container {
    TypeKind kind;
    unsigned values;
};

const std::map<std::string, Container>& containers() {
    static const std::map<std::string, Container> all = {
        {"vector", {TypeKind::Sequence, 1}},
        {"deque", {TypeKind::Sequence, 1}},
        {"valarray", {TypeKind::Sequence, 1}},
        {"list", {TypeKind::Linked, 1}},
        {"forward_list", {TypeKind::Linked, 1}},
        {"set", {TypeKind::Set, 1}},
        {"multiset", {TypeKind::Set, 1}},
        {"unordered_set", {TypeKind::Set, 1}},
        {"unordered_multiset", {TypeKind::Set, 1}},
        {"map", {TypeKind::Map, 2}},
        {"multimap", {TypeKind::Map, 2}},
        {"unordered_map", {TypeKind::Map, 2}},
        {"unordered_multimap", {TypeKind::Map, 2}},
        {"optional", {TypeKind::Optional, 1}},
        {"pair", {TypeKind::Pair, 2}},
        {"complex", {TypeKind::Complex, 1}},
    };
    return all;
}

bool isBuiltin(const clang::TemplateArgument& argument, clang::BuiltinType::Kind kind) {
    return argument.getKind() == clang::TemplateArgument::Type && argument.getAsType()->isSpecificBuiltinType(kind);
}

/// True for an argument that the standard library has by default.
bool isUsual(const clang::TemplateArgument& argument) {
    static const std::set<std::string> usual = {"allocator", "char_traits", "less", "hash", "equal_to"};
    if (argument.getKind() != clang::TemplateArgument::Type) return false;
    const clang::CXXRecordDecl* record = argument.getAsType()->getAsCXXRecordDecl();
    if (record == nullptr || !record->isInStdNamespace() || usual.count(record->getNameAsString()) == 0) return false;
    // std::less<> compares any types, and makes the container another type.
    const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(record);
    return instance == nullptr || !instance->getTemplateArgs()[0].getAsType()->isVoidType();
}

Classified classifyString(clang::QualType type, const clang::TemplateArgumentList& arguments) {
    const bool ofChar =
        isBuiltin(arguments[0], clang::BuiltinType::Char_S) || isBuiltin(arguments[0], clang::BuiltinType::Char_U);
    if (!ofChar || !isUsual(arguments[1])) return reject(Reason::OtherString, type);
    if (!isUsual(arguments[2])) return reject(Reason::CustomAllocator, type);
    Classified result;
    result.use = model::TypeUse{TypeKind::String, "std::string", "/std/string", {}, ""};
    return result;
}

/// Classifies the parts of a type one after the other, and keeps the first fault.
class Parts {
public:
    explicit Parts(const clang::ASTContext& context) : context_(context) {}

    bool add(const clang::TemplateArgument& argument) {
        Classified part = classifyValue(argument.getAsType(), context_);
        if (!part.use) {
            fault_ = std::move(part);
            return false;
        }
        uses_.push_back(*part.use);
        users_.insert(users_.end(), part.users.begin(), part.users.end());
        return true;
    }
    Classified fault() const { return fault_; }
    Classified make(TypeKind kind, const std::string& cpp, const std::string& name) const {
        Classified result;
        result.use = model::TypeUse{kind, cpp, name, uses_, ""};
        result.users = users_;
        return result;
    }
    const std::vector<model::TypeUse>& uses() const { return uses_; }

private:
    const clang::ASTContext& context_;
    std::vector<model::TypeUse> uses_;
    std::vector<const clang::TagDecl*> users_;
    Classified fault_;
};

/// Returns "std::map<K, V>" and "/std/map<K,V>" from the parts, and other unusual arguments after them.
TypeName nameOfInstance(const std::string& name, const std::vector<model::TypeUse>& parts,
                        const std::vector<TypeName>& more) {
    TypeName result{"std::" + name + "<", "/std/" + name + "<"};
    const auto add = [&result](const std::string& cpp, const std::string& registry) {
        const bool first = result.cpp.back() == '<';
        result.cpp += (first ? "" : ", ") + cpp;
        result.registry += (first ? "" : ",") + registry;
    };
    for (const model::TypeUse& part : parts) add(part.cpp, part.name);
    for (const TypeName& argument : more) add(argument.cpp, argument.registry);
    result.cpp += ">";
    result.registry += ">";
    return result;
}

/// Returns the arguments from `first` on if one of them is unusual; nothing if one of them cannot be named.
std::optional<std::vector<TypeName>> unusual(const clang::TemplateArgumentList& arguments, unsigned first) {
    const auto rest = arguments.asArray().drop_front(first);
    std::vector<TypeName> names;
    if (llvm::all_of(rest, isUsual)) return names;
    for (const clang::TemplateArgument& argument : rest) {
        const bool isType = argument.getKind() == clang::TemplateArgument::Type;
        const auto* tag = isType ? argument.getAsType()->getAsTagDecl() : nullptr;
        const auto name = tag != nullptr ? nameOf(*tag) : std::nullopt;
        if (!name) return std::nullopt;
        names.push_back(*name);
    }
    return names;
}

Classified classifyContainer(clang::QualType type, const clang::ClassTemplateSpecializationDecl& instance,
                             const Container& container, const clang::ASTContext& context) {
    const clang::TemplateArgumentList& arguments = instance.getTemplateArgs();
    Parts parts(context);
    for (unsigned i = 0; i != container.values; ++i)
        if (!parts.add(arguments[i])) return parts.fault();
    const std::string name = instance.getNameAsString();
    const bool hashed = name.rfind("unordered_", 0) == 0;
    const TypeKind key = parts.uses().front().kind;
    if (hashed && key != TypeKind::Scalar && key != TypeKind::String && key != TypeKind::Enum)
        return reject(Reason::HashedKey, type);
    const auto more = unusual(arguments, container.values);
    if (!more) return reject(Reason::CustomAllocator, type);
    const TypeName names = nameOfInstance(name, parts.uses(), *more);
    return parts.make(container.kind, names.cpp, names.registry);
}

Classified classifyTuple(const clang::TemplateArgumentList& arguments, const clang::ASTContext& context) {
    Parts parts(context);
    for (const clang::TemplateArgument& argument : arguments[0].getPackAsArray())
        if (!parts.add(argument)) return parts.fault();
    const TypeName name = nameOfInstance("tuple", parts.uses(), {});
    return parts.make(TypeKind::Tuple, name.cpp, name.registry);
}

Classified classifyVariant(clang::QualType type, const clang::TemplateArgumentList& arguments,
                           const clang::ASTContext& context) {
    Parts parts(context);
    std::set<std::string> seen;
    for (const clang::TemplateArgument& argument : arguments[0].getPackAsArray()) {
        if (!parts.add(argument)) return parts.fault();
        if (!seen.insert(parts.uses().back().cpp).second) return reject(Reason::SameAlternative, type);
    }
    const TypeName name = nameOfInstance("variant", parts.uses(), {});
    return parts.make(TypeKind::Variant, name.cpp, name.registry);
}

std::string unitOf(const std::string& period) {
    static const std::map<std::string, std::string> units = {
        {"1/1000000000", "ns"}, {"1/1000000", "us"}, {"1/1000", "ms"},   {"1/1", "s"},
        {"60/1", "min"},        {"3600/1", "h"},     {"86400/1", "day"},
    };
    const auto known = units.find(period);
    return known != units.end() ? known->second : period + " s";
}

/// std::chrono::duration<Rep, std::ratio<N, D>>
Classified classifyDuration(clang::QualType type, const clang::TemplateArgumentList& arguments,
                            const clang::ASTContext& context) {
    const auto* ratio =
        llvm::dyn_cast_or_null<clang::ClassTemplateSpecializationDecl>(arguments[1].getAsType()->getAsCXXRecordDecl());
    Parts parts(context);
    if (ratio == nullptr || !parts.add(arguments[0])) return reject(Reason::OtherStandard, type);
    if (parts.uses().front().kind != TypeKind::Scalar) return reject(Reason::OtherStandard, type);
    const std::string over = llvm::toString(ratio->getTemplateArgs()[0].getAsIntegral(), 10);
    const std::string under = llvm::toString(ratio->getTemplateArgs()[1].getAsIntegral(), 10);
    const std::string& cpp = parts.uses().front().cpp;
    Classified result =
        parts.make(TypeKind::Count, "std::chrono::duration<" + cpp + ", std::ratio<" + over + ", " + under + ">>",
                   "/std/chrono/duration<" + parts.uses().front().name + "," + over + "," + under + ">");
    result.use->unit = unitOf(over + "/" + under);
    return result;
}

/// std::chrono::time_point<Clock, Duration>
Classified classifyTimePoint(clang::QualType type, const clang::TemplateArgumentList& arguments,
                             const clang::ASTContext& context) {
    const clang::CXXRecordDecl* clock = arguments[0].getAsType()->getAsCXXRecordDecl();
    const auto clockName = clock != nullptr ? nameOf(*clock) : std::nullopt;
    Classified duration = classifyValue(arguments[1].getAsType(), context);
    if (!clockName || !duration.use || duration.use->kind != TypeKind::Count)
        return reject(Reason::OtherStandard, type);
    model::TypeUse& use = *duration.use;
    use.cpp = "std::chrono::time_point<" + clockName->cpp + ", " + use.cpp + ">";
    use.name = "/std/chrono/time_point<" + clockName->registry + "," + use.name + ">";
    use.unit += " since the epoch of " + clock->getNameAsString();
    return duration;
}

Classified classifyBits(const clang::TemplateArgumentList& arguments) {
    const std::string bits = llvm::toString(arguments[0].getAsIntegral(), 10);
    Classified result;
    result.use = model::TypeUse{TypeKind::Bits, "std::bitset<" + bits + ">", "/std/bitset<" + bits + ">", {}, ""};
    return result;
}

}  // namespace

Classified classifyStandard(clang::QualType type, const clang::CXXRecordDecl& record,
                            const clang::ASTContext& context) {
    const std::string name = record.getNameAsString();
    if (const auto* instance = llvm::dyn_cast<clang::ClassTemplateSpecializationDecl>(&record)) {
        const clang::TemplateArgumentList& arguments = instance->getTemplateArgs();
        if (isStandard(record, "basic_string")) return classifyString(type, arguments);
        if (isStandard(record, "tuple")) return classifyTuple(arguments, context);
        if (isStandard(record, "variant")) return classifyVariant(type, arguments, context);
        if (isStandard(record, "bitset")) return classifyBits(arguments);
        if (name == "duration") return classifyDuration(type, arguments, context);
        if (name == "time_point") return classifyTimePoint(type, arguments, context);
        const auto known = containers().find(name);
        if (known != containers().end() && record.isInStdNamespace())
            return classifyContainer(type, *instance, known->second, context);
    }
    if (isStandard(record, "monostate")) {
        Classified nothing;
        nothing.use = model::TypeUse{TypeKind::Nothing, "std::monostate", "/std/monostate", {}, ""};
        return nothing;
    }
    const auto known = rejectedTypes().find(name);
    return reject(known == rejectedTypes().end() ? Reason::OtherStandard : known->second, type);
}

}  // namespace oroforge::cxx

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include <driver/manifest_types.hpp>

#include <algorithm>
#include <cctype>
#include <set>

#include <clang/types/manifest_types.hpp>
#include <clang/base/toolchain_flags.hpp>
#include <diag/nearest_match.hpp>
#include <emit/outputs.hpp>
#include <model/cpp_type.hpp>
#include <model/interfaces.hpp>
#include <model/names.hpp>
#include <view/cpp_text.hpp>

namespace fs = std::filesystem;

namespace oroforge::driver {

namespace {

const std::vector<std::string> kBuiltin = {"bool",    "char",     "double",  "float",    "int",     "long",
                                           "short",   "unsigned", "int8_t",  "uint8_t",  "int16_t", "uint16_t",
                                           "int32_t", "uint32_t", "int64_t", "uint64_t", "size_t"};
const std::vector<std::string> kStandard = {"string", "vector", "array", "map",      "pair",
                                            "set",    "list",   "deque", "optional", "complex"};
constexpr std::size_t kMostEnumerators = 8;

/// A type in the manifest, with its place.
struct Use {
    std::string what;  ///< "port"
    const model::Text* type;
    const model::Text* value;  ///< its default, or null
    std::string space;
};

class Collector {
public:
    std::vector<Use> uses;

    void add(const model::Component& component) {
        space_ = model::namespaceOf(component.className.value);
        model::eachInterface(component, [this](const model::Interface& one, const model::ServicePath&) { add(one); });
        for (const model::Requirement& service : component.required)
            for (const model::Operation& operation : service.operations) add(operation);
    }
    void add(const model::ServicePlugin& service) {
        space_ = model::namespaceOf(service.className.value);
        model::eachInterface(service, [this](const model::Interface& one, const model::ServicePath&) { add(one); });
    }

private:
    void add(const std::string& what, const model::Text& type, const model::Text* value = nullptr) {
        if (!type.given()) return;
        // Types such as const double& need no lookup either.
        std::string bare = model::normalised(type.value);
        if (bare.compare(0, 6, "const ") == 0) bare.erase(0, 6);
        if (!bare.empty() && bare.back() == '&') bare.pop_back();
        if (bare == "void" || model::classify(bare) != model::TypeClass::Other) return;
        uses.push_back({what, &type, value != nullptr && value->given() ? value : nullptr, space_});
    }
    void add(const model::Operation& operation) {
        add("return", operation.returns);
        for (const model::Argument& argument : operation.arguments) add("argument", argument.type);
    }
    void add(const model::Interface& one) {
        for (const model::Port& port : one.ports) add("port", port.type);
        for (const model::Property& property : one.properties) add("property", property.type, &property.defaultValue);
        for (const model::Attribute& attribute : one.attributes)
            add("attribute", attribute.type, &attribute.defaultValue);
        for (const model::Operation& operation : one.operations) add(operation);
    }

    std::string space_;
};

/// "std::vector<tank::Level>" → "std::vector", "tank::Level"
std::vector<std::string> namesIn(const std::string& type) {
    std::vector<std::string> names(1);
    for (const char c : type) {
        const bool isLetter = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == ':';
        if (isLetter)
            names.back() += c;
        else if (!names.back().empty())
            names.emplace_back();
    }
    for (std::string& name : names)
        if (name.compare(0, 2, "::") == 0) name.erase(0, 2);
    names.erase(std::remove_if(names.begin(), names.end(),
                               [](const std::string& name) {
                                   return name.empty() || std::isdigit(static_cast<unsigned char>(name[0])) != 0 ||
                                          model::isKeyword(name);
                               }),
                names.end());
    return names;
}

std::string outermost(const std::string& name) {
    const std::size_t end = name.find("::");
    return end == std::string::npos ? "" : name.substr(0, end);
}

class TypeCheck {
public:
    /// `isWhole`: the headers are complete, so a name that is not in them does not exist.
    TypeCheck(const cxx::TypeLookup& found, bool isWhole, diag::Sink& sink)
        : found_(found), isWhole_(isWhole), names_(found.names.begin(), found.names.end()), sink_(sink) {}

    void check(const Use& use, const cxx::TypeAnswer& answer) {
        if (!answer.fault.empty()) return checkNames(use, answer.fault);
        if (!isWhole_) return;
        if (!answer.noValue.empty()) {
            sink_
                .error(use.type->where, "OM025",
                       use.what + " type '" + use.type->value + "' is no value: the class " + answer.noValue)
                .hint(
                    "move the data into a plain struct; or, if the class is one of values, give its fields accessors");
        } else if (use.value != nullptr && !answer.enumerators.empty() && !answer.valueFault.empty()) {
            checkDefault(use, answer.enumerators);
        }
    }

private:
    void checkNames(const Use& use, const std::string& fault) {
        bool hasOthers = false;  // names that the runtime's headers may define
        for (const std::string& name : namesIn(use.type->value)) {
            const std::string space = outermost(name);
            if (space == "RTT" || space == "boost") return;
            if (space == "std") {
                hasOthers = true;
                const bool isKnown = std::find(kStandard.begin(), kStandard.end(), name.substr(5)) != kStandard.end();
                const auto nearest = diag::nearestMatch(name.substr(5), kStandard);
                const bool exists = fault.find("'" + name.substr(5) + "'") == std::string::npos;
                if (!isKnown && !exists && nearest) return report(use, name, "std::" + *nearest);
            } else if (!isKnown(name, use.space)) {
                const std::string nearest = nearestTo(name, use.space);
                if (isWhole_ || (space.empty() && isBuiltin(nearest))) report(use, name, nearest);
                return;
            }
        }
        if (hasOthers || !isWhole_) return;
        sink_.error(use.type->where, "OM024",
                    use.what + " type '" + use.type->value + "' is none to the compiler: " + fault);
    }

    void report(const Use& use, const std::string& name, const std::string& nearest) {
        const std::string where = found_.headers.empty() ? "is not known" : "is in none of the typekit's headers";
        const std::string meant = nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
        sink_.error(use.type->where, "OM024",
                    use.what + " type '" + use.type->value + "': '" + name + "' " + where + meant);
    }

    static bool isBuiltin(const std::string& name) {
        return std::find(kBuiltin.begin(), kBuiltin.end(), name) != kBuiltin.end() || outermost(name) == "std";
    }

    /// Looks for a name as C++ does, from the namespace outwards.
    bool isKnown(const std::string& name, std::string space) const {
        if (std::find(kBuiltin.begin(), kBuiltin.end(), name) != kBuiltin.end()) return true;
        for (;; space = model::namespaceOf(space)) {
            if (names_.count(space.empty() ? name : space + "::" + name) != 0) return true;
            if (space.empty()) return false;
        }
    }

    std::string nearestTo(const std::string& name, const std::string& space) const {
        if (!outermost(name).empty()) {
            const auto nearest = diag::nearestMatch(name, found_.names);
            if (nearest) return *nearest;
        }
        const std::string last = model::lastName(name);
        std::vector<std::string> spelled, meant;
        const auto offer = [&](const std::string& word, const std::string& full) {
            spelled.push_back(word);
            meant.push_back(full);
        };
        if (last == name) {
            for (const std::string& builtin : kBuiltin) offer(builtin, builtin);
            for (const std::string& standard : kStandard) offer(standard, "std::" + standard);
        }
        // Names of the same namespace come first.
        for (const bool own : {true, false})
            for (const std::string& known : found_.names)
                if ((model::namespaceOf(known) == space) == own) offer(model::lastName(known), known);
        const auto nearest = diag::nearestMatch(last, spelled);
        if (!nearest) return "";
        return meant[static_cast<std::size_t>(std::find(spelled.begin(), spelled.end(), *nearest) - spelled.begin())];
    }

    void checkDefault(const Use& use, const std::vector<std::string>& enumerators) {
        std::vector<std::string> shown(
            enumerators.begin(),
            enumerators.begin() + static_cast<std::ptrdiff_t>(std::min(enumerators.size(), kMostEnumerators)));
        std::vector<std::string> spelled;
        for (const std::string& one : enumerators) spelled.push_back(model::lastName(one));
        const auto nearest = diag::nearestMatch(model::lastName(use.value->value), spelled);
        std::string meant;
        if (nearest) {
            const auto at = std::find(spelled.begin(), spelled.end(), *nearest) - spelled.begin();
            meant = "; did you mean '" + enumerators[static_cast<std::size_t>(at)] + "'?";
        }
        const std::string more = enumerators.size() > kMostEnumerators ? " …" : "";
        sink_.error(use.value->where, "OM036",
                    "default '" + use.value->value + "' is no enumerator of '" + use.type->value + "', expected " +
                        diag::oneOf(shown) + more + meant);
    }

    const cxx::TypeLookup& found_;
    bool isWhole_;
    std::set<std::string> names_;
    diag::Sink& sink_;
};

/// Only the build knows which classes adapters describe.
bool hasAdapters(const fs::path& folder) {
    return emit::textOf(folder / "CMakeLists.txt").find("ADAPTERS") != std::string::npos;
}

}  // namespace

std::vector<std::string> checkTypes(const model::Package& package, const fs::path& folder,
                                    const std::vector<std::string>& flags, diag::Sink& sink) {
    Collector collector;
    for (const model::Component& component : package.components) collector.add(component);
    for (const model::ServicePlugin& service : package.services) collector.add(service);
    if (collector.uses.empty()) return {};
    const fs::path root = fs::absolute(folder.empty() ? fs::path(".") : folder).lexically_normal();
    cxx::TypeLookupRequest request;
    bool isWhole = !package.typekitHeaders.empty();
    for (const model::Text& header : package.typekitHeaders) {
        const fs::path path = root / header.value;
        if (emit::isFile(path)) request.headers.push_back(path.string());
        isWhole = isWhole && emit::isFile(path);
    }
    std::vector<std::string> types;
    for (const Use& use : collector.uses) {
        types.push_back(use.type->value);
        request.questions.push_back(
            {use.space, model::normalised(use.type->value), use.value == nullptr ? std::string() : use.value->value});
    }
    request.standardHeaders = view::standardHeaders(types);
    for (const char* always : {"cstddef", "cstdint", "string"}) request.standardHeaders.emplace_back(always);
    for (const char* place : {"include", "src", ""}) request.flags.push_back("-I" + (root / place).string());
    request.flags.insert(request.flags.end(), flags.begin(), flags.end());
    const std::vector<std::string> toolchain = cxx::toolchainFlags();
    request.flags.insert(request.flags.end(), toolchain.begin(), toolchain.end());
    cxx::TypeLookup found = cxx::lookUpTypes(request);
    if (hasAdapters(root))
        for (cxx::TypeAnswer& answer : found.answers) answer.noValue.clear();
    TypeCheck check(found, isWhole && found.isSound, sink);
    for (std::size_t i = 0; i != collector.uses.size(); ++i) check.check(collector.uses[i], found.answers[i]);
    return found.headers;
}

}  // namespace oroforge::driver

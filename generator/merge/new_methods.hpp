// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_NEW_METHODS_HPP
#define OROFORGE_GENERATOR_MERGE_NEW_METHODS_HPP

#include <map>
#include <optional>

#include <merge/insertion.hpp>
#include <merge/method_style.hpp>
#include <merge/plan.hpp>

namespace oroforge::merge {

/// Adds declarations to a class, and definitions beside the others: after the operation or hook before it in the
/// manifest, else after constructor and destructor, else at the end of the class.
class NewMethods {
public:
    NewMethods(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into)
        : wanted_(wanted), type_(type), input_(input), into_(into) {}

    void add(const WantedMethod& method);

private:
    std::vector<const WantedMethod*> methodsBefore(const WantedMethod& method) const;
    std::vector<const model::UserFunction*> ranked(const WantedMethod& method, bool inClass) const;
    Place placeOf(const WantedMethod& method, bool inClass);
    void addAtEnd(const WantedMethod& method, bool overrides, bool isInline);
    std::string labelFor(model::Access wanted, const std::string& text, const std::string& lineEnd);
    void define(const WantedMethod& method, const Place& place);
    bool overrides(const WantedMethod& method) const { return method.isHook || type_.hasGeneratedBase; }

    const WantedClass& wanted_;
    const model::UserClass& type_;
    const Input& input_;
    Plan& into_;
    std::map<std::string, Place> declared_;  ///< added declarations, by name
    std::map<std::string, Place> defined_;
    std::optional<model::Access> endAccess_;  ///< access at the end of the class, once something was added there
};

}  // namespace oroforge::merge

#endif

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Finds what a file about some types must include and declare: a changed header must change only files that need it.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_TYPE_NEEDS_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_TYPE_NEEDS_HPP

#include <map>
#include <set>
#include <string>
#include <vector>

#include <model/type_model.hpp>

namespace oroforge::typekit {

struct Needs {
    std::vector<std::size_t> headers;  ///< numbers of listed headers, in their order
    std::set<std::string> types;       ///< names of these types and of all types they are made of
};

class TypeNeeds {
public:
    /// `model` must outlive this object.
    explicit TypeNeeds(const model::TypeModel& model);

    /// Takes registry names of types, "/demo/Point[]" for an array; the entries of a map have a name, too.
    Needs of(const std::vector<std::string>& names) const;

    /// Returns the number of the listed header that a type belongs to: the one that defines it, else the first that
    /// provides all its parts. A library type belongs to the first header with such a field.
    std::size_t homeOf(const std::string& name) const;

private:
    static constexpr auto kNowhere = static_cast<std::size_t>(-1);
    struct Node {
        std::vector<const model::TypeUse*> parts;
        model::Homes homes;  // of a library type: one set, the headers with a struct that has such a field
        bool isUnknown = false;
        std::size_t home = kNowhere;
    };
    /// A type that has a library type as a field.
    struct User {
        const model::Homes& homes;
        std::size_t home;
    };
    template <class Type>
    User addNamed(const Type& type);
    void addUse(const model::TypeUse& use, const User& user);
    void add(const std::string& name, const std::vector<model::TypeUse>& parts, const User& user);
    void addArguments(const std::vector<model::Constructor>& all, const User& user, Node& to);
    void addArray(const model::TypeUse& use, const User& user);
    void addUnused(const std::string& name, const std::vector<const model::TypeUse*>& parts);
    void collect(const std::string& name, std::set<std::string>& to) const;
    std::vector<std::size_t> headersOf(const std::set<std::string>& names) const;

    const model::TypeModel& model_;
    std::map<std::string, Node> nodes_;
};

}  // namespace oroforge::typekit

#endif

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What a file about some of the types has to include and to declare, so that an edit of a header changes no other files
/// than those about types that have to do with it.
#ifndef OROFORGE_TYPEKIT_GEN_PLAN_BUCKET_NEEDS_HPP
#define OROFORGE_TYPEKIT_GEN_PLAN_BUCKET_NEEDS_HPP

#include <map>
#include <set>
#include <string>
#include <vector>

#include <model/type_model.hpp>

namespace oroforge::typekit {

struct Needs {
    std::vector<std::size_t> headers;  ///< numbers of listed ones, in their order
    std::set<std::string> types;       ///< names of these types and of all that they are made of
};

class BucketNeeds {
public:
    /// `model` has to live as long.
    explicit BucketNeeds(const model::TypeModel& model);

    /// Of types by their names in the registry, "/demo/Point[]" for an array, and the entries of a map.
    Needs of(const std::vector<std::string>& names) const;

private:
    struct Node {
        std::vector<const model::TypeUse*> parts;
        model::Homes homes;  // of a library type: one set, of the headers with a struct that has such a field
        bool isUnknown = false;
    };
    void addUse(const model::TypeUse& use, const model::Homes& homes);
    void add(const std::string& name, const std::vector<model::TypeUse>& parts, const model::Homes& homes);
    void addArguments(const std::vector<model::Constructor>& all, const model::Homes& homes, Node& to);
    void addArray(const model::TypeUse& use, const model::Homes& homes);
    void collect(const std::string& name, std::set<std::string>& to) const;
    std::vector<std::size_t> headersOf(const std::set<std::string>& names) const;

    const model::TypeModel& model_;
    std::map<std::string, Node> nodes_;
};

}  // namespace oroforge::typekit

#endif

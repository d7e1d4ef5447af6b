// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_GENERATOR_MERGE_NEW_MEMBERS_HPP
#define OROFORGE_GENERATOR_MERGE_NEW_MEMBERS_HPP

#include <map>
#include <string>

#include <merge/insertion.hpp>
#include <merge/plan.hpp>

namespace oroforge::merge {

/// True if a call registers that kind: "addEventPort" registers a "port".
bool registers(const std::string& verb, const std::string& kind);

/// Adds data members to a class, and the calls that register them to its constructor: each after the last of its kind,
/// and written like that one.
class NewMembers {
public:
    NewMembers(const model::UserClass& type, const Input& input, Plan& into);

    /// Returns the constructor whose body registers the interface; null if there is none.
    const model::UserFunction* constructor() const { return constructor_; }

    /// Declares the member; returns the name of the data member.
    std::string declare(const WantedMember& member);
    /// Adds "this->" + call + ".doc(…);" to the constructor.
    void registerBy(const std::string& kind, const std::string& path, const std::string& call,
                    const std::vector<DocText>& texts);
    /// Makes the edits.
    void finish();

private:
    std::string memberName(const WantedMember& member) const;
    const model::UserField* lastField(const std::string& kind) const;
    std::string portPrefix() const;
    std::string receiverLike(const model::UserRegistration* sample, bool sameKind) const;

    const model::UserClass& type_;
    const Input& input_;
    Plan& into_;
    const model::UserFunction* constructor_ = nullptr;
    std::map<std::size_t, std::string> declarations_;  ///< lines by place in the file of the class
    bool atEnd_ = false;
    std::map<std::size_t, std::string> calls_;  ///< lines by place in the file of the constructor
};

}  // namespace oroforge::merge

#endif

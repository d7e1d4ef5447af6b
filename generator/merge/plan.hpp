// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Decides how the user's files follow a change of the manifest.
///
///     manifest ─► wanted ─┐
///     sources ─► user code ├─► plan: edits, a new record, what to tell
///     record of last time ─┘
///
/// Three signatures meet: the one in the manifest, the one that was last written, and the one in the code. Code that is
/// as it was written follows the manifest. Code that the user changed stays; if the manifest changed as well, that is
/// an error, because nobody can guess which one is right.
#ifndef OROFORGE_GENERATOR_MERGE_PLAN_HPP
#define OROFORGE_GENERATOR_MERGE_PLAN_HPP

#include <map>
#include <set>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <merge/edits.hpp>
#include <merge/record.hpp>
#include <merge/wanted.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

/// Conflicts that the user decided, by names in the manifest, with or without the class: "finish" or "Plant.finish".
struct Choices {
    std::set<std::string> manifest;
    std::set<std::string> code;
};

bool isChosen(const std::set<std::string>& names, const std::string& className, const std::string& name);

/// The compiler's view of signatures in the namespace of a class; the key is question().
using Answers = std::map<std::string, model::CanonicalSignature>;

std::string question(const model::Signature& signature);

/// Returns the signatures that plan() compares with those in the code.
std::vector<model::Signature> questionsOf(const WantedClass& wanted, const RecordedClass* recorded);

struct Input {
    const model::UserCode& code;
    const std::map<std::string, Answers>& answers;  ///< by class
    const Record& record;
    const Choices& choices;
};

struct Plan {
    Edits edits;
    Record record;
    std::vector<std::string> changes;  ///< "src/Plant.hpp: bool finish(int sent)"
};

/// Plans the wanted classes that the code has. A plan with errors in the sink must not be carried out.
Plan plan(const std::vector<WantedClass>& wanted, const Input& input, diag::Sink& sink);

/// Returns the record of files that were just made.
RecordedClass recordOf(const WantedClass& wanted);

/// Plans declarations and registrations of members in a class without a generated base.
void planMembers(const WantedClass& wanted, const model::UserClass& type, const Input& input, Plan& into,
                 diag::Sink& sink);

}  // namespace oroforge::merge

#endif

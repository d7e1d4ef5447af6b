// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// Records what was last written into the user's classes. It shows what has changed since: the manifest, or the code.
#ifndef OROFORGE_GENERATOR_MERGE_RECORD_HPP
#define OROFORGE_GENERATOR_MERGE_RECORD_HPP

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

/// The name of the record in a package; it belongs under version control.
inline constexpr const char* kRecordFile = ".orocreate-pkg.json";

/// .doc("The level") or .arg("hard", "All of it").
struct DocText {
    std::string argument;  ///< empty for doc()
    std::string words;
};

inline bool operator==(const DocText& a, const DocText& b) { return a.argument == b.argument && a.words == b.words; }

/// A registration in a class without a generated base.
struct Registration {
    std::string how;  ///< "addEventPort"; "OwnThread" of an operation
    std::vector<DocText> texts;
};

struct RecordedMethod {
    model::Signature signature;
    bool isHook = false;
    bool kept = false;  ///< the user decided for the code, whatever this signature is
    std::optional<Registration> registration = std::nullopt;
};

struct RecordedMember {
    std::string kind;    ///< "port", "property" or "attribute"
    std::string member;  ///< name of the data member
    std::string type;
    bool kept = false;
    std::string portClass = {};  ///< "InputPort" or "OutputPort" of a port
    std::optional<Registration> registration = std::nullopt;
};

struct RecordedClass {
    std::map<std::string, RecordedMethod> methods;
    std::map<std::string, RecordedMember> members;  ///< by name in the manifest
};

/// By qualified name.
using Record = std::map<std::string, RecordedClass>;

/// Sorted, without times or paths: equal records have equal texts.
std::string toText(const Record& record);

/// Reports an error OC039 if the text is not a record.
std::optional<Record> parseRecord(const std::string& text, const std::string& file, diag::Sink& sink);

}  // namespace oroforge::merge

#endif

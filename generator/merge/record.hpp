// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/// What was last written into the classes of the user. Tells who changed what since: the manifest, or the user.
#ifndef OROFORGE_GENERATOR_MERGE_RECORD_HPP
#define OROFORGE_GENERATOR_MERGE_RECORD_HPP

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <diag/sink.hpp>
#include <model/user_code.hpp>

namespace oroforge::merge {

/// Its name in a package; it belongs under version control.
inline constexpr const char* kRecordFile = ".orocreate-pkg.json";

struct RecordedText {
    std::string argument;  ///< empty for doc()
    std::string words;
};

inline bool operator==(const RecordedText& a, const RecordedText& b) {
    return a.argument == b.argument && a.words == b.words;
}

/// Of classes that have no generated base.
struct RecordedRegistration {
    std::string how;  ///< "addEventPort"; of an operation "OwnThread"
    std::vector<RecordedText> texts;
};

struct RecordedMethod {
    model::Signature signature;
    bool isHook = false;
    bool kept = false;  ///< the user decided for what stands in the code, whatever this signature is
    std::optional<RecordedRegistration> registration = std::nullopt;
};

struct RecordedMember {
    std::string kind;    ///< "port", "property" or "attribute"
    std::string member;  ///< name of the data member
    std::string type;
    bool kept = false;
    std::string portClass = {};  ///< "InputPort" or "OutputPort" of a port
    std::optional<RecordedRegistration> registration = std::nullopt;
};

struct RecordedClass {
    std::map<std::string, RecordedMethod> methods;
    std::map<std::string, RecordedMember> members;  ///< by their name in the manifest
};

/// By qualified name.
using Record = std::map<std::string, RecordedClass>;

/// Sorted, without times or paths: equal records are equal texts.
std::string toText(const Record& record);

/// An error OC039 if it is no such text.
std::optional<Record> parseRecord(const std::string& text, const std::string& file, diag::Sink& sink);

}  // namespace oroforge::merge

#endif

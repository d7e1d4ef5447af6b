// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#include "message_schema.hpp"

#include "detail/idl_text.hpp"
#include "detail/limits.hpp"
#include "detail/ros_text.hpp"

#include <algorithm>

namespace oroforge::schema {
namespace {

/** Structs that contain themselves, which only lists and unions end, or too many others. */
class Nesting {
public:
    explicit Nesting(const std::vector<Struct>& structs) : structs_(structs), states_(structs.size()) {}

    /** Why a struct cannot be walked through; null if it can. */
    const char* refusal(std::size_t at, std::size_t depth = 0) {
        if (states_[at] == State::Open) return "a type contains itself";
        if (states_[at] == State::Good) return nullptr;
        if (depth == kDeepest) return "types nest too deeply";
        states_[at] = State::Open;
        for (const Field& field : structs_[at].fields) {
            if (field.basic != Basic::Struct || ends(structs_[at], field)) continue;
            if (const char* const wrong = refusal(field.structAt, depth + 1)) return wrong;
        }
        states_[at] = State::Good;
        return nullptr;
    }

private:
    enum class State : std::uint8_t { New, Open, Good };

    static bool ends(const Struct& its, const Field& field) {
        return its.isUnion ||
               std::any_of(field.lists.begin(), field.lists.end(), [](Many many) { return many.isSequence; });
    }

    const std::vector<Struct>& structs_;
    std::vector<State> states_;
};

/** Elements of lists have bytes, so that lists end with the message; so do structs, so that they do not multiply. */
bool haveBytes(const std::vector<Struct>& structs, std::string& why) {
    for (const Struct& one : structs)
        for (const Field& field : one.fields) {
            if (field.basic != Basic::Struct || (one.isUnion && field.lists.empty())) continue;
            const Struct& type = structs[field.structAt];
            if (!type.fields.empty() || type.hasByte || type.isUnion) continue;
            why = "line " + std::to_string(field.line) + ": the field '" + field.name + "' has the type '" + type.name +
                  "' without fields, which only a field of a union can have";
            return false;
        }
    return true;
}

}  // namespace

bool MessageSchema::isKnown(const std::string& encoding) {
    return encoding == "ros2msg" || encoding == "omgidl" || encoding == "ros2idl";
}

bool MessageSchema::read(const std::string& encoding, const std::string& name, const std::string& text,
                         std::string& why) {
    structs_.clear();
    root_ = 0;
    if (!isKnown(encoding)) {
        why = "its type is described as '" + encoding + "', and only ros2msg, omgidl and ros2idl are read";
        return false;
    }
    const bool isRead =
        encoding == "ros2msg" ? readRos(text, structs_, why) : readIdl(text, name, structs_, root_, why);
    if (!isRead || !haveBytes(structs_, why)) return false;
    Nesting nesting(structs_);
    // Behind a list or in a union is the beginning of another walk.
    for (std::size_t at = 0; at != structs_.size(); ++at)
        if (const char* const wrong = nesting.refusal(at)) {
            why = wrong;
            return false;
        }
    return true;
}

}  // namespace oroforge::schema

// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// A type as languages describe it: structs whose fields are numbers, texts and other structs, or lists of those.
#ifndef ORO_ENCODING_DETAIL_SCHEMA_MODEL_HPP
#define ORO_ENCODING_DETAIL_SCHEMA_MODEL_HPP

#include <rtt/encoding/detail/form.hpp>

#include <cstddef>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace RTT {
namespace encoding {
namespace detail {

struct SchemaStruct;

struct SchemaField {
    std::string name;
    const SchemaStruct* type = nullptr;  // null for a number or a text
    const Form* basic = nullptr;         // the number, enumeration or text
    bool isSequence = false;
    std::size_t count = 0;  // not 0 for an array
    const char* doc = "";
    const char* unit = "";
};

struct SchemaStruct {
    std::vector<std::string> path;  // its namespaces
    std::string name;
    bool isUnion = false;  // of a variant: each field is an alternative
    bool hasByte = false;  // it has no fields, and the encoding has a byte for it
    std::vector<SchemaField> fields;
};

class SchemaModel {
public:
    explicit SchemaModel(const Form& root);

    const SchemaStruct& root() const { return *root_; }
    /** All structs, each after those that it contains. */
    const std::vector<const SchemaStruct*>& structs() const { return order_; }

    /** The types that became structs. */
    const std::map<const Form*, const SchemaStruct*>& forms() const { return known_; }

    /** Turns the names of fields into legal ones of ROS, unless two would become one. */
    void useRosNames();
    /** What ROS does not allow; empty if it allows everything. */
    std::string whyNotRos() const;

private:
    const SchemaStruct* structOf(const Form& form);
    const SchemaStruct* again(const SchemaStruct* known);
    const SchemaStruct* finished(SchemaStruct& its);
    const SchemaStruct* variantOf(const Form& form, SchemaStruct& its);
    const SchemaStruct* listOf(const Form& form);
    const SchemaStruct* nothing();
    void add(SchemaStruct& to, const std::string& name, const Form& form, std::size_t count, const char* doc,
             const char* unit);
    void setType(SchemaField& field, const Form& form);
    SchemaStruct& newStruct(std::vector<std::string> path, const std::string& name);
    SchemaStruct& newStruct(const std::string& typeName);

    std::deque<SchemaStruct> all_;
    std::map<const Form*, const SchemaStruct*> known_;
    std::set<std::string> names_;
    std::vector<const SchemaStruct*> order_;
    const SchemaStruct* nothing_ = nullptr;
    std::set<const SchemaStruct*> unfinished_;
    const SchemaStruct* recursive_ = nullptr;  // one that contains itself
    const SchemaStruct* root_;
};

/** The number that encodes a number or an enumeration; for an enumeration of bool, Bool. */
types::Shape::Number numberOf(const Form& basic);
/** What both languages call it: "int32"; null for Bool, Float32 and Float64, on which they differ. */
const char* sharedNameOf(types::Shape::Number number);
/** How ROS calls the byte of a struct without fields. */
constexpr const char* kEmptyField = "structure_needs_at_least_one_member";
/** A text in one line, as a comment needs it. */
std::string oneLine(const char* text);
/** The description and the unit of a field; empty if it has neither. */
std::string commentOf(const SchemaField& field);
/** "angleRad" and "_angle__rad_" become "angle_rad". */
std::string snakeCase(const std::string& name);
/** The namespaces and the name of its type. */
std::vector<std::string> pathOf(const Form& form);
std::string valueText(const types::Shape::Enumerator& one, const Form& enumeration);

std::string rosName(const SchemaStruct& one, const char* separator);
std::string rosText(const SchemaModel& model);
bool isRosName(const std::string& name);
std::string idlName(const SchemaStruct& one);
std::string idlText(const SchemaModel& model);

}  // namespace detail
}  // namespace encoding
}  // namespace RTT

#endif

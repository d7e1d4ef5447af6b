// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * A value taken apart into the columns of a report. The tree is built once; each row then only follows it:
 *
 *     struct ──► a Group with a node per member            double, string, …  ──► a Leaf
 *     sequence ──► a Group with a node per element          vector of numbers  ──► Numbers, as a whole
 *     anything else: a Leaf with the text that its type makes of it
 */
#ifndef ORO_OCL_REPORTING_VALUE_TREE_HPP
#define ORO_OCL_REPORTING_VALUE_TREE_HPP

#include "leaf_kinds.hpp"
#include "other_value.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/base/DataSourceBase.hpp>

#include <string>
#include <vector>

namespace OCL::reporting {

class Record;

/** How far values are taken apart. */
enum class Decomposition {
    None,     ///< not at all: one column with the text of the value
    Members,  ///< members by name, elements by index
    Types,    ///< as the types put themselves into property files; allocates for each row
};

/** One value, or part of a value. Follows the value, which belongs to the thread that uses the tree. */
class ValueTree {
public:
    typedef RTT::base::DataSourceBase::shared_ptr Value;

    /** `others` must outlive the records. */
    ValueTree(std::string name, Value value, Decomposition decomposition, OtherValues& others);

    /** Appends the value as it is now. True if it has other columns than before. */
    bool encode(Record& record);
    /** Appends the names of the columns, a blank before each. */
    void appendNames(std::string& line) const { appendNames(line, name_); }
    /** Adds the value as properties that are copies, one bag per value with members. */
    void addTo(RTT::PropertyBag& bag);

private:
    enum class Kind { Leaf, Text, Numbers, Group, Bag };

    void decide();
    bool becomeGroup();
    void addPart(const std::string& name, const Value& part);
    bool resize(int size);
    const void* address() const;
    bool encodeBag(Record& record);
    bool takeMembers();
    bool currentBag(RTT::PropertyBag& bag) const;
    std::size_t elements() const;
    /** What is empty has one column all the same, "name[0]"; without a value those behind it would move. */
    void encodeEmptiness(Record& record) const;
    /** A part without a name is called by its number, from 1. */
    void appendNames(std::string& line, const std::string& name) const;

    std::string name_;
    Value value_;
    Decomposition decomposition_;
    OtherValues* others_;
    Kind kind_ = Kind::Text;
    const void* fixed_ = nullptr;  // where the value is, if it stays there
    Encode encode_ = nullptr;      // Leaf
    const NumberVector* numbers_ = nullptr;
    const OtherValue* other_ = nullptr;  // Text: null if the text is made here
    Value count_;                        // Group: of a sequence
    int size_ = 0;                       // elements of Numbers or of a sequence
    std::vector<ValueTree> parts_;
};

}  // namespace OCL::reporting

#endif

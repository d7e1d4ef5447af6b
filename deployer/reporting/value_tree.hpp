// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
/**
 * A value taken apart into the columns of a report. The tree is built once; rows only follow it:
 *
 *     struct ──► a Group with a node per member            double, string, …  ──► a Leaf
 *     sequence ──► a List with a node per element           vector of numbers  ──► Numbers, as a whole
 *     anything else: a Leaf with the text of the value
 */
#ifndef ORO_OCL_REPORTING_VALUE_TREE_HPP
#define ORO_OCL_REPORTING_VALUE_TREE_HPP

#include "fields.hpp"
#include "leaf_kinds.hpp"
#include "other_value.hpp"

#include <rtt/PropertyBag.hpp>
#include <rtt/base/DataSourceBase.hpp>

#include <memory>
#include <set>
#include <string>
#include <vector>

namespace OCL::reporting {

class Record;

/** How values are taken apart. */
enum class Decomposition {
    None,     ///< not at all: one column with the text of the value
    Members,  ///< members by name, elements by index
    Types,    ///< as in property files; allocates for each row
};

/** A value, or part of one. The value belongs to the thread that uses the tree. */
class ValueTree {
public:
    typedef RTT::base::DataSourceBase::shared_ptr Value;

    /** `others` must outlive the records. */
    ValueTree(std::string name, Value value, Decomposition decomposition, OtherValues& others);

    /** Appends the present value. True if field() has changed; the size of a sequence does not count. */
    bool encode(Record& record);
    /** What encode() appends. Allocates. */
    Field field() const;
    /** Adds the names of the types of parts that have neither members nor a text. */
    void addTypesWithoutText(std::set<std::string>& types) const;
    /** Adds the value as properties with copies, one bag per value with members. */
    void addTo(RTT::PropertyBag& bag);

private:
    enum class Kind { Leaf, Text, Numbers, Group, List, Bag };

    void decide();
    bool becomeGroup();
    void addPart(const std::string& name, const Value& part);
    void becomeList();
    bool resize(int size);
    void findElement();
    const void* address() const;
    bool encodeBag(Record& record);
    bool takeMembers();
    bool currentBag(RTT::PropertyBag& bag) const;
    /** Appends names and types of all parts, to see whether they have changed. */
    void appendSignature(std::string& text) const;
    Field leaf() const;
    bool isFixed() const;

    std::string name_;
    Value value_;
    Decomposition decomposition_;
    OtherValues* others_;
    Kind kind_ = Kind::Text;
    const void* fixed_ = nullptr;  // the address of the value, if it is constant
    Encode encode_ = nullptr;      // Leaf
    const NumberVector* numbers_ = nullptr;
    const OtherValue* other_ = nullptr;     // Text: null if this thread makes the text
    Value count_;                           // List: the size
    std::shared_ptr<const Field> element_;  // List: what all elements are like; null if each has a field of its own
    int size_ = 0;                          // number of elements of Numbers or a sequence
    std::vector<ValueTree> parts_;
};

}  // namespace OCL::reporting

#endif

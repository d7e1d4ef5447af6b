// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Values of components as JSON and as text, and back. Used outside of components' threads, with copies.
#ifndef OROFORGE_LIVE_VALUES_HPP
#define OROFORGE_LIVE_VALUES_HPP

#include <rtt/base/DataSourceBase.hpp>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace RTT {
class PropertyBag;
}

namespace OCL::live {

typedef RTT::base::DataSourceBase::shared_ptr Source;

/**
 * A value of a component and a copy of it. The copy is made here and filled in the thread of the component. A bag of
 * properties has one for each of them.
 */
class Copied {
public:
    explicit Copied(const Source& original);

    /** In the thread of the component. Allocates only what the type does, and nothing for a text or a vector of
        numbers: one that needs more memory than the copy has is left out, and this is false. Then grow() and try
        again. */
    bool fill();
    /** Takes the memory that fill() wanted, or that a value such as this one needs. */
    void grow();
    void growFor(const Source& value);
    /** fill() allocates what it needs from now on. */
    void mayAllocate() { allocates_ = true; }
    /** The copy; for a bag a new one, whose properties are copies. Null for a type of which there are no copies. */
    Source value() const { return isCopied_ ? copy_ : Source(); }

private:
    struct Leaf {
        Source original, copy;
        std::size_t room, wanted;  ///< letters or elements
        bool done = false;
    };
    static void take(Leaf& leaf, std::size_t room);
    bool fill(Leaf& leaf) const;

    Source original_, copy_;
    std::vector<Leaf> leaves_;  // one; of a bag: its properties
    bool allocates_ = false, isCopied_ = true;
    void addBag(const RTT::PropertyBag& from, RTT::PropertyBag& to, unsigned depth);
};

/** As scripts write it: "pkg.Type". */
std::string typeOf(const Source& value);
/** As the console shows it, cut. */
std::string textOf(const Source& value, std::size_t most);
/** Null if the type has no form in JSON, or if it would be larger than `most` bytes; `wasCut` says that. */
nlohmann::json jsonOf(const Source& value, std::size_t most, bool& wasCut);

/** The part of a value at this path of fields, elements and properties of bags; throws Failure, naming `path`. */
Source partOf(const Source& whole, const std::vector<std::string>& parts, const std::string& path);

/** Sets a copy from JSON: fields that are not there keep theirs. Throws Failure that says where it is wrong. */
void assign(const Source& value, const nlohmann::json& from, const std::string& path);
/** The same from text, see value_syntax.hpp. */
void assign(const Source& value, const std::string& text, const std::string& path);

/** "m" from "Its length [m]", which loses it. */
std::string unitOf(std::string& doc);

}  // namespace OCL::live

#endif

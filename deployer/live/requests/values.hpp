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

    /** In the thread of the component; allocates only what the type does. */
    void fill();
    /** The copy; for a bag a new one, whose properties are copies. Null for a type of which there are no copies. */
    const Source& value() const { return copy_; }

private:
    Source original_, copy_;
    std::vector<std::pair<Source, Source>> leaves_;  // of a bag: originals and copies
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

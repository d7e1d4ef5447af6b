// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Moves values between a bag in memory and a property file.
#ifndef ORO_PROPERTY_FILE_HPP
#define ORO_PROPERTY_FILE_HPP

#include "cpf_reader.hpp"

namespace RTT {
namespace marsh {

enum class LoadMode {
    refresh,        ///< set what both have
    strictRefresh,  ///< the same, and the file must have every property of the bag
    load,           ///< set what both have, and add to the bag what only the file has
};

/** A property file in memory. */
struct RTT_API PropertyFile {
    /** Reads it, and reports errors. */
    PropertyFile(const std::string& file, diag::Sink& sink);
    PropertyFile(const PropertyFile&) = delete;
    PropertyFile& operator=(const PropertyFile&) = delete;

    const std::string name;
    PropertyBag bag;
    Places places;
    const bool isGood;  ///< false if there was an error; then the bag may have a part of the file
};

/** On an error no value of the bag changes. Errors have places in the file. */
RTT_API bool loadFrom(const PropertyFile& file, PropertyBag& bag, LoadMode mode, diag::Sink& sink);
RTT_API bool loadFromFile(PropertyBag& bag, const std::string& file, LoadMode mode, diag::Sink& sink);
/** Sets one property, given its path; bag and file must both have it. */
RTT_API bool loadOneFromFile(PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink);

enum class SaveMode {
    store,   ///< the file then has exactly the properties of the bag
    merge,   ///< what only the file has stays
    update,  ///< only properties that the file has change; a missing file is stored
};

/** A file that exists but cannot be read is an error and stays as it is. */
RTT_API bool saveToFile(const PropertyBag& bag, const std::string& file, SaveMode mode, diag::Sink& sink);
RTT_API bool saveOneToFile(const PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink);

}  // namespace marsh
}  // namespace RTT

#endif

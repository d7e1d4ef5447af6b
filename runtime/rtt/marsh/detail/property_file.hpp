// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
// Between a bag in memory and a property file: which side gives what.
#ifndef ORO_PROPERTY_FILE_HPP
#define ORO_PROPERTY_FILE_HPP

#include "cpf_reader.hpp"

namespace RTT {
namespace marsh {

enum class LoadMode {
    refresh,        ///< what both have
    strictRefresh,  ///< every property of the bag must be in the file
    load,           ///< what both have, and the bag gets what it lacks
};

/** On error all values of the bag are as before. Errors name their places in the file. */
RTT_API bool loadFromFile(PropertyBag& bag, const std::string& file, LoadMode mode, diag::Sink& sink);
/** One property by its path; it must be in both. */
RTT_API bool loadOneFromFile(PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink);

enum class SaveMode {
    store,   ///< the file holds exactly the bag afterwards
    merge,   ///< what the file had besides stays
    update,  ///< only what the file has already is changed; a missing file is stored
};

/** A file that exists but cannot be read stays as it is, and that is an error. */
RTT_API bool saveToFile(const PropertyBag& bag, const std::string& file, SaveMode mode, diag::Sink& sink);
RTT_API bool saveOneToFile(const PropertyBag& bag, const std::string& file, const std::string& path, diag::Sink& sink);

}  // namespace marsh
}  // namespace RTT

#endif

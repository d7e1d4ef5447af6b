// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef OROFORGE_LIVE_RIGHTS_HPP
#define OROFORGE_LIVE_RIGHTS_HPP

namespace OCL::live {

/** What a client may do besides looking. */
struct Rights {
    bool properties = false;  ///< set properties and attributes
    bool operations = false;  ///< call operations
    bool lifecycle = false;   ///< configure, start, stop … components
    bool stop = false;        ///< end the deployment
    bool console = false;     ///< lines of a console, which may do all of that
};

}  // namespace OCL::live

#endif

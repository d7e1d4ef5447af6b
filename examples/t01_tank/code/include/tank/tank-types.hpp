// SPDX-License-Identifier: Apache-2.0
// Copyright Oroforge contributors
#ifndef TANK_TYPES_HPP
#define TANK_TYPES_HPP

#include <string>
#include <vector>

namespace tank {

/** How far a sample can be trusted. */
enum class Quality { Good, Estimated, Bad };

/** One measurement of the level. */
struct LevelSample {
    int number = 0;                   ///< counts the samples, from 1
    double level = 0.0;               ///< height of the water, in m
    Quality quality = Quality::Good;  ///< trust in the level
    std::string sensor;               ///< name of the sensor
    std::vector<double> raw;          ///< readings the level was made of, in m
};

}  // namespace tank

#endif
